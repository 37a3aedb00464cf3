#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/render/hit_rows.h"
#include "lib/render/sample_pattern.h"
#include "lib/render/surface_shader.h"
#include "lib/render/triangle_planes.h"
#include "tristim/image/view.h"
#include "tristim/render/render.h"

namespace tristim::detail {

/// A picture on its way: what all tiles share.
struct Frame {
  const Scene& scene;
  const World& world;
  const RenderOptions& options;
  View view;
  FixedGrid grid;
  std::vector<SampleOffset> offsets;
  std::vector<std::vector<FilterTap>> taps;
  ColorPlan plan;
  SurfaceShader shader;
  std::vector<DeviceTriangle> triangles;
  bool has_transparent = false;
  bool wants_data = false;  // layers that are not filtered
  int margin = 0;           // pixels around a tile that it depends on
};

/// A place on a transparent surface in front of the opaque ones.
struct Fragment {
  std::uint32_t pixel = 0;     // of the plane
  std::uint32_t triangle = 0;  // place in the list of the tile
  float nearness = 0;
};

/// The memory of one thread, for one tile after the other.
class TileRenderer {
 public:
  explicit TileRenderer(const Frame& frame) : frame_(frame) {}

  /// Draws the pixels of `rows` from column `x0` on, `width` of them; row 0 of the view is row `y0`
  /// of the picture. `list` names the triangles that may reach the tile or its margin, in order.
  void draw(std::span<const std::uint32_t> list, int x0, int width, int y0, ImageView<float> rows);

 private:
  struct Group {
    std::size_t material;
    std::span<const HitRun> runs;
  };
  void set_list(std::span<const std::uint32_t> list);
  std::size_t material_of(std::uint32_t place) const;
  std::size_t area() const noexcept { return plane_.id.size(); }
  void make_planes(std::uint32_t place);

  // One sample of each pixel.
  void draw_sample(const SampleOffset& offset);
  void draw_transparent(const SampleOffset& offset);
  void blend(const Fragment& fragment, std::size_t i);

  // Colours of what runs see, to `out` at the runs' pixels.
  void shade_runs(const SampleOffset& offset, ColorRows& out);
  void shade_each_sample(const Group& group, const SampleOffset& offset, ColorRows& out);
  void shade_corners(const Group& group);
  void spread_corners(const HitRun& run, const SampleOffset& offset, ColorRows& out) const;

  void filter_sample(const std::vector<FilterTap>& taps);

  const Frame& frame_;
  std::vector<std::uint32_t> list_;  // opaque triangles, then transparent ones
  std::size_t opaque_ = 0;
  TileRect rect_;
  VisibilityPlane plane_;
  std::vector<HitRun> runs_;
  std::vector<HitRun> sorted_;

  // By place in the list, made when they are first needed.
  std::vector<SurfacePlanes> planes_;
  std::vector<char> has_planes_;
  std::vector<float> corners_;  // the colours where the model runs on triangles or vertices
  std::vector<CornerWeights> weights_;
  std::vector<char> has_corners_;

  HitRows hits_;
  ColorRows shaded_;
  std::vector<Fragment> fragments_;
  ColorRows fragment_colors_;
  ColorRows sample_;            // the plan's channels, then coverage
  std::vector<double> pixels_;  // likewise, filtered
};

/// How many channels a layer has.
int layer_channels(const RenderLayer& layer, std::size_t lights) noexcept;

/// Writes the layers of a tile: those of its colours from `color`, which has a plane of `rect` for
/// each channel, the others from what the pixels' centres see.
struct TileOutput {
  const Frame& frame;
  TileRect rect;
  int x0 = 0, width = 0, y0 = 0;
  ImageView<float> rows;
};
template <class T>
void write_colors(const TileOutput& output, const T* planes);
void write_data(const TileOutput& output, const VisibilityPlane& centres,
                std::span<const std::uint32_t> list);

}  // namespace tristim::detail
