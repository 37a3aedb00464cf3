#include "lib/core/ordered_pipeline.h"

#include <oneapi/tbb/parallel_pipeline.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "lib/core/parallel.h"
#include "lib/core/thread_arena.h"

namespace tristim::detail {
namespace {

using Slot = void**;

// The items under way. oneTBB forgets those that it holds when an exception ends a pipeline, so
// they are owned here; an item is in its slot from produce to discard.
class Slots {
 public:
  Slots(std::size_t count, const OrderedSteps& steps) : items_(count), steps_(steps) {}
  ~Slots() {
    for (void* item : items_) {
      if (item != nullptr) steps_.discard(item);
    }
  }
  Slots(const Slots&) = delete;
  Slots& operator=(const Slots&) = delete;

  // In order: as no more items are under way than there are slots, the next one is free.
  Slot put(void* item) {
    const Slot slot = &items_[next_++ % items_.size()];
    *slot = item;
    return slot;
  }

  void discard(Slot slot) {
    steps_.discard(*slot);
    *slot = nullptr;
  }

 private:
  std::vector<void*> items_;
  std::size_t next_ = 0;
  const OrderedSteps& steps_;
};

void run_alone(const OrderedSteps& steps) {
  while (void* made = steps.produce()) {
    const std::shared_ptr<void> item(made, steps.discard);
    steps.work(made);
    for (const auto& settle : steps.settle) settle(made);
    steps.consume(made);
  }
}

}  // namespace

void run_ordered(const OrderedSteps& steps, int threads, int most) {
  const int count = thread_count(threads);
  if (count == 1) return run_alone(steps);
  namespace tbb = oneapi::tbb;
  const auto under_way = static_cast<std::size_t>(most > 0 ? std::max(most, 2) : count + 1);
  Slots slots(under_way, steps);
  const auto source = [&](tbb::flow_control& control) -> Slot {
    void* made = steps.produce();
    if (made != nullptr) return slots.put(made);
    control.stop();
    return nullptr;
  };
  const auto pass = [](const std::function<void(void*)>& step) {
    return [&step](Slot slot) {
      step(*slot);
      return slot;
    };
  };
  const auto last = [&](Slot slot) {
    steps.consume(*slot);
    slots.discard(slot);
  };
  ThreadArena arena(count);
  arena.execute([&] {
    constexpr auto kInOrder = tbb::filter_mode::serial_in_order;
    auto filters = tbb::make_filter<void, Slot>(kInOrder, source) &
                   tbb::make_filter<Slot, Slot>(tbb::filter_mode::parallel, pass(steps.work));
    for (const auto& settle : steps.settle) {
      filters = filters & tbb::make_filter<Slot, Slot>(kInOrder, pass(settle));
    }
    tbb::parallel_pipeline(under_way, filters & tbb::make_filter<Slot, void>(kInOrder, last));
  });
}

}  // namespace tristim::detail
