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
  ThreadArena arena(thread_count(threads));
  arena.execute([&] {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<int>(0, rows),
                              [&](const oneapi::tbb::blocked_range<int>& some) {
                                for (int row = some.begin(); row < some.end(); ++row) {
                                  body(context, row);
                                }
                              });
  });
}

}  // namespace tristim::detail
