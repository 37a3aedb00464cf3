#include "tristim/image/fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/image/memory.h"

namespace tristim {
namespace {

/// Rows made as they are asked for; counts them, and fails at a row where asked to.
class MadeRows : public RowSource {
 public:
  MadeRows(PictureInfo info, std::function<float(int x, int y, int c)> sample)
      : info_(std::move(info)), sample_(std::move(sample)) {}

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    ASSERT_EQ(rows.width, info_.width);
    ASSERT_EQ(rows.channels, info_.channels);
    ASSERT_LE(next_ + rows.height, info_.height);
    for (int y = 0; y < rows.height; ++y, ++next_) {
      if (next_ == fails_at) throw Error(ErrorKind::kContent, "made.exr", "row is damaged");
      for (int x = 0; x < rows.width; ++x) {
        for (int c = 0; c < rows.channels; ++c) rows.pixel(x, y)[c] = sample_(x, next_, c);
      }
    }
  }

  int fails_at = -1;

 private:
  PictureInfo info_;
  std::function<float(int, int, int)> sample_;
  int next_ = 0;
};

PictureInfo sized(int width, int height, int channels = 3) {
  PictureInfo info;
  info.width = width;
  info.height = height;
  info.channels = channels;
  info.name = "made.exr";
  return info;
}

std::unique_ptr<MadeRows> flat(int width, int height, float value = 0.25F) {
  return std::make_unique<MadeRows>(sized(width, height), [=](int, int, int) { return value; });
}

/// Light that differs everywhere: no two of its rows or columns are alike.
float noise(int x, int y, int c) {
  auto bits = static_cast<unsigned>(x * 7919 + y * 104729 + c * 1299709 + 12345);
  bits = (bits ^ (bits >> 15)) * 2246822519U;
  bits = (bits ^ (bits >> 13)) * 3266489917U;
  return static_cast<float>((bits ^ (bits >> 16)) >> 8) / 16777216.0F;
}

std::unique_ptr<MadeRows> noisy(int width, int height, int channels = 3) {
  return std::make_unique<MadeRows>(sized(width, height, channels), noise);
}

Image read_all(RowSource& source, int band = 1 << 30) {
  const PictureInfo& info = source.info();
  Image image(info.width, info.height, info.channels);
  for (int y = 0; y < info.height;) {
    const int count = std::min(band, info.height - y);
    source.read(image.view().rows(y, count));
    y += count;
  }
  return image;
}

Image fitted(std::unique_ptr<RowSource> source, const FitOptions& options) {
  return read_all(*fit(std::move(source), options));
}

std::vector<float> samples(const Image& image) {
  const auto view = image.view();
  return {view.data, view.data + view.stride * view.height};
}

/// One channel of a small picture, row after row.
std::vector<float> channel(const Image& image, int c = 0) {
  std::vector<float> values;
  for (int y = 0; y < image.view().height; ++y) {
    for (int x = 0; x < image.view().width; ++x) values.push_back(image.view().pixel(x, y)[c]);
  }
  return values;
}

double mean(const Image& image) {
  double sum = 0;
  const auto all = samples(image);
  for (const float sample : all) sum += double{sample};
  return sum / static_cast<double>(all.size());
}

/// The pixels that differ from the background (9), as left, top, right, bottom (exclusive).
std::vector<int> inner_box(const Image& image) {
  int left = 1 << 30, top = 1 << 30, right = 0, bottom = 0;
  const auto view = image.view();
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      if (view.pixel(x, y)[0] > 8) continue;
      left = std::min(left, x), right = std::max(right, x + 1);
      top = std::min(top, y), bottom = std::max(bottom, y + 1);
    }
  }
  return {left, top, right, bottom};
}

FitOptions framed(int width, int height, FitMode mode) {
  FitOptions options{.width = width, .height = height, .mode = mode};
  options.background = {9, 9, 9};
  return options;
}

TEST(Fit, ReturnsTheSourceWhereNothingIsToBeDone) {
  for (const auto& options : {FitOptions{}, FitOptions{.width = 40, .height = 30},
                              FitOptions{.width = 40}, FitOptions{.height = 30}}) {
    auto source = flat(40, 30);
    const RowSource* const before = source.get();
    EXPECT_EQ(fit(std::move(source), options).get(), before);
  }
}

