#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tristim/color/rgb.h"
#include "tristim/light/fresnel.h"
#include "tristim/light/microfacet.h"
#include "tristim/light/phong.h"
#include "tristim/light/samples.h"
#include "tristim/light/source.h"
#include "tristim/light/transparency.h"
#include "tristim/render/mesh.h"

namespace tristim {

// What render_scene draws: plain values. Lengths are in one unit of the user's choice, axes are
// right-handed.

/// Looks from `eye` to `target`, with `up` upwards in the picture.
struct Camera {
  Eigen::Vector3d eye{0, 0, 5};
  Eigen::Vector3d target{0, 0, 0};
  Eigen::Vector3d up{0, 1, 0};
  bool orthographic = false;
  double fov_deg = 40;  // angle of view from bottom to top, above 0 and below 180
  double height = 2;    // of the view, where it is orthographic
  double near = 0.01;   // distance along the view axis, above 0
  double far = std::numeric_limits<double>::infinity();  // above `near`
};

/// A flat polygon that shines evenly on the side where its corners run counter-clockwise. Matte
/// reflection is exact; highlights are those of `samples` x `samples` points on it.
struct PolygonLight {
  std::vector<Eigen::Vector3d> polygon = {};
  Rgb intensity = {};  // Le
  int samples = 8;     // 1..64
};

/// A light of a scene.
struct SceneLight {
  std::string name = {};  // of its layers
  std::variant<DirectionalLight, PointLight, SpotLight, PolygonLight> source = DirectionalLight{};
  std::optional<SpectralColor> spectrum = {};  // Ip or Le, in the place of the source's own
  bool with_camera = false;  // placed in the camera's axes: x right, y up, z to the viewer
};

/// How a surface answers to light.
struct ReflectionModel {
  std::string_view name;
  std::string_view formula;
  std::string_view source;
};

inline constexpr ReflectionModel kPhongReflection{"phong", "kd Od N.L + ks Os (R.V)^n",
                                                  "[Phong75]"};
inline constexpr ReflectionModel kBlinnReflection{"blinn-phong", "kd Od N.L + ks Os (N.H)^n",
                                                  "[Blinn77]"};
inline constexpr ReflectionModel kMicrofacetReflection{
    "cook-torrance", "N.L (kd Od/pi + ks Os rho_s)", "[Cook82, Walter07]"};
/// Tones of the scene's first light; ambient light and the other lights do not count.
inline constexpr ReflectionModel kGoochReflection{
    "gooch", "kw warm + (1 - kw) cool + ks Os (R.V)^n", "[UBC, Gooch98]"};
inline constexpr ReflectionModel kFlatColor{"color", "Od, without any light", "[UBC]"};

/// Every model. The scene files, the docs and the tests read this list.
inline constexpr std::array kReflectionModels{kPhongReflection, kBlinnReflection,
                                              kMicrofacetReflection, kGoochReflection, kFlatColor};

/// What a rough surface is made of [Shoaff 3.8].
struct RoughSurface {
  Microfacets facets = {};
  std::array<Reflector, 3> reflectors = {};  // for red, green and blue light
  std::optional<std::array<Reflector, kSpectralSamples>> spectral = {};  // for each wavelength
};

/// Colours of the surface at each wavelength.
struct SpectralSurface {
  SpectralColor od = kWhiteOf<SpectralColor>;
  SpectralColor os = kWhiteOf<SpectralColor>;
};

enum class Transparency { kNone, kInterpolated, kFiltered };

/// Warm and cool tones, of what faces the light and of what is turned away.
struct GoochTones {
  Rgb warm{0.3, 0.3, 0};
  Rgb cool{0, 0, 0.55};
};

/// How an object looks.
struct SceneMaterial {
  std::string name = {};
  ReflectionModel model = kPhongReflection;
  Material surface = {};  // ka, kd, ks, n, Od, Os
  std::optional<SpectralSurface> spectral = {};
  RoughSurface rough = {};  // of kMicrofacetReflection
  GoochTones gooch = {};    // of kGoochReflection
  Transparency transparency = Transparency::kNone;
  TransparentSurface transparent = {};  // kt, Ot
  bool two_sided = false;               // back faces are drawn, with their normals turned round
};

/// A mesh and where it stands.
struct SceneObject {
  std::string name = {};
  std::size_t mesh = 0;                                             // of the scene's
  Eigen::Matrix4d world_from_object = Eigen::Matrix4d::Identity();  // affine
  std::optional<std::uint32_t> material = {};  // of all triangles; else each has its own
};

/// Where the illumination model runs.
struct Shading {
  std::string_view name;
  std::string_view source;
};

/// Once for a triangle, at its centroid with the normal of the face.
inline constexpr Shading kFlatShading{"flat", "[Shoaff 4.1]"};
/// At the vertices; its results are interpolated.
inline constexpr Shading kGouraudShading{"gouraud", "[Gouraud71]"};
/// At every sample, with the interpolated normal made unit.
inline constexpr Shading kPhongShading{"phong", "[Phong75]"};
inline constexpr std::array kShadings{kFlatShading, kGouraudShading, kPhongShading};

/// How the samples of a pixel and its neighbours add up.
struct PixelFilter {
  std::string_view name;
  std::string_view formula;  // the weight of a sample at (x, y) pixels from the pixel's centre
  double radius;             // pixels
};

inline constexpr PixelFilter kBoxFilter{"box", "1 for |x|, |y| <= 1/2", 0.5};
inline constexpr PixelFilter kTentFilter{"tent", "(1 - |x|)(1 - |y|)", 1};
inline constexpr PixelFilter kGaussianFilter{"gaussian", "exp(-2 (x^2 + y^2)) for |x|, |y| <= 1.5",
                                             1.5};
inline constexpr std::array kPixelFilters{kBoxFilter, kTentFilter, kGaussianFilter};

/// Lines over the surfaces: where the outline and the sharp edges of the meshes are seen [UBC].
struct EdgeLines {
  bool silhouettes = false;
  bool creases = false;
  double crease_deg = 60;  // least angle between the faces' normals, 0..180
  double width = 1.5;      // pixels, above 0
  Rgb color = {};
};

/// How the picture is made.
struct PictureSettings {
  int width = 640;   // 1..65536
  int height = 480;  // 1..65536
  int samples = 1;   // of a pixel: 1, 4, 16 or 64
  PixelFilter filter = kBoxFilter;
  Shading shading = kPhongShading;
  bool affine = false;  // interpolate along the screen, which is wrong in perspective
};

/// All of it.
struct Scene {
  Camera camera = {};
  Rgb ambient = {};                                    // Ia
  std::optional<SpectralColor> ambient_spectrum = {};  // in the place of `ambient`
  std::optional<SpectralColor> white = {};  // of the spectra: what has Y = 1; D65 if there is none
  std::vector<SceneLight> lights = {};
  std::vector<SceneMaterial> materials = {};
  std::vector<Mesh> meshes = {};
  std::vector<SceneObject> objects = {};
  EdgeLines edges = {};
  PictureSettings picture = {};
};

}  // namespace tristim
