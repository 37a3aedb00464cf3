#include "lib/core/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>

#include "lib/core/thread_arena.h"

namespace tristim::detail {

int thread_count(int threads) noexcept {
  return threads > 0 ? threads : oneapi::tbb::info::default_concurrency();
}

void parallel_for_rows(int rows, int threads, void (*body)(void* context, int row), void* context) {
  if (rows <= 1 || thread_count(threads) == 1) {
    for (int row = 0; row < rows; ++row) body(context, row);
    return;
  }
  const auto share_out = [&] {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, rows),
                              [&](const oneapi::tbb::blocked_range<int>& some) {
                                for (int row = some.begin(); row < some.end(); ++row) {
                                  body(context, row);
                                }
                              });
  };
  // In an arena of that size already, as every band of a picture is: arenas made and left for each
  // of them pile up in memory while other programs keep the processors busy. Isolated, as a thread
  // that waits here shall not begin another band.
  if (oneapi::tbb::this_task_arena::max_concurrency() == thread_count(threads)) {
    oneapi::tbb::this_task_arena::isolate(share_out);
    return;
  }
  ThreadArena(thread_count(threads)).execute(share_out);
}

}  // namespace tristim::detail
