#include "tests/support.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace tristim {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what + ": " + std::generic_category().message(errno));
}

/// Owns a file descriptor; closed early where the other end must see the end of the stream.
class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  void set(int fd) { fd_ = fd; }
  void close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
  }

 private:
  int fd_;
};

struct Pipe {
  Descriptor read_end, write_end;
  Pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe");
    read_end.set(ends[0]);
    write_end.set(ends[1]);
  }
};

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// A file and not a pipe, so that no program can make the test wait by not reading.
File input_file(const std::string& bytes) {
  File file(std::tmpfile(), &std::fclose);
  if (!file) fail("tmpfile");
  if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) fail("fwrite");
  std::rewind(file.get());
  fcntl(fileno(file.get()), F_SETFD, FD_CLOEXEC);
  return file;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  list.reserve(texts.size() + 1);
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

// Between fork and exec: only calls that are safe there.
[[noreturn]] void become(char* const* command, char* const* variables, const char* directory,
                         int input, int out, int err) {
  dup2(input, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  if (*directory != '\0' && chdir(directory) != 0) _exit(126);
  for (; *variables != nullptr; ++variables) putenv(*variables);
  execvp(command[0], command);
  _exit(127);
}

/// Reads both streams until their ends, or until `timeout_s` has passed; false then.
bool collect(Pipe& out, Pipe& err, pid_t child, const CommandOptions& options,
             Clock::time_point start, CommandResult& result) {
  bool signalled = options.signal == 0;
  std::array<char, 65536> buffer;
  while (out.read_end.get() >= 0 || err.read_end.get() >= 0) {
    const double now = seconds_since(start);
    if (now >= options.timeout_s) return false;
    if (!signalled && now >= options.signal_after_s) {
      kill(child, options.signal);
      signalled = true;
    }
    const double next = signalled ? options.timeout_s : options.signal_after_s;
    std::array<pollfd, 2> ends{{{out.read_end.get(), POLLIN, 0}, {err.read_end.get(), POLLIN, 0}}};
    if (poll(ends.data(), ends.size(), static_cast<int>((next - now) * 1000) + 1) < 0) continue;
    const auto take = [&](const pollfd& end, Descriptor& from, std::string& to) {
      if (end.fd < 0 || end.revents == 0) return;
      const ssize_t count = read(from.get(), buffer.data(), buffer.size());
      if (count > 0) to.append(buffer.data(), static_cast<std::size_t>(count));
      if (count <= 0) from.close();
    };
    take(ends[0], out.read_end, result.out);
    take(ends[1], err.read_end, result.err);
  }
  return true;
}

}  // namespace

std::optional<std::filesystem::path> shared_dir() {
  const char* chosen = std::getenv("TRISTIM_SHARED");
  const std::filesystem::path path = chosen != nullptr ? chosen : TRISTIM_SHARED;
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) return std::nullopt;
  return path;
}

std::filesystem::path source_file(const std::filesystem::path& relative) {
  return std::filesystem::path(TRISTIM_SOURCE_DIR) / relative;
}

TemporaryDirectory::TemporaryDirectory() {
  std::string name = testing::TempDir() + "tristim-XXXXXX";
  if (mkdtemp(name.data()) == nullptr) fail(name);
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  // A test may have taken the right to write away.
  std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ignored);
  std::filesystem::remove_all(path_, ignored);
}

std::string read_bytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  if (!in || (in.peek() != EOF && !(bytes << in.rdbuf()))) fail(path.string());
  return std::move(bytes).str();
}

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream out(path, std::ios::binary);
  out << bytes << std::flush;
  if (!out) fail(path.string());
}

CommandResult run_command(const std::vector<std::string>& command, const CommandOptions& options) {
  std::vector<std::string> arguments = command;
  std::vector<std::string> variables = options.variables;
  const std::vector<char*> argv = pointers(arguments);
  const std::vector<char*> environment = pointers(variables);
  const std::string directory = options.directory.string();
  const File input = input_file(options.input);
  Pipe out;
  Pipe err;

  const Clock::time_point start = Clock::now();
  const pid_t child = fork();
  if (child < 0) fail("fork");
  if (child == 0) {
    become(argv.data(), environment.data(), directory.c_str(), fileno(input.get()),
           out.write_end.get(), err.write_end.get());
  }
  out.write_end.close();
  err.write_end.close();

  CommandResult result;
  result.timed_out = !collect(out, err, child, options, start, result);
  if (result.timed_out) kill(child, SIGKILL);
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  result.seconds = seconds_since(start);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  result.peak_bytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
  return result;
}

std::string tristim_path() { return TRISTIM_COMMAND; }

CommandResult run_tristim(const std::vector<std::string>& arguments,
                          const CommandOptions& options) {
  std::vector<std::string> command{tristim_path()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_command(command, options);
}

}  // namespace tristim
