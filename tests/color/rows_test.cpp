#include "tristim/color/rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "lib/color/row_kernels.h"
#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

RowConversion rows_of(std::string_view from, std::string_view to, RowOptions options = {}) {
  return {parse_model(from, "from"), parse_model(to, "to"), Adaptation::kBradford, options};
}

std::vector<float> converted(const RowConversion& rows, const std::vector<float>& in,
                             std::size_t in_channels = 3, std::size_t out_channels = 3) {
  std::vector<float> out(in.size() / in_channels * out_channels);
  rows(in, in_channels, out, out_channels);
  return out;
}

// Names the instruction set for conversions made while it lives.
class InstructionSet {
 public:
  explicit InstructionSet(std::string_view name) {
    setenv("TRISTIM_SIMD", std::string(name).c_str(), 1);
  }
  ~InstructionSet() { unsetenv("TRISTIM_SIMD"); }
  InstructionSet(const InstructionSet&) = delete;
  InstructionSet& operator=(const InstructionSet&) = delete;
};

// Colours in and about the cube, greys, every kind of float there is.
std::vector<float> many_colors(std::size_t pixels, unsigned seed) {
  constexpr float kOdd[] = {0,          -0.0F,      1,        0.5F,   2,    -1,
                            3e38F,      -3e38F,     1e-45F,   1e-30F, kNan, kInfinity,
                            -kInfinity, 0.0031308F, 0.04045F, 360,    -60,  7e12F};
  std::mt19937 random(seed);
  std::vector<float> samples;
  while (samples.size() < 3 * pixels) {
    const unsigned kind = random() % 8;
    float c[3];
    for (float& x : c) {
      x = std::uniform_real_distribution<float>(0, 1)(random);
      if (kind == 1) x = std::uniform_real_distribution<float>(-2, 400)(random);
      if (kind == 2) x = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
      if (kind == 3) x = kOdd[random() % std::size(kOdd)];
    }
    if (kind == 4) c[1] = c[2] = c[0];
    samples.insert(samples.end(), c, c + 3);
  }
  samples.resize(3 * pixels);
  return samples;
}

std::vector<std::string> names_of_models() {
  std::vector<std::string> names;
  for (const ColorModel& model : color_models()) {
    const bool is_munsell = model.hue_turn != 360;  // a search; its last bits are its own
    if (model.to_text == nullptr && component_count(model) == 3 && !is_munsell)
      names.emplace_back(model.name);
  }
  for (const TransferFunction& curve : kTransferFunctions) {
    names.push_back("rgb:srgb/" + std::string(curve.name));
  }
  names.emplace_back("rgb:srgb/gamma2.2");
  names.emplace_back("rgb:bt2020");
  names.emplace_back("lab@d50");
  return names;
}

template <typename Check>
void for_every_conversion(Check&& check) {
  for (const std::string& name : names_of_models()) {
    for (const std::string_view hub : {"linear:srgb", "rgb:srgb", "xyz"}) {
      const ColorModel& model = *parse_model(name, "name").model;
      SCOPED_TRACE(name + " and " + std::string(hub));
      if (model.from_base != nullptr || model.base.empty()) check(hub, name);
      if (model.to_base != nullptr || model.base.empty()) check(name, hub);
    }
  }
}

TEST(Rows, AreTheSameBitsInEveryInstructionSet) {
  const std::vector<float> in = many_colors(515, 1);
  for_every_conversion([&](std::string_view from, std::string_view to) {
    std::vector<float> scalar;
    {
      const InstructionSet chosen("scalar");
      scalar = converted(rows_of(from, to), in);
    }
    for (const detail::RowKernels& kernels : detail::simd_row_kernels()) {
      SCOPED_TRACE(kernels.name);
      const InstructionSet chosen(kernels.name);
      const std::vector<float> simd = converted(rows_of(from, to), in);
      for (std::size_t i = 0; i < simd.size(); ++i) {
        ASSERT_EQ(std::bit_cast<std::uint32_t>(simd[i]), std::bit_cast<std::uint32_t>(scalar[i]))
            << "pixel " << in[i / 3 * 3] << " " << in[i / 3 * 3 + 1] << " " << in[i / 3 * 3 + 2];
      }
    }
  });
}

