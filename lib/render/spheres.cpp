#include "tristim/render/spheres.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

#include "lib/core/parallel.h"
#include "lib/light/power.h"
#include "lib/light/product.h"
#include "lib/render/visibility.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using detail::product;
using detail::sum;
using Eigen::Vector3d;

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kNear = 1e-9;  // a ray does not meet the surface that it starts from

struct Ray {
  Vector3d from;
  Vector3d along;  // unit
};

struct Hit {
  double distance = kFar;
  const Sphere* sphere = nullptr;  // nullptr: the ground, or nothing where the distance is infinite
};

Rgb mix(const Rgb& a, const Rgb& b, double t) noexcept {
  return sum(product(1 - t, a), product(t, b));
}

// The distance to the first crossing in front, or kFar.
double meet(const Ray& ray, const Sphere& sphere) noexcept {
  const Vector3d to_centre = sphere.centre - ray.from;
  const double middle = dot(to_centre, ray.along);
  const Vector3d across = to_centre - middle * ray.along;  // keeps its digits for a distant sphere
  const double under = sphere.radius * sphere.radius - dot(across, across);
  if (under < 0) return kFar;
  const double near = middle - std::sqrt(under);
  if (near > kNear) return near;
  return kFar;
}

Hit first_sphere(const SphereScene& scene, const Ray& ray) noexcept {
  Hit hit;
  for (const Sphere& sphere : scene.spheres) {
    const double distance = meet(ray, sphere);
    if (distance < hit.distance) hit = {distance, &sphere};
  }
  return hit;
}

Hit first_hit(const SphereScene& scene, const Ray& ray) noexcept {
  const Hit hit = first_sphere(scene, ray);
  const double to_ground = -ray.from.y() / ray.along.y();
  return to_ground > kNear && to_ground < hit.distance ? Hit{to_ground, nullptr} : hit;
}

Rgb direct_light(const SphereScene& scene, const Material& material, const SpecularModel& model,
                 const Vector3d& point, const Vector3d& normal, const Vector3d& to_eye,
                 const Sphere* self) noexcept {
  Rgb radiance;
  for (const SoftLight& light : scene.lights) {
    const Incident arriving = incident(light.light, point);
    if (!(dot(normal, arriving.to_light) > 0)) continue;
    const double visible = detail::visible_part(scene, light, arriving.to_light, point, self);
    if (visible == 0) continue;
    const Rgb reflected = direct_reflection(material, model, normal, to_eye, arriving);
    radiance = sum(radiance, product(visible, reflected));
  }
  return radiance;
}

// The part of the ground's light that a sphere's lower side gets: the ground is dark under the
// sphere.
double lit_ground(double up, const Sphere& sphere) noexcept {
  const double height = sphere.centre.y() / sphere.radius;
  const double reach = 1.5 * (1 + up) + (height - 1);
  const double squared = 1 + reach * reach;
  return 1 - 1 / (squared * std::sqrt(squared));
}

Rgb shade_sphere(const SphereScene& scene, const Sphere& sphere, const Vector3d& point,
                 const Vector3d& to_eye) noexcept {
  const Vector3d normal = normalize(point - sphere.centre);
  const double up = normal.y();
  const Rgb from_ground = product(lit_ground(up, sphere), scene.ground_ambient);
  const Rgb around = mix(from_ground, scene.ambient, (1 + up) / 2);
  const Rgb ambient = product(detail::unblocked_part(scene, point, normal, &sphere),
                              ambient_reflection(sphere.material, around));
  return sum(ambient,
             direct_light(scene, sphere.material, sphere.model, point, normal, to_eye, &sphere));
}

Rgb sky(const Backdrop& backdrop, const Vector3d& along) noexcept {
  const double t = std::clamp(along.y() / backdrop.height, 0.0, 1.0);
  const double cosine = std::max(dot(along, backdrop.to_glow), 0.0);
  const double glow = detail::integer_power(cosine, backdrop.glow_exponent);
  return sum(mix(backdrop.horizon, backdrop.zenith, t * (2 - t)), product(glow, backdrop.glow));
}

Rgb shade_ground(const SphereScene& scene, const Vector3d& point, const Vector3d& to_eye) noexcept {
  const Vector3d normal(0, 1, 0);
  const Material& material = scene.ground.material;
  const Rgb ambient = product(detail::unblocked_part(scene, point, normal, nullptr),
                              ambient_reflection(material, scene.ambient));
  return sum(ambient,
             direct_light(scene, material, scene.ground.model, point, normal, to_eye, nullptr));
}

// What the ground mirrors: spheres or the sky.
Rgb mirrored(const SphereScene& scene, const Ray& ray) noexcept {
  const Hit hit = first_sphere(scene, ray);
  if (hit.sphere == nullptr) return sky(scene.backdrop, ray.along);
  return shade_sphere(scene, *hit.sphere, ray.from + hit.distance * ray.along, -ray.along);
}

Rgb radiance_at(const SphereScene& scene, const Ray& ray, const Hit& hit) noexcept {
  if (hit.distance == kFar) return sky(scene.backdrop, ray.along);
  const Vector3d point = ray.from + hit.distance * ray.along;
  if (hit.sphere != nullptr) return shade_sphere(scene, *hit.sphere, point, -ray.along);

  const double x = hit.distance / scene.ground.fade_distance;
  const double faded = x * x * x * x / (1 + x * x * x * x);
  Rgb radiance = shade_ground(scene, point, -ray.along);
  if (scene.ground.mirror > 0) {
    const double r0 = scene.ground.mirror;
    const double c = 1 + ray.along.y();  // 1 - cosine of the view
    const double part = r0 + (1 - r0) * (c * c * c * c * c);
    const Vector3d up_again(ray.along.x(), -ray.along.y(), ray.along.z());
    radiance = mix(radiance, mirrored(scene, {point, up_again}), part);
  }
  const Vector3d level = normalize(Vector3d(ray.along.x(), 0, ray.along.z()));
  return mix(radiance, sky(scene.backdrop, level), faded);
}