TEST(Fit, EveryModeMakesTheAskedSize) {
  for (const auto& mode : kFitModes) {
    for (const auto& [width, height] :
         {std::pair{800, 480}, {480, 800}, {1, 1}, {64, 48}, {63, 49}, {7, 300}}) {
      SCOPED_TRACE(std::string(mode.name) + " " + std::to_string(width) + "x" +
                   std::to_string(height));
      const auto source = fit(flat(64, 48), framed(width, height, mode.mode));
      EXPECT_EQ(source->info().width, width);
      EXPECT_EQ(source->info().height, height);
      for (const float sample : samples(read_all(*source))) {
        ASSERT_TRUE(sample == 9.0F || std::abs(sample - 0.25F) < 5e-7F) << sample;
      }
    }
  }
}

TEST(Fit, ContainCentresAllOfThePicture) {
  // 64x48 in 100x48: 64 wide, 36 columns left over; in 33x100: 33 x 24.75, rounded to 25.
  EXPECT_EQ(inner_box(fitted(flat(64, 48), framed(100, 48, FitMode::kContain))),
            (std::vector{18, 0, 82, 48}));
  EXPECT_EQ(inner_box(fitted(flat(64, 48), framed(33, 100, FitMode::kContain))),
            (std::vector{0, 37, 33, 62}));
}

TEST(Fit, AContainedSideIsAtLeastOnePixel) {
  EXPECT_EQ(inner_box(fitted(flat(1000, 1), framed(20, 11, FitMode::kContain))),
            (std::vector{0, 5, 20, 6}));
}

TEST(Fit, CoverAndStretchLeaveNoBackground) {
  for (const FitMode mode : {FitMode::kCover, FitMode::kStretch}) {
    EXPECT_EQ(inner_box(fitted(flat(64, 48), framed(100, 31, mode))), (std::vector{0, 0, 100, 31}));
  }
}

TEST(Fit, CoverKeepsTheMiddle) {
  // Columns 0..8 of value 0..8 in 3x3 pixels of their own size: columns 3, 4, 5 are left.
  const auto source = [] {
    return std::make_unique<MadeRows>(sized(9, 3),
                                      [](int x, int, int) { return static_cast<float>(x); });
  };
  EXPECT_EQ(channel(fitted(source(), framed(3, 3, FitMode::kCover))),
            (std::vector<float>{3, 4, 5, 3, 4, 5, 3, 4, 5}));
}

TEST(Fit, NoneCropsAndPadsWithoutResampling) {
  const auto source = [] {
    return std::make_unique<MadeRows>(
        sized(5, 2), [](int x, int y, int) { return static_cast<float>(x + 10 * y) / 10; });
  };
  EXPECT_EQ(channel(fitted(source(), framed(2, 4, FitMode::kNone))),
            (std::vector<float>{9, 9, 0.1F, 0.2F, 1.1F, 1.2F, 9, 9}));
}

TEST(Fit, OneSideFollowsFromTheOther) {
  const auto size = [](int width, int height, int degrees) {
    FitOptions options{.width = width, .height = height};
    options.rotate_deg = degrees;
    const auto source = fit(flat(64, 48), options);
    return std::pair(source->info().width, source->info().height);
  };
  EXPECT_EQ(size(32, 0, 0), std::pair(32, 24));
  EXPECT_EQ(size(0, 24, 0), std::pair(32, 24));
  EXPECT_EQ(size(24, 0, 90), std::pair(24, 32));
  EXPECT_EQ(size(1, 0, 0), std::pair(1, 1));
}

TEST(Fit, SquaresPixels) {
  const auto fitted_info = [](double aspect, const FitOptions& options) {
    PictureInfo info = sized(40, 30);
    info.pixel_aspect = aspect;
    return fit(std::make_unique<MadeRows>(info, noise), options)->info();
  };
  EXPECT_EQ(fitted_info(2, {}).width, 80);
  EXPECT_EQ(fitted_info(2, {}).height, 30);
  EXPECT_EQ(fitted_info(2, {}).pixel_aspect, 1);
  EXPECT_EQ(fitted_info(0.5, {}).width, 20);
  EXPECT_EQ(fitted_info(2, {.rotate_deg = 90}).width, 30);
  EXPECT_EQ(fitted_info(2, {.rotate_deg = 90}).height, 80);
  EXPECT_EQ(fitted_info(2, {.width = 40}).height, 15);
  EXPECT_EQ(fitted_info(1.0001, {}).pixel_aspect, 1);
}

