#include "lib/core/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace tristim::detail {

int thread_count(int threads) noexcept {
  return threads > 0 ? threads : oneapi::tbb::info::default_concurrency();
}

void parallel_for_rows(int rows, int threads, void (*body)(void* context, int row), void* context) {
  if (rows <= 1 || thread_count(threads) == 1) {
    for (int row = 0; row < rows; ++row) body(context, row);
    return;
  }
  using oneapi::tbb::global_control;
  const auto wanted = static_cast<std::size_t>(thread_count(threads));
  std::optional<global_control> more;  // than there are processors
  if (wanted > global_control::active_value(global_control::max_allowed_parallelism)) {
    more.emplace(global_control::max_allowed_parallelism, wanted);
  }
  // An arena of more than the application allows would print a warning.
  const std::size_t allowed = global_control::active_value(global_control::max_allowed_parallelism);
  oneapi::tbb::task_arena arena(static_cast<int>(std::min(wanted, allowed)));
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
