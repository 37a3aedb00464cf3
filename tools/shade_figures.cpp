#include <cmath>
#include <filesystem>
#include <system_error>
#include <vector>

#include "tools/figures.h"
#include "tools/outputs.h"
#include "tools/shade_paper.h"
#include "tristim/color/transfer.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/frame/io/write.h"
#include "tristim/image/io/exr.h"

namespace tristim::tools {
namespace {

constexpr Command kCommand{"shade figures", "[FIGURE...] -o DIR [options]",
                           "figures of the illumination models as EXR, PNG and SVG",
                           run_shade_figures};

constexpr std::string_view kExamples =
    "  tristim shade figures -o figures\n"
    "  tristim shade figures fisher-woo-2 fresnel -o figures --force\n"
    "  tristim shade figures --list\n";

struct Options {
  std::vector<std::string> names;
  std::string directory;
  bool force = false, list = false;
};

// Grey light as EXR, single floats.
void write_exr(const std::string& path, ImageView<const float> light, bool replace) {
  PictureInfo info{.width = light.width, .height = light.height, .channels = 3, .grey = true};
  const auto sink = open_exr_sink(path, info, {.pixel = ExrPixel::kFloat, .replace = replace});
  Image row(light.width, 1, 3);
  for (int y = 0; y < light.height; ++y) {
    for (int x = 0; x < light.width; ++x) {
      for (int c = 0; c < 3; ++c) row.view().pixel(x, 0)[c] = *light.pixel(x, y);
    }
    sink->write(row.view());
  }
  sink->finish();
}

std::uint16_t srgb_code(double light) {
  return static_cast<std::uint16_t>(255 * srgb_encode(std::fmin(std::fmax(light, 0), 1)) + 0.5);
}

void write_png(const std::string& path, const Figure& figure, ImageView<const float> light,
               bool replace) {
  const bool grey = figure.tone == grey_tone;
  FrameInfo info{.width = light.width, .height = light.height};
  info.layout.packing = *find_by_name(kPackings, grey ? "gray8" : "rgb888");
  info.srgb = true;
  const auto sink = open_code_sink(path, info, {.format = "png", .replace = replace});
  Raster<std::uint16_t> row(light.width, 1, info.layout.packing.samples);
  for (int y = 0; y < light.height; ++y) {
    for (int x = 0; x < light.width; ++x) {
      const Rgb color = figure.tone(*light.pixel(x, y));
      std::uint16_t* code = row.view().pixel(x, 0);
      code[0] = srgb_code(color.r);
      if (grey) continue;
      code[1] = srgb_code(color.g);
      code[2] = srgb_code(color.b);
    }
    sink->write(row.view());
  }
  sink->finish();
}

void write_text(const std::string& path, const std::string& text, bool replace) {
  OutputFile file(path, replace);
  file.write(text);
  file.commit();
}

std::string path_of(const Options& options, const Figure& figure, std::string_view extension) {
  return (std::filesystem::path(options.directory) /
          (std::string(figure.name) + std::string(extension)))
      .string();
}

std::vector<std::string> paths_of(const Options& options, const Figure& figure) {
  if (figure.drawing != nullptr) return {path_of(options, figure, ".svg")};
  return {path_of(options, figure, ".exr"), path_of(options, figure, ".png")};
}

void write_figure(const Options& options, const Figure& figure) {
  const std::vector<std::string> paths = paths_of(options, figure);
  if (figure.drawing != nullptr) return write_text(paths[0], figure.drawing(), options.force);
  const Image light = figure.picture();
  write_exr(paths[0], light.view(), options.force);
  write_png(paths[1], figure, light.view(), options.force);
}

std::vector<Figure> chosen_figures(const Options& options) {
  if (options.names.empty()) return {kFigures.begin(), kFigures.end()};
  std::vector<Figure> figures;
  for (const std::string& name : options.names) {
    const Figure* figure = find_by_name(kFigures, name);
    if (figure == nullptr) {
      throw Error(ErrorKind::kMisuse, name, "unknown figure", name_hint(kFigures, name));
    }
    figures.push_back(*figure);
  }
  return figures;
}

void make_directory(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (!error && std::filesystem::is_directory(directory, error)) return;
  const std::string wrong =
      error ? "cannot be made: " + system_message(error.value()) : std::string("is no directory");
  throw Error(ErrorKind::kSystem, directory, wrong, "give another directory with -o");
}

std::string list_text() {
  std::string text;
  for (const Figure& figure : kFigures) {
    std::string name(figure.name);
    name.resize(22, ' ');
    text += name + (figure.drawing != nullptr ? "SVG       " : "EXR, PNG  ");
    text.append(figure.what).append("\n");
  }
  return text;
}

}  // namespace

void run_shade_figures(Arguments arguments) {
  Options options;
  CommandLine line(kCommand, kExamples);
  line.positional("FIGURE...", "names from --list; default: all", options.names, 0, 1000);
  line.option("-o,--output", "DIR", "directory of the files; made where it is missing",
              options.directory);
  line.flag("-f,--force", "replace existing files", options.force);
  line.flag("--list", "print the figures", options.list);
  if (!line.parse(arguments)) return;
  if (options.list) return print(list_text());
  if (options.directory.empty()) {
    throw Error(ErrorKind::kMisuse, "--output", "is missing", "give a directory: -o figures");
  }
  const std::vector<Figure> figures = chosen_figures(options);
  make_directory(options.directory);
  std::vector<std::string> paths;
  for (const Figure& figure : figures) {
    for (std::string& path : paths_of(options, figure)) paths.push_back(std::move(path));
  }
  refuse_taken_outputs(paths, options.force);
  for (const Figure& figure : figures) write_figure(options, figure);
}

}  // namespace tristim::tools
