#include <algorithm>

#include "lib/render/interleave.h"
#include "lib/render/tile_renderer.h"
#include "tristim/color/primaries.h"

namespace tristim::detail {
namespace {

// The number of lights as layers have it.
int parts_of(const RenderLayer& layer, const Scene& scene) {
  return layer.each_light ? static_cast<int>(scene.lights.size()) : 1;
}

// The first plane of a layer, or -1 where its channels are not one behind the other.
int first_plane(const RenderLayer& layer, const ColorPlan& plan, const PlaneLayout& layout) {
  const struct {
    const RenderLayer& layer;
    int plane;
  } planes[] = {{kAmbientLayer, plan.ambient},
                {kDiffuseLayer, plan.diffuse},
                {kSpecularLayer, plan.specular},
                {kAlbedoLayer, plan.albedo},
                {kBlinnMinusPhongLayer, plan.difference},
                {kNormalLayer, layout.normal},
                {kPositionLayer, layout.place},
                {kDepthLayer, layout.distance},
                {kIdLayer, layout.id},
                {kUvLayer, layout.uv},
                {kMachLayer, layout.mach},
                {kBeautyLayer, plan.beauty}};
  for (const auto& each : planes) {
    if (each.layer.name == layer.name) return each.plane;
  }
  return 0;
}

}  // namespace

std::vector<int> channel_planes(const Scene& scene, const RenderOptions& options,
                                const ColorPlan& plan, const PlaneLayout& layout) {
  std::vector<int> planes;
  for (const RenderLayer& layer : options.layers) {
    const int each = std::max(1, static_cast<int>(layer.channels.size()));
    const int count = each * parts_of(layer, scene);
    const int first = first_plane(layer, plan, layout);
    for (int c = 0; c < count; ++c) planes.push_back(first + c);
    if (layer.name == kBeautyLayer.name) planes.back() = layout.coverage;
  }
  return planes;
}

// Places are those from the eye so far.
void TileRenderer::place_in_world() {
  const Eigen::Vector3d& eye = frame_->seen.view.eye;
  for (int axis = 0; axis < 3; ++axis) {
    const int number = frame_->layout.place + axis;
    if (frame_->keeps[static_cast<std::size_t>(number)] == 0) continue;
    const std::span<float> row = plane(number);
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (plane_.id[i] != kNothing) row[i] = static_cast<float>(eye[axis] + double{row[i]});
    }
  }
}

void TileRenderer::draw_ids() {
  const std::span<float> ids = plane(frame_->layout.id);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    ids[i] = 0;
    if (plane_.id[i] == kNothing) continue;
    const DeviceTriangle& drawn = frame_->triangles[list_[plane_.id[i]]];
    ids[i] = static_cast<float>(frame_->seen.world.triangles[drawn.triangle].number);
  }
}

void TileRenderer::draw_uvs() {
  clear_planes(frame_->layout.uv, frame_->layout.mach);
  const std::span<float> u = plane(frame_->layout.uv);
  const std::span<float> v = plane(frame_->layout.uv + 1);
  const World& world = frame_->seen.world;
  for (const HitRun& run : runs_) {
    const DeviceTriangle& drawn = frame_->triangles[list_[run.triangle]];
    const CornerWeights weights = corner_weights(frame_->seen, drawn, frame_->scene.picture.affine);
    std::array<Uv, 3> at;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t index = world.triangles[drawn.triangle].uv[k];
      if (index != kNoIndex) at[k] = world.uvs[index];
    }
    const Plane up = weights.of(at[0].u, at[1].u, at[2].u);
    const Plane vp = weights.of(at[0].v, at[1].v, at[2].v);
    const Plane whole = weights.of(1, 1, 1);
    for (std::uint32_t i = 0; i < run.length; ++i) {
      const double across = run.x + static_cast<double>(i) + 0.5 - weights.x0;
      const double down = run.y + 0.5 - weights.y0;
      const double sum = whole.at(across, down);
      u[run.pixel + i] = static_cast<float>(up.at(across, down) / sum);
      v[run.pixel + i] = static_cast<float>(vp.at(across, down) / sum);
    }
  }
}

// As mach_bands of the whole picture.
void TileRenderer::draw_mach_bands() {
  const Eigen::RowVector3d weights = xyz_from_rgb(Primaries{}).row(1);
  const float* color = planes_.row(frame_->plan.beauty);
  const std::size_t size = area();
  std::vector<float> luminance(size);
  for (std::size_t i = 0; i < size; ++i) {
    luminance[i] = static_cast<float>(weights[0] * color[i] + weights[1] * color[i + size] +
                                      weights[2] * color[i + 2 * size]);
  }
  const auto bend = [&](std::ptrdiff_t at, std::ptrdiff_t step, int place, int length) {
    if (place <= 0 || place >= length - 1) return 0.0F;
    const float* here = luminance.data() + at;
    return 2 * here[0] - here[-step] - here[step];
  };
  const std::span<float> bands = plane(frame_->layout.mach);
  for (int y = 1; y < rect_.height - 1; ++y) {
    for (int x = 1; x < rect_.width - 1; ++x) {
      const std::ptrdiff_t at = std::ptrdiff_t{y} * rect_.width + x;
      bands[static_cast<std::size_t>(at)] =
          bend(at, 1, rect_.x0 + x, frame_->seen.view.width) +
          bend(at, rect_.width, rect_.y0 + y, frame_->seen.view.height);
    }
  }
}

void TileRenderer::use_xyz() {
  const Eigen::Matrix3d to_xyz = xyz_from_rgb(Primaries{});
  for (int first = 0; first < frame_->plan.channels; first += 3) {
    const std::span<float> r = plane(first);
    const std::span<float> g = plane(first + 1);
    const std::span<float> b = plane(first + 2);
    for (std::size_t i = 0; i < r.size(); ++i) {
      const Eigen::Vector3d xyz = to_xyz * Eigen::Vector3d(r[i], g[i], b[i]);
      r[i] = static_cast<float>(xyz.x());
      g[i] = static_cast<float>(xyz.y());
      b[i] = static_cast<float>(xyz.z());
    }
  }
}

void TileRenderer::write(int x0, int width, int y0, ImageView<float> rows) const {
  std::vector<const float*> row(frame_->channels.size());
  for (int y = 0; y < rows.height; ++y) {
    const std::ptrdiff_t at = std::ptrdiff_t{y0 + y - rect_.y0} * rect_.width + (x0 - rect_.x0);
    for (std::size_t c = 0; c < row.size(); ++c) row[c] = planes_.row(frame_->channels[c]) + at;
    interleave(row, static_cast<std::size_t>(width), rows.pixel(x0, y));
  }
}

}  // namespace tristim::detail
