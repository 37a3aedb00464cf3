// The sheets of the gallery that are scenes, changed a little from picture to picture.
#include <algorithm>
#include <array>

#include "tools/render_gallery.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/image/memory.h"
#include "tristim/light/vector.h"
#include "tristim/render/io/scene_file.h"
#include "tristim/render/mesh_normals.h"
#include "tristim/render/render.h"
#include "tristim/render/shapes.h"

namespace tristim::tools {
namespace {

constexpr Rgb kPaper{0.9, 0.88, 0.82};

// Rows of one kind of layer.
Image layer_picture(const Scene& scene, const RenderLayer& layer, int threads) {
  RenderOptions options;
  options.layers = {layer};
  options.threads = threads;
  const PictureInfo info = render_info(scene, options);
  ImageSink sink(info.width, info.height, info.channels);
  SceneRenderer(scene).render(scene.camera, options, sink);
  sink.finish();
  Image picture(info.width, info.height, info.channels);
  for (int y = 0; y < info.height; ++y) {
    std::ranges::copy(sink.image().view().row(y), picture.view().row(y).begin());
  }
  return picture;
}

Scene scene_named(const std::string& name) { return load_scene(name).scene; }

// A shape with averaged normals in the place of the scene's only mesh.
void set_shape(Scene& scene, const std::string& name, const std::vector<double>& values,
               const NormalWeighting* weighting = nullptr, double smoothing_deg = 180) {
  PolygonModel model = find_by_name(shapes(), name)->make(values);
  if (weighting != nullptr) {
    average_normals(model, *weighting, smoothing_deg);
  } else if (!has_normals(model)) {
    drop_normals(model);
  }
  scene.meshes[0] = triangulated(model);
}

std::string number(double value) { return rounded(value, 3); }

}  // namespace

Image gallery_picture(const Scene& scene, int threads, const Rgb& background) {
  const Image with_alpha = layer_picture(scene, kBeautyLayer, threads);
  const std::array<double, 3> behind{background.r, background.g, background.b};
  Image picture(with_alpha.view().width, with_alpha.view().height, 3);
  for (int y = 0; y < picture.view().height; ++y) {
    for (int x = 0; x < picture.view().width; ++x) {
      const float* from = with_alpha.view().pixel(x, y);
      float* to = picture.view().pixel(x, y);
      for (std::size_t c = 0; c < 3; ++c) {
        to[c] = static_cast<float>(from[c] + (1 - from[3]) * behind[c]);
      }
    }
  }
  return picture;
}

std::vector<GalleryPanel> lights_panels(int threads) {
  const Scene all = scene_named("solids");
  std::vector<GalleryPanel> panels;
  Scene scene = all;
  scene.lights.clear();
  panels.push_back({"ambient only", gallery_picture(scene, threads)});
  for (const SceneLight& light : all.lights) {
    scene.lights = {light};
    panels.push_back({light.name + " and ambient", gallery_picture(scene, threads)});
  }
  panels.push_back({"all together", gallery_picture(all, threads)});
  return panels;
}

std::vector<GalleryPanel> shading_panels(int threads) {
  Scene scene = scene_named("coarse");
  std::vector<GalleryPanel> panels;
  for (const Shading& shading : kShadings) {
    scene.picture.shading = shading;
    panels.push_back({std::string(shading.name), gallery_picture(scene, threads)});
  }
  return panels;
}

std::vector<GalleryPanel> phong_grid_panels(int threads) {
  Scene scene = scene_named("ball");
  Material& surface = scene.materials[0].surface;
  std::vector<GalleryPanel> panels;
  for (const double n : {2.0, 8.0, 32.0, 128.0}) {
    for (const double ks : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      surface.n = n;
      surface.ks = ks;
      panels.push_back({"ks " + number(ks) + ", n " + number(n), gallery_picture(scene, threads)});
    }
  }
  return panels;
}

std::vector<GalleryPanel> phong_terms_panels(int threads) {
  Scene scene = scene_named("ball");
  const Material surface = scene.materials[0].surface;
  Material ambient = surface;
  ambient.kd = ambient.ks = 0;
  Material diffuse = surface;
  diffuse.ka = diffuse.ks = 0;
  Material specular = surface;
  specular.ka = specular.kd = 0;
  struct Term {
    const char* name;
    Material surface;
  };
  const std::array<Term, 4> terms{
      {{"ambient", ambient}, {"diffuse", diffuse}, {"specular", specular}, {"total", surface}}};
  std::vector<GalleryPanel> panels;
  for (const double phi_deg : {60.0, 25.0, 0.0}) {
    auto& light = std::get<DirectionalLight>(scene.lights[0].source);
    light.to_light = {-cosine_deg(90 - phi_deg), 0, cosine_deg(phi_deg)};
    for (const Term& term : terms) {
      scene.materials[0].surface = term.surface;
      panels.push_back(
          {std::string(term.name) + ", phi " + number(phi_deg), gallery_picture(scene, threads)});
    }
  }
  return panels;
}

std::vector<GalleryPanel> transparency_panels(int threads) {
  Scene scene = scene_named("glass");
  struct Kind {
    const char* name;
    Transparency kind;
  };
  std::vector<GalleryPanel> panels;
  for (const Kind& kind :
       {Kind{"opaque", Transparency::kNone}, Kind{"interpolated", Transparency::kInterpolated},
        Kind{"filtered", Transparency::kFiltered}}) {
    for (SceneMaterial& material : scene.materials) {
      if (material.transparent.kt > 0) material.transparency = kind.kind;
    }
    panels.push_back({kind.name, gallery_picture(scene, threads)});
  }
  return panels;
}

std::vector<GalleryPanel> gooch_panels(int threads) {
  const Scene lines = scene_named("machine");
  Scene tones = lines;
  tones.edges = {};
  Scene phong = tones;
  for (SceneMaterial& material : phong.materials) material.model = kPhongReflection;
  std::vector<GalleryPanel> panels;
  panels.push_back({"Phong", gallery_picture(phong, threads, kPaper)});
  panels.push_back({"cool to warm", gallery_picture(tones, threads, kPaper)});
  panels.push_back({"with lines", gallery_picture(lines, threads, kPaper)});
  return panels;
}

std::vector<GalleryPanel> silhouette_panels(int threads) {
  Scene scene = scene_named("ball");
  std::vector<GalleryPanel> panels;
  for (const bool lines : {false, true}) {
    scene.edges = {.silhouettes = lines, .width = 3, .color = {0.9, 0.9, 0.2}};
    for (const double columns : {6.0, 12.0, 48.0}) {
      set_shape(scene, "sphere", {1, columns, columns / 2});
      panels.push_back({number(columns) + " columns" + (lines ? ", silhouettes" : ""),
                        gallery_picture(scene, threads)});
    }
  }
  return panels;
}

std::vector<GalleryPanel> normals_panels(int threads) {
  Scene scene = scene_named("pyramid");
  const std::vector<double> sides{4, 2, 1};
  std::vector<GalleryPanel> panels;
  set_shape(scene, "pyramid", sides);
  panels.push_back({"of the faces", gallery_picture(scene, threads)});
  for (const NormalWeighting& weighting : kNormalWeightings) {
    set_shape(scene, "pyramid", sides, &weighting);
    panels.push_back({std::string(weighting.name), gallery_picture(scene, threads)});
  }
  return panels;
}

std::vector<GalleryPanel> smoothing_panels(int threads) {
  Scene scene = scene_named("pyramid");
  scene.camera.eye = {1.5, 2.5, 5};
  scene.camera.target = {0, 0, 0};
  std::vector<GalleryPanel> panels;
  for (const double smoothing_deg : {0.0, 40.0, 180.0}) {
    set_shape(scene, "cylinder", {1, 2, 12, 1}, &kAngleNormals, smoothing_deg);
    panels.push_back({number(smoothing_deg) + " degrees", gallery_picture(scene, threads)});
  }
  return panels;
}

std::vector<GalleryPanel> corrugation_panels(int threads) {
  Scene scene = scene_named("corrugation");
  std::vector<GalleryPanel> panels;
  panels.push_back({"of the faces", gallery_picture(scene, threads)});
  set_shape(scene, "corrugation", {4, 2, 0.22, 8}, &kUniformNormals);
  panels.push_back({"averaged", gallery_picture(scene, threads)});
  return panels;
}

// The map is above 0 for bright bands and below for dark ones: grey is 0.
std::vector<GalleryPanel> mach_panels(int threads) {
  Scene scene = scene_named("coarse");
  scene.picture.samples = 1;
  std::vector<GalleryPanel> panels;
  for (const Shading& shading : {kFlatShading, kGouraudShading}) {
    scene.picture.shading = shading;
    panels.push_back({std::string(shading.name), gallery_picture(scene, threads)});
    const Image bands = layer_picture(scene, kMachLayer, threads);
    Image shown(bands.view().width, bands.view().height, 3);
    for (int y = 0; y < shown.view().height; ++y) {
      for (int x = 0; x < shown.view().width; ++x) {
        constexpr float kGrey = 0.2F;
        constexpr float kGain = 4;
        std::fill_n(shown.view().pixel(x, y), 3, kGrey + kGain * *bands.view().pixel(x, y));
      }
    }
    panels.push_back({std::string(shading.name) + ", its Mach bands", std::move(shown)});
  }
  return panels;
}

std::vector<GalleryPanel> perspective_panels(int threads) {
  Scene scene = scene_named("corrugation");
  set_shape(scene, "plane", {4, 8, 1, 1});
  scene.camera.eye = {0, 1, 4.6};
  scene.camera.target = {0, 0, 1};
  std::vector<GalleryPanel> panels;
  for (const bool affine : {false, true}) {
    scene.picture.affine = affine;
    const Image uv = layer_picture(scene, kUvLayer, threads);
    Image shown(uv.view().width, uv.view().height, 3);
    for (int y = 0; y < shown.view().height; ++y) {
      for (int x = 0; x < shown.view().width; ++x) {
        const float* at = uv.view().pixel(x, y);
        if (at[0] == 0 && at[1] == 0) continue;
        const bool light = (static_cast<int>(8 * at[0]) + static_cast<int>(16 * at[1])) % 2 == 0;
        std::fill_n(shown.view().pixel(x, y), 3, light ? 0.8F : 0.1F);
      }
    }
    panels.push_back({affine ? "along the screen" : "in perspective", std::move(shown)});
  }
  return panels;
}

}  // namespace tristim::tools