TEST(Rows, RunOnWhatTheProcessorHas) {
  EXPECT_TRUE(detail::row_kernels().name != "scalar" || detail::simd_row_kernels().empty());
  for (const detail::RowKernels& kernels : detail::simd_row_kernels()) {
    const InstructionSet chosen(kernels.name);
    EXPECT_EQ(detail::row_kernels().name, kernels.name);
  }
}

TEST(Rows, DoNotDependOnTheirLength) {
  const RowConversion rows = rows_of("rgb:srgb", "lab");
  const std::vector<float> in = many_colors(1001, 2);
  const std::vector<float> whole = converted(rows, in);
  for (const std::size_t pixels : {0, 1, 3, 7, 8, 9, 15, 16, 17, 127, 128, 129, 1000}) {
    const std::vector<float> part =
        converted(rows, {in.begin(), in.begin() + static_cast<std::ptrdiff_t>(3 * pixels)});
    for (std::size_t i = 0; i < part.size(); ++i) {
      ASSERT_EQ(std::bit_cast<std::uint32_t>(part[i]), std::bit_cast<std::uint32_t>(whole[i]));
    }
  }
}

// 1.5 units in the last place, 2 for roots; Lab and Luv 4e-5, and beyond 100 in proportion.
double bound_of_row(const ColorModel& to, double largest) {
  const bool is_lightness = to.name.starts_with("lab") || to.name.starts_with("luv");
  return is_lightness ? std::max(4e-5, 4.5e-7 * largest) : 2.4e-7 * largest;
}

TEST(Rows, AreTheDoubleFunctionsWithinTheirBounds) {
  const std::vector<float> in = many_colors(2000, 3);
  for_every_conversion([&](std::string_view from, std::string_view to) {
    const RowConversion rows = rows_of(from, to, {.keep_undefined = true});
    const std::vector<float> out = converted(rows, in);
    for (std::size_t i = 0; i < in.size(); i += 3) {
      const float* c = &in[i];
      if (!(std::fabs(c[0]) < 1e3F && std::fabs(c[1]) < 1e3F && std::fabs(c[2]) < 1e3F)) continue;
      const Components expected = rows.conversion()({c[0], c[1], c[2]});
      double largest = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        if (std::isfinite(expected[k])) largest = std::max(largest, std::fabs(expected[k]));
      }
      for (std::size_t k = 0; k < 3; ++k) {
        if (std::isnan(expected[k])) {
          EXPECT_TRUE(std::isnan(out[i + k])) << c[0] << " " << c[1] << " " << c[2];
          continue;
        }
        const bool grey = rows.conversion().to().hue == static_cast<int>(k) && expected[1] < 1e-6;
        if (grey) continue;  // the hue of what cancelled
        const bool turn = std::fabs(expected[k] - 360) < 4e-5 && out[i + k] == 0;  // never 360
        if (turn || std::fabs(expected[k]) > 1e30) continue;
        ASSERT_NEAR(out[i + k], expected[k], bound_of_row(rows.conversion().to(), largest))
            << k << ": " << c[0] << " " << c[1] << " " << c[2];
      }
    }
  });
}

TEST(Rows, KeepGreysOfEverySetExactlyNeutral) {
  std::vector<float> greys;
  for (int code = -20; code <= 300; ++code) greys.insert(greys.end(), 3, float(code) / 255);
  for (const NamedPrimaries& set : primaries_list()) {
    for (const std::string model : {"linear:", "rgb:"}) {
      for (const std::string_view to : {"lab", "luv"}) {
        SCOPED_TRACE(model + std::string(set.name) + " to " + std::string(to));
        const std::vector<float> out = converted(rows_of(model + std::string(set.name), to), greys);
        for (std::size_t i = 0; i < out.size(); i += 3) {
          ASSERT_EQ(out[i + 1], 0) << greys[i];
          ASSERT_EQ(out[i + 2], 0) << greys[i];
        }
      }
    }
  }
}

