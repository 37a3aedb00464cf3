#pragma once

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace tristim::detail {

/// A place for `threads` threads to work in, also where there are fewer processors. An arena may be
/// used inside the work of another one.
class ThreadArena {
 public:
  explicit ThreadArena(int threads) {
    using oneapi::tbb::global_control;
    const auto wanted = static_cast<std::size_t>(threads);
    const auto allowed = [] {
      return global_control::active_value(global_control::max_allowed_parallelism);
    };
    if (wanted > allowed()) more_.emplace(global_control::max_allowed_parallelism, wanted);
    // An arena of more than the application allows would print a warning.
    arena_.emplace(static_cast<int>(std::min(wanted, allowed())));
  }

  template <typename F>
  void execute(F&& work) {
    arena_->execute(work);
  }

 private:
  std::optional<oneapi::tbb::global_control> more_;
  std::optional<oneapi::tbb::task_arena> arena_;
};

}  // namespace tristim::detail
