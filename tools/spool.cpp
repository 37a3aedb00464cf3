#include "tools/spool.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "tristim/core/error.h"

namespace tristim::tools {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void fail(const char* doing) {
  const int error = errno;
  throw Error(ErrorKind::kSystem, "standard input", doing + (": " + system_message(error)),
              error == ENOSPC ? "free some space, or give the name of a file" : "");
}

void copy(std::FILE* to) {
  std::vector<char> block(std::size_t{1} << 18);
  for (;;) {
    const ssize_t count = ::read(STDIN_FILENO, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("cannot be read");
    if (count == 0) break;
    const auto size = static_cast<std::size_t>(count);
    if (std::fwrite(block.data(), 1, size, to) != size) fail("cannot be kept in a temporary file");
  }
  if (std::fflush(to) != 0) fail("cannot be kept in a temporary file");
}

}  // namespace

void make_rereadable(const std::string& input) {
  std::error_code ignored;
  if (input != "-") {
    if (!std::filesystem::is_fifo(input, ignored)) return;
    throw Error(ErrorKind::kMisuse, input,
                "is a pipe, and the choice of a palette reads a picture twice",
                "give - as the picture and the pipe as standard input");
  }
  const bool file = ::lseek(STDIN_FILENO, 0, SEEK_CUR) == 0;  // pipes have no place
  if (file || errno == EBADF) return;  // whoever opens it tells of the latter
  const File spooled(std::tmpfile(), &std::fclose);
  if (!spooled) fail("cannot be kept in a temporary file");
  copy(spooled.get());
  std::rewind(spooled.get());
  if (::dup2(::fileno(spooled.get()), STDIN_FILENO) < 0) fail("cannot be kept in a temporary file");
}

}  // namespace tristim::tools
