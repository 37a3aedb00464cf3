#include "tristim/pipeline/run.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "lib/core/ordered_pipeline.h"

namespace tristim {
namespace {

// A band on its way: its light, its codes, and the light that observers asked for.
struct Work {
  int y0;
  Image light;
  Image dither_mask;  // 1 channel; empty without one
  Raster<std::uint16_t> codes;
  std::vector<Image> wanted;  // by observer; empty images where none is wanted
  StageCounts counts;
};

// The next rows of a mask: its first channel, clipped to [0, 1].
Image read_mask(RowSource& mask, int rows) {
  const PictureInfo& info = mask.info();
  Image read(info.width, rows, info.channels);
  mask.read(read.view());
  Image strength(info.width, rows, 1);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < info.width; ++x) {
      const float value = *read.view().pixel(x, y);
      *strength.view().pixel(x, y) = value > 0 ? std::min(value, 1.0F) : 0;
    }
  }
  return strength;
}

// Copies a row for the observers that want it after so many stages.
void keep_wanted(Work& work, std::span<BandObserver* const> observers, int stages_done, int row) {
  for (std::size_t i = 0; i < observers.size(); ++i) {
    if (observers[i]->light_after() != stages_done) continue;
    const ImageView<float> light = work.light.view();
    if (row == 0) work.wanted[i] = Image(light.width, light.height, light.channels);
    std::ranges::copy(light.row(row), work.wanted[i].view().row(row).begin());
  }
}

// All stages of a row while it is in the nearest cache: what one of them does to a row does not
// depend on the others.
void apply_stages(std::span<const Stage> stages, Work& work,
                  std::span<BandObserver* const> observers) {
  const ImageView<float> light = work.light.view();
  for (int row = 0; row < light.height; ++row) {
    keep_wanted(work, observers, 0, row);
    for (std::size_t i = 0; i < stages.size(); ++i) {
      apply(stages[i], {light.rows(row, 1), work.y0 + row, {}}, work.counts);
      keep_wanted(work, observers, static_cast<int>(i) + 1, row);
    }
  }
}

}  // namespace

int band_rows(const PictureInfo& info) noexcept {
  constexpr std::int64_t kBandBytes = 3 << 20;
  constexpr std::int64_t kTogether = 64;  // rows that error diffusion works on at once
  constexpr std::int64_t kMostRows = 256;
  const std::int64_t row_bytes = std::int64_t{info.width} * 3 * static_cast<int>(sizeof(float));
  std::int64_t rows = std::clamp(kBandBytes / row_bytes, std::int64_t{1}, kMostRows);
  if (rows > kTogether) rows -= rows % kTogether;
  const std::int64_t chunk = std::max(info.chunk_rows, 1);
  return static_cast<int>(rows >= chunk ? rows / chunk * chunk : rows);
}

StageCounts run(RowSource& source, std::span<const Stage> stages, Reducer& reducer, CodeSink& sink,
                std::span<BandObserver* const> observers, const RunOptions& options) {
  const PictureInfo& info = source.info();
  const int wanted_rows = options.band_rows > 0 ? options.band_rows : band_rows(info);
  const int rows = reducer.whole_picture() ? info.height : wanted_rows;
  int next = 0;
  StageCounts total;

  detail::OrderedSteps steps;
  steps.produce = [&]() -> void* {
    if (next == info.height) return nullptr;
    const int count = std::min(rows, info.height - next);
    auto work = std::make_unique<Work>(
        Work{next,
             Image(info.width, count, 3),
             options.dither_mask ? read_mask(*options.dither_mask, count) : Image{},
             Raster<std::uint16_t>(info.width, count, reducer.samples()),
             std::vector<Image>(observers.size()),
             {}});
    source.read(work->light.view());
    next += count;
    return work.release();
  };
  const auto reduce = [&](Work& work) {
    reducer.reduce({work.light.view(), work.y0, work.dither_mask.view()}, work.codes.view());
  };
  steps.work = [&](void* item) {
    Work& work = *static_cast<Work*>(item);
    apply_stages(stages, work, observers);
    if (!reducer.in_order()) reduce(work);
  };
  steps.settle = [&](void* item) {
    if (reducer.in_order()) reduce(*static_cast<Work*>(item));
  };
  steps.consume = [&](void* item) {
    Work& work = *static_cast<Work*>(item);
    const ImageView<const std::uint16_t> codes = work.codes.view();
    for (std::size_t i = 0; i < observers.size(); ++i) {
      observers[i]->seen(work.wanted[i].view(), codes);
    }
    sink.write(codes);
    total.out_of_gamut += work.counts.out_of_gamut;
    total.clipped += work.counts.clipped;
  };
  steps.discard = [](void* item) { delete static_cast<Work*>(item); };
  detail::run_ordered(steps, options.threads);
  return total;
}

}  // namespace tristim
