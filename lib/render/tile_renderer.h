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

/// The planes of a tile, by their numbers: the colours of a ColorPlan, then what follows.
struct PlaneLayout {
  int coverage = 0;
  int normal = 0;    // three
  int place = 0;     // three
  int distance = 0;  // along the view axis
  int id = 0;
  int uv = 0;  // two
  int mach = 0;
  int count = 0;
};

constexpr PlaneLayout plane_layout(int colors) noexcept {
  return {colors,     colors + 1, colors + 4,  colors + 7,
          colors + 8, colors + 9, colors + 11, colors + 12};
}

/// Which data beside light is asked for.
struct DataPlan {
  bool geometry = false;  // normal, place, distance
  bool id = false;
  bool uv = false;
  bool mach = false;
};

/// A picture on its way: what all tiles share.
struct Frame {
  const Scene& scene;
  const RenderOptions& options;
  SeenWorld seen;
  std::vector<SampleOffset> offsets;
  std::vector<std::vector<FilterTap>> taps;
  ColorPlan plan;
  DataPlan data;
  PlaneLayout layout;
  std::vector<int> channels;  // the plane of each channel of the rows
  std::vector<char> keeps;    // for each plane whether a channel needs it
  SurfaceShader shader;
  std::vector<DeviceTriangle> triangles;
  bool has_transparent = false;
  int margin = 0;  // pixels around a tile that it depends on
};

/// For each channel of the rows its plane.
std::vector<int> channel_planes(const Scene& scene, const RenderOptions& options,
                                const ColorPlan& plan, const PlaneLayout& layout);

/// A place on a transparent surface in front of the opaque ones.
struct Fragment {
  std::uint32_t pixel = 0;     // of the plane
  std::uint32_t triangle = 0;  // place in the list of the tile
  float nearness = 0;
};

/// The memory of one thread, for one tile after the other.
class TileRenderer {
 public:
  /// Draws the pixels of `rows` from column `x0` on, `width` of them; row 0 of the view is row `y0`
  /// of the picture. `list` names the triangles that may reach the tile or its margin, in order.
  void draw(const Frame& frame, std::span<const std::uint32_t> list, int x0, int width, int y0,
            ImageView<float> rows);

 private:
  // Runs of one material.
  struct Group {
    std::size_t material;
    std::span<const HitRun> runs;
  };
  void set_list(std::span<const std::uint32_t> list);
  std::size_t area() const noexcept { return plane_.nearness.size(); }
  std::uint32_t material_of(std::uint32_t place) const {
    return frame_->triangles[list_[place]].material;
  }
  std::span<float> plane(int number) noexcept { return planes_.row(number, area()); }
  void clear_planes(int first, int last);
  void clear_geometry();
  void group_runs();
  template <class Use>
  void for_hits(const Group& group, const SampleOffset& offset, Use&& use);

  // One sample of each pixel: what is seen, in groups of runs, then its colours.
  void see(std::size_t triangles, const SampleOffset& offset);
  void draw_sample(const SampleOffset& offset);
  void draw_transparent(const SampleOffset& offset);
  void blend(const Fragment& fragment, std::size_t i);
  void shade_groups(const SampleOffset& offset, ColorRows& out);
  void shade_corners(const Group& group);
  void add_corners(const DeviceTriangle& drawn, bool flat, bool facing);
  void spread_corners(const HitRun& run, const SampleOffset& offset, ColorRows& out) const;
  void filter_sample(const std::vector<FilterTap>& taps);

  // What is known of the pixels' centres.
  void draw_data(bool seen);
  void keep_geometry();
  void place_in_world();
  void draw_ids();
  void draw_uvs();
  void draw_mach_bands();

  void use_xyz();
  void write(int x0, int width, int y0, ImageView<float> rows) const;

  const Frame* frame_ = nullptr;     // that of draw()
  std::vector<std::uint32_t> list_;  // opaque triangles, then transparent ones
  std::size_t opaque_ = 0;
  TileRect rect_;
  VisibilityPlane plane_;
  std::vector<HitRun> run_memory_;
  std::span<const HitRun> runs_;
  std::vector<HitRun> sorted_;
  std::vector<Group> groups_;
  bool keeps_geometry_ = false;

  // By place in the list, made when they are first needed.
  std::vector<SurfacePlanes> surfaces_;
  std::vector<char> has_surface_;
  std::vector<float> corners_;  // the colours where the model runs on triangles or vertices
  std::vector<CornerWeights> weights_;
  std::vector<char> has_corners_;

  HitRows hits_;
  ColorRows shaded_;
  std::vector<Fragment> fragments_;
  ColorRows fragment_colors_;
  ColorRows planes_;
  std::vector<double> filtered_;  // colours and coverage
};

}  // namespace tristim::detail
