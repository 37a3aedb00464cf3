#include "tools/screen_chart.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <vector>

#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/dither/ordered.h"
#include "tristim/frame/io/write.h"

namespace tristim::tools {
namespace {

constexpr int kPatch = 128;  // pixels a side
constexpr std::string_view kUsualTones = "0.05,0.1,0.25,0.5,0.75,0.9,0.95";
constexpr std::size_t kMostCsv = std::size_t{16} << 20;  // thresholds

std::vector<float> tones_of(const std::string& text) {
  std::vector<float> tones;
  const std::string_view list = text.empty() ? kUsualTones : std::string_view(text);
  for (const std::string_view part : split(list, ',')) {
    const auto tone = parse_number(part);
    if (!tone || !(*tone >= 0 && *tone <= 1)) {
      throw Error(ErrorKind::kMisuse, "--tones", "'" + std::string(part) + "' is no tone",
                  "give numbers from 0 (black) to 1 (white): 0.1,0.5");
    }
    tones.push_back(static_cast<float>(*tone));
  }
  return tones;
}

void write_chart(const std::string& output, const Screen& screen, const std::vector<float>& tones,
                 bool replace) {
  FrameInfo info;
  info.width = kPatch * static_cast<int>(tones.size());
  info.height = kPatch;
  info.layout.packing = *find_by_name(kPackings, "mono1");
  info.dpi = screen.dpi;
  const OrderedDither dither({{0, 1}, {0, 1}}, screen_matrix(screen));
  const auto sink = open_code_sink(output, info, {.format = "png", .replace = replace});
  std::vector<float> light;
  for (const float tone : tones) light.insert(light.end(), kPatch, tone);
  std::vector<std::uint16_t> codes(light.size());
  for (int y = 0; y < kPatch; ++y) {
    dither.row({light.data(), info.width, 1}, y, {codes.data(), info.width, 1});
    sink->write({codes.data(), info.width, 1, 1, info.width});
  }
  sink->finish();
}

nlohmann::ordered_json matrix_json(const ThresholdMatrix& matrix) {
  return {{"name", matrix.name},   {"width", matrix.width}, {"height", matrix.height},
          {"shift", matrix.shift}, {"ranks", matrix.ranks}, {"rank", matrix.rank}};
}

// The rows until the shifts of the tile add up to its width.
std::string matrix_csv(const std::string& output, const ThresholdMatrix& matrix) {
  const int turns = matrix.width / std::gcd(matrix.width, matrix.shift);
  const auto width = static_cast<std::size_t>(matrix.width);
  const std::size_t rows =
      static_cast<std::size_t>(matrix.height) * static_cast<std::size_t>(turns);
  if (rows * width > kMostCsv) {
    throw Error(ErrorKind::kMisuse, output,
                "a table that tiles without a shift has " + std::to_string(rows) + " rows of " +
                    std::to_string(width),
                "write .json, which has the shift, or give --single-cell");
  }
  std::string text;
  for (std::size_t y = 0; y < rows; ++y) {
    const std::uint16_t* rank = matrix.row(static_cast<int>(y));
    const auto first = static_cast<std::size_t>(matrix.column(static_cast<int>(y)));
    for (std::size_t x = 0; x < width; ++x) {
      text += std::to_string(rank[(first + x) % width]) + (x + 1 == width ? "\n" : ",");
    }
  }
  return text;
}

void write_text(const std::string& output, const std::string& text, bool replace) {
  OutputFile file(output, replace);
  file.write(text);
  file.commit();
}

}  // namespace

void write_screen(const std::string& output, const Screen& screen, const std::string& tones,
                  bool replace) {
  const std::string extension = std::filesystem::path(output).extension().string();
  const std::vector<float> asked = tones_of(tones);
  if (same_name(extension, ".png")) return write_chart(output, screen, asked, replace);
  if (same_name(extension, ".json")) {
    return write_text(output, json_line(matrix_json(screen_matrix(screen))), replace);
  }
  if (same_name(extension, ".csv")) {
    return write_text(output, matrix_csv(output, screen_matrix(screen)), replace);
  }
  throw Error(ErrorKind::kMisuse, output, "does not end in .png, .json or .csv",
              "give a chart or thresholds one of these names");
}

}  // namespace tristim::tools
