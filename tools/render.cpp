#include <filesystem>

#include "tools/commands.h"
#include "tools/outputs.h"
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
  constexpr int kMostSide = 65536;
  const std::size_t x = text.find_first_of("xX");
  const auto width = parse_integer(std::string_view(text).substr(0, x));
  const auto height =
      x == std::string::npos ? std::nullopt : parse_integer(std::string_view(text).substr(x + 1));
  const auto good = [](auto side) { return side && *side >= 1 && *side <= kMostSide; };
  if (!good(width) || !good(height)) {
    throw Error(ErrorKind::kMisuse, "--size", "'" + text + "' is no size",
                "give WIDTHxHEIGHT in pixels, at most 65536 a side: 1280x720");
  }
  options.width = static_cast<int>(*width);
  options.height = static_cast<int>(*height);
}

void check_output(const std::string& output) {
  if (output.empty()) {
    throw Error(ErrorKind::kMisuse, "--output", "is missing", "give -o spheres.exr");
  }
  refuse_terminal(output);
  const std::filesystem::path path(output);
  const bool stream = output == "-" || output.starts_with("/dev/");
  if (stream || same_name(path.extension().string(), ".exr")) return;
  throw Error(ErrorKind::kMisuse, output, "does not end in .exr",
              "render writes EXR, tristim process makes other formats of it");
}

}  // namespace

void run_render(Arguments arguments) {
  std::vector<std::string> scenes;
  std::string output;
  SpheresOptions options;
  bool force = false;
  CommandLine line(*find_by_name(kCommands, "render"), kExamples);
  line.positional("SCENE", "one of: " + list_names(kScenes), scenes, 1, 1);
  line.option("-o,--output", "OUT.exr", "linear light, half floats; - is standard output", output);
  line.option("--size", "WxH", "default: 1280x720",
              [&](const std::string& v) { set_size(options, v); });
  line.option("--samples", "N", "samples of a pixel; default: 16", [&](const std::string& v) {
    options.samples = integer_option("--samples", v, 1, 1024);
  });
  line.option(
      "--threads", "N", "default: one for each processor; the result is the same",
      [&](const std::string& v) { options.threads = integer_option("--threads", v, 0, 256); });
  line.flag("-f,--force", "replace an existing file", force);
  if (!line.parse(arguments)) return;
  if (find_by_name(kScenes, scenes[0]) == nullptr) {
    throw Error(ErrorKind::kMisuse, scenes[0], "unknown scene", name_hint(kScenes, scenes[0]));
  }
  check_output(output);
  const auto sink = open_exr_sink(output, spheres_info(options), {.replace = force});
  render_spheres(default_scene(), options, *sink);
  sink->finish();
}

}  // namespace tristim::tools
