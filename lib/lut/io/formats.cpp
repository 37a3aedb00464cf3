#include "lib/lut/io/formats.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "lib/lut/io/tables.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

using std::string_view_literals::operator""sv;

constexpr std::size_t kMostBytes = std::size_t{2} << 30;
constexpr int kMostOfOcio = 129;  // points of an edge that OpenColorIO takes
constexpr int kMostCurveOfOcio = 1 << 20;

template <const std::string_view& Magic>
bool begins_with(std::string_view bytes) {
  return without_utf8_mark(bytes).starts_with(Magic);
}
constexpr std::string_view kSpi3d = "SPILUT";
constexpr std::string_view kCsp = "CSPLUTV100";
constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n";
bool begins_icc(std::string_view bytes) {
  return bytes.size() > 40 && bytes.substr(36, 4) == "acsp";
}

constexpr int kHaldSizes[] = {4, 9, 16, 25, 36, 49, 64, 81, 100, 121, 144, 169, 196, 225, 256};
constexpr int kRampSizes[] = {256, 1024, 4096};

constexpr LutCapacity kCubeFiles{.curves = 65536,
                                 .cube = kMostCubeSize,
                                 .shaper = 65536,
                                 .alone = LutRanges::kAny,
                                 .first = LutRanges::kEqual,
                                 .second = LutRanges::kEqual};
constexpr LutCapacity kResolveFiles{.curves = 65536,
                                    .cube = kMostCubeSize,
                                    .shaper = 65536,
                                    .alone = LutRanges::kEqual,
                                    .first = LutRanges::kEqual,
                                    .second = LutRanges::kEqual};
constexpr LutCapacity kClfFiles{
    .curves = kMostCurveOfOcio, .cube = kMostOfOcio, .alone = LutRanges::kAny, .any = true};
constexpr LutCapacity kRamps{.curves = 4096, .sizes = kRampSizes, .bits = 16};
constexpr LutCapacity kArrays{.curves = kMostCurveSize,
                              .cube = kMostCubeSize,
                              .alone = LutRanges::kAny,
                              .chooses_bits = true};

constexpr LutFormat kFormats[] = {
    {"cube", "cube", "Iridas, Adobe; with curves before the cube, Resolve", kCubeFiles, nullptr,
     detail::read_cube, detail::write_cube},
    {"resolve", "cube", "DaVinci Resolve: one range for all channels", kResolveFiles, nullptr,
     detail::read_cube, detail::write_resolve},
    {"spi1d",
     "spi1d",
     "curves of Sony Pictures Imageworks, Nuke",
     {.curves = kMostCurveOfOcio, .alone = LutRanges::kEqual},
     nullptr,
     detail::read_spi1d,
     detail::write_spi1d},
    {"spi3d",
     "spi3d",
     "a cube of Sony Pictures Imageworks, Nuke",
     {.cube = kMostCubeSize},
     begins_with<kSpi3d>,
     detail::read_spi3d,
     detail::write_spi3d},
    {"3dl",
     "3dl",
     "Lustre and Flame: integers of 12 bits, or as --bits says",
     {.cube = kMostCubeSize, .shaper = 65536, .grey = true, .bits = 12, .chooses_bits = true},
     nullptr,
     detail::read_3dl,
     detail::write_3dl},
    {"csp",
     "csp",
     "Cinespace: curves through points before the table",
     {.curves = 65536,
      .cube = kMostCubeSize,
      .shaper = 65536,
      .alone = LutRanges::kAny,
      .first = LutRanges::kAny,
      .points_first = true},
     begins_with<kCsp>,
     detail::read_csp,
     detail::write_csp},
    {"clf", "clf", "Common LUT Format; whatever OpenColorIO reads of it", kClfFiles, nullptr,
     detail::read_clf, detail::write_clf},
    {"ctf", "ctf", "Autodesk's Color Transform Format, likewise", kClfFiles, nullptr,
     detail::read_ctf, detail::write_ctf},
    {"hald",
     "png",
     "a Hald picture: PNG of 16 bits, or 8 as --bits says",
     {.cube = kMostCubeSize, .sizes = kHaldSizes, .bits = 16, .chooses_bits = true},
     begins_with<kPng>,
     detail::read_hald,
     detail::write_hald},
    {"icc",
     "icc icm",
     "a display's ICC profile with curves for the graphics card (vcgt)",
     {.curves = 4096, .bits = 16},
     begins_icc,
     detail::read_icc,
     detail::write_icc},
    {"ramp", "ramp", "a gamma ramp as text: integers of 16 bits", kRamps, nullptr,
     detail::read_ramp, detail::write_ramp},
    {"xrandr", "xrandr", "a gamma ramp as XRRSetCrtcGamma takes it: words, red first", kRamps,
     nullptr, detail::read_xrandr, detail::write_xrandr},
    {"drm", "drm", "a gamma ramp as Linux takes it: an array of drm_color_lut", kRamps, nullptr,
     detail::read_drm, detail::write_drm},
    {"raw",
     "raw bin",
     "integers, nothing else: bytes, or words as --bits says",
     {.curves = kMostCurveSize, .cube = kMostCubeSize, .bits = 8, .chooses_bits = true},
     nullptr,
     detail::read_raw,
     detail::write_raw},
    {"c", "h c inc", "a C header: floats, or integers as --bits says", kArrays, nullptr,
     detail::read_c_lut, detail::write_c_lut},
    {"cpp", "hpp hxx hh", "a C++ header, likewise", kArrays, nullptr, detail::read_c_lut,
     detail::write_cpp_lut},
    {"json",
     "json",
     "every step",
     {.curves = kMostCurveSize,
      .cube = kMostCubeSize,
      .alone = LutRanges::kAny,
      .points = true,
      .any = true},
     nullptr,
     detail::read_json_lut,
     detail::write_json_lut},
    {"csv",
     "csv",
     "a table of what goes in and what comes out",
     {.curves = kMostCurveSize, .cube = kMostCubeSize, .alone = LutRanges::kEqual, .points = true},
     nullptr,
     detail::read_csv_lut,
     detail::write_csv_lut},
};

