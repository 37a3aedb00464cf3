#include "lib/render/tile_renderer.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "tristim/light/normals.h"
#include "tristim/light/vector.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kChunk = 512;  // samples that are shaded together: they stay in the cache

double in_pixels(std::int32_t fixed, const FixedGrid& grid) noexcept {
  return fixed / static_cast<double>(std::int64_t{1} << grid.bits);
}

// A tile with its margin, in whole blocks of pixels.
TileRect rect_around(int x0, int width, int y0, int height, int margin) {
  const auto down = [](int x) { return x - ((x % kBlock) + kBlock) % kBlock; };
  const int left = down(x0 - margin);
  const int right = down(x0 + width + margin + kBlock - 1);
  return {left, y0 - margin, right - left, height + 2 * margin};
}

// Values of hits to the pixels that they belong to.
void scatter(const HitRows& hits, const float* from, float* to) {
  constexpr std::uint32_t kAll = (1U << kBlock) - 1;
  for (std::size_t b = 0; b < hits.size / kBlock; ++b, from += kBlock) {
    const HitBlock& block = hits.blocks[b];
    float* pixel = to + block.pixel;
    if (block.lanes == kAll) {
      std::memcpy(pixel, from, kBlock * sizeof(float));
      continue;
    }
    for (std::uint32_t left = block.lanes; left != 0; left &= left - 1) {
      const auto lane = std::countr_zero(left);
      pixel[lane] = from[lane];
    }
  }
}

}  // namespace

void TileRenderer::set_list(std::span<const std::uint32_t> list) {
  list_.assign(list.begin(), list.end());
  opaque_ = list_.size();
  if (frame_->has_transparent) {
    const auto transparent =
        std::stable_partition(list_.begin(), list_.end(), [&](std::uint32_t i) {
          const SceneMaterial& material = frame_->scene.materials[frame_->triangles[i].material];
          return material.transparency == Transparency::kNone;
        });
    opaque_ = static_cast<std::size_t>(transparent - list_.begin());
  }
  surfaces_.resize(std::max(surfaces_.size(), list_.size()));
  has_surface_.assign(list_.size(), 0);
  has_corners_.assign(list_.size(), 0);
}

void TileRenderer::draw(const Frame& frame, std::span<const std::uint32_t> list, int x0, int width,
                        int y0, ImageView<float> rows) {
  frame_ = &frame;
  if (list.empty()) {
    for (int y = 0; y < rows.height; ++y) {
      std::fill_n(rows.pixel(x0, y), width * rows.channels, 0.0F);
    }
    return;
  }
  set_list(list);
  rect_ = rect_around(x0, width, y0, rows.height, frame_->margin);
  const auto size = static_cast<std::size_t>(rect_.width) * static_cast<std::size_t>(rect_.height);
  planes_.resize(frame_->layout.count, size);
  const bool filtered = frame_->offsets.size() > 1 || frame_->taps[0].size() > 1;
  const auto colors = static_cast<std::size_t>(frame_->plan.channels + 1);
  if (filtered) filtered_.assign(colors * size, 0);
  const DataPlan& data = frame_->data;
  const bool centres = frame_->offsets.size() == 1 && opaque_ == list_.size();
  keeps_geometry_ = centres && data.geometry;
  if (keeps_geometry_) clear_geometry();
  for (std::size_t i = 0; i < frame_->offsets.size() && frame_->plan.channels > 0; ++i) {
    draw_sample(frame_->offsets[i]);
    if (filtered) filter_sample(frame_->taps[i]);
  }
  if (filtered) std::copy_n(filtered_.begin(), filtered_.size(), planes_.values.begin());
  if (data.mach) draw_mach_bands();
  if (data.geometry || data.id || data.uv) draw_data(centres && frame_->plan.channels > 0);
  if (frame_->options.xyz) use_xyz();
  write(x0, width, y0, rows);
}

void TileRenderer::clear_planes(int first, int last) {
  const auto begin = planes_.values.begin();
  const auto size = static_cast<std::ptrdiff_t>(planes_.capacity);
  std::fill(begin + first * size, begin + last * size, 0.0F);
}

void TileRenderer::clear_geometry() {
  for (int p = frame_->layout.normal; p < frame_->layout.id; ++p) {
    if (frame_->keeps[static_cast<std::size_t>(p)] != 0) clear_planes(p, p + 1);
  }
}

