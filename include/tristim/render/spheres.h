#pragma once

#include <Eigen/Core>
#include <vector>

#include "tristim/color/rgb.h"
#include "tristim/image/picture.h"
#include "tristim/light/phong.h"
#include "tristim/light/source.h"

namespace tristim {

/// A sphere and how it reflects.
struct Sphere {
  Eigen::Vector3d centre{0, 0, 0};
  double radius = 1;
  Material material = {};
  SpecularModel model = kPhong;
};

/// A light and how large it looks, which is how soft its shadows are: `size` is the radius of a
/// point light, the tangent of the angular radius of a directional one; 0 makes hard shadows.
struct SoftLight {
  Light light = {};
  double size = 0;
};

/// The ground, the plane y = 0. It mirrors `mirror` (0..1) of the light straight ahead and more
/// towards the grazing angle [Schlick94]; at `fade_distance` half of it is the horizon's colour.
struct Ground {
  Material material = {};
  SpecularModel model = kBlinnPhong;
  double mirror = 0;
  double fade_distance = 1;
};

/// The sky: a smooth gradient from the horizon up, and a soft glow.
struct Backdrop {
  Rgb zenith = {};
  Rgb horizon = {};
  double height = 1;                  // sine of the elevation where the gradient ends
  Eigen::Vector3d to_glow{0, 0, -1};  // unit
  Rgb glow = {};                      // added at its centre
  int glow_exponent = 1;              // the larger the narrower
};

/// A pinhole camera; x right, y up. The view is the size of the frame at distance 1; a picture of
/// another shape shows more than the frame, never less.
struct FrameCamera {
  Eigen::Vector3d eye{0, 0, 1};
  Eigen::Vector3d target{0, 0, 0};
  double view_width = 1;
  double view_height = 1;
};

/// Spheres on a ground plane under a sky.
struct SphereScene {
  FrameCamera camera = {};
  Backdrop backdrop = {};
  Ground ground = {};
  Rgb ambient = {};         // Ia of the sky
  Rgb ground_ambient = {};  // Ia from below
  std::vector<Sphere> spheres = {};
  std::vector<SoftLight> lights = {};
};

/// The scene of `tristim render spheres`, composed for 16:9: a grey sphere and a spiral of coloured
/// ones. The highlights reach 10, the shadows go below .001: it needs tone mapping.
SphereScene default_scene();

/// Each pixel has the same `samples` points, a (0, 2)-sequence of equal weights [Kollig02]. Of
/// those that meet the same surface at most `shaded` are shaded and stand for the others.
struct SpheresOptions {
  int width = 1280;  // 1..65536
  int height = 720;  // 1..65536
  int samples = 16;  // 1..1024
  int shaded = 4;    // 1..1024
  int threads = 0;   // 0: one for each processor; the picture is the same for any number
};

/// What render_spheres delivers, for opening its sink: 3 channels (every pixel is opaque), linear,
/// in sRGB's primaries.
PictureInfo spheres_info(const SpheresOptions& options);

/// Casts one ray a sample and shades what it meets by the scene's models; the eye is at
/// the camera (local viewer), shadows are soft, and spheres keep ambient light from each other.
///
/// Rows go to `sink` in bands; memory is bounded by the width. The caller calls sink.finish().
/// Throws std::invalid_argument for options out of range, and what the sink throws.
void render_spheres(const SphereScene& scene, const SpheresOptions& options, RowSink& sink);

}  // namespace tristim
