#include "tristim/core/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lib/core/temporary_name.h"
#include "tristim/core/error.h"

namespace tristim {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{256} << 10;
constexpr int kMaxLinks = 40;  // of a chain of symbolic links, as the kernel's own limit

template <typename Call>
auto retry(Call call) {
  auto result = call();
  while (result == -1 && errno == EINTR) result = call();
  return result;
}

std::string shown(const std::string& path, const char* standard) {
  return path == "-" ? standard : path;
}

[[noreturn]] void fail(const std::string& thing, std::string_view doing, int error_number) {
  std::string_view remedy;
  if (error_number == ENOSPC || error_number == EDQUOT)
    remedy = "free some space or write elsewhere";
  if (error_number == EFBIG) remedy = "raise the limit (ulimit -f) or write elsewhere";
  if (error_number == EPIPE) remedy = "the program that reads it has ended";
  if (error_number == EACCES || error_number == EPERM || error_number == EROFS) {
    remedy = "check the permissions";
  }
  throw Error(ErrorKind::kSystem, thing, std::string(doing) + ": " + system_message(error_number),
              remedy);
}

[[noreturn]] void fail_exists(const std::string& thing) {
  throw Error(ErrorKind::kSystem, thing, "exists already", "give --force to replace it");
}

void write_all(const std::string& thing, int fd, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = retry([&] { return ::write(fd, bytes.data(), bytes.size()); });
    if (written < 0) fail(thing, "cannot write", errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

/// What `path` finally names, whether it exists or not.
std::string follow_links(const std::string& path) {
  namespace fs = std::filesystem;
  fs::path target = path;
  std::error_code error;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(fs::symlink_status(target, error)); ++i) {
    target = target.parent_path() / fs::read_symlink(target, error);
  }
  return target.string();
}

std::string directory_of(const std::string& path) {
  const std::string parent = std::filesystem::path(path).parent_path().string();
  return parent.empty() ? "." : parent;
}

/// A file without a name in `directory`, or -1 where the file system (or a missing /proc, which
/// commit needs) does not allow it.
int open_unnamed(const std::string& directory, int access_mode) {
  const int fd =
      retry([&] { return ::open(directory.c_str(), O_TMPFILE | access_mode | O_CLOEXEC, 0666); });
  if (fd < 0) return fd;
  if (detail::use_unnamed_files && ::access("/proc/self/fd", X_OK) == 0) return fd;
  ::close(fd);
  errno = EOPNOTSUPP;
  return -1;
}

std::string name_of_descriptor(int fd) { return "/proc/self/fd/" + std::to_string(fd); }

/// An unlinked file for what a pipe cannot take yet.
int open_spool(const std::string& thing) {
  const char* variable = std::getenv("TMPDIR");
  const std::string directory = variable != nullptr && *variable != 0 ? variable : "/tmp";
  const int unnamed = open_unnamed(directory, O_RDWR);
  if (unnamed >= 0) return unnamed;
  std::string name = directory + "/tristim-XXXXXX";
  const int fd = ::mkostemp(name.data(), O_CLOEXEC);
  if (fd < 0) fail(thing, "cannot make a temporary file in " + directory, errno);
  ::unlink(name.c_str());
  return fd;
}

}  // namespace

struct OutputFile::State {
  std::string path;    // as given
  std::string thing;   // as errors call it
  std::string target;  // the regular file to appear; empty where there is none
  bool replace = false;
  int fd = -1;                                       // what write() fills
  int direct_fd = -1;                                // the pipe, where fd is its spool
  bool owns_fd = true;                               // standard output stays open
  std::unique_ptr<detail::TemporaryName> temporary;  // where the file needs a name
  std::vector<std::byte> buffer;
  std::size_t flushed = 0;
  bool failed = false;

  ~State() {
    if (fd >= 0 && owns_fd) ::close(fd);
    if (direct_fd > STDERR_FILENO) ::close(direct_fd);
    if (temporary) ::unlink(temporary->c_str());
  }

  void open_standard_output(bool seekable);
  void open_direct(bool seekable);
  void open_regular();
  void open_named();
  void flush();
  void append(std::span<const std::byte> bytes);
  void copy_spool();
  void appear();
  void appear_named();
};

void OutputFile::State::open_standard_output(bool seekable) {
  fd = seekable ? open_spool(thing) : STDOUT_FILENO;
  owns_fd = seekable;
  if (seekable) direct_fd = STDOUT_FILENO;
}

void OutputFile::State::open_direct(bool seekable) {
  const int opened = retry([&] { return ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY); });
  if (opened < 0) fail(thing, "cannot be opened for writing", errno);
  if (seekable) {
    direct_fd = opened;
    fd = open_spool(thing);
  } else {
    fd = opened;
  }
}