TEST(Fit, SquaresPixelsInsideAFrame) {
  PictureInfo info = sized(40, 30);
  info.pixel_aspect = 2;  // 80 x 30 square pixels
  const auto source = [&] {
    return std::make_unique<MadeRows>(info, [](int, int, int) { return 0.5F; });
  };
  EXPECT_EQ(inner_box(fitted(source(), framed(40, 40, FitMode::kContain))),
            (std::vector{0, 12, 40, 27}));
  EXPECT_EQ(inner_box(fitted(source(), framed(100, 40, FitMode::kNone))),
            (std::vector{10, 5, 90, 35}));
}

TEST(Fit, RefusesAPixelAspectThatIsNoRatio) {
  for (const double aspect : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()}) {
    PictureInfo info = sized(4, 3);
    info.pixel_aspect = aspect;
    EXPECT_THROW(fit(std::make_unique<MadeRows>(info, noise), {}), Error);
  }
}

TEST(Fit, RefusesAShapeThatMakesASideTooLong) {
  PictureInfo info = sized(4, 3);
  info.pixel_aspect = 1e9;
  EXPECT_THROW(fit(std::make_unique<MadeRows>(info, noise), {}), Error);
  EXPECT_EQ(fit(std::make_unique<MadeRows>(info, noise), {.width = 8, .height = 4})->info().width,
            8);
}

// The picture 0 1 / 2 3 / 4 5 (2 wide, 3 high), stored as each orientation says, and what is shown.
struct OrientedRows {
  int width;
  std::vector<float> rows;
  float at(int x, int y) const {
    return rows[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x)];
  }
};

TEST(Fit, TurnsExifOrientationsUpright) {
  const OrientedRows stored[] = {{2, {0, 1, 2, 3, 4, 5}}, {2, {1, 0, 3, 2, 5, 4}},
                                 {2, {5, 4, 3, 2, 1, 0}}, {2, {4, 5, 2, 3, 0, 1}},
                                 {3, {0, 2, 4, 1, 3, 5}}, {3, {1, 3, 5, 0, 2, 4}},
                                 {3, {5, 3, 1, 4, 2, 0}}, {3, {4, 2, 0, 5, 3, 1}}};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    SCOPED_TRACE(orientation);
    const OrientedRows& rows = stored[orientation - 1];
    PictureInfo info = sized(rows.width, 6 / rows.width);
    info.orientation = orientation;
    const auto source =
        fit(std::make_unique<MadeRows>(info, [&](int x, int y, int) { return rows.at(x, y); }), {});
    EXPECT_EQ(source->info().width, 2);
    EXPECT_EQ(source->info().orientation, 1);
    EXPECT_EQ(channel(read_all(*source)), (std::vector<float>{0, 1, 2, 3, 4, 5}));
  }
}

TEST(Fit, RotatesClockwiseAfterOrientation) {
  const auto rotated = [](int degrees, int orientation) {
    PictureInfo info = sized(2, 3);
    info.orientation = orientation;
    FitOptions options;
    options.rotate_deg = degrees;
    return channel(
        fitted(std::make_unique<MadeRows>(
                   info, [](int x, int y, int) { return static_cast<float>(y * 2 + x); }),
               options));
  };
  EXPECT_EQ(rotated(90, 1), (std::vector<float>{4, 2, 0, 5, 3, 1}));
  EXPECT_EQ(rotated(180, 1), (std::vector<float>{5, 4, 3, 2, 1, 0}));
  EXPECT_EQ(rotated(270, 1), (std::vector<float>{1, 3, 5, 0, 2, 4}));
  EXPECT_EQ(rotated(90, 2), (std::vector<float>{5, 3, 1, 4, 2, 0}));
  EXPECT_EQ(rotated(90, 6), (std::vector<float>{5, 4, 3, 2, 1, 0}));
  EXPECT_EQ(rotated(270, 6), (std::vector<float>{0, 1, 2, 3, 4, 5}));
}

