#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "tristim/device/display.h"
#include "tristim/image/picture.h"
#include "tristim/pipeline/proof.h"

namespace tristim::detail {

/// How much of each ink lies on a pixel, by code: 0, bare, to kSolid. A device of greys has one
/// ink, its darkest level.
struct InkCoverage {
  static constexpr int kSolid = 65535;

  explicit InkCoverage(const Display& display);

  std::vector<Ink> inks;
  std::vector<std::vector<std::uint16_t>> of_code;  // by ink
};

/// What dots add to the paper around them, or lack themselves, so that an area on average seems to
/// be as large as its gain makes it.
class SpreadInk {
 public:
  explicit SpreadInk(const DotGain& gain);

  /// The area that a pixel seems to cover where it is covered by `own` and its surroundings by
  /// `mean`: the rest of it, or all of it, takes the same share everywhere.
  float operator()(float own, float mean) const noexcept;

 private:
  std::vector<float> share_;  // by mean; above 0 of what is bare, below 0 of what is covered
};

/// Codes to the light of the dots that they make on paper. Works on rows as they come and writes
/// each when as many rows as `dots.reach` have come below it, at the end the rest.
class PrintedDotsSink final : public CodeSink {
 public:
  PrintedDotsSink(const Display& display, const SeenDots& dots, std::unique_ptr<RowSink> light);
  void write(ImageView<const std::uint16_t> rows) override;
  void finish() override;

 private:
  void take(std::span<const std::uint16_t> codes);
  void count(std::span<const std::uint16_t> codes, int sign);
  void write_row(int y);
  void spread_ink(std::size_t ink, std::span<const std::uint16_t> codes, std::span<float> areas);

  InkCoverage coverage_;
  SpreadInk spread_;
  int reach_;
  std::unique_ptr<RowSink> light_;
  std::deque<std::vector<std::uint16_t>> rows_;  // those around the next to be written ...
  int first_row_ = 0;                            // ... from this one on
  int written_ = 0;
  std::vector<std::vector<std::uint32_t>> columns_;  // sums over rows_, by ink
};

}  // namespace tristim::detail
