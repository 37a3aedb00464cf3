#include "lib/render/tile_renderer.h"

#include <algorithm>

#include "tristim/light/normals.h"
#include "tristim/light/vector.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kChunk = 512;  // samples that are shaded together: they stay in the cache

double in_pixels(std::int32_t fixed, const FixedGrid& grid) noexcept {
  return fixed / static_cast<double>(std::int64_t{1} << grid.bits);
}

bool is_transparent(const Frame& frame, std::uint32_t triangle) {
  const WorldTriangle& of = frame.world.triangles[frame.triangles[triangle].triangle];
  return frame.scene.materials[of.material].transparency != Transparency::kNone;
}

// A tile with its margin, in whole blocks of pixels.
TileRect rect_around(int x0, int width, int y0, int height, int margin) {
  const auto down = [](int x) { return x - ((x % kBlock) + kBlock) % kBlock; };
  const int left = down(x0 - margin);
  const int right = down(x0 + width + margin + kBlock - 1);
  return {left, y0 - margin, right - left, height + 2 * margin};
}

}  // namespace

void TileRenderer::set_list(std::span<const std::uint32_t> list) {
  list_.assign(list.begin(), list.end());
  opaque_ = list_.size();
  if (frame_.has_transparent) {
    const auto transparent = std::stable_partition(
        list_.begin(), list_.end(), [&](std::uint32_t i) { return !is_transparent(frame_, i); });
    opaque_ = static_cast<std::size_t>(transparent - list_.begin());
  }
  planes_.resize(std::max(planes_.size(), list_.size()));
  has_planes_.assign(list_.size(), 0);
  has_corners_.assign(list_.size(), 0);
}

std::size_t TileRenderer::material_of(std::uint32_t place) const {
  return frame_.world.triangles[frame_.triangles[list_[place]].triangle].material;
}

void TileRenderer::make_planes(std::uint32_t place) {
  if (has_planes_[place] != 0) return;
  has_planes_[place] = 1;
  planes_[place] = surface_planes(frame_.view, frame_.grid, frame_.world,
                                  frame_.triangles[list_[place]], frame_.scene.picture.affine);
}

void TileRenderer::draw(std::span<const std::uint32_t> list, int x0, int width, int y0,
                        ImageView<float> rows) {
  set_list(list);
  rect_ = rect_around(x0, width, y0, rows.height, frame_.margin);
  const TileOutput output{frame_, rect_, x0, width, y0, rows};
  const bool filtered = frame_.offsets.size() > 1 || frame_.taps[0].size() > 1;
  if (frame_.plan.channels > 0) {
    const auto size = static_cast<std::size_t>(rect_.width * rect_.height);
    sample_.resize(frame_.plan.channels + 1, size);
    if (filtered) pixels_.assign(sample_.values.size(), 0);
    for (std::size_t i = 0; i < frame_.offsets.size(); ++i) {
      draw_sample(frame_.offsets[i]);
      if (filtered) filter_sample(frame_.taps[i]);
    }
    if (filtered) {
      write_colors(output, pixels_.data());
    } else {
      write_colors(output, sample_.values.data());
    }
  }
  if (!frame_.wants_data) return;
  const bool seen =
      frame_.plan.channels > 0 && frame_.offsets.size() == 1 && opaque_ == list_.size();
  if (!seen) {
    plane_.clear(rect_);
    const SampleOffset centre = sample_offsets(1, frame_.grid.bits)[0];
    draw_triangles(frame_.triangles, list_, frame_.grid.bits, centre, plane_);
  }
  write_data(output, plane_, list_);
}

void TileRenderer::draw_sample(const SampleOffset& offset) {
  plane_.clear(rect_);
  const std::span<const std::uint32_t> opaque(list_.data(), opaque_);
  draw_triangles(frame_.triangles, opaque, frame_.grid.bits, offset, plane_);
  std::ranges::fill(sample_.values, 0.0F);
  find_runs(plane_, runs_);
  shade_runs(offset, sample_);
  const std::span<float> coverage = sample_.row(frame_.plan.channels, area());
  for (std::size_t i = 0; i < coverage.size(); ++i) coverage[i] = plane_.id[i] == kNothing ? 0 : 1;
  if (opaque_ < list_.size()) draw_transparent(offset);
}

// Colours of the runs, one material after the other.
void TileRenderer::shade_runs(const SampleOffset& offset, ColorRows& out) {
  const std::size_t materials = frame_.scene.materials.size();
  std::vector<std::size_t> first(materials + 1, 0);
  for (const HitRun& run : runs_) ++first[material_of(run.triangle) + 1];
  for (std::size_t m = 0; m < materials; ++m) first[m + 1] += first[m];
  std::vector<std::size_t> next(first.begin(), first.end());
  sorted_.resize(runs_.size());
  for (const HitRun& run : runs_) sorted_[next[material_of(run.triangle)]++] = run;
  for (std::size_t m = 0; m < materials; ++m) {
    const Group group{m, {sorted_.data() + first[m], first[m + 1] - first[m]}};
    if (group.runs.empty()) continue;
    if (frame_.scene.picture.shading.name == kPhongShading.name) {
      shade_each_sample(group, offset, out);
    } else {
      shade_corners(group);
      for (const HitRun& run : group.runs) spread_corners(run, offset, out);
    }
  }
}

