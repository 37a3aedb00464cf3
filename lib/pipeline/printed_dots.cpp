#include "lib/pipeline/printed_dots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tristim/color/primaries.h"
#include "tristim/image/memory.h"
#include "tristim/pipeline/reduce.h"

namespace tristim::detail {
namespace {

constexpr std::size_t kSpreadSteps = 4096;

std::uint16_t covered_part(double area) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(area, 0.0, 1.0) * InkCoverage::kSolid));
}

}  // namespace

InkCoverage::InkCoverage(const Display& display) {
  if (display.press) {
    inks = display.press->inks;
    for (std::size_t i = 0; i < inks.size(); ++i) {
      of_code.emplace_back();
      for (std::size_t code = 0; code < display.palette.size(); ++code) {
        of_code.back().push_back((code >> i & 1) != 0 ? kSolid : 0);
      }
    }
    return;
  }
  const Decoder decoder(display);
  const Eigen::RowVector3d weights = xyz_from_rgb(display.primaries).row(1);
  const auto luminance = [&](const Rgb& c) -> double {
    return weights * Eigen::Vector3d(c.r, c.g, c.b);
  };
  const std::size_t codes = display.palette.empty()
                                ? std::size_t{1} << display.frame.packing.bits[0]
                                : display.palette.size();
  std::vector<Rgb> light;
  for (std::size_t code = 0; code < codes; ++code) {
    const auto sample = static_cast<std::uint16_t>(code);
    light.push_back(decoder.light(&sample));
  }
  const Rgb darkest = *std::ranges::min_element(light, {}, luminance);
  inks.push_back({"ink", darkest});
  of_code.emplace_back();
  for (const Rgb& c : light) {
    of_code.back().push_back(covered_part((1 - luminance(c)) / (1 - luminance(darkest))));
  }
}

SpreadInk::SpreadInk(const DotGain& gain) {
  for (std::size_t i = 0; i <= kSpreadSteps; ++i) {
    const double mean = static_cast<double>(i) / kSpreadSteps;
    const double more = covered_area(gain, mean) - mean;
    const double of = more > 0 ? 1 - mean : mean;
    share_.push_back(static_cast<float>(of > 0 ? more / of : 0));
  }
}

float SpreadInk::operator()(float own, float mean) const noexcept {
  const float place = std::clamp(mean, 0.0F, 1.0F) * static_cast<float>(kSpreadSteps);
  const auto i = std::min(static_cast<std::size_t>(place), kSpreadSteps - 1);
  const float share = share_[i] + (share_[i + 1] - share_[i]) * (place - static_cast<float>(i));
  return own + share * (share > 0 ? 1 - own : own);
}

PrintedDotsSink::PrintedDotsSink(const Display& display, const SeenDots& dots,
                                 std::unique_ptr<RowSink> light)
    : coverage_(display), spread_(dots.gain), reach_(dots.reach), light_(std::move(light)) {}

void PrintedDotsSink::write(ImageView<const std::uint16_t> rows) {
  if (columns_.empty()) {
    columns_.assign(coverage_.inks.size(),
                    std::vector<std::uint32_t>(static_cast<std::size_t>(rows.width)));
  }
  for (int y = 0; y < rows.height; ++y) take(rows.row(y));
}

void PrintedDotsSink::finish() {
  while (written_ < first_row_ + static_cast<int>(rows_.size())) write_row(written_);
  light_->finish();
}

void PrintedDotsSink::take(std::span<const std::uint16_t> codes) {
  rows_.emplace_back(codes.begin(), codes.end());
  count(codes, 1);
  const int last = first_row_ + static_cast<int>(rows_.size()) - 1;
  if (last - written_ == reach_) write_row(written_);
}

void PrintedDotsSink::count(std::span<const std::uint16_t> codes, int sign) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    for (std::size_t x = 0; x < codes.size(); ++x) {
      const std::uint32_t part = coverage_.of_code[i][codes[x]];
      columns_[i][x] += sign > 0 ? part : 0 - part;
    }
  }
}

// `areas`: of one ink, of the row `codes` in the middle of rows_.
void PrintedDotsSink::spread_ink(std::size_t ink, std::span<const std::uint16_t> codes,
                                 std::span<float> areas) {
  const std::vector<std::uint32_t>& columns = columns_[ink];
  const auto width = static_cast<int>(columns.size());
  std::uint64_t sum = 0;
  for (int x = 0; x < std::min(reach_, width); ++x) sum += columns[static_cast<std::size_t>(x)];
  for (int x = 0; x < width; ++x) {
    const int right = x + reach_;
    const int left = x - reach_;
    if (right < width) sum += columns[static_cast<std::size_t>(right)];
    if (left > 0) sum -= columns[static_cast<std::size_t>(left - 1)];
    const int wide = std::min(right, width - 1) - std::max(left, 0) + 1;
    const double most = double{InkCoverage::kSolid} * wide * static_cast<double>(rows_.size());
    const auto at = static_cast<std::size_t>(x);
    const float own = static_cast<float>(coverage_.of_code[ink][codes[at]]) / InkCoverage::kSolid;
    areas[at] = spread_(own, static_cast<float>(static_cast<double>(sum) / most));
  }
}

void PrintedDotsSink::write_row(int y) {
  for (; first_row_ < y - reach_; ++first_row_) {
    count(rows_.front(), -1);
    rows_.pop_front();
  }
  const std::vector<std::uint16_t>& codes = rows_[static_cast<std::size_t>(y - first_row_)];
  const std::size_t width = codes.size();
  std::vector<std::vector<float>> areas(coverage_.inks.size(), std::vector<float>(width));
  for (std::size_t i = 0; i < areas.size(); ++i) spread_ink(i, codes, areas[i]);
  Image light(static_cast<int>(width), 1, 3);
  std::vector<double> of_pixel(areas.size());
  for (std::size_t x = 0; x < width; ++x) {
    for (std::size_t i = 0; i < areas.size(); ++i) of_pixel[i] = areas[i][x];
    const Rgb seen = printed_light(coverage_.inks, of_pixel);
    float* to = light.view().pixel(static_cast<int>(x), 0);
    to[0] = static_cast<float>(seen.r);
    to[1] = static_cast<float>(seen.g);
    to[2] = static_cast<float>(seen.b);
  }
  light_->write(light.view());
  ++written_;
}

}  // namespace tristim::detail
