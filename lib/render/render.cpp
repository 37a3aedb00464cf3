#include "tristim/render/render.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

#include "lib/core/ordered_pipeline.h"
#include "lib/core/parallel.h"
#include "lib/core/trigonometry.h"
#include "lib/render/bands.h"
#include "lib/render/cross.h"
#include "lib/render/edge_lines.h"
#include "lib/render/scene_check.h"
#include "lib/render/tile_renderer.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace detail {

struct PreparedScene {
  Scene scene;
  RenderReport report;
  World world;
  std::vector<MaterialLook> looks;
  std::vector<WorldEdge> edges;  // where lines are drawn, in the last material
};

namespace {

using Eigen::Vector3d;

std::vector<DeviceVertex> device_vertices(const View& view, const FixedGrid& grid,
                                          const World& world, int threads) {
  constexpr std::size_t kPart = 4096;
  const std::size_t size = world.positions.size();
  std::vector<DeviceVertex> vertices(size);
  parallel_for_rows(static_cast<int>((size + kPart - 1) / kPart), threads, [&](int part) {
    const std::size_t first = static_cast<std::size_t>(part) * kPart;
    for (std::size_t i = first; i < std::min(first + kPart, size); ++i) {
      vertices[i] = device_vertex(view, grid, world.positions[i]);
    }
  });
  return vertices;
}

std::vector<DeviceTriangle> device_triangles(const SeenWorld& seen, const Scene& scene,
                                             int threads) {
  constexpr std::size_t kPart = 4096;
  const std::size_t size = seen.world.triangles.size();
  std::vector<std::vector<DeviceTriangle>> parts((size + kPart - 1) / kPart);
  parallel_for_rows(static_cast<int>(parts.size()), threads, [&](int part) {
    const std::size_t first = static_cast<std::size_t>(part) * kPart;
    const std::size_t last = std::min(first + kPart, size);
    add_device_triangles(seen.view, seen.grid, seen.world, seen.vertices, scene.materials,
                         static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last),
                         parts[static_cast<std::size_t>(part)]);
  });
  std::vector<DeviceTriangle> all;
  std::size_t count = 0;
  for (const auto& part : parts) count += part.size();
  all.reserve(count);
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

void check_options(const RenderOptions& options) {
  if (options.tile >= kBlock && options.tile <= 256 && options.tile % kBlock == 0) return;
  throw std::invalid_argument("tile: " + std::to_string(options.tile) +
                              "; expected 16 to 256 in steps of 16");
}

bool asks_for(const RenderOptions& options, const RenderLayer& layer) {
  return std::ranges::any_of(options.layers,
                             [&](const RenderLayer& each) { return each.name == layer.name; });
}

DataPlan data_plan(const RenderOptions& options) {
  const auto asked = [&](const RenderLayer& layer) { return asks_for(options, layer); };
  return {.geometry = asked(kNormalLayer) || asked(kPositionLayer) || asked(kDepthLayer),
          .id = asked(kIdLayer),
          .uv = asked(kUvLayer),
          .mach = asked(kMachLayer)};
}

SeenWorld seen_world(const PreparedScene& prepared, const Camera& camera, int threads) {
  const PictureSettings& picture = prepared.scene.picture;
  const View view = view_of(camera, picture.width, picture.height);
  const FixedGrid grid = fixed_grid(picture.width, picture.height);
  return {prepared.world, view, grid, device_vertices(view, grid, prepared.world, threads)};
}

Frame frame_of(const PreparedScene& prepared, const Camera& camera, const RenderOptions& options) {
  check_options(options);
  const Scene& scene = prepared.scene;
  const PictureSettings& picture = scene.picture;
  SeenWorld seen = seen_world(prepared, camera, options.threads);
  const View view = seen.view;
  const ColorPlan plan = color_plan(scene, options);
  Frame frame{.scene = scene,
              .options = options,
              .seen = std::move(seen),
              .offsets = {},
              .taps = {},
              .plan = plan,
              .data = data_plan(options),
              .layout = plane_layout(plan.channels),
              .channels = {},
              .keeps = {},
              .shader = SurfaceShader(scene, prepared.looks, view, plan),
              .triangles = {}};
  frame.triangles = device_triangles(frame.seen, scene, options.threads);
  if (!prepared.edges.empty()) {
    const auto material = static_cast<std::uint32_t>(scene.materials.size() - 1);
    add_edge_lines(frame.seen, prepared.edges, scene.edges, material, frame.triangles);
  }
  frame.offsets = sample_offsets(picture.samples, frame.seen.grid.bits);
  frame.taps = filter_taps(picture.filter, frame.offsets, frame.seen.grid.bits);
  frame.channels = channel_planes(scene, options, plan, frame.layout);
  frame.keeps.assign(static_cast<std::size_t>(frame.layout.count), 0);
  for (const int plane : frame.channels) frame.keeps[static_cast<std::size_t>(plane)] = 1;
  frame.margin = filter_margin(picture.filter) + (frame.data.mach ? 1 : 0);
  frame.has_transparent = std::ranges::any_of(scene.materials, [](const auto& material) {
    return material.transparency != Transparency::kNone;
  });
  return frame;
}

// Some rows of the picture, and the memory to draw them.
struct Band {
  explicit Band(const Frame& frame, int channels)
      : rows(frame.seen.view.width, frame.options.tile, channels), tiles(frame) {}
  int index = 0;
  Image rows;
  TileRenderer tiles;
};

class BandRenderer {
 public:
  BandRenderer(const Frame& frame, int channels)
      : frame_(frame),
        channels_(channels),
        tile_(frame.options.tile),
        count_((frame.seen.view.height + tile_ - 1) / tile_),
        lists_(StripLists::of(
            frame.triangles.size(), count_, tile_, frame.margin,
            [&](std::size_t i) { return rows_of(frame.triangles[i], frame.seen.grid.bits); })) {}

