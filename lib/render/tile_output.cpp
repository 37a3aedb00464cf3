#include <algorithm>
#include <cmath>

#include "lib/render/tile_renderer.h"
#include "tristim/color/primaries.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

// The places of a layer's pixels in the planes of the tile and in the rows of the picture.
template <class Use>
void for_pixels(const TileOutput& output, Use&& use) {
  for (int y = 0; y < output.rows.height; ++y) {
    const int row = (output.y0 + y - output.rect.y0) * output.rect.width;
    for (int x = 0; x < output.width; ++x) {
      use(row + (output.x0 + x - output.rect.x0), output.x0 + x, output.y0 + y,
          output.rows.pixel(output.x0 + x, y));
    }
  }
}

template <class T>
void copy_plane(const TileOutput& output, const T* plane, int channel) {
  const int channels = output.rows.channels;
  for (int y = 0; y < output.rows.height; ++y) {
    const T* from =
        plane + (output.y0 + y - output.rect.y0) * output.rect.width + (output.x0 - output.rect.x0);
    float* to = output.rows.pixel(output.x0, y) + channel;
    for (int x = 0; x < output.width; ++x)
      to[std::ptrdiff_t{x} * channels] = static_cast<float>(from[x]);
  }
}

template <class T>
void copy_color(const TileOutput& output, const T* planes, int channel) {
  const std::ptrdiff_t size = std::ptrdiff_t{output.rect.width} * output.rect.height;
  if (!output.frame.options.xyz) {
    for (int c = 0; c < 3; ++c) copy_plane(output, planes + c * size, channel + c);
    return;
  }
  static const Eigen::Matrix3d to_xyz = xyz_from_rgb(Primaries{});
  for_pixels(output, [&](int at, int, int, float* pixel) {
    const Vector3d xyz = to_xyz * Vector3d(planes[at], planes[at + size], planes[at + 2 * size]);
    for (int c = 0; c < 3; ++c) pixel[channel + c] = static_cast<float>(xyz[c]);
  });
}

// As mach_bands of the whole picture.
template <class T>
void write_mach_bands(const TileOutput& output, const T* beauty, int channel) {
  static const Eigen::RowVector3d weights = xyz_from_rgb(Primaries{}).row(1);
  const int stride = output.rect.width;
  const std::ptrdiff_t size = std::ptrdiff_t{stride} * output.rect.height;
  const auto luminance = [&](int at) {
    return static_cast<float>(weights[0] * beauty[at] + weights[1] * beauty[at + size] +
                              weights[2] * beauty[at + 2 * size]);
  };
  const auto bend = [&](int at, int step, int place, int length) {
    if (place == 0 || place == length - 1) return 0.0F;
    return 2 * luminance(at) - luminance(at - step) - luminance(at + step);
  };
  const View& view = output.frame.view;
  for_pixels(output, [&](int at, int x, int y, float* pixel) {
    pixel[channel] = bend(at, 1, x, view.width) + bend(at, stride, y, view.height);
  });
}

// What is known of the surface at the centre of a pixel.
struct Seen {
  float id = 0, z = 0;
  Vector3d place{0, 0, 0}, normal{0, 0, 0};
  Uv uv = {};
};

Uv uv_at(const Frame& frame, const DeviceTriangle& drawn, double x, double y) {
  const WorldTriangle& triangle = frame.world.triangles[drawn.triangle];
  const CornerWeights weights =
      corner_weights(frame.view, frame.grid, frame.world, drawn, frame.scene.picture.affine);
  double u = 0;
  double v = 0;
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = weights.corners[i].at(x - weights.x0, y - weights.y0);
    const Uv uv = triangle.uv[i] == kNoIndex ? Uv{} : frame.world.uvs[triangle.uv[i]];
    u += part * uv.u;
    v += part * uv.v;
    sum += part;
  }
  return {static_cast<float>(u / sum), static_cast<float>(v / sum)};
}

Seen seen_at(const Frame& frame, const DeviceTriangle& drawn, const SurfacePlanes& planes, double x,
             double y) {
  const WorldTriangle& triangle = frame.world.triangles[drawn.triangle];
  const double across = x - planes.x0;
  const double down = y - planes.y0;
  const double nearness = planes.nearness.at(across, down);
  const double distance = frame.view.orthographic ? nearness : 1 / nearness;
  const ViewRay ray = view_ray(frame.view, x, y);
  Seen seen;
  seen.id = static_cast<float>(triangle.number);
  seen.z = static_cast<float>(distance);
  const Vector3d from_eye = ray.from + distance * ray.along;
  seen.place = frame.view.eye + from_eye;
  seen.normal =
      Vector3d(planes.nx.at(across, down), planes.ny.at(across, down), planes.nz.at(across, down));
  seen.normal = seen.normal / std::sqrt(seen.normal.squaredNorm());
  const Vector3d& away = frame.view.orthographic ? ray.along : from_eye;
  const bool turned =
      frame.scene.materials[triangle.material].two_sided && seen.normal.dot(away) > 0;
  if (turned) seen.normal = -seen.normal;
  return seen;
}

