#include <algorithm>
#include <functional>
#include <optional>

#include "lib/lut/io/formats.h"
#include "lib/lut/io/tables.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

constexpr int kMostPoints = 65536;
constexpr int kMostCurve = 1 << 20;

// The points of one channel, and their ends in double: those may be a range.
struct Prelut {
  LutCurve curve;
  double low = 0, high = 0;
};

// Their number, then a line of what goes in and a line of what comes out.
Prelut read_prelut(TextLines& lines) {
  lines.need();
  const int size = lines.take_integer(2, kMostPoints, "number of points");
  lines.end_line();
  lines.promise(2 * static_cast<std::size_t>(size));
  Prelut prelut;
  lines.need();
  for (int i = 0; i < size; ++i) {
    prelut.high = lines.take_double();
    if (i == 0) prelut.low = prelut.high;
    prelut.curve.in.push_back(static_cast<float>(prelut.high));
  }
  lines.end_line();
  if (std::ranges::adjacent_find(prelut.curve.in, std::greater_equal<>()) !=
      prelut.curve.in.end()) {
    lines.fail("the points do not ascend");
  }
  lines.need();
  for (int i = 0; i < size; ++i) prelut.curve.out.push_back(lines.take_float());
  lines.end_line();
  return prelut;
}

using Preluts = std::array<Prelut, 3>;

bool is_range(const Prelut& prelut) {
  const LutCurve& curve = prelut.curve;
  return curve.in.size() == 2 && curve.out[0] == 0 && curve.out[1] == 1;
}

LutRange range_of(const Preluts& preluts) {
  LutRange range;
  for (std::size_t c = 0; c < 3; ++c) {
    range.low[c] = preluts[c].low;
    range.high[c] = preluts[c].high;
  }
  return range;
}

// Points at equal steps with the same number for each channel are curves; else they stay points.
LutStep shaper_of(const Preluts& preluts) {
  const std::size_t size = preluts[0].curve.in.size();
  Lut1D curves{range_of(preluts), static_cast<int>(size), std::vector<float>(3 * size)};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& [curve, low, high] = preluts[c];
    if (curve.in.size() != size || !equal_steps(curve.in, low, high)) {
      return LutPoints{{preluts[0].curve, preluts[1].curve, preluts[2].curve}};
    }
    for (std::size_t i = 0; i < size; ++i) curves.rgb[3 * i + c] = curve.out[i];
  }
  return curves;
}

// Points from 0 to 1 are the range of the table behind them.
void put_steps(Lut& lut, const Preluts& preluts, LutStep table) {
  if (std::ranges::all_of(preluts, is_range)) {
    if (auto* curves = std::get_if<Lut1D>(&table)) curves->range = range_of(preluts);
    if (auto* cube = std::get_if<Lut3D>(&table)) cube->range = range_of(preluts);
  } else {
    lut.steps.push_back(shaper_of(preluts));
  }
  lut.steps.push_back(std::move(table));
}

void read_metadata(TextLines& lines, Lut& lut) {
  lines.need();
  if (lines.rest() != "BEGIN METADATA") return lines.again();
  for (lines.need(); lines.rest() != "END METADATA"; lines.need()) {
    if (lut.title.empty()) lut.title = one_line(lines.rest());
  }
}

Lut3D read_table3(TextLines& lines) {
  lines.need();
  const int size = lines.take_integer(2, kMostCubeSize, "number of points an edge");
  for (int i = 0; i < 2; ++i) lines.take_integer(size, size, "size like that of red");
  lines.end_line();
  return read_cube_rows(lines, size);
}

Lut1D read_table1(TextLines& lines) {
  lines.need();
  const int size = lines.take_integer(2, kMostCurve, "number of entries");
  lines.end_line();
  return read_curve_rows(lines, size);
}

void append_points(std::string& text, const LutCurve& curve) {
  text += std::to_string(curve.in.size()) + "\n";
  for (const std::vector<float>* values : {&curve.in, &curve.out}) {
    for (const float value : *values) {
      append_float(text, value);
      text += ' ';
    }
    text.back() = '\n';
  }
}

void append_range(std::string& text, const LutRange& range, std::size_t c) {
  text += "2\n" + shortest(range.low[c]) + " " + shortest(range.high[c]) + "\n0 1\n";
}

void append_curve(std::string& text, const Lut1D& curves, std::size_t c) {
  text += std::to_string(curves.size) + "\n";
  for (int i = 0; i < curves.size; ++i) {
    text += shortest(step_point(curves.range.low[c], curves.range.high[c], i, curves.size)) + " ";
  }
  text.back() = '\n';
  for (std::size_t i = c; i < curves.rgb.size(); i += 3) {
    append_float(text, curves.rgb[i]);
    text += ' ';
  }
  text.back() = '\n';
}

}  // namespace

// Cinespace's file [OCIO]: curves through points in front ("prelut"), whose output 0 to 1 is the
// range of the table.
Lut read_csp(std::string_view bytes, const std::string& file, const LutFileOptions& /*options*/) {
  TextLines lines(bytes, file, '\0');
  lines.need();
  if (lines.rest() != "CSPLUTV100") lines.fail("does not begin with CSPLUTV100");
  lines.need();
  const bool is_cube = lines.rest() == "3D";
  if (!is_cube && lines.rest() != "1D") lines.fail("is neither 1D nor 3D");
  Lut lut;
  read_metadata(lines, lut);
  Preluts preluts;
  for (Prelut& prelut : preluts) prelut = read_prelut(lines);
  LutStep table = is_cube ? LutStep(read_table3(lines)) : LutStep(read_table1(lines));
  if (lines.next()) lines.fail("there are more rows than the size says");
  put_steps(lut, preluts, std::move(table));
  return lut;
}

std::string write_csp(const Lut& lut, const LutFileOptions& /*options*/) {
  const auto [points, curves, cube] = parts_of(lut);
  std::string text = std::string("CSPLUTV100\n") + (cube != nullptr ? "3D" : "1D") + "\n\n";
  text += "BEGIN METADATA\n" + one_line(lut.title) + "\nEND METADATA\n\n";
  for (std::size_t c = 0; c < 3; ++c) {
    if (points != nullptr) {
      append_points(text, points->curves[c]);
    } else if (curves != nullptr && cube != nullptr) {
      append_curve(text, *curves, c);
    } else {
      append_range(text, cube != nullptr ? cube->range : curves->range, c);
    }
  }
  text += '\n';
  if (cube != nullptr) {
    const std::string edge = std::to_string(cube->size);
    text += edge + " " + edge + " " + edge + "\n";
  } else {
    text += std::to_string(curves != nullptr ? curves->size : 2) + "\n";
  }
  static const std::vector<float> kIdentity = {0, 0, 0, 1, 1, 1};
  const std::vector<float>& rgb = cube != nullptr     ? cube->rgb
                                  : curves != nullptr ? curves->rgb
                                                      : kIdentity;
  for (std::size_t i = 0; i < rgb.size(); i += 3) append_row(text, rgb.data() + i);
  return text;
}

}  // namespace tristim::detail
