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

// Some rows of the picture, and the memory to draw them.
struct Band {
  int index = 0;
  Image rows;
  int width = 0, channels = 0, height = 0;  // of the rows
  TileRenderer tiles;
};

// What a frame needs room for, used again by the next one.
struct FrameMemory {
  std::vector<DeviceVertex> vertices;
  std::vector<std::vector<DeviceTriangle>> parts;
  std::vector<DeviceTriangle> triangles;
  std::vector<std::unique_ptr<Band>> bands;
};

class FramePool {
 public:
  std::unique_ptr<FrameMemory> take() {
    const std::scoped_lock lock(mutex_);
    if (free_.empty()) return std::make_unique<FrameMemory>();
    std::unique_ptr<FrameMemory> memory = std::move(free_.back());
    free_.pop_back();
    return memory;
  }
  void give_back(std::unique_ptr<FrameMemory> memory) {
    const std::scoped_lock lock(mutex_);
    free_.push_back(std::move(memory));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<FrameMemory>> free_;
};

struct PreparedScene {
  Scene scene;
  RenderReport report;
  World world;
  std::vector<MaterialLook> looks;
  std::vector<WorldEdge> edges;  // where lines are drawn, in the last material
  mutable FramePool pool = {};
};

namespace {

using Eigen::Vector3d;

void set_vertices(SeenWorld& seen, int threads) {
  constexpr std::size_t kPart = 4096;
  const auto& positions = seen.world.positions;
  seen.vertices.resize(positions.size());
  parallel_for_rows(static_cast<int>((positions.size() + kPart - 1) / kPart), threads,
                    [&](int part) {
                      const std::size_t first = static_cast<std::size_t>(part) * kPart;
                      const std::size_t last = std::min(first + kPart, positions.size());
                      for (std::size_t i = first; i < last; ++i) {
                        seen.vertices[i] = device_vertex(seen.view, seen.grid, positions[i]);
                      }
                    });
}

void set_triangles(Frame& frame, std::vector<std::vector<DeviceTriangle>>& parts, int threads) {
  constexpr std::size_t kPart = 4096;
  const SeenWorld& seen = frame.seen;
  const std::size_t size = seen.world.triangles.size();
  parts.resize((size + kPart - 1) / kPart);
  parallel_for_rows(static_cast<int>(parts.size()), threads, [&](int part) {
    const std::size_t first = static_cast<std::size_t>(part) * kPart;
    const std::size_t last = std::min(first + kPart, size);
    auto& out = parts[static_cast<std::size_t>(part)];
    out.clear();
    add_device_triangles(seen.view, seen.grid, seen.world, seen.vertices, frame.scene.materials,
                         static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last), out);
  });
  frame.triangles.clear();
  for (const auto& part : parts) {
    frame.triangles.insert(frame.triangles.end(), part.begin(), part.end());
  }
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

Frame frame_of(const PreparedScene& prepared, const Camera& camera, const RenderOptions& options,
               FrameMemory& memory) {
  check_options(options);
  const Scene& scene = prepared.scene;
  const PictureSettings& picture = scene.picture;
  const View view = view_of(camera, picture.width, picture.height);
  const ColorPlan plan = color_plan(scene, options);
  Frame frame{
      .scene = scene,
      .options = options,
      .seen = {prepared.world, view, fixed_grid(picture.width, picture.height, picture.samples),
               std::move(memory.vertices)},
      .offsets = {},
      .taps = {},
      .plan = plan,
      .data = data_plan(options),
      .layout = plane_layout(plan.channels),
      .channels = {},
      .keeps = {},
      .shader = SurfaceShader(scene, prepared.looks, view, plan),
      .triangles = std::move(memory.triangles)};
  set_vertices(frame.seen, options.threads);
  set_triangles(frame, memory.parts, options.threads);
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

class BandRenderer {
 public:
  BandRenderer(const Frame& frame, FrameMemory& memory)
      : frame_(frame),
        memory_(memory),
        tile_(frame.options.tile),
        rows_(std::max(kBlock, tile_ / 2)),
        count_((frame.seen.view.height + rows_ - 1) / rows_),
        lists_(StripLists::of(
            frame.triangles.size(), count_, rows_, frame.margin,
            [&](std::size_t i) { return rows_of(frame.triangles[i], frame.seen.grid.bits); })) {}

  void run(RowSink& sink) {
    const auto band = [](void* item) -> Band& { return *static_cast<Band*>(item); };
    run_ordered({.produce = [&] { return static_cast<void*>(next()); },
                 .work = [&](void* item) { draw(band(item)); },
                 .settle = {},
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
      if (!memory_.bands.empty()) {
        band = std::move(memory_.bands.back());
        memory_.bands.pop_back();
      }
    }
    if (band == nullptr) band = std::make_unique<Band>();
    const auto channels = static_cast<int>(frame_.channels.size());
    const int width = frame_.seen.view.width;
    if (band->width != width || band->height != rows_ || band->channels != channels) {
      band->rows = Image(width, rows_, channels);
      band->width = width;
      band->height = rows_;
      band->channels = channels;
    }
    band->index = next_++;
    return band.release();
  }

  void give_back(Band* band) {
    const std::scoped_lock lock(mutex_);
    memory_.bands.emplace_back(band);
  }

  ImageView<float> view(Band& band) const {
    const int y0 = band.index * rows_;
    return band.rows.view().rows(0, std::min(rows_, frame_.seen.view.height - y0));
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
      band.tiles.draw(frame_, in_tile, x0, std::min(tile_, width - x0), band.index * rows_, rows);
    }
  }

  const Frame& frame_;
  FrameMemory& memory_;
  int tile_;  // columns of a tile
  int rows_;  // of a band: half as many, so that its memory stays in the cache
  int count_;
  StripLists lists_;
  int next_ = 0;
  std::mutex mutex_;
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
  prepared_.reset(new detail::PreparedScene{std::move(scene), report, std::move(world),
                                            std::move(looks), std::move(edges)});
}

SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

const Scene& SceneRenderer::scene() const noexcept { return prepared_->scene; }
const RenderReport& SceneRenderer::report() const noexcept { return prepared_->report; }

void SceneRenderer::render(const Camera& camera, const RenderOptions& options,
                           RowSink& sink) const {
  std::unique_ptr<detail::FrameMemory> memory = prepared_->pool.take();
  detail::Frame frame = detail::frame_of(*prepared_, camera, options, *memory);
  detail::BandRenderer(frame, *memory).run(sink);
  memory->vertices = std::move(frame.seen.vertices);
  memory->triangles = std::move(frame.triangles);
  prepared_->pool.give_back(std::move(memory));
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
