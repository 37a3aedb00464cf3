#include "tools/render_gallery.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "tools/gallery_sheet.h"
#include "tools/outputs.h"
#include "tools/progress.h"
#include "tristim/core/error.h"
#include "tristim/frame/io/write.h"
#include "tristim/image/io/exr.h"
#include "tristim/pipeline/reduce.h"

namespace tristim::tools {
namespace {

constexpr std::array kSheets{
    GallerySheet{"lights", "ambient only; with a directional, a point, a spot and an area light",
                 "[UBC]", 3, lights_panels},
    GallerySheet{"shading", "flat, Gouraud and Phong shading of coarse meshes",
                 "[Gouraud71, Phong75, UBC]", 3, shading_panels},
    GallerySheet{"phong-grid", "ks across, the exponent n down", "[Phong75]", 5, phong_grid_panels},
    GallerySheet{"phong-terms", "the terms of Phong's model under three angles of the light",
                 "[UBC]", 4, phong_terms_panels},
    GallerySheet{"transparency", "opaque, interpolated and filtered", "[Shoaff 4.4]", 3,
                 transparency_panels},
    GallerySheet{"gooch", "Phong's model, cool-to-warm tones, with silhouettes and creases",
                 "[Gooch98, UBC]", 3, gooch_panels},
    GallerySheet{"silhouettes", "smooth shading leaves the outline polygonal", "[Shoaff 4.3]", 3,
                 silhouette_panels},
    GallerySheet{"normals", "a truncated pyramid with normals of faces, and averaged in four ways",
                 "[Shoaff 4.3, Thuermer98]", 3, normals_panels},
    GallerySheet{"smoothing", "averaged normals with creases at a smoothing angle", "[Shoaff 4.3]",
                 3, smoothing_panels},
    GallerySheet{"corrugation", "averaged normals flatten folds", "[Shoaff 4.3]", 2,
                 corrugation_panels},
    GallerySheet{"mach-bands", "what the eye adds where the slope of the intensity jumps",
                 "[Mach65, Shoaff 4.1]", 2, mach_panels},
    GallerySheet{"perspective", "texture coordinates interpolated right, and along the screen",
                 "[UBC]", 2, perspective_panels},
    GallerySheet{"orientation", "one quad, interpolated while it is turned, shown turned back",
                 "[Shoaff 4.3]", 4, orientation_panels},
    GallerySheet{"t-junction", "a vertex that the neighbour does not share, and the remedy",
                 "[Shoaff 4.3]", 2, junction_panels},
};

std::string file_of(const std::string& folder, const GallerySheet& sheet, const char* extension) {
  return (std::filesystem::path(folder) / (std::string(sheet.name) + extension)).string();
}

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw Error(ErrorKind::kSystem, folder, system_message(error.value()));
}

// The panels of a sheet in one picture without words.
Image mosaic_of(const GallerySheet& sheet, std::span<const GalleryPanel> panels) {
  constexpr int kGap = 4;
  const ImageView<const float> first = panels[0].picture.view();
  const int count = static_cast<int>(panels.size());
  const int rows = (count + sheet.columns - 1) / sheet.columns;
  Image all(sheet.columns * (first.width + kGap) - kGap, rows * (first.height + kGap) - kGap, 3);
  for (int i = 0; i < count; ++i) {
    const ImageView<const float> panel = panels[static_cast<std::size_t>(i)].picture.view();
    const int left = i % sheet.columns * (first.width + kGap);
    const int top = i / sheet.columns * (first.height + kGap);
    for (int y = 0; y < panel.height; ++y) {
      const std::span<const float> row = panel.row(y);
      std::copy(row.begin(), row.end(), all.view().pixel(left, top + y));
    }
  }
  return all;
}

void write_mosaic(const std::string& path, const GallerySheet& sheet,
                  std::span<const GalleryPanel> panels, bool replace) {
  const Image mosaic = mosaic_of(sheet, panels);
  PictureInfo info;
  info.width = mosaic.view().width;
  info.height = mosaic.view().height;
  info.name = std::string(sheet.name);
  const auto sink = open_exr_sink(path, info, {.replace = replace});
  sink->write(mosaic.view());
  sink->finish();
}

void write_titled(const std::string& path, const GallerySheet& sheet,
                  std::vector<GalleryPanel> panels, bool replace) {
  std::vector<GalleryCell> cells;
  for (GalleryPanel& panel : panels) {
    const int width = panel.picture.view().width;
    cells.push_back({panel.title, {}, std::move(panel.picture), Image(width, 0, 3)});
  }
  const Raster<std::uint16_t> titled = gallery_sheet(cells, sheet.columns);
  const ImageView<const std::uint16_t> view = titled.view();
  const auto sink = open_code_sink(path, frame_info(Display{}, view.width, view.height),
                                   {.format = "png", .replace = replace});
  sink->write(view);
  sink->finish();
}

}  // namespace

std::span<const GallerySheet> gallery_sheets() { return kSheets; }

void render_gallery(const std::string& folder, int threads, bool replace) {
  std::vector<std::string> outputs;
  for (const GallerySheet& sheet : kSheets) {
    outputs.push_back(file_of(folder, sheet, ".exr"));
    outputs.push_back(file_of(folder, sheet, ".png"));
  }
  refuse_taken_outputs(outputs, replace);
  make_folder(folder);
  Progress progress(folder, static_cast<int>(kSheets.size()));
  for (const GallerySheet& sheet : kSheets) {
    std::vector<GalleryPanel> panels = sheet.panels(threads);
    write_mosaic(file_of(folder, sheet, ".exr"), sheet, panels, replace);
    write_titled(file_of(folder, sheet, ".png"), sheet, std::move(panels), replace);
    progress.advance(1);
  }
}

}  // namespace tristim::tools
