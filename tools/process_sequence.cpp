#include "tools/process_sequence.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "lib/core/ordered_pipeline.h"
#include "lib/core/parallel.h"
#include "tools/process_report.h"
#include "tools/progress.h"

namespace tristim::tools {
namespace {

// A picture on its way: before it is processed, and after.
struct Turn {
  std::size_t place;
  Job job;
  Processed processed;
  std::exception_ptr failure;
};

// Ends a picture whose result nobody will see.
struct GivenUp {};

class GiveUpBehind final : public BandObserver {
 public:
  GiveUpBehind(const std::atomic<std::size_t>& failed, std::size_t place)
      : failed_(failed), place_(place) {}
  int light_after() const noexcept override { return -1; }
  void seen(ImageView<const float> /*light*/, ImageView<const std::uint16_t> /*codes*/) override {
    if (failed_ < place_) throw GivenUp();
  }

 private:
  const std::atomic<std::size_t>& failed_;
  std::size_t place_;
};

void lower(std::atomic<std::size_t>& least, std::size_t value) {
  std::size_t seen = least;
  while (value < seen && !least.compare_exchange_weak(seen, value)) {
  }
}

// Each on one thread alone, or a few, `at_once` of them at the same time.
void process_side_by_side(const ProcessOptions& options, const Display& device, std::span<Job> jobs,
                          int at_once) {
  std::size_t next = 0;
  std::atomic<std::size_t> failed = jobs.size();  // the first place of those that failed
  Progress progress(std::to_string(jobs.size()) + " pictures", static_cast<int>(jobs.size()));
  detail::OrderedSteps steps;
  steps.produce = [&]() -> void* {
    if (next == jobs.size() || failed < next) return nullptr;
    const std::size_t place = next++;
    return new Turn{place, std::move(jobs[place]), {}, {}};
  };
  // A failure waits for its turn, as those before it may fail too.
  steps.work = [&](void* item) {
    Turn& turn = *static_cast<Turn*>(item);
    try {
      if (failed < turn.place) throw GivenUp();
      turn.processed =
          process_picture(options, device, std::move(turn.job), [&](const std::string&, int) {
            return std::make_unique<GiveUpBehind>(failed, turn.place);
          });
    } catch (...) {
      turn.failure = std::current_exception();
      lower(failed, turn.place);
    }
  };
  steps.consume = [&](void* item) {
    const Turn& turn = *static_cast<Turn*>(item);
    if (turn.failure) std::rethrow_exception(turn.failure);
    progress.erase();
    report(options, turn.processed);
    progress.advance(1);
  };
  steps.discard = [](void* item) { delete static_cast<Turn*>(item); };
  detail::run_ordered(steps, at_once);
}

}  // namespace

void process_sequence(const ProcessOptions& options, const Display& device, std::vector<Job> jobs) {
  const auto threads = static_cast<std::size_t>(detail::thread_count(options.threads));
  // A thread for each picture, while there are pictures for all of them, loses the least; those
  // that are left over share the threads.
  const std::size_t rest = jobs.size() % threads;
  const auto process = [&](std::span<Job> some, std::size_t at_once) {
    ProcessOptions shared = options;
    shared.threads = static_cast<int>(threads / at_once);
    process_side_by_side(shared, device, some, static_cast<int>(at_once));
  };
  if (rest < jobs.size()) process(std::span(jobs).first(jobs.size() - rest), threads);
  if (rest == 1) {
    report(options, process_picture(options, device, std::move(jobs.back()), make_progress));
  } else if (rest > 0) {
    process(std::span(jobs).last(rest), rest);
  }
}

}  // namespace tristim::tools
