#include <unistd.h>
#include <cerrno>
#include <cstdlib>
#include <filesystem>

#include "lib/lut/io/formats.h"
#include "lib/lut/io/ocio_module.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

// Bytes under a name of their own, as OpenColorIO reads files alone.
class TemporaryFile {
 public:
  TemporaryFile(std::string_view bytes, std::string_view extension) {
    path_ = (std::filesystem::temp_directory_path() / "tristim-XXXXXX").string();
    path_ += extension;
    const int file = ::mkstemps(path_.data(), static_cast<int>(extension.size()));
    if (file < 0) fail();
    std::string_view rest = bytes;
    while (!rest.empty()) {
      const ssize_t done = ::write(file, rest.data(), rest.size());
      if (done < 0 && errno != EINTR) break;
      if (done > 0) rest.remove_prefix(static_cast<std::size_t>(done));
    }
    const int error = errno;
    ::close(file);
    if (rest.empty()) return;
    ::unlink(path_.c_str());
    errno = error;
    fail();
  }
  ~TemporaryFile() { ::unlink(path_.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const noexcept { return path_; }

 private:
  [[noreturn]] void fail() const {
    throw Error(ErrorKind::kSystem, path_, "cannot be written: " + system_message(errno));
  }
  std::string path_;
};

Lut read_with_ocio(std::string_view bytes, const std::string& file, std::string_view extension) {
  const TemporaryFile copy(bytes, extension);
  auto* read = reinterpret_cast<ReadWithOcio*>(load_function(kOcioReadModule));
  Lut lut;
  read(copy.path(), file, lut);
  return lut;
}

}  // namespace

Lut read_clf(std::string_view bytes, const std::string& file, const LutFileOptions& /*options*/) {
  return read_with_ocio(bytes, file, ".clf");
}

Lut read_ctf(std::string_view bytes, const std::string& file, const LutFileOptions& /*options*/) {
  return read_with_ocio(bytes, file, ".ctf");
}

}  // namespace tristim::detail
