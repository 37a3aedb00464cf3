#pragma once

#include <atomic>
#include <memory>
#include <string>

namespace tristim::detail {

/// Whether output goes to files without a name where the file system has them; tests turn it off.
inline std::atomic<bool> use_unnamed_files{true};

struct TemporarySlot;

/// The name of a temporary file; remove_temporary_files() removes what bears it while this lives.
class TemporaryName {
 public:
  explicit TemporaryName(std::string path);
  ~TemporaryName();  // leaves the file alone
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;

  const char* c_str() const noexcept { return path_.c_str(); }

 private:
  std::string path_;
  TemporarySlot* slot_ = nullptr;
};

/// `directory`/.tristim-PID-N, N new each time.
std::unique_ptr<TemporaryName> new_temporary_name(const std::string& directory);

}  // namespace tristim::detail
