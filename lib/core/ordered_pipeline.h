#pragma once

#include <functional>
#include <vector>

namespace tristim::detail {

/// One item on its way through run_ordered: the caller's own type, made and destroyed by the
/// caller's functions.
struct OrderedSteps {
  std::function<void*()> produce;                  // in order; nullptr ends
  std::function<void(void*)> work;                 // on several items at once, in any order
  std::vector<std::function<void(void*)>> settle;  // one after the other; each in order, one item
                                                   // at a time, beside the others with other items
  std::function<void(void*)> consume;  // in order, one at a time, beside settle of the next item
  std::function<void(void*)> discard;  // after consume, and for items left over after an exception
};

/// Sends items through the steps on up to `threads` threads (0: one for each processor).
/// `most` are under way at once, at least 2; 0: one more than there are threads. The first
/// exception stops all and reaches the caller.
void run_ordered(const OrderedSteps& steps, int threads, int most = 0);

}  // namespace tristim::detail