void TileRenderer::see(std::size_t triangles, const SampleOffset& offset) {
  plane_.clear(rect_);
  draw_triangles(frame_->triangles, {list_.data(), triangles}, frame_->seen.grid.bits, offset,
                 plane_);
  const std::size_t count = find_runs(plane_, run_memory_);
  runs_ = {run_memory_.data(), count};
  group_runs();
}

void TileRenderer::draw_sample(const SampleOffset& offset) {
  see(opaque_, offset);
  clear_planes(0, frame_->layout.coverage);
  shade_groups(offset, planes_);
  const std::span<float> coverage = plane(frame_->layout.coverage);
  for (std::size_t i = 0; i < coverage.size(); ++i) coverage[i] = plane_.id[i] == kNothing ? 0 : 1;
  if (opaque_ < list_.size()) draw_transparent(offset);
}

// One material after the other, each in the order of rows.
void TileRenderer::group_runs() {
  const std::size_t materials = frame_->scene.materials.size();
  groups_.clear();
  if (materials == 1) {
    if (!runs_.empty()) groups_.push_back({0, runs_});
    return;
  }
  std::vector<std::size_t> next(materials + 1, 0);
  for (const HitRun& run : runs_) ++next[material_of(run.triangle) + 1];
  for (std::size_t m = 0; m < materials; ++m) next[m + 1] += next[m];
  sorted_.resize(runs_.size());
  for (std::size_t m = 0; m < materials; ++m) {
    const std::span<const HitRun> runs(sorted_.data() + next[m], next[m + 1] - next[m]);
    if (!runs.empty()) groups_.push_back({m, runs});
  }
  for (const HitRun& run : runs_) sorted_[next[material_of(run.triangle)]++] = run;
}

// Calls use() for all samples of a group, some at a time in `hits_`.
template <class Use>
void TileRenderer::for_hits(const Group& group, const SampleOffset& offset, Use&& use) {
  const SeenWorld& seen = frame_->seen;
  const HitRays rays = hit_rays(seen.view);
  const bool facing = frame_->scene.materials[group.material].two_sided;
  hits_.resize(kChunk + kBlock);
  for (std::size_t i = 0; i < group.runs.size();) {
    const std::size_t begin = i;
    std::uint32_t block = kNothing;
    for (std::size_t samples = 0; i < group.runs.size(); ++i) {
      const HitRun& run = group.runs[i];
      if (run.pixel / kBlock != block) samples += kBlock;
      if (samples > kChunk) break;
      block = run.pixel / kBlock;
      if (has_surface_[run.triangle] != 0) continue;
      has_surface_[run.triangle] = 1;
      surfaces_[run.triangle] = surface_planes(seen, frame_->triangles[list_[run.triangle]],
                                               frame_->scene.picture.affine);
    }
    gather_hits({group.runs.subspan(begin, i - begin), surfaces_.data(),
                 in_pixels(offset.x, seen.grid), in_pixels(offset.y, seen.grid), rays, facing},
                hits_);
    use();
  }
}

void TileRenderer::shade_groups(const SampleOffset& offset, ColorRows& out) {
  for (const Group& group : groups_) {
    if (frame_->scene.picture.shading.name != kPhongShading.name) {
      shade_corners(group);
      for (const HitRun& run : group.runs) spread_corners(run, offset, out);
      if (keeps_geometry_) for_hits(group, offset, [&] { keep_geometry(); });
      continue;
    }
    for_hits(group, offset, [&] {
      shaded_.resize(frame_->plan.channels, hits_.x.size());
      frame_->shader.shade(group.material, hits_.surface(), shaded_);
      for (int c = 0; c < frame_->plan.channels; ++c) {
        scatter(hits_, shaded_.row(c), out.row(c, 0).data());
      }
      if (keeps_geometry_) keep_geometry();
    });
  }
}

void TileRenderer::keep_geometry() {
  const PlaneLayout& to = frame_->layout;
  const std::array<std::pair<int, const std::vector<float>*>, 7> rows{
      {{to.normal, &hits_.nx},
       {to.normal + 1, &hits_.ny},
       {to.normal + 2, &hits_.nz},
       {to.place, &hits_.x},
       {to.place + 1, &hits_.y},
       {to.place + 2, &hits_.z},
       {to.distance, &hits_.distance}}};
  for (const auto& [number, row] : rows) {
    if (frame_->keeps[static_cast<std::size_t>(number)] != 0) {
      scatter(hits_, row->data(), plane(number).data());
    }
  }
}