TEST(Rows, GiveNoUndefinedComponentUnlessAsked) {
  const std::vector<float> grey{0.5F, 0.5F, 0.5F};
  EXPECT_EQ(converted(rows_of("rgb", "hsv"), grey), (std::vector<float>{0, 0, 0.5F}));
  EXPECT_EQ(converted(rows_of("linear", "xyy"), {0, 0, 0}), (std::vector<float>{0, 0, 0}));
  EXPECT_TRUE(std::isnan(converted(rows_of("rgb", "hsv", {.keep_undefined = true}), grey)[0]));
  // max + min = 0: no saturation outside the cube
  EXPECT_EQ(converted(rows_of("rgb", "hls"), {0.5F, -0.5F, 0})[2], 0);
  EXPECT_TRUE(
      std::isnan(converted(rows_of("rgb", "hls", {.keep_undefined = true}), {0.5F, -0.5F, 0})[2]));
}

TEST(Rows, PassNan) {
  for_every_conversion([&](std::string_view from, std::string_view to) {
    const bool hue_first = from.starts_with("h");
    const std::vector<float> in =
        hue_first ? std::vector<float>{0.5F, kNan, 0.5F} : std::vector<float>{kNan, 0.5F, 0.5F};
    const std::vector<float> out = converted(rows_of(from, to), in);
    EXPECT_TRUE(std::isnan(out[0]) || std::isnan(out[1]) || std::isnan(out[2]));
  });
}

TEST(Rows, NeverHaveAHueOf360) {
  std::vector<float> in;
  for (float blue = 0; blue < 1e-4F; blue = std::nextafter(blue * 1.01F, 1.0F)) {
    in.insert(in.end(), {1, 0, blue});
  }
  const std::vector<float> out = converted(rows_of("rgb", "hsv"), in);
  for (std::size_t i = 0; i < out.size(); i += 3) ASSERT_LT(out[i], 360) << in[i + 2];
}

TEST(Rows, ReadHuesModuloATurn) {
  const RowConversion rows = rows_of("hsv", "rgb");
  const std::vector<float> expected = converted(rows, {300, 0.5F, 0.7F});
  EXPECT_EQ(converted(rows, {-60, 0.5F, 0.7F}), expected);
  EXPECT_EQ(converted(rows, {660, 0.5F, 0.7F}), expected);
  EXPECT_EQ(converted(rows, {kNan, 0, 0.7F}), (std::vector<float>{0.7F, 0.7F, 0.7F}));
  for (const float hue : {1e9F, 7e12F, 3e25F, 3e38F, -3e38F}) {
    const Components c = rows.conversion()({hue, 0.5, 0.75});
    const std::vector<float> out = converted(rows, {hue, 0.5F, 0.75F});
    EXPECT_NEAR(out[0], c[0], 1e-7) << hue;
    EXPECT_NEAR(out[1], c[1], 1e-7) << hue;
    EXPECT_NEAR(out[2], c[2], 1e-7) << hue;
  }
}

TEST(Rows, CarryAlpha) {
  const RowConversion rows = rows_of("rgb", "cmy");
  EXPECT_EQ(converted(rows, {1, 0, 0.25F, 0.5F}, 4, 4), (std::vector<float>{0, 1, 0.75F, 0.5F}));
  EXPECT_EQ(converted(rows, {1, 0, 0.25F}, 3, 4), (std::vector<float>{0, 1, 0.75F, 1}));
  EXPECT_EQ(converted(rows, {1, 0, 0.25F, 0.5F}, 4, 3), (std::vector<float>{0, 1, 0.75F}));
  EXPECT_TRUE(std::isnan(converted(rows, {1, 0, 0.25F, kNan}, 4, 4)[3]));
  // CMYK has no room for it
  EXPECT_EQ(converted(rows_of("rgb", "cmyk"), {1, 0.5F, 0.5F, 0.25F}, 4, 4),
            (std::vector<float>{0, 0.5F, 0.5F, 0}));
}

TEST(Rows, GiveTheSameColorsBesideAlpha) {
  const std::vector<float> in = many_colors(300, 6);
  std::vector<float> with_alpha;
  for (std::size_t i = 0; i < in.size(); i += 3) {
    with_alpha.insert(with_alpha.end(), {in[i], in[i + 1], in[i + 2], 0.25F});
  }
  for (const std::string_view to : {"hsv", "lab", "luv", "oklab", "xyz"}) {
    SCOPED_TRACE(to);
    const RowConversion rows = rows_of(to == "hsv" ? "rgb" : "linear", to);
    const std::vector<float> expected = converted(rows, in);
    const std::vector<float> out = converted(rows, with_alpha, 4, 4);
    for (std::size_t i = 0; i < in.size(); ++i) {
      ASSERT_EQ(std::bit_cast<std::uint32_t>(out[i / 3 * 4 + i % 3]),
                std::bit_cast<std::uint32_t>(expected[i]));
    }
    EXPECT_EQ(out.back(), 0.25F);
  }
}