TEST(Fit, CropsTheSamePixelsHoweverTheRowsAreStored) {
  // Upright 5x4 of value x + 10 y, cropped to 2x1 by none: x 1..2, y 1.
  for (int orientation = 1; orientation <= 8; ++orientation) {
    SCOPED_TRACE(orientation);
    const bool swapped = orientation > 4;
    PictureInfo info = swapped ? sized(4, 5) : sized(5, 4);
    info.orientation = orientation;
    const bool from_right =
        orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool from_bottom =
        orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    const auto sample = [&](int x, int y, int) {
      const int u = from_right ? info.width - 1 - x : x;
      const int v = from_bottom ? info.height - 1 - y : y;
      return static_cast<float>(swapped ? v + 10 * u : u + 10 * v);
    };
    EXPECT_EQ(channel(fitted(std::make_unique<MadeRows>(info, sample),
                             {.width = 2, .height = 1, .mode = FitMode::kNone})),
              (std::vector<float>{11, 12}));
  }
}

TEST(Fit, TurnedResultsAreTurnsOfResults) {
  // Within rounding, whether the resampling comes before the turn (smaller) or after it (larger).
  for (const auto& [width, height] : {std::pair{20, 30}, {90, 140}}) {
    FitOptions options{.width = width, .height = height, .mode = FitMode::kStretch};
    options.rotate_deg = 90;
    const Image turned = fitted(noisy(61, 47), options);
    const Image upright =
        fitted(noisy(61, 47), {.width = height, .height = width, .mode = FitMode::kStretch});
    float largest = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        largest = std::max(largest, std::abs(turned.view().pixel(x, y)[1] -
                                             upright.view().pixel(y, width - 1 - x)[1]));
      }
    }
    EXPECT_LT(largest, 1e-6F);  // measured: 1.8e-7
  }
}

TEST(Fit, KeepsAConstant) {
  // Largest error measured: 1.4e-6 of the value (bicubic).
  for (const auto& filter : kFilters) {
    for (const auto& [width, height] :
         {std::pair{800, 480}, {1, 1}, {2, 3}, {1024, 400}, {90, 1500}}) {
      SCOPED_TRACE(std::string(filter.name) + " " + std::to_string(width) + "x" +
                   std::to_string(height));
      FitOptions options{.width = width, .height = height, .mode = FitMode::kStretch};
      options.filter = filter;
      for (const float sample : samples(fitted(flat(1023, 601, 0.7F), options))) {
        ASSERT_NEAR(sample, 0.7F, 0.7F * 2e-6F);
      }
    }
  }
}

TEST(Fit, OnePixelBecomesAFlatPictureExactly) {
  for (const auto& filter : kFilters) {
    FitOptions options{.width = 800, .height = 480, .mode = FitMode::kStretch};
    options.filter = filter;
    const Image image = fitted(flat(1, 1, 0.3F), options);
    EXPECT_TRUE(std::ranges::all_of(samples(image), [](float s) { return s == 0.3F; }));
  }
}

TEST(Fit, ShrinkingKeepsTheMeanOfTheLight) {
  for (const auto& filter : kFilters) {
    if (filter.support == 0) continue;
    for (const auto& [width, height] : {std::pair{101, 57}, {40, 3}, {400, 7}}) {
      SCOPED_TRACE(std::string(filter.name) + " " + std::to_string(width));
      FitOptions options{.width = width, .height = height, .mode = FitMode::kStretch};
      options.filter = filter;
      // Largest error measured: 7.1e-6.
      EXPECT_NEAR(mean(fitted(noisy(808, 456), options)), mean(read_all(*noisy(808, 456))), 1e-5);
    }
  }
}

TEST(Fit, OnePixelIsTheMean) {
  const auto ramp = [](int width, int height) {
    return std::make_unique<MadeRows>(sized(width, height), [=](int x, int y, int) {
      return static_cast<float>(x + y) / static_cast<float>(width + height - 2);
    });
  };
  for (const auto& [width, height] : {std::pair{16384, 1}, {1, 16384}, {300, 200}}) {
    const Image image = fitted(ramp(width, height), {.width = 1, .height = 1});
    EXPECT_NEAR(image.view().pixel(0, 0)[0], 0.5F, 1e-6F);  // measured: 9e-8
  }
}

