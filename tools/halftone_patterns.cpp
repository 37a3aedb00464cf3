#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tools/halftone.h"
#include "tools/outputs.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/frame/io/write.h"
#include "tristim/plot/svg.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim halftone patterns d2 -o d2.svg\n"
    "  tristim halftone patterns d3 -o d3.png\n"
    "  tristim halftone patterns spiral5 --dot 6 -o spiral5.png\n";

constexpr int kMostLevels = 257;  // of a 16 x 16 cell; of larger ones this many, evenly spaced

/// Where the patterns of a chart stand: all lengths in pixels.
struct ChartLayout {
  const ThresholdMatrix* matrix = nullptr;
  int dot = 0;  // side of one pixel of a pattern
  std::vector<int> levels;
  int columns = 0, rows = 0;
  int margin = 12, gap = 16, label = 14;

  int cell_width() const { return matrix->width * dot; }
  int cell_height() const { return matrix->height * dot; }
  int width() const { return 2 * margin + columns * (cell_width() + gap) - gap; }
  int height() const { return 2 * margin + rows * (cell_height() + label + gap) - gap; }
  int left(std::size_t i) const {
    return margin + static_cast<int>(i) % columns * (cell_width() + gap);
  }
  int top(std::size_t i) const {
    return margin + static_cast<int>(i) / columns * (cell_height() + label + gap);
  }
};

ChartLayout layout_of(const ThresholdMatrix& matrix, int dot) {
  ChartLayout layout{.matrix = &matrix, .dot = dot};
  const int count = std::min(matrix.ranks + 1, kMostLevels);
  for (int i = 0; i < count; ++i) {
    layout.levels.push_back(static_cast<int>(std::int64_t{matrix.ranks} * i / (count - 1)));
  }
  if (layout.dot == 0) layout.dot = std::clamp(48 / std::max(matrix.width, matrix.height), 1, 16);
  // About as wide as high.
  const double aspect = static_cast<double>(layout.cell_height() + layout.label + layout.gap) /
                        (layout.cell_width() + layout.gap);
  layout.columns = std::clamp(static_cast<int>(std::ceil(std::sqrt(count * aspect))), 1, count);
  layout.rows = (count + layout.columns - 1) / layout.columns;
  return layout;
}

// Digits of 3 x 5 pixels, row by row.
constexpr std::string_view kDigits[] = {
    "111101101101111", "010110010010111", "111001111100111", "111001111001111", "101101111001001",
    "111100111001111", "111100111101111", "111001001010010", "111101111101111", "111101111001111"};

using Sheet = Raster<std::uint16_t>;

void fill(Sheet& sheet, int x, int y, int width, int height, std::uint16_t grey) {
  for (int row = y; row < y + height; ++row) {
    std::fill_n(sheet.view().pixel(x, row), width, grey);
  }
}

void draw_number(Sheet& sheet, int x, int y, int number) {
  for (const char c : std::to_string(number)) {
    const std::string_view digit = kDigits[c - '0'];
    for (int i = 0; i < 15; ++i) {
      if (digit[static_cast<std::size_t>(i)] == '1')
        fill(sheet, x + i % 3 * 2, y + i / 3 * 2, 2, 2, 0);
    }
    x += 8;
  }
}

constexpr std::uint16_t kPaper = 255;
constexpr std::uint16_t kLit = 255;
constexpr std::uint16_t kDark = 32;
constexpr std::uint16_t kGrid = 128;

void draw_pattern(Sheet& sheet, const ChartLayout& layout, std::size_t i) {
  const ThresholdMatrix& matrix = *layout.matrix;
  fill(sheet, layout.left(i) - 1, layout.top(i) - 1, layout.cell_width() + 2,
       layout.cell_height() + 2, kGrid);
  const int inset = layout.dot > 4 ? 1 : 0;  // lines between dots that have room for them
  for (int y = 0; y < matrix.height; ++y) {
    for (int x = 0; x < matrix.width; ++x) {
      fill(sheet, layout.left(i) + x * layout.dot, layout.top(i) + y * layout.dot,
           layout.dot - inset, layout.dot - inset,
           matrix.row(y)[x] < layout.levels[i] ? kLit : kDark);
    }
  }
  draw_number(sheet, layout.left(i), layout.top(i) + layout.cell_height() + 4, layout.levels[i]);
}

