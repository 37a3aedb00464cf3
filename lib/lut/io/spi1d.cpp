#include <optional>

#include "lib/lut/io/formats.h"
#include "lib/lut/io/tables.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

constexpr int kMostCurve = 1 << 20;

struct Header {
  double low = 0, high = 1;
  int size = 0;
  int components = 0;
};

void take_header(TextLines& lines, Header& header) {
  for (lines.need(); lines.rest() != "{"; lines.need()) {
    const std::string_view word = lines.take_word();
    if (word == "Version") {
      lines.take_integer(1, 1, "version of a spi1d file");
    } else if (word == "From") {
      header.low = lines.take_double();
      header.high = lines.take_double();
    } else if (word == "Length") {
      header.size = lines.take_integer(2, kMostCurve, "length");
    } else if (word == "Components") {
      header.components = lines.take_integer(1, 3, "number of components");
    } else {
      lines.fail("'" + std::string(word.substr(0, 40)) + "' is no keyword of a spi1d file",
                 "it has Version, From, Length, Components and {");
    }
    lines.end_line();
  }
  if (header.size == 0) lines.fail("numbers come before a Length");
  if (header.components == 0) lines.fail("numbers come before Components");
}

}  // namespace

// The curves of Sony Pictures Imageworks [OCIO]: one component is all channels, of two the third
// is 0.
Lut read_spi1d(std::string_view bytes, const std::string& file, const LutFileOptions& /*options*/) {
  TextLines lines(bytes, file);
  Header header;
  take_header(lines, header);
  const auto count = static_cast<std::size_t>(header.components);
  lines.promise(static_cast<std::size_t>(header.size) * count);
  Lut1D curves{{}, header.size, std::vector<float>(curve_samples(header.size))};
  curves.range.low.fill(header.low);
  curves.range.high.fill(header.high);
  for (std::size_t i = 0; i < curves.rgb.size(); i += 3) {
    lines.need();
    if (lines.rest() == "}") lines.fail("there are fewer rows than Length says");
    for (std::size_t c = 0; c < count; ++c) curves.rgb[i + c] = lines.take_float();
    lines.end_line();
    if (count == 1) curves.rgb[i + 1] = curves.rgb[i + 2] = curves.rgb[i];
  }
  lines.need();
  if (lines.rest() != "}") lines.fail("there are more rows than Length says", "close them with }");
  return {"", {std::move(curves)}};
}

std::string write_spi1d(const Lut& lut, const LutFileOptions& /*options*/) {
  const Lut1D& curves = *parts_of(lut).curves;
  const bool grey = equal_channels(curves);
  std::string text = "Version 1\nFrom " + shortest(curves.range.low[0]) + " " +
                     shortest(curves.range.high[0]) + "\nLength " + std::to_string(curves.size) +
                     "\nComponents " + (grey ? "1" : "3") + "\n{\n";
  for (std::size_t i = 0; i < curves.rgb.size(); i += 3) {
    if (grey) {
      append_float(text, curves.rgb[i]);
      text += '\n';
    } else {
      append_row(text, curves.rgb.data() + i);
    }
  }
  return text + "}\n";
}

}  // namespace tristim::detail
