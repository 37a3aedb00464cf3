#include <optional>

#include "lib/lut/io/formats.h"
#include "lib/lut/io/tables.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

constexpr int kMostCurve = 65536;  // [Cube]

// What stands before the numbers.
struct Header {
  std::string title;
  int curve_size = 0, cube_size = 0;  // 0: none
  LutRange domain, curve_range, cube_range;
};

// The text between the quotes, or the line where it has none.
std::string title_of(std::string_view text) {
  const std::size_t first = text.find('"');
  const std::size_t last = text.rfind('"');
  if (first != last) text = text.substr(first + 1, last - first - 1);
  return one_line(text);
}

void take_triple(TextLines& lines, std::array<double, 3>& values) {
  for (double& value : values) value = lines.take_double();
}

// LUT_3D_INPUT_RANGE: two numbers for all channels.
void take_input_range(TextLines& lines, LutRange& range) {
  range.low.fill(lines.take_double());
  range.high.fill(lines.take_double());
}

void take_size(TextLines& lines, int& size, int most, const char* what) {
  if (size != 0) lines.fail("says its size for the second time");
  size = lines.take_integer(2, most, what);
}

// One line of the header; false where it is a row of numbers.
bool take_keyword(TextLines& lines, Header& header) {
  const std::string_view first = lines.rest();
  if (first.find_first_of("0123456789+-.") == 0) return false;
  const std::string_view word = lines.take_word();
  if (word == "TITLE") {
    header.title = title_of(lines.rest());
    return true;
  }
  if (word == "LUT_1D_SIZE") {
    take_size(lines, header.curve_size, kMostCurve, "number of entries");
  } else if (word == "LUT_3D_SIZE") {
    take_size(lines, header.cube_size, kMostCubeSize, "number of points an edge");
  } else if (word == "DOMAIN_MIN") {
    take_triple(lines, header.domain.low);
  } else if (word == "DOMAIN_MAX") {
    take_triple(lines, header.domain.high);
  } else if (word == "LUT_1D_INPUT_RANGE") {
    take_input_range(lines, header.curve_range);
  } else if (word == "LUT_3D_INPUT_RANGE") {
    take_input_range(lines, header.cube_range);
  } else {
    lines.fail("'" + std::string(word.substr(0, 40)) + "' is no keyword of a cube file",
               "it has TITLE, LUT_1D_SIZE, LUT_3D_SIZE, DOMAIN_MIN, DOMAIN_MAX, LUT_1D_INPUT_RANGE "
               "and LUT_3D_INPUT_RANGE");
  }
  lines.end_line();
  return true;
}

std::string triple_text(const std::array<double, 3>& v) {
  return shortest(v[0]) + " " + shortest(v[1]) + " " + shortest(v[2]) + "\n";
}

std::string range_text(const LutRange& range) {
  return shortest(range.low[0]) + " " + shortest(range.high[0]) + "\n";
}

std::string title_text(const Lut& lut) {
  return lut.title.empty() ? "" : "TITLE \"" + one_line(lut.title) + "\"\n";
}

void append_rows(std::string& text, const std::vector<float>& rgb) {
  for (std::size_t i = 0; i < rgb.size(); i += 3) append_row(text, rgb.data() + i);
}

}  // namespace

// The cube file of Iridas and Adobe [Cube], and Resolve's, which has curves before a cube.
Lut read_cube(std::string_view bytes, const std::string& file, const LutFileOptions& /*options*/) {
  TextLines lines(bytes, file);
  Header header;
  bool numbers = false;
  while (!numbers) {
    lines.need();
    numbers = !take_keyword(lines, header);
  }
  lines.again();
  if (header.curve_size == 0 && header.cube_size == 0) {
    lines.fail("numbers come before a size", "write LUT_3D_SIZE or LUT_1D_SIZE first");
  }
  Lut lut{header.title, {}};
  const auto range = [&](const LutRange& stated) {
    return stated == LutRange{} ? header.domain : stated;
  };
  if (header.curve_size > 0) {
    Lut1D curves = read_curve_rows(lines, header.curve_size);
    curves.range = range(header.curve_range);
    lut.steps.emplace_back(std::move(curves));
  }
  if (header.cube_size > 0) {
    Lut3D cube = read_cube_rows(lines, header.cube_size);
    // A domain is what goes into the file: the curves in front, where there are some.
    cube.range = header.curve_size > 0 ? header.cube_range : range(header.cube_range);
    lut.steps.emplace_back(std::move(cube));
  }
  if (lines.next()) lines.fail("there are more rows than the size says");
  return lut;
}

std::string write_cube(const Lut& lut, const LutFileOptions& options) {
  const LutParts parts = parts_of(lut);
  if (parts.curves != nullptr && parts.cube != nullptr) return write_resolve(lut, options);
  const LutRange& range = parts.cube != nullptr ? parts.cube->range : parts.curves->range;
  std::string text = title_text(lut);
  text += parts.cube != nullptr ? "LUT_3D_SIZE " + std::to_string(parts.cube->size) + "\n"
                                : "LUT_1D_SIZE " + std::to_string(parts.curves->size) + "\n";
  if (range != LutRange{}) {
    text += "DOMAIN_MIN " + triple_text(range.low) + "DOMAIN_MAX " + triple_text(range.high);
  }
  append_rows(text, parts.cube != nullptr ? parts.cube->rgb : parts.curves->rgb);
  return text;
}

// Resolve knows no TITLE in files with both tables; comments it skips.
std::string write_resolve(const Lut& lut, const LutFileOptions& /*options*/) {
  const auto [points, curves, cube] = parts_of(lut);
  std::string text = lut.title.empty() ? "" : "# " + one_line(lut.title) + "\n";
  if (curves != nullptr) {
    text += "LUT_1D_SIZE " + std::to_string(curves->size) + "\n";
    text += "LUT_1D_INPUT_RANGE " + range_text(curves->range);
  }
  if (cube != nullptr) {
    text += "LUT_3D_SIZE " + std::to_string(cube->size) + "\n";
    text += "LUT_3D_INPUT_RANGE " + range_text(cube->range);
  }
  if (curves != nullptr) append_rows(text, curves->rgb);
  if (cube != nullptr) append_rows(text, cube->rgb);
  return text;
}

}  // namespace tristim::detail
