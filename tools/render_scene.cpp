#include "tools/render_scene.h"

#include <stdexcept>
#include <vector>

#include "tools/cli.h"
#include "tools/outputs.h"
#include "tools/progress.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/image/io/exr.h"
#include "tristim/render/io/scene_file.h"

namespace tristim::tools {
namespace {

// Rows on their way to a file, counted.
class CountedSink final : public RowSink {
 public:
  CountedSink(RowSink& to, Progress& progress) : to_(to), progress_(progress) {}
  void write(ImageView<const float> rows) override {
    to_.write(rows);
    progress_.advance(rows.height);
  }
  void finish() override { to_.finish(); }

 private:
  RowSink& to_;
  Progress& progress_;
};

void apply(const RenderSceneOptions& options, PictureSettings& picture) {
  picture.width = options.width.value_or(picture.width);
  picture.height = options.height.value_or(picture.height);
  picture.samples = options.samples.value_or(picture.samples);
  picture.shading = options.shading.value_or(picture.shading);
  picture.filter = options.filter.value_or(picture.filter);
  picture.affine = picture.affine || options.affine;
}

// What a user might wonder about.
void tell(const RenderSceneOptions& options, const std::vector<std::string>& notes) {
  for (const std::string& text : notes) note(options.scene + ": " + text);
}

SceneRenderer renderer_of(const RenderSceneOptions& options, SceneFile& file) {
  try {
    return SceneRenderer(std::move(file.scene));
  } catch (const std::invalid_argument& wrong) {
    throw Error(ErrorKind::kContent, options.scene, wrong.what());
  }
}

void render_frame(const RenderSceneOptions& options, const SceneRenderer& renderer,
                  const Camera& camera, const std::string& output) {
  const Scene& scene = renderer.scene();
  const PictureInfo info = render_info(scene, options.render);
  const ExrWriteOptions write{.pixel = options.half ? ExrPixel::kHalf : ExrPixel::kFloat,
                              .replace = options.force,
                              .channels = render_channels(scene, options.render)};
  const auto sink = open_exr_sink(output, info, write);
  Progress progress(output == "-" ? options.scene : output, info.height, info.width);
  CountedSink counted(*sink, progress);
  try {
    renderer.render(camera, options.render, counted);
  } catch (const std::invalid_argument& wrong) {
    throw Error(ErrorKind::kContent, options.scene, wrong.what());
  }
  sink->finish();
}

// The name of each frame's file.
std::vector<std::string> frame_outputs(const RenderSceneOptions& options, const FrameRange& range) {
  if (range.last > 1 && options.output.find('%') == std::string::npos) {
    throw Error(ErrorKind::kMisuse, "--frames", "'" + options.output + "' names one file",
                "write %04d for the number of the frame: turn-%04d.exr");
  }
  const std::vector<std::string> inputs(static_cast<std::size_t>(range.last), options.scene);
  const std::vector<std::string> all = output_names(options.output, inputs, "--output");
  return {all.begin() + range.first - 1, all.end()};
}

}  // namespace

std::vector<RenderLayer> layers_of(const std::string& text) {
  std::vector<RenderLayer> layers;
  if (same_name(text, "all")) return {kRenderLayers.begin(), kRenderLayers.end()};
  std::size_t at = 0;
  while (at <= text.size()) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string name = text.substr(at, comma - at);
    const RenderLayer* layer = find_by_name(kRenderLayers, name);
    if (layer == nullptr) {
      throw Error(ErrorKind::kMisuse, "--layers", "'" + name + "' is no layer",
                  name_hint(kRenderLayers, name));
    }
    for (const RenderLayer& other : layers) {
      if (other.name == layer->name) {
        throw Error(ErrorKind::kMisuse, "--layers", name + " stands there twice");
      }
    }
    layers.push_back(*layer);
    at = comma + 1;
  }
  return layers;
}

FrameRange frames_of(const std::string& text) {
  constexpr int kMost = 100000;
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::size_t dash = std::min(text.find('-'), slash);
  const std::string_view all(text);
  const auto first = parse_integer(all.substr(0, dash));
  const auto last = dash == slash ? first : parse_integer(all.substr(dash + 1, slash - dash - 1));
  const auto turn = slash == text.size() ? last : parse_integer(all.substr(slash + 1));
  const bool good = first && last && turn && *first >= 1 && *first <= *last && *last <= kMost &&
                    *turn >= 1 && *turn <= kMost;
  if (!good) {
    throw Error(ErrorKind::kMisuse, "--frames", "'" + text + "' is no range of frames",
                "give the first and the last: 1-24; and those of a whole turn where they are more: "
                "1-12/24");
  }
  return {static_cast<int>(*first), static_cast<int>(*last), static_cast<int>(*turn)};
}

void render_scene_file(const RenderSceneOptions& options) {
  const FrameRange range = options.frames.value_or(FrameRange{});
  const std::vector<std::string> outputs =
      options.frames ? frame_outputs(options, range) : std::vector{options.output};
  refuse_inputs_as_outputs({options.scene}, outputs);
  refuse_taken_outputs(outputs, options.force);
  SceneFile file = load_scene(options.scene);
  apply(options, file.scene.picture);
  const SceneRenderer renderer = renderer_of(options, file);
  tell(options, file.notes);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const int frame = range.first + static_cast<int>(i);
    render_frame(options, renderer, orbit(renderer.scene().camera, frame, range.turn), outputs[i]);
  }
}

}  // namespace tristim::tools
