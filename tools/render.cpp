#include <filesystem>

#include "tools/commands.h"
#include "tools/outputs.h"
#include "tools/render_gallery.h"
#include "tools/render_scene.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/image/io/exr.h"
#include "tristim/render/io/scene_file.h"
#include "tristim/render/spheres.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim render teapot -o teapot.exr\n"
    "  tristim render still-life --size 320x180 --layers beauty,N,Z,id -o layers.exr\n"
    "  printf 'v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf 1 2 3\\n' > model.obj && tristim render model.obj "
    "--samples 16 --filter gaussian -o model.exr\n"
    "  tristim render teapot --size 160x120 --frames 1-6 -o turn-%04d.exr\n"
    "  tristim render still-life --size 800x480 | tristim process - --device epaper-4grey "
    "--tone-map "
    "reinhard:6 -o panel.png\n"
    "  tristim render --gallery -o gallery\n"
    "  tristim render spheres --size 320x180 --samples 4 -o small.exr\n";

constexpr std::string_view kSpheres = "spheres";

struct Size {
  int width, height;
};

Size size_of(const std::string& text) {
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
  return {static_cast<int>(*width), static_cast<int>(*height)};
}

void check_output(const std::string& output) {
  refuse_terminal(output);
  const std::filesystem::path path(output);
  const bool stream = output == "-" || output.starts_with("/dev/");
  if (stream || same_name(path.extension().string(), ".exr")) return;
  throw Error(ErrorKind::kMisuse, output, "does not end in .exr",
              "render writes EXR, tristim process makes other formats of it");
}

template <class List>
auto one_of(const List& list, const std::string& option, const std::string& name) {
  if (const auto* found = find_by_name(list, name)) return *found;
  throw Error(ErrorKind::kMisuse, option, "'" + name + "' is unknown", name_hint(list, name));
}

void render_the_spheres(const RenderSceneOptions& options) {
  if (options.frames) {
    throw Error(ErrorKind::kMisuse, "--frames", "spheres has one picture only",
                "give a scene file");
  }
  SpheresOptions spheres;
  spheres.width = options.width.value_or(spheres.width);
  spheres.height = options.height.value_or(spheres.height);
  spheres.samples = options.samples.value_or(spheres.samples);
  spheres.threads = options.render.threads;
  const auto sink =
      open_exr_sink(options.output, spheres_info(spheres), {.replace = options.force});
  render_spheres(default_scene(), spheres, *sink);
  sink->finish();
}

std::string scene_names() {
  std::string names(kSpheres);
  for (const BuiltInScene& scene : built_in_scenes()) names += ", " + std::string(scene.name);
  return names;
}

void render_the_gallery(const std::vector<std::string>& scenes, const RenderSceneOptions& options) {
  if (!scenes.empty()) {
    throw Error(ErrorKind::kMisuse, "--gallery", "draws scenes of its own", "leave out SCENE");
  }
  if (options.output == "-") {
    throw Error(ErrorKind::kMisuse, "--output", "is missing", "give a directory: -o gallery");
  }
  render_gallery(options.output, options.render.threads, options.force);
}

void check_samples(const RenderSceneOptions& options) {
  const int samples = options.samples.value_or(1);
  if (samples == 1 || samples == 4 || samples == 16 || samples == 64) return;
  throw Error(ErrorKind::kMisuse, "--samples",
              std::to_string(samples) + " is none of 1, 4, 16, 64");
}

void declare_picture(CommandLine& line, RenderSceneOptions& options) {
  line.section("Picture");
  line.option("--size", "WxH", "default: that of the scene", [&](const std::string& v) {
    const Size size = size_of(v);
    options.width = size.width;
    options.height = size.height;
  });
  line.option(
      "--samples", "N", "of a pixel: 1, 4, 16, 64; spheres: 1 to 1024",
      [&](const std::string& v) { options.samples = integer_option("--samples", v, 1, 1024); });
  line.option("--filter", "F", "over the samples: " + list_names(kPixelFilters),
              [&](const std::string& v) { options.filter = one_of(kPixelFilters, "--filter", v); });
  line.option("--shading", "S", "where the model runs: " + list_names(kShadings),
              [&](const std::string& v) { options.shading = one_of(kShadings, "--shading", v); });
  line.flag("--affine", "interpolate along the screen, which is wrong in perspective",
            options.affine);
  line.option("--frames", "A-B[/N]",
              "pictures A to B of a turn of N (default: B) round the target; write %04d in OUT.exr",
              [&](const std::string& v) { options.frames = frames_of(v); });
}

void declare_file(CommandLine& line, RenderSceneOptions& options) {
  line.section("File");
  line.option("--layers", "L,...",
              "default: beauty; or all, or some of " + list_names(kRenderLayers),
              [&](const std::string& v) { options.render.layers = layers_of(v); });
  line.flag("--xyz", "CIE XYZ instead of light in sRGB's primaries", options.render.xyz);
  line.flag("--half", "half floats: files of half the size", options.half);
}

}  // namespace

void run_render(Arguments arguments) {
  std::vector<std::string> scenes;
  RenderSceneOptions options;
  options.output = "-";
  CommandLine line(*find_by_name(kCommands, "render"), kExamples);
  line.positional("SCENE", "a file: TOML (docs/scenes.md), OBJ, glTF; or one of " + scene_names(),
                  scenes, 0, 1);
  line.option("-o,--output", "OUT.exr", "linear light; default: -, standard output",
              options.output);
  line.option("--threads", "N", "default: one for each processor; the result is the same",
              [&](const std::string& v) {
                options.render.threads = integer_option("--threads", v, 0, 256);
              });
  line.flag("-f,--force", "replace existing files", options.force);
  bool gallery = false;
  line.flag("--gallery", "no SCENE: the scenes of the lectures, a PNG and an EXR each, into -o DIR",
            gallery);
  declare_picture(line, options);
  declare_file(line, options);
  if (!line.parse(arguments)) return;
  if (gallery) return render_the_gallery(scenes, options);
  if (scenes.empty()) {
    throw Error(ErrorKind::kMisuse, "render", "SCENE is missing",
                "use: tristim render SCENE -o OUT.exr, or --gallery");
  }
  options.scene = scenes[0];
  check_output(options.output);
  if (same_name(options.scene, kSpheres)) return render_the_spheres(options);
  check_samples(options);
  render_scene_file(options);
}

}  // namespace tristim::tools
