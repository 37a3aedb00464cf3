#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace tristim {

/// A file that appears under its name only when it is complete.
///
/// Where the file system allows it the bytes go to a file without a name in the target's directory,
/// so that nothing is left behind however the process ends; elsewhere to a temporary file beside
/// the target, which remove_temporary_files() removes. A symbolic link is written through to what
/// it points to. A target that is no regular file (a pipe, /dev/null) is written directly. "-" and
/// "/dev/stdout" are standard output. Permissions follow the umask.
///
/// The caller ignores SIGPIPE and SIGXFSZ, so that a lost reader and a size limit become Errors.
class OutputFile {
 public:
  /// `seekable`: write_at will be called; what goes to a pipe is then kept in an unlinked temporary
  /// file until commit(). Throws Error: kSystem where the target exists and `replace` is false, is
  /// a directory or write-protected, or its directory is missing or cannot be written; kMisuse
  /// where `path` is empty.
  explicit OutputFile(std::string path, bool replace = false, bool seekable = false);
  ~OutputFile();  // without commit(): removes what was written
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Appends. Throws Error (kSystem) on a full disk and the like; after that the file cannot be
  /// committed.
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);

  /// Overwrites at `position`, for formats that fill in a table at the end (EXR). Throws
  /// std::invalid_argument beyond what was appended so far, or where a pipe was not opened
  /// `seekable`; Error as write() does.
  void write_at(std::size_t position, std::span<const std::byte> bytes);

  /// The bytes appended so far.
  std::size_t size() const noexcept;

  /// Makes the file appear; once, and nothing is written after it. Throws Error (kSystem); kSystem
  /// too where the target has come into being meanwhile and may not be replaced.
  void commit();

  const std::string& path() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Removes the named temporary files (of the first 64 OutputFiles at a time) not yet committed.
/// Safe to call from a signal handler, after which the process should end.
void remove_temporary_files() noexcept;

/// The whole of a text file; "-" is standard input. Throws Error: kSystem where it is missing, a
/// directory or unreadable, kContent where it is longer than `limit` bytes.
std::string read_text_file(const std::string& path, std::size_t limit = std::size_t{64} << 20);

}  // namespace tristim
