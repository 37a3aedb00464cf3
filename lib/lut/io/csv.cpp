#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "lib/lut/io/formats.h"
#include "lib/lut/io/tables.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

constexpr std::string_view kGreyHead = "in,out";
constexpr std::string_view kCurvesHead = "in,red,green,blue";
constexpr std::string_view kPointsHead = "red_in,red,green_in,green,blue_in,blue";
constexpr std::string_view kCubeHead = "red_in,green_in,blue_in,red,green,blue";
constexpr std::string_view kHeads[] = {kGreyHead, kCurvesHead, kPointsHead, kCubeHead};

std::string known_heads() {
  std::string text = "write ";
  for (const std::string_view head : kHeads)
    text += (text.size() > 6 ? " or " : "") + std::string(head);
  return text;
}

// The text without blanks, which none of the columns has.
std::string squeezed(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c != ' ' && c != '\t') out += c;
  }
  return out;
}

using Cells = std::vector<std::optional<double>>;

// A row of so many numbers. `gaps`: cells may be empty.
Cells cells_of(const TextLines& lines, std::size_t count, bool gaps) {
  Cells cells;
  const std::string row = squeezed(lines.rest());
  for (const std::string_view word : split(row, ',')) {
    const auto value = parse_number(word);
    if (value && std::isfinite(*value)) {
      cells.emplace_back(value);
    } else if (gaps && word.empty()) {
      cells.emplace_back();
    } else {
      lines.fail("'" + std::string(word.substr(0, 40)) + "' is no finite number");
    }
  }
  if (cells.size() != count) {
    lines.fail("has " + std::to_string(cells.size()) + " cells",
               "a row has " + std::to_string(count) + " here");
  }
  return cells;
}

// All rows below the head, one after the other.
std::vector<double> table_of(TextLines& lines, std::size_t columns) {
  std::vector<double> table;
  while (lines.next()) {
    for (const auto& cell : cells_of(lines, columns, false)) table.push_back(*cell);
  }
  return table;
}

Lut1D curves_of(const std::vector<double>& table, std::size_t columns, int size) {
  Lut1D curves{{}, size, {}};
  curves.range.low.fill(table.front());
  curves.range.high.fill(table[table.size() - columns]);
  for (std::size_t i = 0; i < table.size(); i += columns) {
    for (std::size_t c = 0; c < 3; ++c) {
      curves.rgb.push_back(static_cast<float>(table[i + (columns == 2 ? 1 : 1 + c)]));
    }
  }
  return curves;
}

// Curves where the inputs lie at equal steps, else points.
LutStep read_curves(TextLines& lines, std::size_t columns) {
  const std::vector<double> table = table_of(lines, columns);
  const std::size_t size = table.size() / columns;
  if (size < 2 || size > static_cast<std::size_t>(kMostCurveSize)) {
    lines.fail("the file has " + std::to_string(size) + " rows of numbers",
               "curves have 2 to " + std::to_string(kMostCurveSize));
  }
  Lut1D curves = curves_of(table, columns, static_cast<int>(size));
  std::vector<float> in;
  for (std::size_t i = 0; i < table.size(); i += columns) {
    in.push_back(static_cast<float>(table[i]));
  }
  if (equal_steps(in, curves.range.low[0], curves.range.high[0])) return curves;
  LutPoints points;
  for (std::size_t c = 0; c < 3; ++c) {
    points.curves[c].in = in;
    for (std::size_t i = c; i < curves.rgb.size(); i += 3) {
      points.curves[c].out.push_back(curves.rgb[i]);
    }
  }
  return points;
}

LutPoints read_points(TextLines& lines) {
  LutPoints points;
  while (lines.next()) {
    const Cells cells = cells_of(lines, 6, true);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& in = cells[2 * c];
      const auto& out = cells[2 * c + 1];
      if (!in && !out) continue;
      if (!in || !out) lines.fail("has only one of the two cells of a channel");
      points.curves[c].in.push_back(static_cast<float>(*in));
      points.curves[c].out.push_back(static_cast<float>(*out));
    }
  }
  return points;
}