void check_options(const LutFormat& format, const LutFileOptions& options) {
  if (options.bits == 0) return;
  if (!format.holds.chooses_bits) {
    throw Error(ErrorKind::kMisuse, "--bits",
                "format " + std::string(format.name) + " has no choice of bits", "leave it out");
  }
  if (options.bits < 8 || options.bits > 16) {
    throw Error(ErrorKind::kMisuse, "--bits", std::to_string(options.bits) + " is out of range",
                "give 8 to 16");
  }
}

const LutFormat* format_of_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (extension.empty()) return nullptr;
  extension.erase(0, 1);
  for (const LutFormat& format : kFormats) {
    for (const std::string_view name : split(format.extensions, ' ')) {
      if (same_name(name, extension)) return &format;
    }
  }
  return nullptr;
}

const LutFormat& format_named(std::string_view name) {
  if (const LutFormat* format = find_by_name(kFormats, name)) return *format;
  throw Error(ErrorKind::kMisuse, "--format", "unknown format '" + std::string(name) + "'",
              name_hint(kFormats, name));
}

std::string all_extensions() {
  std::string all;
  for (const LutFormat& format : kFormats) {
    if (format.name == "resolve") continue;  // its extension is there already
    all += (all.empty() ? "" : " ") + std::string(format.extensions);
  }
  return all;
}

const LutFormat& format_of_bytes(std::string_view bytes, const std::string& file) {
  for (const LutFormat& format : kFormats) {
    if (format.begins != nullptr && format.begins(bytes)) return format;
  }
  if (const LutFormat* format = format_of_extension(file)) return *format;
  throw Error(ErrorKind::kContent, file, "is no table of a known format",
              "give one of: " + list_names(kFormats));
}

}  // namespace

std::span<const LutFormat> lut_formats() noexcept { return kFormats; }

const LutFormat& lut_format_of(const std::string& path, std::string_view format) {
  if (!format.empty()) return format_named(format);
  if (const LutFormat* found = format_of_extension(path)) return *found;
  throw Error(ErrorKind::kMisuse, path == "-" ? "standard output" : path,
              "has no extension that tells a table's format",
              path == "-" ? "give --format, one of: " + list_names(kFormats)
                          : "use one of: " + all_extensions());
}

Lut parse_lut(std::string_view bytes, const std::string& file, std::string_view format,
              const LutFileOptions& options) {
  if (bytes.empty()) throw Error(ErrorKind::kContent, file, "is empty", "write or copy it again");
  const LutFormat& known = format.empty() ? format_of_bytes(bytes, file) : format_named(format);
  check_options(known, options);
  try {
    Lut lut = known.read(bytes, file, options);
    check(lut);
    return lut;
  } catch (const std::invalid_argument& error) {
    const std::string_view text = error.what();
    throw Error(ErrorKind::kContent, file, text.substr(text.find(": ") + 2));
  }
}

Lut read_lut(const std::string& path, std::string_view format, const LutFileOptions& options) {
  return parse_lut(read_text_file(path, kMostBytes), path == "-" ? "standard input" : path, format,
                   options);
}

std::string lut_bytes(const Lut& lut, const LutFormat& format, const std::string& path,
                      const LutFileOptions& options) {
  if (!holds(format, lut)) {
    throw Error(ErrorKind::kMisuse, path,
                "format " + std::string(format.name) + " does not hold the table as it stands",
                "it holds " + describe(format.holds) + "; sample the table with --size");
  }
  check_options(format, options);
  const Lut1D* const curves = detail::parts_of(lut).curves;
  if (options.one_curve && curves != nullptr && !detail::equal_channels(*curves)) {
    throw Error(ErrorKind::kMisuse, path, "the channels differ, so one curve is not all of them",
                "write all three");
  }
  Lut named = lut;
  if (named.title.empty() && path != "-") named.title = std::filesystem::path(path).stem().string();
  return format.write(named, options);
}

}  // namespace tristim
