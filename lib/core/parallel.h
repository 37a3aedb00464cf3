#pragma once

#include <memory>
#include <type_traits>

namespace tristim::detail {

/// Calls `body(context, row)` once for every row in [0, rows), in any order, on up to `threads`
/// threads at once (0: one for each processor; 1: on the caller's, in order).
void parallel_for_rows(int rows, int threads, void (*body)(void* context, int row), void* context);

/// Calls `body(row)` once for every row in [0, rows), in any order, on up to `threads` threads (0:
/// one for each processor; 1: the caller's alone, in order). Of several exceptions one reaches the
/// caller, after every running row has ended; rows not yet begun are then left out. `body` must
/// give the same result for any number of threads.
template <class F>
void parallel_for_rows(int rows, int threads, F&& body) {
  using Body = std::remove_reference_t<F>;
  parallel_for_rows(
      rows, threads, [](void* context, int row) { (*static_cast<Body*>(context))(row); },
      const_cast<void*>(static_cast<const void*>(std::addressof(body))));
}

/// The number of threads that `threads` asks for: itself, or one for each processor where it is 0.
int thread_count(int threads) noexcept;

}  // namespace tristim::detail