Lut3D read_cube_table(TextLines& lines) {
  const std::vector<double> table = table_of(lines, 6);
  const std::size_t rows = table.size() / 6;
  const auto size = static_cast<int>(std::lround(std::cbrt(static_cast<double>(rows))));
  if (size < 2 || size > kMostCubeSize || cube_samples(size) != 3 * rows) {
    lines.fail("the file has " + std::to_string(rows) + " colours",
               "a cube has 8, 27, 64, ... of them, 2 to 256 an edge");
  }
  Lut3D cube{{}, size, {}};
  const auto edge = static_cast<std::size_t>(size);
  for (std::size_t c = 0; c < 3; ++c) {
    cube.range.low[c] = table[c];
    cube.range.high[c] = table[table.size() - 6 + c];
  }
  std::size_t step = 1;
  for (std::size_t c = 0; c < 3; ++c, step *= edge) {
    for (std::size_t i = 0; i < rows; ++i) {
      const auto place = static_cast<int>(i / step % edge);
      const double point = step_point(cube.range.low[c], cube.range.high[c], place, size);
      if (static_cast<float>(table[6 * i + c]) != static_cast<float>(point)) {
        lines.fail("colour " + std::to_string(i + 1) + " is not at its place",
                   "inputs go in equal steps, red fastest");
      }
    }
  }
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t c = 3; c < 6; ++c) cube.rgb.push_back(static_cast<float>(table[6 * i + c]));
  }
  return cube;
}

void append_cell(std::string& text, float value) {
  append_float(text, value);
  text += ',';
}

void append_curves(std::string& text, const Lut1D& curves) {
  const bool grey = equal_channels(curves);
  text += std::string(grey ? kGreyHead : kCurvesHead) + "\n";
  for (int i = 0; i < curves.size; ++i) {
    text += shortest(step_point(curves.range.low[0], curves.range.high[0], i, curves.size)) + ",";
    const float* rgb = curves.rgb.data() + 3 * static_cast<std::size_t>(i);
    for (int c = 0; c < (grey ? 1 : 3); ++c) append_cell(text, rgb[c]);
    text.back() = '\n';
  }
}

void append_points(std::string& text, const LutPoints& points) {
  text += std::string(kPointsHead) + "\n";
  std::size_t rows = 0;
  for (const LutCurve& curve : points.curves) rows = std::max(rows, curve.in.size());
  for (std::size_t i = 0; i < rows; ++i) {
    for (const LutCurve& curve : points.curves) {
      if (i < curve.in.size()) {
        append_cell(text, curve.in[i]);
        append_cell(text, curve.out[i]);
      } else {
        text += ",,";
      }
    }
    text.back() = '\n';
  }
}

void append_cube(std::string& text, const Lut3D& cube) {
  text += std::string(kCubeHead) + "\n";
  const auto edge = static_cast<std::size_t>(cube.size);
  for (std::size_t i = 0; i < edge * edge * edge; ++i) {
    std::size_t step = 1;
    for (std::size_t c = 0; c < 3; ++c, step *= edge) {
      const auto place = static_cast<int>(i / step % edge);
      text += shortest(step_point(cube.range.low[c], cube.range.high[c], place, cube.size)) + ",";
    }
    for (std::size_t c = 0; c < 3; ++c) append_cell(text, cube.rgb[3 * i + c]);
    text.back() = '\n';
  }
}

}  // namespace

// A table of what goes in and what comes out, under a head that says which columns there are.
Lut read_csv_lut(std::string_view bytes, const std::string& file,
                 const LutFileOptions& /*options*/) {
  TextLines lines(bytes, file);
  lines.need();
  const std::string head = squeezed(lines.rest());
  Lut lut;
  if (head == kGreyHead || head == kCurvesHead) {
    lut.steps.push_back(read_curves(lines, head == kGreyHead ? 2 : 4));
  } else if (head == kPointsHead) {
    lut.steps.emplace_back(read_points(lines));
  } else if (head == kCubeHead) {
    lut.steps.emplace_back(read_cube_table(lines));
  } else {
    lines.fail("is no head of a table", known_heads());
  }
  return lut;
}

std::string write_csv_lut(const Lut& lut, const LutFileOptions& /*options*/) {
  const auto [points, curves, cube] = parts_of(lut);
  std::string text = lut.title.empty() ? "" : "# " + one_line(lut.title) + "\n";
  if (curves != nullptr) append_curves(text, *curves);
  if (points != nullptr) append_points(text, *points);
  if (cube != nullptr) append_cube(text, *cube);
  return text;
}

}  // namespace tristim::detail