void TileRenderer::draw_data(bool seen) {
  const SampleOffset centre = sample_offsets(1, frame_->seen.grid.bits)[0];
  if (!seen) see(list_.size(), centre);
  if (frame_->data.geometry && !(seen && keeps_geometry_)) {
    clear_geometry();
    for (const Group& group : groups_) for_hits(group, centre, [&] { keep_geometry(); });
  }
  if (frame_->data.geometry) place_in_world();
  if (frame_->data.id) draw_ids();
  if (frame_->data.uv) draw_uvs();
}

// The model runs at the centroids or the vertices of all triangles of a group.
void TileRenderer::shade_corners(const Group& group) {
  const bool flat = frame_->scene.picture.shading.name == kFlatShading.name;
  const auto channels = static_cast<std::size_t>(frame_->plan.channels);
  corners_.resize(std::max(corners_.size(), list_.size() * 3 * channels));
  weights_.resize(std::max(weights_.size(), list_.size()));
  std::vector<std::uint32_t> places;
  for (const HitRun& run : group.runs) {
    if (has_corners_[run.triangle] != 0) continue;
    has_corners_[run.triangle] = 1;
    places.push_back(run.triangle);
  }
  const bool facing = frame_->scene.materials[group.material].two_sided;
  hits_.resize(3 * places.size());
  hits_.size = 0;
  for (const std::uint32_t place : places) {
    const DeviceTriangle& drawn = frame_->triangles[list_[place]];
    add_corners(drawn, flat, facing);
    if (!flat) weights_[place] = corner_weights(frame_->seen, drawn, frame_->scene.picture.affine);
  }
  shaded_.resize(frame_->plan.channels, hits_.x.size());
  frame_->shader.shade(group.material, hits_.surface(), shaded_);
  const std::size_t points = flat ? 1 : 3;
  for (std::size_t k = 0; k < hits_.size; ++k) {
    float* to = corners_.data() + (places[k / points] * 3 + k % points) * channels;
    for (std::size_t c = 0; c < channels; ++c) to[c] = shaded_.row(static_cast<int>(c))[k];
  }
}

void TileRenderer::add_corners(const DeviceTriangle& drawn, bool flat, bool facing) {
  const View& view = frame_->seen.view;
  const World& world = frame_->seen.world;
  const auto add = [&](const Vector3d& at, Vector3d normal) {
    const Vector3d seen = at - view.eye;
    if (facing) normal = facing_normal(normal, view.orthographic ? view.back : -seen);
    const std::size_t i = hits_.size++;
    hits_.x[i] = static_cast<float>(seen.x());
    hits_.y[i] = static_cast<float>(seen.y());
    hits_.z[i] = static_cast<float>(seen.z());
    hits_.nx[i] = static_cast<float>(normal.x());
    hits_.ny[i] = static_cast<float>(normal.y());
    hits_.nz[i] = static_cast<float>(normal.z());
  };
  const WorldTriangle& triangle = world.triangles[drawn.triangle];
  const auto at = [&](std::size_t i) -> const Vector3d& {
    return world.positions[triangle.position[i]];
  };
  if (flat) return add((at(0) + at(1) + at(2)) / 3, face_normal(world, triangle));
  const auto normals = corner_normals(world, triangle);
  for (std::size_t i = 0; i < 3; ++i) add(at(i), normals[i]);
}

void TileRenderer::spread_corners(const HitRun& run, const SampleOffset& offset,
                                  ColorRows& out) const {
  const auto channels = static_cast<std::size_t>(frame_->plan.channels);
  const float* a = corners_.data() + run.triangle * 3 * channels;
  const bool flat = frame_->scene.picture.shading.name == kFlatShading.name;
  const CornerWeights& weights = weights_[flat ? 0 : run.triangle];
  const double down = run.y + in_pixels(offset.y, frame_->seen.grid) - weights.y0;
  for (std::uint32_t i = 0; i < run.length; ++i) {
    const double across =
        run.x + static_cast<double>(i) + in_pixels(offset.x, frame_->seen.grid) - weights.x0;
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
      for (int c = 0; c <= frame_->layout.coverage; ++c) {
        const float* in = planes_.row(c) + from;
        double* out = filtered_.data() + static_cast<std::size_t>(c) * size + to;
        for (int x = first; x < last; ++x) out[x] += tap.weight * in[x];
      }
    }
  }
}

}  // namespace tristim::detail
