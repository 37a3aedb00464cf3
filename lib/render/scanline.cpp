#include "tristim/render/scanline.h"

namespace tristim {

std::vector<ScanlineRow> scanline_fill(int width, int height,
                                       std::span<const GouraudVertex> polygon) {
  std::vector<Eigen::Vector2d> outline;
  for (const GouraudVertex& vertex : polygon) outline.push_back(vertex.at);
  std::vector<ScanlineRow> rows;
  for (const PixelRun& run : parity_fill(width, height, outline)) {
    const Eigen::Vector2d first(run.first + 0.5, run.y + 0.5);
    rows.push_back({run, gouraud_span(polygon, first), gouraud_row(polygon, run)});
  }
  return rows;
}

}  // namespace tristim
