#include "lib/core/temporary_name.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>

#include "tristim/core/file.h"

namespace tristim {
namespace detail {

/// One of the names that a signal handler may read: claimed, filled, then published, so that it
/// never reads half a name.
struct TemporarySlot {
  enum State : int { kFree, kClaimed, kPublished };
  std::atomic<int> state{kFree};
  std::array<char, 4096> path{};
};

}  // namespace detail

namespace {

static_assert(std::atomic<int>::is_always_lock_free, "read in signal handlers");
std::array<detail::TemporarySlot, 64> slots;

}  // namespace

detail::TemporaryName::TemporaryName(std::string path) : path_(std::move(path)) {
  if (path_.size() >= slots[0].path.size()) return;  // the kernel takes no such name
  for (TemporarySlot& slot : slots) {
    int expected = TemporarySlot::kFree;
    if (!slot.state.compare_exchange_strong(expected, TemporarySlot::kClaimed)) continue;
    std::copy_n(path_.c_str(), path_.size() + 1, slot.path.begin());
    slot.state.store(TemporarySlot::kPublished);
    slot_ = &slot;
    return;
  }
}

detail::TemporaryName::~TemporaryName() {
  if (slot_ != nullptr) slot_->state.store(TemporarySlot::kFree);
}

std::unique_ptr<detail::TemporaryName> detail::new_temporary_name(const std::string& directory) {
  static std::atomic<unsigned> counter{0};
  return std::make_unique<TemporaryName>(directory + "/.tristim-" + std::to_string(getpid()) + "-" +
                                         std::to_string(counter++));
}

void remove_temporary_files() noexcept {
  const int saved = errno;
  for (const detail::TemporarySlot& slot : slots) {
    if (slot.state.load() == detail::TemporarySlot::kPublished) ::unlink(slot.path.data());
  }
  errno = saved;
}

}  // namespace tristim