void OutputFile::State::open_regular() {
  const std::string directory = directory_of(target);
  fd = open_unnamed(directory, O_WRONLY);
  if (fd >= 0) return;
  switch (errno) {
    case ENOENT:
      throw Error(ErrorKind::kSystem, thing, "there is no directory " + directory,
                  "create it first");
    case ENOTDIR:
      throw Error(ErrorKind::kSystem, thing, directory + " is no directory",
                  "choose another place");
    case EACCES:
    case EROFS:
      fail(thing, "cannot write in directory " + directory, errno);
    default:
      open_named();
  }
}

void OutputFile::State::open_named() {
  do {
    temporary = detail::new_temporary_name(directory_of(target));
    fd = retry(
        [&] { return ::open(temporary->c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666); });
  } while (fd < 0 && errno == EEXIST);
  if (fd >= 0) return;
  const int error_number = errno;
  temporary.reset();
  fail(thing, "cannot write in directory " + directory_of(target), error_number);
}

void OutputFile::State::flush() {
  if (buffer.empty()) return;
  append(buffer);
  buffer.clear();
}

void OutputFile::State::append(std::span<const std::byte> bytes) {
  failed = true;  // until it has gone well
  write_all(thing, fd, bytes);
  failed = false;
  flushed += bytes.size();
}

void OutputFile::State::copy_spool() {
  buffer.resize(kBufferBytes);
  for (off_t position = 0;;) {
    const ssize_t got = retry([&] { return ::pread(fd, buffer.data(), buffer.size(), position); });
    if (got < 0) fail(thing, "cannot read the temporary file", errno);
    if (got == 0) return;
    write_all(thing, direct_fd, std::span(buffer).first(static_cast<std::size_t>(got)));
    position += got;
  }
}