// Where each layer that is not filtered starts in a pixel, or -1.
struct DataChannels {
  int normal = -1, place = -1, z = -1, id = -1, uv = -1;
};

DataChannels data_channels(const RenderOptions& options, std::size_t lights) {
  DataChannels at;
  int next = 0;
  for (const RenderLayer& layer : options.layers) {
    if (layer.name == kNormalLayer.name) at.normal = next;
    if (layer.name == kPositionLayer.name) at.place = next;
    if (layer.name == kDepthLayer.name) at.z = next;
    if (layer.name == kIdLayer.name) at.id = next;
    if (layer.name == kUvLayer.name) at.uv = next;
    next += layer_channels(layer, lights);
  }
  return at;
}

void put(float* pixel, int channel, const Vector3d& v) {
  if (channel < 0) return;
  for (int i = 0; i < 3; ++i) pixel[channel + i] = static_cast<float>(v[i]);
}

void put_seen(float* pixel, const DataChannels& to, const Seen& seen) {
  put(pixel, to.normal, seen.normal);
  put(pixel, to.place, seen.place);
  if (to.z >= 0) pixel[to.z] = seen.z;
  if (to.id >= 0) pixel[to.id] = seen.id;
  if (to.uv >= 0) pixel[to.uv] = seen.uv.u;
  if (to.uv >= 0) pixel[to.uv + 1] = seen.uv.v;
}

}  // namespace

int layer_channels(const RenderLayer& layer, std::size_t lights) noexcept {
  const int each = layer.channels.empty() ? 1 : static_cast<int>(layer.channels.size());
  return layer.each_light ? each * static_cast<int>(lights) : each;
}

template <class T>
void write_colors(const TileOutput& output, const T* planes) {
  const Frame& frame = output.frame;
  const ColorPlan& plan = frame.plan;
  const std::ptrdiff_t size = std::ptrdiff_t{output.rect.width} * output.rect.height;
  const auto lights = static_cast<int>(frame.scene.lights.size());
  const auto color = [&](int from, int channel) {
    copy_color(output, planes + from * size, channel);
  };
  int next = 0;
  for (const RenderLayer& layer : frame.options.layers) {
    if (layer.name == kBeautyLayer.name) {
      color(plan.beauty, next);
      copy_plane(output, planes + plan.channels * size, next + 3);
    }
    if (layer.name == kAmbientLayer.name) color(plan.ambient, next);
    if (layer.name == kAlbedoLayer.name) color(plan.albedo, next);
    if (layer.name == kBlinnMinusPhongLayer.name) color(plan.difference, next);
    for (int i = 0; i < lights; ++i) {
      if (layer.name == kDiffuseLayer.name) color(plan.diffuse + 3 * i, next + 3 * i);
      if (layer.name == kSpecularLayer.name) color(plan.specular + 3 * i, next + 3 * i);
    }
    if (layer.name == kMachLayer.name) {
      write_mach_bands(output, planes + plan.beauty * size, next);
    }
    next += layer_channels(layer, frame.scene.lights.size());
  }
}

template void write_colors(const TileOutput& output, const float* planes);
template void write_colors(const TileOutput& output, const double* planes);

void write_data(const TileOutput& output, const VisibilityPlane& centres,
                std::span<const std::uint32_t> list) {
  const Frame& frame = output.frame;
  const DataChannels to = data_channels(frame.options, frame.scene.lights.size());
  std::uint32_t last = kNothing;
  SurfacePlanes planes;
  for_pixels(output, [&](int at, int x, int y, float* pixel) {
    const std::uint32_t place = centres.id[static_cast<std::size_t>(at)];
    if (place == kNothing) return put_seen(pixel, to, {});
    const DeviceTriangle& drawn = frame.triangles[list[place]];
    if (place != last) {
      planes =
          surface_planes(frame.view, frame.grid, frame.world, drawn, frame.scene.picture.affine);
    }
    last = place;
    Seen seen = seen_at(frame, drawn, planes, x + 0.5, y + 0.5);
    if (to.uv >= 0) seen.uv = uv_at(frame, drawn, x + 0.5, y + 0.5);
    put_seen(pixel, to, seen);
  });
}

}  // namespace tristim::detail
