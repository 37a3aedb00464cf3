// The sheets of the gallery that are drawn in the plane, by Gouraud's interpolation alone.
#include <algorithm>
#include <array>

#include "tools/render_gallery.h"
#include "tristim/core/text.h"
#include "tristim/light/vector.h"
#include "tristim/render/scanline.h"

namespace tristim::tools {
namespace {

using Eigen::Vector2d;

constexpr int kSide = 200;

void set_grey(Image& picture, int x, int y, double value) {
  std::fill_n(picture.view().pixel(x, y), 3, static_cast<float>(value));
}

void draw(Image& picture, const std::vector<GouraudVertex>& polygon) {
  const int width = picture.view().width;
  const int height = picture.view().height;
  for (const ScanlineRow& row : scanline_fill(width, height, polygon)) {
    for (int x = row.run.first; x < row.run.last; ++x) {
      set_grey(picture, x, row.run.y, row.intensity[static_cast<std::size_t>(x - row.run.first)]);
    }
  }
}

}  // namespace

std::vector<GalleryPanel> orientation_panels(int) {
  constexpr double kHairDeg = 1e-7;  // so that no edge is level
  const std::vector<Vector2d> corners{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  std::vector<GouraudVertex> quad;
  for (std::size_t i = 0; i < 4; ++i) quad.push_back({0.9 * corners[i], i % 2 == 0 ? 0.9 : 0.05});
  std::vector<Vector2d> outline;
  for (const GouraudVertex& vertex : quad) outline.push_back(vertex.at);
  std::vector<GalleryPanel> panels;
  for (const double angle_deg : {0.0, 22.5, 45.0, 67.5}) {
    Image picture(kSide, kSide, 3);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const Vector2d p((x + 0.5) * 2 / kSide - 1, 1 - (y + 0.5) * 2 / kSide);
        if (is_inside(outline, p)) {
          set_grey(picture, x, y, gouraud_turned(quad, p, angle_deg + kHairDeg));
        }
      }
    }
    panels.push_back({rounded(angle_deg, 3) + " degrees", std::move(picture)});
  }
  return panels;
}

// Two polygons above, one below whose upper edge has a vertex more or not.
std::vector<GalleryPanel> junction_panels(int) {
  const GouraudVertex left{{10, 150}, 0.15};
  const GouraudVertex middle{{150, 150}, 0.9};
  const GouraudVertex right{{290, 150}, 0.3};
  const GouraudVertex top_left{{10, 10}, 0.3};
  const GouraudVertex top{{150, 10}, 0.5};
  const GouraudVertex top_right{{290, 10}, 0.2};
  const GouraudVertex bottom_left{{10, 290}, 0.35};
  const GouraudVertex bottom_right{{290, 290}, 0.5};
  const GouraudVertex bottom{{150, 290}, 0.42};
  std::vector<GalleryPanel> panels;
  for (const bool shared : {false, true}) {
    Image picture(300, 300, 3);
    draw(picture, {top_left, top, middle, left});
    draw(picture, {top, top_right, right, middle});
    if (shared) {
      draw(picture, {left, middle, bottom, bottom_left});
      draw(picture, {middle, right, bottom_right, bottom});
    } else {
      draw(picture, {left, right, bottom_right, bottom_left});
    }
    panels.push_back({shared ? "shared by all" : "not shared below", std::move(picture)});
  }
  return panels;
}

}  // namespace tristim::tools