void TileRenderer::shade_each_sample(const Group& group, const SampleOffset& offset,
                                     ColorRows& out) {
  const HitRays rays = hit_rays(frame_.view);
  const bool facing = frame_.scene.materials[group.material].two_sided;
  hits_.resize(kChunk + static_cast<std::size_t>(rect_.width));
  shaded_.resize(frame_.plan.channels, hits_.x.size());
  for (std::size_t i = 0; i < group.runs.size();) {
    const std::size_t begin = i;
    std::size_t samples = 0;
    for (; i < group.runs.size() && samples < kChunk; ++i) {
      make_planes(group.runs[i].triangle);
      samples += group.runs[i].length;
    }
    hits_.size = 0;
    gather_hits(group.runs.subspan(begin, i - begin), planes_.data(),
                in_pixels(offset.x, frame_.grid), in_pixels(offset.y, frame_.grid), rays, facing,
                hits_);
    frame_.shader.shade(group.material, hits_.surface(), shaded_);
    for (int c = 0; c < frame_.plan.channels; ++c) {
      const float* from = shaded_.row(c);
      float* to = out.row(c, 0).data();
      for (std::size_t k = 0; k < hits_.size; ++k) to[hits_.pixel[k]] = from[k];
    }
  }
}

// The model runs at the centroids or the vertices of all triangles of a group.
void TileRenderer::shade_corners(const Group& group) {
  const bool flat = frame_.scene.picture.shading.name == kFlatShading.name;
  const auto channels = static_cast<std::size_t>(frame_.plan.channels);
  corners_.resize(std::max(corners_.size(), list_.size() * 3 * channels));
  weights_.resize(std::max(weights_.size(), list_.size()));
  std::vector<std::uint32_t> places;
  for (const HitRun& run : group.runs) {
    if (has_corners_[run.triangle] != 0) continue;
    has_corners_[run.triangle] = 1;
    places.push_back(run.triangle);
  }
  const bool facing = frame_.scene.materials[group.material].two_sided;
  hits_.resize(3 * places.size());
  hits_.size = 0;
  const auto add = [&](const Vector3d& at, Vector3d normal) {
    const Vector3d seen = at - frame_.view.eye;
    if (facing) normal = facing_normal(normal, frame_.view.orthographic ? frame_.view.back : -seen);
    const std::size_t i = hits_.size++;
    hits_.x[i] = static_cast<float>(seen.x());
    hits_.y[i] = static_cast<float>(seen.y());
    hits_.z[i] = static_cast<float>(seen.z());
    hits_.nx[i] = static_cast<float>(normal.x());
    hits_.ny[i] = static_cast<float>(normal.y());
    hits_.nz[i] = static_cast<float>(normal.z());
  };
  const World& world = frame_.world;
  for (const std::uint32_t place : places) {
    const DeviceTriangle& drawn = frame_.triangles[list_[place]];
    const WorldTriangle& triangle = world.triangles[drawn.triangle];
    const auto at = [&](std::size_t i) { return world.positions[triangle.position[i]]; };
    if (flat) {
      add((at(0) + at(1) + at(2)) / 3, face_normal(world, triangle));
      continue;
    }
    const auto normals = corner_normals(world, triangle);
    for (std::size_t i = 0; i < 3; ++i) add(at(i), normals[i]);
    weights_[place] =
        corner_weights(frame_.view, frame_.grid, world, drawn, frame_.scene.picture.affine);
  }
  shaded_.resize(frame_.plan.channels, hits_.x.size());
  frame_.shader.shade(group.material, hits_.surface(), shaded_);
  const std::size_t points = flat ? 1 : 3;
  for (std::size_t k = 0; k < hits_.size; ++k) {
    float* to = corners_.data() + (places[k / points] * 3 + k % points) * channels;
    for (std::size_t c = 0; c < channels; ++c) to[c] = shaded_.row(static_cast<int>(c))[k];
  }
}

void TileRenderer::spread_corners(const HitRun& run, const SampleOffset& offset,
                                  ColorRows& out) const {
  const auto channels = static_cast<std::size_t>(frame_.plan.channels);
  const float* a = corners_.data() + run.triangle * 3 * channels;
  const bool flat = frame_.scene.picture.shading.name == kFlatShading.name;
  const CornerWeights& weights = weights_[flat ? 0 : run.triangle];
  const double down = run.y + in_pixels(offset.y, frame_.grid) - weights.y0;
  for (std::uint32_t i = 0; i < run.length; ++i) {
    const double across =
        run.x + static_cast<double>(i) + in_pixels(offset.x, frame_.grid) - weights.x0;
    const double wa = weights.corners[0].at(across, down);
    const double wb = weights.corners[1].at(across, down);
    const double wc = weights.corners[2].at(across, down);
    const double sum = wa + wb + wc;
    for (std::size_t c = 0; c < channels; ++c) {
      const double value =
          flat ? a[c] : (wa * a[c] + wb * a[channels + c] + wc * a[2 * channels + c]) / sum;
      out.row(static_cast<int>(c), area())[run.pixel + i] = static_cast<float>(value);
    }
  }
}

void TileRenderer::filter_sample(const std::vector<FilterTap>& taps) {
  const std::size_t size = area();
  for (const FilterTap& tap : taps) {
    const int first = std::max(0, -tap.x);
    const int last = rect_.width - std::max(0, tap.x);
    for (int y = std::max(0, -tap.y); y < rect_.height - std::max(0, tap.y); ++y) {
      const std::ptrdiff_t from = std::ptrdiff_t{y} * rect_.width;
      const std::ptrdiff_t to = std::ptrdiff_t{y + tap.y} * rect_.width + tap.x;
      for (int c = 0; c <= frame_.plan.channels; ++c) {
        const float* in = sample_.row(c) + from;
        double* out = pixels_.data() + static_cast<std::size_t>(c) * size + to;
        for (int x = first; x < last; ++x) out[x] += tap.weight * in[x];
      }
    }
  }
}

}  // namespace tristim::detail
