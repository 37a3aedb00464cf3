#include <algorithm>

#include "lib/render/tile_renderer.h"

namespace tristim::detail {
namespace {

// As keep_nearer of tile_draw_simd.cpp, but what is in front of the opaque surfaces is added to a
// list.
void add_fragments(const DeviceTriangle& triangle, std::uint32_t place, int bits,
                   const SampleOffset& offset, const VisibilityPlane& opaque,
                   std::vector<Fragment>& fragments) {
  const TileRect& rect = opaque.rect;
  const auto [left, right] = std::minmax({triangle.at[0].x, triangle.at[1].x, triangle.at[2].x});
  const auto [top, bottom] = std::minmax({triangle.at[0].y, triangle.at[1].y, triangle.at[2].y});
  const PixelRange columns = pixels_between(left, right, offset.x, bits, rect.x0, rect.width);
  const PixelRange rows = pixels_between(top, bottom, offset.y, bits, rect.y0, rect.height);
  const NearnessPlane plane = nearness_plane(triangle, bits);
  const double pixel = 1.0 / static_cast<double>(std::int64_t{1} << bits);
  for (int y = rows.first; y < rows.last; ++y) {
    for (int x = columns.first; x < columns.last; ++x) {
      bool inside = true;
      for (std::size_t i = 0; i < 3; ++i) {
        inside = inside && pixel_edge(triangle, i, bits, offset, x, y).start >= 0;
      }
      if (!inside) continue;
      const auto exact = static_cast<float>(plane.at(x + offset.x * pixel, y + offset.y * pixel));
      const float nearness = std::clamp(exact, plane.least, plane.most);
      const auto at = static_cast<std::uint32_t>((y - rect.y0) * rect.width + (x - rect.x0));
      if (nearness > opaque.nearness[at]) fragments.push_back({at, place, nearness});
    }
  }
}

}  // namespace

void TileRenderer::draw_transparent(const SampleOffset& offset) {
  fragments_.clear();
  for (std::size_t i = opaque_; i < list_.size(); ++i) {
    add_fragments(frame_->triangles[list_[i]], static_cast<std::uint32_t>(i),
                  frame_->seen.grid.bits, offset, plane_, fragments_);
  }
  // From behind to the front; of equally near ones the first is in front, as among opaque ones.
  std::ranges::sort(fragments_, [](const Fragment& a, const Fragment& b) {
    if (a.pixel != b.pixel) return a.pixel < b.pixel;
    if (a.nearness != b.nearness) return a.nearness < b.nearness;
    return a.triangle > b.triangle;
  });
  run_memory_.clear();
  for (std::size_t i = 0; i < fragments_.size(); ++i) {
    const auto pixel = static_cast<int>(fragments_[i].pixel);
    run_memory_.push_back({static_cast<std::uint32_t>(i), fragments_[i].triangle,
                           rect_.x0 + pixel % rect_.width, rect_.y0 + pixel / rect_.width, 1});
  }
  fragment_colors_.resize(frame_->plan.channels, fragments_.size());
  runs_ = run_memory_;
  group_runs();
  shade_groups(offset, fragment_colors_);
  for (std::size_t i = 0; i < fragments_.size(); ++i) blend(fragments_[i], i);
}

// I = (1 - kt) I1 + kt I2, or I1 + kt Ot I2 [Shoaff 4.4], for each layer alike, so that they still
// add up. What is behind a surface shows through it in kt of the pixel.
void TileRenderer::blend(const Fragment& fragment, std::size_t i) {
  const SceneMaterial& material = frame_->scene.materials[material_of(fragment.triangle)];
  const bool filtered = material.transparency == Transparency::kFiltered;
  const TransparentSurface& surface = material.transparent;
  const double front = filtered ? 1 : 1 - surface.kt;
  const Rgb tint = filtered ? surface.tint : Rgb{1, 1, 1};
  const std::array<double, 3> behind{surface.kt * tint.r, surface.kt * tint.g, surface.kt * tint.b};
  for (int c = 0; c < frame_->plan.channels; ++c) {
    float& value = plane(c)[fragment.pixel];
    const float own = fragment_colors_.row(c)[i];
    value = static_cast<float>(front * own + behind[static_cast<std::size_t>(c % 3)] * value);
  }
  float& coverage = plane(frame_->layout.coverage)[fragment.pixel];
  coverage = static_cast<float>(1 - surface.kt * (1 - coverage));
}

}  // namespace tristim::detail
