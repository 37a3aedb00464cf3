#include "tristim/frame/io/write.h"

#include <algorithm>
#include <iterator>

#include "lib/frame/io/file_sink.h"
#include "lib/frame/io/formats.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

struct Opener {
  std::string_view name;
  std::unique_ptr<CodeSink> (*open)(const std::string&, const FrameInfo&, const FrameWriteOptions&);
};

constexpr Opener kOpeners[] = {
    {"png", detail::open_png},    {"gif", detail::open_gif}, {"bmp", detail::open_bmp},
    {"tiff", detail::open_tiff},  {"pnm", detail::open_pnm}, {"raw", detail::open_raw},
    {"c", detail::open_c_header},
};
static_assert(std::size(kOpeners) == std::size(kFrameFormats));

bool has_extension(const FrameFormat& format, std::string_view extension) {
  std::string_view rest = format.extensions;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == extension) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

const FrameFormat& format_of_path(const std::string& path) {
  if (path == "-" || path == "/dev/stdout") {
    throw Error(ErrorKind::kMisuse, "standard output", "has no extension that tells the format",
                "name one of: " + list_names(kFrameFormats));
  }
  const std::string extension = detail::extension_of(path);
  std::string known;
  for (const FrameFormat& format : kFrameFormats) {
    if (has_extension(format, extension)) return format;
    if (!known.empty()) known += ' ';
    known += format.extensions;
  }
  throw Error(ErrorKind::kMisuse, path,
              extension.empty() ? "has no extension that tells the format"
                                : "unknown extension '" + extension + "'",
              "use one of: " + known);
}

const FrameFormat& format_named(std::string_view name) {
  const FrameFormat* format = find_by_name(kFrameFormats, name);
  if (format != nullptr) return *format;
  throw Error(ErrorKind::kMisuse, "format", "unknown name '" + std::string(name) + "'",
              name_hint(kFrameFormats, name));
}

}  // namespace

std::unique_ptr<CodeSink> open_code_sink(const std::string& path, const FrameInfo& info,
                                         const FrameWriteOptions& options) {
  detail::check_frame(info);
  const FrameFormat& format =
      options.format.empty() ? format_of_path(path) : format_named(options.format);
  if (info.frames > 1 && !format.moves) {
    throw Error(
        ErrorKind::kMisuse, path,
        std::string(format.name) + " holds one picture, these are " + std::to_string(info.frames),
        "write a moving picture as GIF");
  }
  return find_by_name(kOpeners, format.name)->open(path, info, options);
}

}  // namespace tristim
