#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tristim/image/picture.h"
#include "tristim/render/scene.h"

namespace tristim {

/// What is known of each pixel beside its light.
struct RenderLayer {
  std::string_view name;
  std::string_view channels;  // a letter each; none: one channel with the name of the layer
  std::string_view meaning;
  bool each_light = false;  // a layer for each light, its name behind a '.'
  bool filtered = true;     // else that of the pixel's centre, never mixed
};

inline constexpr RenderLayer kBeautyLayer{
    "beauty", "RGBA", "the light that arrives, and the part of the pixel covered"};
inline constexpr RenderLayer kAmbientLayer{"ambient", "RGB", "ka Ia Od"};
inline constexpr RenderLayer kDiffuseLayer{"diffuse", "RGB", "the matte part of a light", true};
inline constexpr RenderLayer kSpecularLayer{"specular", "RGB", "the highlights of a light", true};
inline constexpr RenderLayer kNormalLayer{"N", "XYZ", "the unit normal, in the world", false,
                                          false};
inline constexpr RenderLayer kPositionLayer{"P", "XYZ", "the point, in the world", false, false};
inline constexpr RenderLayer kDepthLayer{"Z", "", "the distance along the view axis", false, false};
inline constexpr RenderLayer kAlbedoLayer{"albedo", "RGB", "kd Od"};
inline constexpr RenderLayer kIdLayer{"id", "", "the number of the triangle, from 1", false, false};
inline constexpr RenderLayer kUvLayer{"uv", "UV", "the texture coordinates", false, false};
inline constexpr RenderLayer kMachLayer{
    "machband", "", "2 I - I_left - I_right + 2 I - I_above - I_below of beauty's luminance"};
inline constexpr RenderLayer kBlinnMinusPhongLayer{"blinn_minus_phong", "RGB",
                                                   "sum ks Os f_att Ip ((N.H)^4n - (R.V)^n)"};

/// Every layer. ambient, diffuse and specular add up to beauty. The command line, the docs and the
/// tests read this list.
inline constexpr std::array kRenderLayers{kBeautyLayer,   kAmbientLayer, kDiffuseLayer,
                                          kSpecularLayer, kNormalLayer,  kPositionLayer,
                                          kDepthLayer,    kAlbedoLayer,  kIdLayer,
                                          kUvLayer,       kMachLayer,    kBlinnMinusPhongLayer};

struct RenderOptions {
  std::vector<RenderLayer> layers{kBeautyLayer};
  bool xyz = false;  // colours are CIE XYZ instead of linear light in sRGB's primaries
  int threads = 0;   // 0: one for each processor; the picture is the same for any number
  int tile = 64;     // pixels on a side, 16..256 in steps of 16; the picture is the same for any
};

/// The channels of the rows that render() delivers, layer after layer: "R", "G", "B", "A",
/// "diffuse.key.R", "N.X", "Z".
std::vector<std::string> render_channels(const Scene& scene, const RenderOptions& options);

/// What render() delivers, for opening its sink; as many channels as render_channels() names.
PictureInfo render_info(const Scene& scene, const RenderOptions& options);

/// What a picture was made of.
struct RenderReport {
  std::size_t triangles = 0;   // in the scene
  std::size_t degenerate = 0;  // of them, without area: left out
};

namespace detail {
struct PreparedScene;
}

/// Draws a scene, any number of times and from any place. What does not depend on the camera is
/// computed once.
///
/// World to view, clipped at the near and far plane, NDC to device [UBC, to_viewport], vertices
/// rounded to 2^-16 of a pixel (2^-14 above 16384 pixels a side); a sample belongs to a triangle by
/// exact integers and the top-left rule, so that a closed mesh has no holes and no pixel twice.
/// The nearest surface by 1/w is kept, of equally near ones the first, and shaded afterwards. Light
/// is computed in single precision, within 2e-5 of the double functions of `light`. Surfaces cast
/// no shadows. Back faces are left out unless their material has two sides. All layers are 0 where
/// nothing is hit.
class SceneRenderer {
 public:
  /// Throws std::invalid_argument for numbers out of range or not finite, and for indices of
  /// meshes, materials or corners that do not exist.
  explicit SceneRenderer(Scene scene);
  ~SceneRenderer();
  SceneRenderer(SceneRenderer&&) noexcept;
  SceneRenderer& operator=(SceneRenderer&&) noexcept;

  const Scene& scene() const noexcept;
  const RenderReport& report() const noexcept;

  /// Rows go to `sink` in bands; memory is that of the meshes and of a few bands. The caller calls
  /// sink.finish(). Throws std::invalid_argument for a camera or options out of range, and what the
  /// sink throws.
  void render(const Camera& camera, const RenderOptions& options, RowSink& sink) const;

 private:
  std::unique_ptr<const detail::PreparedScene> prepared_;
};

/// The camera of frame `frame` of `frames`, 1 the first, on its way round the target: turned
/// counter-clockwise, seen from above, about the axis `up` through it by frame/frames of a turn.
Camera orbit(const Camera& camera, int frame, int frames);

}  // namespace tristim
