#include "tools/commands.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/image/io/exr.h"
#include "tristim/render/spheres.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim render spheres -o spheres.exr\n"
    "  tristim render spheres --size 320x180 --samples 4 -o small.exr\n";

struct SceneName {
  std::string_view name;
};
constexpr SceneName kScenes[] = {{"spheres"}};

void set_size(SpheresOptions& options, const std::string& text) {
  const std::vector<std::string_view> sides = split(text, 'x');
  const auto side = [&](std::size_t i) {
    return integer_option("--size", sides.size() == 2 ? sides[i] : text, 1, 65536);
  };
  options.width = side(0);
  options.height = side(1);
}

}  // namespace

void run_render(Arguments arguments) {
  std::vector<std::string> scenes;
  std::string output;
  SpheresOptions options;
  bool force = false;
  CommandLine line(*find_by_name(kCommands, "render"), kExamples);
  line.positional("SCENE", "spheres", scenes, 1, 1);
  line.option("-o,--output", "OUT.exr", "linear light, half floats; - is standard output", output);
  line.option("--size", "WxH", "default 1280x720",
              [&](const std::string& v) { set_size(options, v); });
  line.option("--samples", "N", "samples of a pixel; default 16", [&](const std::string& v) {
    options.samples = integer_option("--samples", v, 1, 1024);
  });
  line.option("--threads", "N", "default: one for each processor", [&](const std::string& v) {
    options.threads = integer_option("--threads", v, 0, 1024);
  });
  line.flag("-f,--force", "replace an existing file", force);
  if (!line.parse(arguments)) return;
  if (find_by_name(kScenes, scenes[0]) == nullptr) {
    throw Error(ErrorKind::kMisuse, scenes[0], "unknown scene", name_hint(kScenes, scenes[0]));
  }
  if (output.empty()) {
    throw Error(ErrorKind::kMisuse, "--output", "is missing", "give -o spheres.exr");
  }
  const auto sink = open_exr_sink(output, spheres_info(options), {.replace = force});
  render_spheres(default_scene(), options, *sink);
  sink->finish();
}

}  // namespace tristim::tools
