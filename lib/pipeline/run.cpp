#include "tristim/pipeline/run.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <vector>

#include "lib/core/ordered_pipeline.h"
#include "lib/core/parallel.h"

namespace tristim {
namespace {

constexpr std::int64_t kBandBytes = 3 << 20;  // of a band's light

// A band on its way: its light, its codes, and the light that observers asked for.
struct Work {
  Image light;
  Raster<std::uint16_t> codes;
  int y0 = 0;
  int rows = 0;               // of those that there is room for
  Image dither_mask;          // 1 channel; empty without one
  std::vector<Image> wanted;  // by observer; empty images where none is wanted
  StageCounts counts;

  ImageView<float> light_view() noexcept { return light.view().rows(0, rows); }
  Band light_band() noexcept { return {light_view(), y0, dither_mask.view()}; }
  ImageView<std::uint16_t> codes_view() noexcept { return codes.view().rows(0, rows); }
};

// Bands that have been written are used again: fresh memory costs more than what is done to it.
class WorkPool {
 public:
  WorkPool(int width, int rows, int samples) : width_(width), rows_(rows), samples_(samples) {}

  std::unique_ptr<Work> take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) {
      return std::make_unique<Work>(
          Work{Image(width_, rows_, 3), Raster<std::uint16_t>(width_, rows_, samples_)});
    }
    std::unique_ptr<Work> work = std::move(idle_.back());
    idle_.pop_back();
    return work;
  }

  // One more than there are threads, but for rows so wide that one is more than a band should be.
  int most_under_way(int threads) const noexcept {
    constexpr std::int64_t kMostBytes = 32 << 20;
    const std::int64_t row_bytes = std::int64_t{width_} * (3 * 4 + samples_ * 2);
    const int usual = detail::thread_count(threads) + 1;
    if (row_bytes <= kBandBytes) return usual;
    return static_cast<int>(std::clamp<std::int64_t>(kMostBytes / row_bytes, 2, usual));
  }

  void give_back(std::unique_ptr<Work> work) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(work));
  }

 private:
  const int width_, rows_, samples_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Work>> idle_;
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

// What an observer wants to see. A copy goes its own way there: the codes' plan makes no such
// light.
struct Wanted {
  bool any = false;
  Plan plan;
};

std::vector<Wanted> wanted_light(std::span<BandObserver* const> observers,
                                 std::span<const Stage> stages) {
  std::vector<Wanted> wanted;
  for (const BandObserver* observer : observers) {
    const int count = observer->light_after();
    const bool any = count >= 0;
    wanted.push_back(
        {any, plan_chain(stages.first(any ? static_cast<std::size_t>(count) : 0), false)});
  }
  return wanted;
}

void keep_wanted(Work& work, std::span<const Wanted> wanted) {
  const ImageView<float> light = work.light_view();
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!wanted[i].any) continue;
    Image& kept = work.wanted[i] = Image(light.width, light.height, light.channels);
    for (int y = 0; y < light.height; ++y) {
      std::ranges::copy(light.row(y), kept.view().row(y).begin());
    }
    StageCounts ignored;
    apply(wanted[i].plan, {kept.view(), work.y0, {}}, ignored);
  }
}

}  // namespace

int band_rows(const PictureInfo& info, bool in_order) noexcept {
  constexpr std::int64_t kCacheBytes = 3 << 18;  // what a processor's own cache holds with codes
  constexpr std::int64_t kTogether = 64;         // rows that error diffusion works on at once
  constexpr std::int64_t kMostRows = 256;
  const std::int64_t row_bytes = std::int64_t{info.width} * 3 * static_cast<int>(sizeof(float));
  const std::int64_t chunk = std::max(info.chunk_rows, 1);
  std::int64_t rows = std::clamp(kBandBytes / row_bytes, std::int64_t{1}, kMostRows);
  if (!in_order) rows = std::min(rows, std::max(kCacheBytes / row_bytes, chunk));
  if (in_order && rows > kTogether) rows -= rows % kTogether;
  return static_cast<int>(std::max(rows >= chunk ? rows / chunk * chunk : rows, std::int64_t{1}));
}

StageCounts run(RowSource& source, std::span<const Stage> stages, Reducer& reducer, CodeSink& sink,
                std::span<BandObserver* const> observers, const RunOptions& options) {
  const PictureInfo& info = source.info();
  const int wanted_rows =
      options.band_rows > 0 ? options.band_rows : band_rows(info, reducer.chains() > 0);
  const int rows = reducer.whole_picture() ? info.height : wanted_rows;
  int next = 0;
  StageCounts total;

  const Plan plan = plan_chain(stages, reducer.leads());
  const std::vector<Wanted> wanted = wanted_light(observers, stages);
  WorkPool pool(info.width, std::min(rows, info.height), reducer.samples());
  const int threads = detail::thread_count(options.threads);
  detail::OrderedSteps steps;
  steps.produce = [&]() -> void* {
    if (next == info.height) return nullptr;
    std::unique_ptr<Work> work = pool.take();
    work->y0 = next;
    work->rows = std::min(rows, info.height - next);
    work->counts = {};
    work->wanted = std::vector<Image>(observers.size());
    if (options.dither_mask) work->dither_mask = read_mask(*options.dither_mask, work->rows);
    source.read(work->light_view());
    next += work->rows;
    return work.release();
  };
  steps.work = [&](void* item) {
    Work& work = *static_cast<Work*>(item);
    keep_wanted(work, wanted);
    apply(plan, work.light_band(), work.counts);
    work.counts += reducer.prepare(work.light_band(), work.codes_view(), plan.lead, threads);
  };
  for (int chain = 0; chain < reducer.chains(); ++chain) {
    steps.settle.emplace_back([&reducer, chain, threads](void* item) {
      Work& work = *static_cast<Work*>(item);
      reducer.advance(chain, work.light_band(), work.codes_view(), threads);
    });
  }
  steps.consume = [&](void* item) {
    Work& work = *static_cast<Work*>(item);
    reducer.finish(work.codes_view());
    const ImageView<const std::uint16_t> codes = work.codes_view();
    for (std::size_t i = 0; i < observers.size(); ++i) {
      observers[i]->seen(work.wanted[i].view(), codes);
    }
    sink.write(codes);
    total += work.counts;
  };
  steps.discard = [&](void* item) {
    pool.give_back(std::unique_ptr<Work>(static_cast<Work*>(item)));
  };
  detail::run_ordered(steps, options.threads, pool.most_under_way(options.threads));
  return total;
}

}  // namespace tristim