/// Gives the unnamed file its name.
void OutputFile::State::appear() {
  const std::string source = name_of_descriptor(fd);
  const auto link_as = [&](const char* name) {
    return ::linkat(AT_FDCWD, source.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
  };
  if (link_as(target.c_str())) return;
  if (errno == EEXIST && !replace) fail_exists(thing);
  if (errno != EEXIST) fail(thing, "cannot be created", errno);
  // A link cannot replace, a rename can: so a name beside the target first.
  bool linked = false;
  do {
    temporary = detail::new_temporary_name(directory_of(target));
    linked = link_as(temporary->c_str());
  } while (!linked && errno == EEXIST);
  if (!linked || ::rename(temporary->c_str(), target.c_str()) != 0) {
    fail(thing, "cannot be replaced", errno);
  }
  temporary.reset();
}

/// Renames the named temporary file to the target.
void OutputFile::State::appear_named() {
  const int closed =
      ::close(std::exchange(fd, -1));  // network file systems report a full disk here
  if (closed != 0) fail(thing, "cannot write", errno);
  if (replace) {
    if (::rename(temporary->c_str(), target.c_str()) != 0) fail(thing, "cannot be replaced", errno);
    temporary.reset();
    return;
  }
  if (::renameat2(AT_FDCWD, temporary->c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) == 0) {
    temporary.reset();
    return;
  }
  // File systems without RENAME_NOREPLACE (NFS) have links, which do not replace either.
  if (errno != EEXIST && ::link(temporary->c_str(), target.c_str()) == 0) {
    ::unlink(temporary->c_str());
    temporary.reset();
    return;
  }
  if (errno == EEXIST) fail_exists(thing);
  fail(thing, "cannot be created", errno);
}

OutputFile::OutputFile(std::string path, bool replace, bool seekable)
    : state_(std::make_unique<State>()) {
  State& state = *state_;
  if (path.empty()) {
    throw Error(ErrorKind::kMisuse, "output", "its name is empty",
                "give a file name, or - for standard output");
  }
  state.path = path == "/dev/stdout" ? "-" : std::move(path);
  state.thing = shown(state.path, "standard output");
  state.replace = replace;
  state.buffer.reserve(kBufferBytes);
  if (state.path == "-") {
    state.open_standard_output(seekable);
    return;
  }

  struct stat facts {};
  const bool exists = ::stat(state.path.c_str(), &facts) == 0;
  if (!exists && errno != ENOENT && errno != ENOTDIR) fail(state.thing, "cannot be written", errno);
  if ((exists && S_ISDIR(facts.st_mode)) || state.path.back() == '/') {
    throw Error(ErrorKind::kSystem, state.thing, "is a directory", "give the name of a file in it");
  }
  const bool device = exists && !S_ISREG(facts.st_mode);
  if (device && !S_ISBLK(facts.st_mode)) {
    state.open_direct(seekable);
    return;
  }
  struct stat link {};
  const bool taken =
      exists || ::lstat(state.path.c_str(), &link) == 0;  // a dangling link is taken too
  if (taken && !replace) fail_exists(state.thing);
  if (device) {
    state.open_direct(seekable);
    return;
  }
  if (exists && ::faccessat(AT_FDCWD, state.path.c_str(), W_OK, AT_EACCESS) != 0) {
    throw Error(ErrorKind::kSystem, state.thing, "is write-protected",
                "make it writable (chmod u+w) or choose another name");
  }
  state.target = follow_links(state.path);
  state.open_regular();
}

OutputFile::~OutputFile() = default;

void OutputFile::write(std::span<const std::byte> bytes) {
  State& state = *state_;
  if (state.buffer.size() + bytes.size() > kBufferBytes) state.flush();
  if (bytes.size() >= kBufferBytes) {
    state.append(bytes);
  } else {
    state.buffer.insert(state.buffer.end(), bytes.begin(), bytes.end());
  }
}

void OutputFile::write(std::string_view text) { write(std::as_bytes(std::span(text))); }

void OutputFile::write_at(std::size_t position, std::span<const std::byte> bytes) {
  State& state = *state_;
  if (position > size() || bytes.size() > size() - position) {
    throw std::invalid_argument("OutputFile::write_at: ends at " +
                                std::to_string(position + bytes.size()) + ", expected at most " +
                                std::to_string(size()));
  }
  if (state.target.empty() && state.direct_fd < 0) {
    throw std::invalid_argument("OutputFile::write_at: " + state.thing +
                                " was not opened seekable");
  }
  state.flush();
  state.failed = true;
  while (!bytes.empty()) {
    const ssize_t written = retry([&] {
      return ::pwrite(state.fd, bytes.data(), bytes.size(), static_cast<off_t>(position));
    });
    if (written < 0) fail(state.thing, "cannot write", errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    position += static_cast<std::size_t>(written);
  }
  state.failed = false;
}

std::size_t OutputFile::size() const noexcept { return state_->flushed + state_->buffer.size(); }

void OutputFile::commit() {
  State& state = *state_;
  assert(state.fd >= 0 && "committed once only");
  if (state.failed) {
    throw Error(ErrorKind::kSystem, state.thing, "was not written completely");
  }
  state.flush();
  if (state.direct_fd >= 0) state.copy_spool();
  if (!state.target.empty()) state.temporary ? state.appear_named() : state.appear();
}

const std::string& OutputFile::path() const noexcept { return state_->path; }

std::string read_text_file(const std::string& path, std::size_t limit) {
  const std::string thing = shown(path, "standard input");
  const int opened =
      path == "-" ? STDIN_FILENO
                  : retry([&] { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY); });
  if (opened < 0 && errno == ENOENT) {
    throw Error(ErrorKind::kSystem, thing, "there is no such file", "check the name");
  }
  if (opened < 0) fail(thing, "cannot be read", errno);
  struct Closer {
    int fd;
    ~Closer() {
      if (fd > STDERR_FILENO) ::close(fd);
    }
  } const file{opened};

  std::string text;
  std::vector<char> chunk(kBufferBytes);
  for (;;) {
    const ssize_t got = retry([&] { return ::read(file.fd, chunk.data(), chunk.size()); });
    if (got < 0 && errno == EISDIR) {
      throw Error(ErrorKind::kSystem, thing, "is a directory", "give the name of a file in it");
    }
    if (got < 0) fail(thing, "cannot be read", errno);
    if (got == 0) return text;
    if (static_cast<std::size_t>(got) > limit - text.size()) {
      throw Error(ErrorKind::kContent, thing, "is longer than " + std::to_string(limit) + " bytes",
                  "give a smaller file");
    }
    text.append(chunk.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace tristim