  void run(RowSink& sink) {
    const auto band = [](void* item) -> Band& { return *static_cast<Band*>(item); };
    run_ordered({.produce = [&] { return static_cast<void*>(next()); },
                 .work = [&](void* item) { draw(band(item)); },
                 .settle = [](void*) {},
                 .consume = [&](void* item) { sink.write(view(band(item))); },
                 .discard = [&](void* item) { give_back(&band(item)); }},
                frame_.options.threads);
  }

 private:
  Band* next() {
    if (next_ == count_) return nullptr;
    std::unique_ptr<Band> band;
    {
      const std::scoped_lock lock(mutex_);
      if (!free_.empty()) {
        band = std::move(free_.back());
        free_.pop_back();
      }
    }
    if (band == nullptr) band = std::make_unique<Band>(frame_, channels_);
    band->index = next_++;
    return band.release();
  }

  void give_back(Band* band) {
    const std::scoped_lock lock(mutex_);
    free_.emplace_back(band);
  }

  ImageView<float> view(Band& band) const {
    const int y0 = band.index * tile_;
    return band.rows.view().rows(0, std::min(tile_, frame_.seen.view.height - y0));
  }

  void draw(Band& band) const {
    const ImageView<float> rows = view(band);
    const std::span<const std::uint32_t> list = lists_[band.index];
    const int width = frame_.seen.view.width;
    const int tiles = (width + tile_ - 1) / tile_;
    const StripLists columns =
        StripLists::of(list.size(), tiles, tile_, frame_.margin, [&](std::size_t i) {
          return columns_of(frame_.triangles[list[i]], frame_.seen.grid.bits);
        });
    std::vector<std::uint32_t> in_tile;
    for (int t = 0; t < tiles; ++t) {
      in_tile.clear();
      for (const std::uint32_t i : columns[t]) in_tile.push_back(list[i]);
      const int x0 = t * tile_;
      band.tiles.draw(in_tile, x0, std::min(tile_, width - x0), band.index * tile_, rows);
    }
  }

  const Frame& frame_;
  int channels_;
  int tile_;
  int count_;
  StripLists lists_;
  int next_ = 0;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Band>> free_;
};

}  // namespace
}  // namespace detail

std::vector<std::string> render_channels(const Scene& scene, const RenderOptions& options) {
  std::vector<std::string> names;
  const auto add = [&](const RenderLayer& layer, const std::string& prefix) {
    if (layer.channels.empty()) names.push_back(prefix);
    const bool bare = layer.name == kBeautyLayer.name;
    for (const char letter : layer.channels) {
      names.push_back(bare ? std::string(1, letter) : prefix + "." + letter);
    }
  };
  for (const RenderLayer& layer : options.layers) {
    if (!layer.each_light) add(layer, std::string(layer.name));
    if (!layer.each_light) continue;
    for (const SceneLight& light : scene.lights) {
      add(layer, std::string(layer.name) + "." + light.name);
    }
  }
  return names;
}

PictureInfo render_info(const Scene& scene, const RenderOptions& options) {
  PictureInfo info;
  info.width = scene.picture.width;
  info.height = scene.picture.height;
  info.channels = static_cast<int>(render_channels(scene, options).size());
  if (options.xyz) info.primaries = {{1, 0}, {0, 1}, {0, 0}, {1.0 / 3, 1.0 / 3}};
  return info;
}

SceneRenderer::SceneRenderer(Scene scene) {
  detail::check_scene(scene);
  RenderReport report;
  detail::World world = detail::world_of(scene, report);
  std::vector<detail::WorldEdge> edges;
  if (scene.edges.silhouettes || scene.edges.creases) {
    edges = detail::edges_of(world);
    scene.materials.push_back(
        {.name = "edges", .model = kFlatColor, .surface = {.od = scene.edges.color}});
  }
  std::vector<detail::MaterialLook> looks = detail::looks_of(scene);
  prepared_ = std::make_unique<const detail::PreparedScene>(detail::PreparedScene{
      std::move(scene), report, std::move(world), std::move(looks), std::move(edges)});
}

SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

const Scene& SceneRenderer::scene() const noexcept { return prepared_->scene; }
const RenderReport& SceneRenderer::report() const noexcept { return prepared_->report; }

void SceneRenderer::render(const Camera& camera, const RenderOptions& options,
                           RowSink& sink) const {
  const detail::Frame frame = detail::frame_of(*prepared_, camera, options);
  const auto channels = static_cast<int>(render_channels(scene(), options).size());
  detail::BandRenderer(frame, channels).run(sink);
}

Camera orbit(const Camera& camera, int frame, int frames) {
  const double turn = 360.0 * (frame - 1) / frames;
  const detail::SineCosine angle = detail::sine_cosine_deg(turn);
  const Eigen::Vector3d axis = normalize(camera.up);
  const Eigen::Vector3d arm = camera.eye - camera.target;
  Camera turned = camera;
  turned.eye = camera.target + angle.cosine * arm + angle.sine * detail::cross(axis, arm) +
               (1 - angle.cosine) * dot(axis, arm) * axis;
  return turned;
}

}  // namespace tristim
