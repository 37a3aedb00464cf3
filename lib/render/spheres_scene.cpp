#include <array>
#include <cmath>

#include "tristim/light/vector.h"
#include "tristim/render/spheres.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

constexpr AttenuationKind kInverseSquare = kAttenuations[1];

// Twelve hues round the wheel, near the edge of sRGB's gamut.
constexpr std::array kHues{
    Rgb{0.92, 0.02, 0.02}, Rgb{0.95, 0.22, 0.01}, Rgb{0.95, 0.55, 0.01}, Rgb{0.92, 0.86, 0.02},
    Rgb{0.30, 0.75, 0.02}, Rgb{0.02, 0.60, 0.06}, Rgb{0.01, 0.60, 0.38}, Rgb{0.01, 0.48, 0.80},
    Rgb{0.01, 0.13, 0.85}, Rgb{0.12, 0.02, 0.80}, Rgb{0.45, 0.01, 0.75}, Rgb{0.88, 0.01, 0.40},
};

Sphere coloured(const Vector3d& centre, double radius, std::size_t i) {
  const bool sharp = i % 2 == 0;
  return {.centre = centre,
          .radius = radius,
          .material = {.ka = 0.9,
                       .kd = 0.17,
                       .ks = 0.85,
                       .n = sharp ? 220.0 : 90.0,
                       .od = kHues[i % kHues.size()]},
          .model = sharp ? kBlinnPhong : kPhong};
}

// A spiral of spheres, each touching the next: a grey one, then the hues, ever smaller. Turns are
// written as cosine and sine because the C library's differ between processors.
std::vector<Sphere> spiral() {
  constexpr double kShrink = 0.86;
  constexpr int kColoured = 30;
  constexpr int kWide = 9;  // the first turns are wide, the rest tighter
  struct Turn {
    double cosine, sine;
  };
  constexpr Turn kWideTurn{0.8960524975255252, 0.4439481069655198};   // .46 rad
  constexpr Turn kTightTurn{0.9210609940028851, 0.3894183423086505};  // .40 rad

  double radius = 1.22;
  Vector3d centre(-3.05, radius, -1.6);
  Vector3d heading(0.9130889403123083, 0, -0.4077604530595702);  // .42 rad away from the eye
  std::vector<Sphere> spheres{
      {.centre = centre,
       .radius = radius,
       .material = {.ka = 0.9, .kd = 0.16, .ks = 0.5, .n = 60, .od = {0.36, 0.36, 0.36}},
       .model = kPhong}};
  for (int i = 0; i < kColoured; ++i) {
    const double next = radius * kShrink;
    centre +=
        2 * std::sqrt(radius * next) * heading;  // spheres on one plane touch at this distance
    centre.y() = next;
    radius = next;
    spheres.push_back(coloured(centre, radius, static_cast<std::size_t>(i)));
    const Turn& turn = i < kWide ? kWideTurn : kTightTurn;
    heading = Vector3d(turn.cosine * heading.x() - turn.sine * heading.z(), 0,
                       turn.sine * heading.x() + turn.cosine * heading.z());
  }
  return spheres;
}

std::vector<SoftLight> three_lights() {
  const PointLight warm_key{.position = {-7, 9, 6.5},
                            .intensity = {2100, 1850, 1500},
                            .attenuation = {.kind = kInverseSquare}};
  const DirectionalLight blue_rim{.to_light = {0.75, 0.42, -0.6}, .intensity = {1.4, 3.2, 7}};
  const PointLight pink_fill{.position = {4.6, 2.2, 7},
                             .intensity = {75, 12, 48},
                             .attenuation = {.kind = kInverseSquare}};
  return {{warm_key, 0.8}, {blue_rim, 0.06}, {pink_fill, 0.4}};
}

}  // namespace

SphereScene default_scene() {
  return {.camera = {.eye = {0, 4.2, 12.5},
                     .target = {0, 0.55, 0},
                     .view_width = 0.73,
                     .view_height = 0.73 * 9 / 16},
          .backdrop = {.zenith = {0.01, 0.025, 0.10},
                       .horizon = {0.03, 0.065, 0.19},
                       .height = 0.22,
                       .to_glow = normalize(Vector3d(-0.27, -0.02, -1)),
                       .glow = {1.25, 0.52, 0.15},
                       .glow_exponent = 70},
          .ground =
              {.material = {.ka = 0.8, .kd = 0.045, .ks = 0.02, .n = 24, .od = {0.27, 0.31, 0.42}},
               .model = kBlinnPhong,
               .mirror = 0.10,
               .fade_distance = 15},
          .ambient = {0.07, 0.09, 0.16},
          .ground_ambient = {0.09, 0.08, 0.09},
          .spheres = spiral(),
          .lights = three_lights()};
}

}  // namespace tristim
