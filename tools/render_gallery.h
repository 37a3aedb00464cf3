#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tristim/image/view.h"
#include "tristim/render/scene.h"

namespace tristim::tools {

/// One picture of a sheet, light in sRGB's primaries, 3 channels.
struct GalleryPanel {
  std::string title;
  Image picture;
};

/// Pictures that belong side by side; all of a sheet are of one size.
struct GallerySheet {
  std::string_view name;  // of its files
  std::string_view what;
  std::string_view source;
  int columns;
  std::vector<GalleryPanel> (*panels)(int threads);
};

/// Every sheet of `tristim render --gallery`.
std::span<const GallerySheet> gallery_sheets();

/// Those of scenes, and those drawn in the plane.
std::vector<GalleryPanel> lights_panels(int threads);
std::vector<GalleryPanel> shading_panels(int threads);
std::vector<GalleryPanel> phong_grid_panels(int threads);
std::vector<GalleryPanel> phong_terms_panels(int threads);
std::vector<GalleryPanel> transparency_panels(int threads);
std::vector<GalleryPanel> gooch_panels(int threads);
std::vector<GalleryPanel> silhouette_panels(int threads);
std::vector<GalleryPanel> normals_panels(int threads);
std::vector<GalleryPanel> smoothing_panels(int threads);
std::vector<GalleryPanel> corrugation_panels(int threads);
std::vector<GalleryPanel> mach_panels(int threads);
std::vector<GalleryPanel> perspective_panels(int threads);
std::vector<GalleryPanel> orientation_panels(int threads);
std::vector<GalleryPanel> junction_panels(int threads);

/// A scene drawn over an even background.
Image gallery_picture(const Scene& scene, int threads, const Rgb& background = {});

/// Makes the directory with two files for each sheet: <name>.png with titles, <name>.exr, the same
/// pictures side by side in linear light. Throws Error (kSystem) for files that are there already
/// unless `replace`.
void render_gallery(const std::string& folder, int threads, bool replace);

}  // namespace tristim::tools
