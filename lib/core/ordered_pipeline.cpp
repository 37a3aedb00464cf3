#include "lib/core/ordered_pipeline.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <memory>

#include "lib/core/parallel.h"

namespace tristim::detail {
namespace {

using Item = std::shared_ptr<void>;

void run_alone(const OrderedSteps& steps) {
  while (void* made = steps.produce()) {
    const Item item(made, steps.discard);
    steps.work(made);
    steps.settle(made);
    steps.consume(made);
  }
}

}  // namespace

void run_ordered(const OrderedSteps& steps, int threads) {
  const int count = thread_count(threads);
  if (count == 1) return run_alone(steps);
  namespace tbb = oneapi::tbb;
  const auto source = [&](tbb::flow_control& control) -> Item {
    void* made = steps.produce();
    if (made == nullptr) {
      control.stop();
      return {};
    }
    return {made, steps.discard};
  };
  const auto pass = [](const std::function<void(void*)>& step) {
    return [&step](Item item) {
      step(item.get());
      return item;
    };
  };
  const auto last = [&](const Item& item) { steps.consume(item.get()); };
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(count));
  tbb::task_arena arena(count);
  arena.execute([&] {
    tbb::parallel_pipeline(
        static_cast<std::size_t>(count) + 2,
        tbb::make_filter<void, Item>(tbb::filter_mode::serial_in_order, source) &
            tbb::make_filter<Item, Item>(tbb::filter_mode::parallel, pass(steps.work)) &
            tbb::make_filter<Item, Item>(tbb::filter_mode::serial_in_order, pass(steps.settle)) &
            tbb::make_filter<Item, void>(tbb::filter_mode::serial_in_order, last));
  });
}

}  // namespace tristim::detail