TEST(Fit, TheDefaultFilterMakesNoHalos) {
  const auto highlight = [] {
    return std::make_unique<MadeRows>(sized(240, 240), [](int x, int y, int) {
      return (x - 120) * (x - 120) + (y - 120) * (y - 120) < 900 ? 1000.0F : 0.18F;
    });
  };
  for (const int side : {50, 100, 239, 500}) {
    const auto all = samples(fitted(highlight(), {.width = side, .height = side}));
    EXPECT_GT(*std::ranges::min_element(all), 0.18F * (1 - 2e-6F)) << side;
    FitOptions sharp{.width = side, .height = side};
    sharp.filter = kBicubicFilter;
    const auto rings = samples(fitted(highlight(), sharp));
    EXPECT_LT(*std::ranges::min_element(rings), -10.0F) << side;
  }
}

TEST(Fit, RowsAreTheSameForAnyBandHeight) {
  for (const auto& filter : kFilters) {
    for (const auto& [width, height] : {std::pair{33, 29}, {200, 150}, {33, 150}, {5, 2}}) {
      SCOPED_TRACE(std::string(filter.name) + " " + std::to_string(height));
      FitOptions options = framed(width, height, FitMode::kContain);
      options.filter = filter;
      std::vector<float> first;
      for (const int band : {1, 2, 7, 64}) {
        const auto all = samples(read_all(*fit(noisy(101, 83), options), band));
        if (first.empty()) first = all;
        EXPECT_EQ(all, first) << band;
      }
    }
  }
}

TEST(Fit, BlocksOfRowsJoinSeamlessly) {
  // A ramp down the picture stays one, but for the ripple of the filter: .012. A misplaced row
  // would be off by 1.
  const auto ramp = [] {
    return std::make_unique<MadeRows>(sized(3, 1000),
                                      [](int, int y, int) { return static_cast<float>(y); });
  };
  for (const int height : {333, 61, 900}) {
    FitOptions options{.width = 3, .height = height, .mode = FitMode::kStretch};
    options.filter = kBicubicFilter;
    const auto rows = channel(fitted(ramp(), options));
    const double step = 1000.0 / height;
    for (int y = 5; y < height - 5; ++y) {
      ASSERT_NEAR(rows[static_cast<std::size_t>(y) * 3], (y + 0.5) * step - 0.5, 0.05) << height;
    }
  }
}

TEST(Fit, AgreesWithTheFilterSummedByHand) {
  // The triangle over mirrored pixels, in doubles, at ratios that need averaging first and do not.
  const auto triangle = [](const std::vector<double>& in, int count) {
    const int n = static_cast<int>(in.size());
    const double step = static_cast<double>(n) / count;
    const double wide = std::max(1.0, step);
    std::vector<double> out;
    for (int i = 0; i < count; ++i) {
      const double centre = (i + 0.5) * step;
      double sum = 0, weights = 0;
      for (int j = -3 * n; j < 4 * n; ++j) {
        const double weight = std::max(0.0, 1 - std::abs(j + 0.5 - centre) / wide);
        const int k = ((j % (2 * n)) + 2 * n) % (2 * n);
        sum += weight * in[static_cast<std::size_t>(k < n ? k : 2 * n - 1 - k)];
        weights += weight;
      }
      out.push_back(sum / weights);
    }
    return out;
  };
  for (const auto& [n, count] :
       {std::pair{100, 37}, {100, 1}, {3, 200}, {2, 7}, {37, 36}, {7, 2}}) {
    for (const bool down : {true, false}) {
      SCOPED_TRACE(std::to_string(n) + " to " + std::to_string(count) + (down ? " down" : ""));
      std::vector<double> in;
      in.reserve(static_cast<std::size_t>(n));
      for (int i = 0; i < n; ++i) in.push_back(noise(down ? 0 : i, down ? i : 0, 0));
      FitOptions options{.width = down ? 1 : count, .height = down ? count : 1};
      options.mode = FitMode::kStretch;
      options.filter = kBilinearFilter;
      const auto out = channel(fitted(noisy(down ? 1 : n, down ? n : 1), options));
      const auto expected = triangle(in, count);
      // Measured: 7.2e-8, and 2.2e-3 where a hundred rows are averaged in sixes first.
      const double bound = down && n == 100 && count == 1 ? 3e-3 : 2e-7;
      for (int i = 0; i < count; ++i) {
        ASSERT_NEAR(out[static_cast<std::size_t>(i)], expected[static_cast<std::size_t>(i)], bound);
      }
    }
  }
}