TEST(Rows, ConvertInPlace) {
  std::vector<float> row = many_colors(300, 5);
  const RowConversion rows = rows_of("linear", "oklab");
  const std::vector<float> expected = converted(rows, row);
  rows(row, 3, row, 3);
  for (std::size_t i = 0; i < row.size(); ++i) {
    ASSERT_EQ(std::bit_cast<std::uint32_t>(row[i]), std::bit_cast<std::uint32_t>(expected[i]));
  }
}

TEST(Rows, RefuseRowsThatDoNotFit) {
  const RowConversion rows = rows_of("rgb", "cmyk");
  std::vector<float> four(4);
  EXPECT_THROW(rows(four, 2, four, 4), std::invalid_argument);
  EXPECT_THROW(rows(four, 4, four, 3), std::invalid_argument);
  std::vector<float> six(6);
  EXPECT_THROW(rows(six, 3, four, 4), std::invalid_argument);
}

// Of the 16.7 million 8-bit colours those of every 15th code, and all greys; bench/accuracy --full
// takes all.
TEST(Rows, KeepEightBitColors) {
  std::vector<float> in;
  for (int r = 0; r < 256; r += 15) {
    for (int g = 0; g < 256; g += 15) {
      for (int b = 0; b < 256; b += 15) {
        for (const int code : {r, g, b}) in.push_back(static_cast<float>(code / 255.0));
      }
    }
  }
  for (int code = 0; code < 256; ++code) in.insert(in.end(), 3, static_cast<float>(code / 255.0));
  for (const std::string_view model :
       {"hsv", "hls", "hsl", "yiq", "xyz", "lab", "luv", "lch", "lchuv", "oklab", "oklch"}) {
    SCOPED_TRACE(model);
    const std::vector<float> back =
        converted(rows_of(model, "rgb"), converted(rows_of("rgb", model), in));
    for (std::size_t i = 0; i < in.size(); ++i) {
      ASSERT_EQ(std::floor(255 * back[i] + 0.5F), std::floor(255 * in[i] + 0.5F)) << i;
    }
  }
}

TEST(Rows, KeepSixteenBitCodesThroughEveryCurve) {
  std::vector<float> codes(3 * 21846);
  for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = static_cast<float>(double(i) / 65535);
  for (const TransferFunction& curve : kTransferFunctions) {
    SCOPED_TRACE(curve.name);
    const std::string model = "rgb:srgb/" + std::string(curve.name);
    const std::vector<float> back =
        converted(rows_of("linear:srgb", model), converted(rows_of(model, "linear:srgb"), codes));
    int lost = 0;
    for (std::size_t i = 0; i <= 65535; ++i) {
      if (std::floor(65535 * double{back[i]} + 0.5) != double(i)) ++lost;
    }
    // the gaps that these two have as printed
    EXPECT_EQ(lost, curve.name == "bt709" ? 16 : curve.name == "smpte240m" ? 7 : 0);
  }
}

TEST(Rows, AgreeWithTheExamplesOfOddNumbers) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  int compared = 0;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/nan_inf_policy.csv")) {
    const std::string& op = row.text("op");
    if (!op.starts_with("rgb_to_h")) continue;
    SCOPED_TRACE(row.text("id"));
    const std::vector<float> out =
        converted(rows_of("rgb", op.substr(7)),
                  {float(row.number("i0")), float(row.number("i1")), float(row.number("i2"))});
    int numbers = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string& expected = row.text("o" + std::to_string(k));
      if (expected == "nan_or_any" && !std::isnan(out[k])) ++numbers;
      if (expected == "undef") EXPECT_EQ(out[k], 0);
      if (expected == "finite") EXPECT_TRUE(std::isfinite(out[k]));
      if (parse_number(expected)) EXPECT_EQ(out[k], std::stof(expected));
    }
    EXPECT_LT(numbers, 3);
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

}  // namespace
}  // namespace tristim