// The i-th point of a (0, 2)-sequence: every power of two of points, from the first on, is spread
// evenly [Kollig02].
struct Offset {
  double x, y;
};

Offset sample_point(unsigned i) noexcept {
  unsigned x = 0;
  unsigned y = 0;
  unsigned vx = 1U << 31;
  unsigned vy = 1U << 31;
  for (; i != 0; i >>= 1, vx >>= 1, vy ^= vy >> 1) {
    if ((i & 1) == 0) continue;
    x ^= vx;
    y ^= vy;
  }
  return {x * 0x1p-32, y * 0x1p-32};
}

class Caster {
 public:
  Caster(const SphereScene& scene, const SpheresOptions& options)
      : scene_(scene), options_(options) {
    const FrameCamera& camera = scene.camera;
    forward_ = normalize(camera.target - camera.eye);
    right_ = normalize(Vector3d(-forward_.z(), 0, forward_.x()));  // forward x (0, 1, 0)
    up_ = Vector3d(right_.y() * forward_.z() - right_.z() * forward_.y(),
                   right_.z() * forward_.x() - right_.x() * forward_.z(),
                   right_.x() * forward_.y() - right_.y() * forward_.x());
    pixel_ = std::max(camera.view_width / options.width, camera.view_height / options.height);
    int cells = 1;  // the points lie at the corners of cells: half a cell on, they are centred
    while (cells < options.samples) cells *= 2;
    for (int i = 0; i < options.samples; ++i) {
      const Offset corner = sample_point(static_cast<unsigned>(i));
      offsets_.push_back({corner.x + 0.5 / cells, corner.y + 0.5 / cells});
    }
  }

  void row(int y, std::span<float> out) const {
    std::vector<Sample> samples(offsets_.size());
    std::vector<Tally> tallies(scene_.spheres.size() + 2);
    for (int x = 0; x < options_.width; ++x) {
      const Rgb radiance = pixel(x, y, samples, tallies);
      const std::size_t at = 3 * static_cast<std::size_t>(x);
      out[at] = static_cast<float>(radiance.r);
      out[at + 1] = static_cast<float>(radiance.g);
      out[at + 2] = static_cast<float>(radiance.b);
    }
  }

 private:
  struct Sample {
    Ray ray;
    Hit hit;
  };

  struct Tally {
    int met = 0;     // samples of the pixel that meet the surface
    int shaded = 0;  // of these
  };

  // Finds what each sample meets, then shades the first few that meet the same surface: they stand
  // for the rest. `tallies` are zero before and after.
  Rgb pixel(int x, int y, std::span<Sample> samples, std::span<Tally> tallies) const noexcept {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Ray toward = ray(x + offsets_[i].x, y + offsets_[i].y);
      samples[i] = {toward, first_hit(scene_, toward)};
      ++tallies[surface(samples[i].hit)].met;
    }
    Rgb total;
    for (const Sample& sample : samples) {
      Tally& tally = tallies[surface(sample.hit)];
      const int most = std::min(tally.met, options_.shaded);
      if (tally.shaded == most) continue;
      ++tally.shaded;
      const double weight = double(tally.met) / most / options_.samples;
      total = sum(total, product(weight, radiance_at(scene_, sample.ray, sample.hit)));
    }
    for (const Sample& sample : samples) tallies[surface(sample.hit)] = {};
    return total;
  }

  // The sphere's position in the scene; behind the last one come ground and sky.
  std::size_t surface(const Hit& hit) const noexcept {
    const std::size_t spheres = scene_.spheres.size();
    if (hit.sphere != nullptr) return static_cast<std::size_t>(hit.sphere - scene_.spheres.data());
    return hit.distance == kFar ? spheres + 1 : spheres;
  }

  Ray ray(double x, double y) const noexcept {
    const double across = (x - 0.5 * options_.width) * pixel_;
    const double above = (0.5 * options_.height - y) * pixel_;
    return {scene_.camera.eye, normalize(forward_ + across * right_ + above * up_)};
  }

  const SphereScene& scene_;
  SpheresOptions options_;
  Vector3d forward_, right_, up_;
  double pixel_ = 0;  // side of a pixel at distance 1
  std::vector<Offset> offsets_;
};

void check(const char* what, int value, int most) {
  if (value >= 1 && value <= most) return;
  throw std::invalid_argument(std::string(what) + " is " + std::to_string(value) +
                              ", expected 1 to " + std::to_string(most));
}

}  // namespace

PictureInfo spheres_info(const SpheresOptions& options) {
  PictureInfo info;
  info.width = options.width;
  info.height = options.height;
  info.name = "spheres";
  return info;
}

void render_spheres(const SphereScene& scene, const SpheresOptions& options, RowSink& sink) {
  check("width", options.width, 65536);
  check("height", options.height, 65536);
  check("samples", options.samples, 1024);
  check("shaded", options.shaded, 1024);
  constexpr int kBandRows = 64;  // enough for the threads to share, few to hold
  const Caster caster(scene, options);
  Image band(options.width, std::min(kBandRows, options.height), 3);
  for (int y0 = 0; y0 < options.height; y0 += kBandRows) {
    const ImageView<float> rows = band.view().rows(0, std::min(kBandRows, options.height - y0));
    detail::parallel_for_rows(rows.height, options.threads,
                              [&](int y) { caster.row(y0 + y, rows.row(y)); });
    sink.write(rows);
  }
}

}  // namespace tristim
