#include "tools/process_output.h"

#include <filesystem>

#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/frame/io/separations.h"
#include "tristim/frame/io/write.h"
#include "tristim/image/io/exr.h"
#include "tristim/pipeline/chain.h"
#include "tristim/pipeline/proof.h"

namespace tristim::tools {
namespace {

std::string extension_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension.empty() ? extension : extension.substr(1);
}

bool is_exr(const ProcessOptions& options, const std::string& output) {
  return same_name(options.format.empty() ? extension_of(output) : options.format, "exr");
}

// What is no file, such as standard output and a pipe with a name, has no extension.
bool is_stream(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  return path == "-" ||
         (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status));
}

// The name of an output's format; "" where it is exr or unknown.
std::string format_of(const ProcessOptions& options, const std::string& output) {
  if (!options.format.empty()) return options.format;
  if (is_stream(output)) return "png";
  for (const FrameFormat& format : kFrameFormats) {
    for (const std::string_view name : split(format.extensions, ' ')) {
      if (same_name(name, extension_of(output))) return std::string(format.name);
    }
  }
  return "";
}

std::vector<std::string> ink_names(const Press& press) {
  std::vector<std::string> names;
  for (const Ink& ink : press.inks) names.push_back(ink.name);
  return names;
}

struct FormatName {
  std::string_view name;
};

void check_format_name(const std::string& name) {
  std::vector<FormatName> known;
  for (const FrameFormat& format : kFrameFormats) known.push_back({format.name});
  known.push_back({"exr"});
  if (find_by_name(known, name) != nullptr) return;
  throw Error(ErrorKind::kMisuse, "--format", "unknown format '" + name + "'",
              name_hint(known, name));
}

}  // namespace

std::vector<std::string> output_files(const ProcessOptions& options, const Display& device,
                                      const std::string& output) {
  if (!device.press || !is_separated(output, {.format = options.format})) return {output};
  return separation_paths(output, ink_names(*device.press));
}

void check_format(const ProcessOptions& options, const std::string& output) {
  if (!options.format.empty()) return check_format_name(options.format);
  const std::string extension = extension_of(output);
  if (is_stream(output) || same_name(extension, "exr")) return;
  std::string known;
  for (const FrameFormat& format : kFrameFormats) {
    for (const std::string_view name : split(format.extensions, ' ')) {
      if (same_name(name, extension)) return;
    }
    known += std::string(format.extensions) + " ";
  }
  throw Error(ErrorKind::kMisuse, output,
              extension.empty() ? "has no extension that tells the format"
                                : "unknown extension '" + extension + "'",
              "use one of: " + known + "exr");
}

void check_proof_format(const std::string& proof) {
  if (is_stream(proof) || same_name(extension_of(proof), "png")) return;
  const std::string name = std::filesystem::path(proof).replace_extension("png").string();
  throw Error(ErrorKind::kMisuse, "--proof", "'" + proof + "' does not end in .png",
              "proofs are PNG: give " + name);
}

bool is_indexed_format(const ProcessOptions& options, const std::string& output) {
  const FrameFormat* format = find_by_name(kFrameFormats, format_of(options, output));
  return format != nullptr && format->indexed;
}

bool is_indexed_only(const ProcessOptions& options, const std::string& output) {
  return same_name(format_of(options, output), "gif");
}

std::unique_ptr<CodeSink> open_sink(const ProcessOptions& options, const std::string& output,
                                    const PaletteDisplay& palette, const PictureInfo& picture,
                                    int frames) {
  if (is_exr(options, output)) {
    PictureInfo info;
    info.width = picture.width;
    info.height = picture.height;
    info.primaries = palette.display.primaries;
    const ReduceOptions reduced = reduce_options(palette.display, options.settings);
    return decoding_sink(palette.display, open_exr_sink(output, info, {.replace = options.force}),
                         seen_dots(palette.display, reduced));
  }
  FrameInfo info = palette_frame_info(palette, picture.width, picture.height);
  info.frames = frames;
  info.delay_s = options.delay_s;
  const FrameWriteOptions how{.format = format_of(options, output),
                              .replace = options.force,
                              .threads = options.threads,
                              .png_level = options.png_level};
  const std::optional<Press>& press = palette.display.press;
  if (press && is_separated(output, how)) {
    return open_separations(output, info, ink_names(*press), how);
  }
  return open_code_sink(output, info, how);
}

std::unique_ptr<CodeSink> open_proof(const ProcessOptions& options, const std::string& path,
                                     const PictureInfo& picture) {
  return open_code_sink(path, frame_info(Display{}, picture.width, picture.height),
                        {.format = "png",
                         .replace = options.force,
                         .threads = options.threads,
                         .png_level = options.png_level});
}

}  // namespace tristim::tools