TEST(Fit, PointTakesPixelsAsTheyAre) {
  FitOptions options{.width = 6, .height = 1};
  options.filter = kPointFilter;
  options.mode = FitMode::kStretch;
  auto source = std::make_unique<MadeRows>(sized(3, 1),
                                           [](int x, int, int) { return static_cast<float>(x); });
  EXPECT_EQ(channel(fitted(std::move(source), options)), (std::vector<float>{0, 0, 1, 1, 2, 2}));
}

TEST(Fit, HandlesExtremeShapes) {
  struct Case {
    int width, height, to_width, to_height;
  };
  for (const Case& c : {Case{100000, 2, 100, 3}, Case{2, 100000, 3, 100}, Case{16384, 1, 800, 480},
                        Case{3, 3, 4000, 5}, Case{5, 4000, 4000, 5}, Case{2, 2, 1, 4000}}) {
    for (const auto& mode : kFitModes) {
      SCOPED_TRACE(std::string(mode.name) + " " + std::to_string(c.width) + "x" +
                   std::to_string(c.height));
      const auto source = fit(flat(c.width, c.height), framed(c.to_width, c.to_height, mode.mode));
      for (const float sample : samples(read_all(*source, 5))) {
        ASSERT_TRUE(sample == 9.0F || std::abs(sample - 0.25F) < 5e-7F) << sample;
      }
    }
  }
}

TEST(Fit, RefusesWhatWouldNeedTooMuchMemory) {
  FitOptions turned;
  turned.rotate_deg = 90;
  EXPECT_THROW(fit(flat(100000, 100000), turned), Error);
  EXPECT_THROW(fit(flat(100000, 3), {.width = 100000, .height = 100000, .mode = FitMode::kStretch}),
               Error);
}

TEST(Fit, KeepsAlpha) {
  const Image image = fitted(noisy(8, 8, 4), framed(20, 10, FitMode::kContain));
  EXPECT_EQ(image.view().channels, 4);
  EXPECT_EQ(image.view().pixel(0, 0)[0], 9);
  EXPECT_EQ(image.view().pixel(0, 0)[3], 1);
}

TEST(Fit, IsGreyOnlyWithNeutralBackground) {
  const auto grey = [](Rgb background, int width) {
    PictureInfo info = sized(4, 4);
    info.grey = true;
    FitOptions options{.width = width, .height = 8};
    options.background = background;
    return fit(std::make_unique<MadeRows>(info, noise), options)->info().grey;
  };
  EXPECT_TRUE(grey({1, 1, 1}, 9));
  EXPECT_FALSE(grey({1, 0, 1}, 9));
  EXPECT_TRUE(grey({1, 0, 1}, 8));
}

TEST(Fit, PassesOnWhatTheSourceThrows) {
  for (const int degrees : {0, 90, 180}) {
    auto source = noisy(100, 100);
    source->fails_at = 60;
    FitOptions options{.width = 50, .height = 50};
    options.rotate_deg = degrees;
    const auto result = fit(std::move(source), options);
    Image image(50, 50, 3);
    try {
      for (int y = 0; y < 50; ++y) result->read(image.view().rows(y, 1));
      FAIL() << "the damaged row was read";
    } catch (const Error& error) {
      EXPECT_STREQ(error.what(), "made.exr: row is damaged");
      EXPECT_EQ(error.kind(), ErrorKind::kContent);
    }
  }
}

TEST(Fit, MayBeAbandonedMidway) {
  const auto result = fit(noisy(100, 100), {.width = 50, .height = 50});
  Image row(50, 1, 3);
  result->read(row.view());
}

TEST(Fit, RefusesBadOptions) {
  EXPECT_THROW(fit(flat(4, 4), {.width = -1}), std::invalid_argument);
  EXPECT_THROW(fit(flat(4, 4), {.height = kMaxFitSide + 1}), std::invalid_argument);
  FitOptions askew;
  askew.rotate_deg = 45;
  EXPECT_THROW(fit(flat(4, 4), askew), std::invalid_argument);
  EXPECT_THROW(fit(flat(4, 4), framed(3, 3, static_cast<FitMode>(7))), std::invalid_argument);
}

TEST(Fit, FindsModesAndFiltersByName) {
  EXPECT_EQ(find_by_name(kFitModes, "Cover")->mode, FitMode::kCover);
  EXPECT_EQ(find_by_name(kFilters, "spline36")->support, 3);
  EXPECT_EQ(FitOptions{}.filter.name, kFilters[0].name);
}

}  // namespace
}  // namespace tristim
