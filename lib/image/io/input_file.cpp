#include "lib/image/io/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <utility>
#include <vector>

#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr std::size_t kSpoolBlock = std::size_t{1} << 20;

// Closes a descriptor unless it has been released: constructors may throw half way.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const noexcept { return value_; }
  int release() noexcept { return std::exchange(value_, -1); }

 private:
  int value_;
};

std::string temporary_directory() {
  const char* directory = std::getenv("TMPDIR");  // NOLINT(concurrency-mt-unsafe): never set here
  return directory != nullptr && *directory != '\0' ? directory : "/tmp";
}

int open_temporary(const std::string& directory) {
  std::string path = directory + "/tristim-XXXXXX";
  const int descriptor = ::mkostemp(path.data(), O_CLOEXEC);
  if (descriptor < 0) {
    throw Error(ErrorKind::kSystem, directory,
                "cannot hold a copy of the input: " + system_message(errno),
                "set TMPDIR to a directory that can be written");
  }
  ::unlink(path.c_str());
  return descriptor;
}

void write_all(int descriptor, const char* data, std::size_t size, const std::string& directory) {
  while (size > 0) {
    const ssize_t written = ::write(descriptor, data, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      throw Error(ErrorKind::kSystem, directory,
                  "cannot hold a copy of the input: " + system_message(errno),
                  "set TMPDIR to a directory with more room");
    }
    data += written;
    size -= static_cast<std::size_t>(written);
  }
}

// Pipes cannot be read at any place, and pictures need that.
int spool(int from, const std::string& name) {
  const std::string directory = temporary_directory();
  Descriptor copy(open_temporary(directory));
  std::vector<char> block(kSpoolBlock);
  for (;;) {
    const ssize_t count = ::read(from, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      throw Error(ErrorKind::kSystem, name, "cannot be read: " + system_message(errno));
    if (count == 0) return copy.release();
    write_all(copy.get(), block.data(), static_cast<std::size_t>(count), directory);
  }
}

int open_for_reading(const std::string& path, const std::string& name) {
  const int descriptor = path == "-" ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0)
                                     : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor >= 0) return descriptor;
  const int error = errno;
  throw Error(ErrorKind::kSystem, name, "cannot be opened: " + system_message(error),
              error == ENOENT ? "check the path" : "");
}

struct stat status(int descriptor, const std::string& name) {
  struct stat facts = {};
  if (::fstat(descriptor, &facts) != 0) {
    throw Error(ErrorKind::kSystem, name, "cannot be read: " + system_message(errno));
  }
  return facts;
}

}  // namespace

InputFile::InputFile(const std::string& path) : name_(path == "-" ? "standard input" : path) {
  if (path.empty()) throw Error(ErrorKind::kSystem, "input", "has no name", "name a picture");
  Descriptor file(open_for_reading(path, name_));
  struct stat facts = status(file.get(), name_);
  if (S_ISDIR(facts.st_mode)) {
    throw Error(ErrorKind::kSystem, name_, "is a directory", "name a picture inside it");
  }
  if (S_ISCHR(facts.st_mode) || S_ISBLK(facts.st_mode)) {
    throw Error(ErrorKind::kSystem, name_, "is a device", "name a picture file or pipe one in");
  }
  if (S_ISREG(facts.st_mode) && ::lseek(file.get(), 0, SEEK_CUR) == 0) {
    if (path != "-") path_ = path;
    descriptor_ = file.release();
  } else {
    Descriptor copy(spool(file.get(), name_));
    facts = status(copy.get(), name_);
    descriptor_ = copy.release();
  }
  size_ = static_cast<std::uint64_t>(facts.st_size);
}

InputFile::InputFile(std::string name, std::string_view bytes)
    : name_(std::move(name)), memory_(bytes), size_(bytes.size()) {}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::string InputFile::reopen_path() const {
  return path_.empty() ? "/dev/fd/" + std::to_string(descriptor_) : path_;
}

std::size_t InputFile::read_at(std::uint64_t position, std::span<std::byte> bytes) const {
  if (descriptor_ < 0) {
    if (position >= memory_.size()) return 0;
    return memory_.copy(reinterpret_cast<char*>(bytes.data()), bytes.size(), position);
  }
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::pread(descriptor_, bytes.data() + done, bytes.size() - done,
                                  static_cast<off_t>(position + done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      throw Error(ErrorKind::kSystem, name_, "cannot be read: " + system_message(errno));
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  return done;
}

}  // namespace tristim::detail
