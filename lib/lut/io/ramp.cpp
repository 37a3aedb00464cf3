#include <algorithm>
#include <optional>

#include "lib/lut/io/formats.h"
#include "lib/lut/io/tables.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr int kMostCode = 65535;
constexpr int kMostRamp = 65536;

std::string kind_of_size(std::size_t entry_bytes) {
  std::string sizes;
  for (const std::size_t size : {std::size_t{256}, std::size_t{1024}, std::size_t{4096}}) {
    sizes += (sizes.empty() ? "" : ", ") + std::to_string(size * entry_bytes);
  }
  return "256, 1024 and 4096 entries have " + sizes + " bytes";
}

int entries_of(std::string_view bytes, const std::string& file, std::size_t entry_bytes) {
  const std::size_t count = bytes.size() / entry_bytes;
  if (bytes.size() % entry_bytes != 0 || count < 2 || count > kMostRamp) {
    throw Error(ErrorKind::kContent, file,
                "has " + std::to_string(bytes.size()) + " bytes, which is no gamma ramp",
                kind_of_size(entry_bytes));
  }
  return static_cast<int>(count);
}

float value_at(std::string_view bytes, std::size_t word) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const int code = byte(2 * word) | byte(2 * word + 1) << 8;
  return static_cast<float>(code) / static_cast<float>(kMostCode);
}

void append_word(std::string& bytes, int code) {
  bytes += static_cast<char>(code & 0xff);
  bytes += static_cast<char>(code >> 8);
}

}  // namespace

// A gamma ramp as text: a line "red green blue" of 16-bit integers for each entry.
Lut read_ramp(std::string_view bytes, const std::string& file, const LutFileOptions& /*options*/) {
  TextLines lines(bytes, file);
  Lut1D curves;
  while (lines.next()) {
    for (int c = 0; c < 3; ++c) {
      const int code = lines.take_integer(0, kMostCode, "code of a gamma ramp");
      curves.rgb.push_back(static_cast<float>(code) / static_cast<float>(kMostCode));
    }
    lines.end_line();
  }
  curves.size = static_cast<int>(std::min<std::size_t>(curves.rgb.size() / 3, kMostRamp + 1));
  if (curves.size < 2 || curves.size > kMostRamp) {
    lines.fail("the file has " + std::to_string(curves.rgb.size() / 3) + " entries",
               "a gamma ramp has 2 to " + std::to_string(kMostRamp));
  }
  return {"", {std::move(curves)}};
}

std::string write_ramp(const Lut& lut, const LutFileOptions& /*options*/) {
  const Lut1D& curves = *parts_of(lut).curves;
  std::string text =
      "# gamma ramp, " + std::to_string(curves.size) + " entries of 16 bits: red green blue\n";
  if (!lut.title.empty()) text += "# " + one_line(lut.title) + "\n";
  for (std::size_t i = 0; i < curves.rgb.size(); ++i) {
    text += std::to_string(table_code(curves.rgb[i], kMostCode)) + (i % 3 < 2 ? " " : "\n");
  }
  return text;
}

// What XRRSetCrtcGamma takes [XRandR]: all of red, all of green, all of blue, 16 bits each, low
// byte first.
Lut read_xrandr(std::string_view bytes, const std::string& file,
                const LutFileOptions& /*options*/) {
  const int size = entries_of(bytes, file, 6);
  Lut1D curves{{}, size, std::vector<float>(curve_samples(size))};
  const auto count = static_cast<std::size_t>(size);
  for (std::size_t i = 0; i < 3 * count; ++i) {
    curves.rgb[i % count * 3 + i / count] = value_at(bytes, i);
  }
  return {"", {std::move(curves)}};
}

std::string write_xrandr(const Lut& lut, const LutFileOptions& /*options*/) {
  const Lut1D& curves = *parts_of(lut).curves;
  std::string bytes;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = c; i < curves.rgb.size(); i += 3) {
      append_word(bytes, table_code(curves.rgb[i], kMostCode));
    }
  }
  return bytes;
}

// What the property GAMMA_LUT of Linux takes [DRM]: an array of drm_color_lut, 16 bits each of red,
// green, blue and nothing, low byte first.
Lut read_drm(std::string_view bytes, const std::string& file, const LutFileOptions& /*options*/) {
  const int size = entries_of(bytes, file, 8);
  Lut1D curves{{}, size, std::vector<float>(curve_samples(size))};
  for (std::size_t i = 0; i < curves.rgb.size(); ++i) {
    curves.rgb[i] = value_at(bytes, i / 3 * 4 + i % 3);
  }
  return {"", {std::move(curves)}};
}

std::string write_drm(const Lut& lut, const LutFileOptions& /*options*/) {
  const Lut1D& curves = *parts_of(lut).curves;
  std::string bytes;
  for (std::size_t i = 0; i < curves.rgb.size(); ++i) {
    append_word(bytes, table_code(curves.rgb[i], kMostCode));
    if (i % 3 == 2) append_word(bytes, 0);
  }
  return bytes;
}

}  // namespace tristim::detail