void write_png(const ChartLayout& layout, const std::string& path, bool force) {
  Sheet sheet(layout.width(), layout.height(), 1);
  fill(sheet, 0, 0, layout.width(), layout.height(), kPaper);
  for (std::size_t i = 0; i < layout.levels.size(); ++i) draw_pattern(sheet, layout, i);
  FrameInfo info{.width = layout.width(), .height = layout.height()};
  info.layout.packing = *find_by_name(kPackings, "gray8");
  info.srgb = true;
  const auto sink = open_code_sink(path, info, {.replace = force});
  sink->write(sheet.view());
  sink->finish();
}

// Lit dots of a row that touch are one rectangle.
void draw_pattern(SvgDrawing& drawing, const ChartLayout& layout, std::size_t i) {
  const ThresholdMatrix& matrix = *layout.matrix;
  const double left = layout.left(i);
  const double top = layout.top(i);
  drawing.rectangle({left, top}, layout.cell_width(), layout.cell_height(),
                    {.fill = "#202020", .stroke = {.color = "#808080", .width = 1}});
  for (int y = 0; y < matrix.height; ++y) {
    for (int x = 0; x < matrix.width;) {
      int end = x;
      while (end < matrix.width && matrix.row(y)[end] < layout.levels[i]) ++end;
      if (end > x) {
        drawing.rectangle({left + x * layout.dot, top + y * layout.dot}, (end - x) * layout.dot,
                          layout.dot, {.fill = "#fff"});
      }
      x = std::max(end, x + 1);
    }
  }
  for (int k = 1; layout.dot > 4 && k < std::max(matrix.width, matrix.height); ++k) {
    const SvgStroke grid{.color = "#808080", .width = 0.5};
    const double at = k * layout.dot;
    if (k < matrix.width) {
      drawing.line({left + at, top}, {left + at, top + layout.cell_height()}, grid);
    }
    if (k < matrix.height) {
      drawing.line({left, top + at}, {left + layout.cell_width(), top + at}, grid);
    }
  }
  drawing.text({left, top + layout.cell_height() + 12}, std::to_string(layout.levels[i]),
               {.size = 11});
}

void write_svg(const ChartLayout& layout, const std::string& path, bool force) {
  const ThresholdMatrix& matrix = *layout.matrix;
  SvgDrawing drawing(layout.width(), layout.height(), "Patterns of " + matrix.name,
                     "Each level lights the dots of the one before and one or more others.");
  drawing.rectangle({0, 0}, layout.width(), layout.height(), {.fill = "#fff"});
  for (std::size_t i = 0; i < layout.levels.size(); ++i) draw_pattern(drawing, layout, i);
  OutputFile file(path, force);
  file.write(drawing.document());
  file.commit();
}

void check_output(const std::string& output) {
  if (output.empty()) {
    throw Error(ErrorKind::kMisuse, "--output", "is missing", "give -o chart.png or chart.svg");
  }
  const std::string extension = std::filesystem::path(output).extension().string();
  if (extension == ".png" || extension == ".svg") return;
  throw Error(ErrorKind::kMisuse, "--output", "'" + output + "' is neither .png nor .svg",
              "give -o chart.png or chart.svg");
}

}  // namespace

void run_halftone_patterns(Arguments arguments) {
  std::vector<std::string> names;
  MatrixOptions options;
  std::string output;
  int dot = 0;
  bool force = false;
  CommandLine line(*halftone_job("patterns"), kExamples);
  line.positional("NAME", "a matrix, or a file with your own", names, 1, 1);
  declare_matrix_options(line, options);
  line.option("-o,--output", "OUT", "chart.png or chart.svg", output);
  line.option("--dot", "N", "side of a drawn dot in pixels, 1 to 64; default: as there is room",
              [&dot](const std::string& v) { dot = integer_option("--dot", v, 1, 64); });
  line.flag("-f,--force", "replace an existing file", force);
  if (!line.parse(arguments)) return;
  check_output(output);
  refuse_inputs_as_outputs({names[0]}, {output});
  refuse_taken_outputs({output}, force);
  const ThresholdMatrix matrix = halftone_matrix(names[0], options);
  constexpr int kMostSide = 256;
  if (matrix.width > kMostSide || matrix.height > kMostSide) {
    throw Error(ErrorKind::kMisuse, names[0],
                "is " + std::to_string(matrix.width) + " x " + std::to_string(matrix.height) +
                    ", too large to draw",
                "draw matrices of up to 256 a side");
  }
  const ChartLayout layout = layout_of(matrix, dot);
  if (output.ends_with(".svg")) return write_svg(layout, output, force);
  write_png(layout, output, force);
}

}  // namespace tristim::tools
