#include "tristim/pipeline/run.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <stdexcept>
#include <string>

#include "tests/pipeline/pictures.h"
#include "tristim/device/display_file.h"

namespace tristim {
namespace {

constexpr int kWidth = 13;
constexpr int kHeight = 70;

// All kinds of stages.
std::vector<Stage> stages() {
  return {Exposure{0.5}, ToneMap{.white = 2},
          ConvertPrimaries{.matrix = rgb_from_rgb({}, {.white = kD50}, Adaptation::kBradford)},
          GamutMap{kDesaturate}};
}

std::vector<std::uint16_t> codes_of(const Display& display, const ReduceOptions& reduce,
                                    const RunOptions& options, StageCounts* counts = nullptr) {
  ImageSource source(test_picture(kWidth, kHeight));
  Reducer reducer(display, reduce, kWidth);
  CodeCollector sink;
  const StageCounts counted = run(source, stages(), reducer, sink, {}, options);
  if (counts != nullptr) *counts = counted;
  return sink.codes;
}

TEST(Run, GivesTheSameCodesForAnyThreadsAndBands) {
  for (const BuiltInDisplay& built_in : built_in_displays()) {
    const Display display = load_display(std::string(built_in.name));
    for (const NamedDither& dither : dither_methods()) {
      if (display.frame.packing.indexed &&
          std::holds_alternative<WholePictureDither>(dither.method))
        continue;
      const ReduceOptions reduce{.dither = dither.method, .parameters = {.serpentine = true}};
      StageCounts expected_counts;
      const auto expected = codes_of(display, reduce, {1, kHeight}, &expected_counts);
      ASSERT_FALSE(expected.empty());
      for (const int threads : {1, 2, 7}) {
        for (const int rows : {1, 3, 64, kHeight}) {
          StageCounts counts;
          ASSERT_EQ(codes_of(display, reduce, {threads, rows}, &counts), expected)
              << built_in.name << " " << dither.name << ", " << threads << " threads, " << rows;
          ASSERT_EQ(counts, expected_counts);
        }
      }
    }
  }
}

// Row by row is the definition; else rows that go one way go side by side.
TEST(Run, GivesTheSameCodesOfRowsSideBySide) {
  for (const char* name : {"srgb", "lcd-rgb565", "epaper-4grey", "epaper-7color"}) {
    const Display display = load_display(name);
    for (const DiffusionKernel& kernel : kDiffusionKernels) {
      const ReduceOptions reduce{.dither = kernel, .parameters = {.serpentine = false}};
      const auto expected = codes_of(display, reduce, {1, 1});
      for (const int threads : {1, 2, 7}) {
        for (const int rows : {5, 64, kHeight}) {
          ASSERT_EQ(codes_of(display, reduce, {threads, rows}), expected)
              << name << " " << kernel.name << ", " << threads << " threads, " << rows;
        }
      }
    }
  }
}

// A mask that is black on the left half and white on the right.
Image half_mask(int width, int height) {
  Image mask(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = width / 2; x < width; ++x) {
      for (int c = 0; c < 3; ++c) mask.view().pixel(x, y)[c] = 1;
    }
  }
  return mask;
}

std::vector<std::uint16_t> masked(const Display& display, const ReduceOptions& reduce, int rows) {
  constexpr int kSide = 64;
  ImageSource source(flat_picture(kSide, kSide, 0.3F, 0.3F, 0.3F));
  ImageSource mask(half_mask(kSide, kSide));
  Reducer reducer(display, reduce, kSide);
  CodeCollector sink;
  run(source, {}, reducer, sink, {}, {.threads = 2, .band_rows = rows, .dither_mask = &mask});
  return sink.codes;
}

TEST(Run, DithersWhereTheMaskAsksForIt) {
  for (const char* device : {"laser-300", "epaper-4grey", "vga16"}) {
    const Display display = load_display(device);
    for (const NamedDither& dither : dither_methods()) {
      if (display.frame.packing.indexed &&
          std::holds_alternative<WholePictureDither>(dither.method))
        continue;
      if (dither.name == "none") continue;
      SCOPED_TRACE(testing::Message() << device << " " << dither.name);
      const auto codes = masked(display, {.dither = dither.method}, 7);
      std::set<std::uint16_t> left, right;
      for (std::size_t i = 0; i < codes.size(); ++i) (i % 64 < 32 ? left : right).insert(codes[i]);
      EXPECT_EQ(left.size(), 1U);
      EXPECT_GT(right.size(), 1U);
      EXPECT_EQ(codes, masked(display, {.dither = dither.method}, 64));
    }
  }
}

TEST(Run, DithersNothingAtStrengthZero) {
  for (const NamedDither& dither : dither_methods()) {
    SCOPED_TRACE(dither.name);
    ImageSource source(flat_picture(32, 32, 0.3F, 0.3F, 0.3F));
    Reducer reducer(load_display("laser-300"),
                    {.dither = dither.method, .parameters = {.strength = 0}}, 32);
    CodeCollector sink;
    run(source, {}, reducer, sink);
    EXPECT_EQ(std::set<std::uint16_t>(sink.codes.begin(), sink.codes.end()).size(), 1U);
  }
}

TEST(Run, CountsWhatTheStagesCount) {
  Image image = flat_picture(4, 3, 0.5F, 0.5F, 0.5F);
  image.view().pixel(1, 0)[0] = -1;
  image.view().pixel(2, 2)[1] = 7;
  ImageSource source(std::move(image));
  Reducer reducer(Display{}, {}, 4);
  CodeCollector sink;
  const Stage clip = GamutMap{};
  EXPECT_EQ(run(source, {&clip, 1}, reducer, sink), (StageCounts{1, 1}));
  EXPECT_EQ(sink.codes.size(), 4U * 3 * 3);
}

// Notes the bands that it sees and the first value of their light.
struct Watcher : BandObserver {
  explicit Watcher(int after) : after_stages(after) {}
  int light_after() const noexcept override { return after_stages; }
  void seen(ImageView<const float> light, ImageView<const std::uint16_t> codes) override {
    rows += codes.height;
    ++bands;
    if (after_stages < 0) {
      EXPECT_EQ(light.data, nullptr);
    } else {
      EXPECT_EQ(light.width, codes.width);
      EXPECT_EQ(light.height, codes.height);
      value = light.row(0)[0];
    }
  }
  int after_stages;
  int rows = 0;
  int bands = 0;
  float value = 0;
};

TEST(Run, ShowsObserversTheLightAfterTheirStage) {
  for (const int threads : {1, 3}) {
    ImageSource source(flat_picture(8, 20, 3, 3, 3));
    const std::vector<Stage> steps{Exposure{-2}, Exposure{1}, GamutMap{}};
    Reducer reducer(Display{}, {}, 8);
    CodeCollector sink;
    Watcher none(-1);
    Watcher first(0);
    Watcher second(1);
    Watcher last(3);
    BandObserver* const observers[] = {&none, &first, &second, &last};
    run(source, steps, reducer, sink, observers, {threads, 6});
    for (const Watcher* watcher : {&none, &first, &second, &last}) {
      EXPECT_EQ(watcher->rows, 20);
      EXPECT_EQ(watcher->bands, 4);
    }
    EXPECT_EQ(first.value, 3);
    EXPECT_EQ(second.value, 0.75F);
    EXPECT_EQ(last.value, 1);  // 1.5, clipped
  }
}

struct FailingSource : ImageSource {
  FailingSource() : ImageSource(Image(8, 40, 3)) {}
  void read(ImageView<float> rows) override {
    if (calls++ == 5) throw std::runtime_error("source");
    ImageSource::read(rows);
  }
  int calls = 0;
};

struct FailingSink : CodeCollector {
  void write(ImageView<const std::uint16_t> rows) override {
    if (calls++ == 5) throw std::runtime_error("sink");
    CodeCollector::write(rows);
  }
  int calls = 0;
};

struct FailingObserver : BandObserver {
  int light_after() const noexcept override { return -1; }
  void seen(ImageView<const float>, ImageView<const std::uint16_t>) override {
    if (calls++ == 5) throw std::runtime_error("observer");
  }
  int calls = 0;
};

std::string failure(RowSource& source, CodeSink& sink, BandObserver& observer, int threads) {
  Reducer reducer(Display{}, {}, 8);
  BandObserver* const observers[] = {&observer};
  try {
    run(source, {}, reducer, sink, observers, {threads, 2});
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Run, HandsOnWhatSourceSinkAndObserversThrow) {
  for (const int threads : {1, 2, 7}) {
    Watcher watcher(-1);
    CodeCollector sink;
    FailingSource failing_source;
    EXPECT_EQ(failure(failing_source, sink, watcher, threads), "source");
    EXPECT_EQ(watcher.bands, static_cast<int>(sink.codes.size()) / (8 * 2 * 3));
    EXPECT_LE(watcher.bands, 5);
    ImageSource source(Image(8, 40, 3));
    FailingSink failing_sink;
    EXPECT_EQ(failure(source, failing_sink, watcher, threads), "sink");
    EXPECT_EQ(failing_sink.codes.size(), 5U * 8 * 2 * 3);
    ImageSource again(Image(8, 40, 3));
    FailingObserver failing_observer;
    EXPECT_EQ(failure(again, sink, failing_observer, threads), "observer");
  }
}

TEST(BandRows, AreAMultipleOfTheChunksWithinAFewMegabytes) {
  EXPECT_EQ(band_rows({.width = 100, .height = 5000}, true), 256);
  EXPECT_EQ(band_rows({.width = 100, .height = 5000, .chunk_rows = 100}, true), 200);
  EXPECT_EQ(band_rows({.width = 16384, .height = 16384}, true), 16);  // 3 MiB / 192 KiB
  EXPECT_EQ(band_rows({.width = 16384, .height = 16384, .chunk_rows = 3}, true), 15);
  EXPECT_EQ(band_rows({.width = 16384, .height = 16384, .chunk_rows = 64}, true), 16);
  EXPECT_EQ(band_rows({.width = 1 << 20, .height = 9, .chunk_rows = 0}, true), 1);
  EXPECT_EQ(band_rows({.width = 1 << 20, .height = 9}, false), 1);
  EXPECT_EQ(band_rows({.width = 3840, .height = 2160}, false), 17);  // 768 KiB / 45 KiB
  EXPECT_EQ(band_rows({.width = 3840, .height = 2160, .chunk_rows = 16}, false), 16);
  EXPECT_EQ(band_rows({.width = 3840, .height = 2160, .chunk_rows = 32}, false), 32);
  EXPECT_EQ(band_rows({.width = 3840, .height = 2160, .chunk_rows = 256}, false), 68);  // 3 MiB
}

}  // namespace
}  // namespace tristim
