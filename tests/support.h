#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tristim {

/// The folder of pictures and tables that may lie beside the checkout: the environment's
/// TRISTIM_SHARED, else
/// ../shared. Without one a test that needs it says so: `if (!shared_dir()) GTEST_SKIP() <<
/// kNoShared;`
std::optional<std::filesystem::path> shared_dir();

inline constexpr const char* kNoShared =
    "no ../shared beside the checkout; set TRISTIM_SHARED to its path";

/// A file of the checkout, such as source_file("luts/devices").
std::filesystem::path source_file(const std::filesystem::path& relative);

/// A new empty directory under testing::TempDir() that goes with all it holds when the object goes.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }

  /// The path of `name` in it, for functions that take text.
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// The bytes of a file, and a file of these bytes. Both throw std::runtime_error where that fails.
std::string read_bytes(const std::filesystem::path& path);
void write_bytes(const std::filesystem::path& path, const std::string& bytes);

/// How a command runs.
struct CommandOptions {
  std::string input = {};                   // its standard input
  std::filesystem::path directory = {};     // "": the test's own
  std::vector<std::string> variables = {};  // NAME=value, over the test's environment
  double timeout_s = 60;                    // then it is killed
  int signal = 0;                           // sent after signal_after_s; 0: none
  double signal_after_s = 0;
};

/// What came of it.
struct CommandResult {
  int exit_code = 0;  // -N where signal N ended it
  bool timed_out = false;
  std::string out;
  std::string err;
  std::size_t peak_bytes =
      0;               // largest resident set; never below what the test itself held at the start
  double seconds = 0;  // wall time
};

/// Runs a program, found in PATH, with its arguments; its output goes to pipes.
/// Throws std::runtime_error where no process can be made; a program that is not found has exit
/// code 127.
CommandResult run_command(const std::vector<std::string>& command,
                          const CommandOptions& options = {});

/// The path of the `tristim` that was built with these tests.
std::string tristim_path();

/// Runs it: run_tristim({"device", "list"}).
CommandResult run_tristim(const std::vector<std::string>& arguments,
                          const CommandOptions& options = {});

}  // namespace tristim
