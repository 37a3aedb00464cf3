#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace tristim::detail {

/// A file of bytes that can be read at any place: a regular file, a copy of a pipe in an unlinked
/// temporary file, or bytes in memory. Several threads may read at once.
class InputFile {
 public:
  /// "-" is standard input. Throws Error (kSystem) where the file is missing, a directory, a device
  /// or unreadable, or where a pipe finds no room for its copy.
  explicit InputFile(const std::string& path);

  /// Bytes that somebody else owns and that outlive this; `name` is for messages.
  InputFile(std::string name, std::string_view bytes);

  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// For messages: the path, or "standard input".
  const std::string& name() const noexcept { return name_; }

  /// A path under which another library can open the same bytes while this object lives; not of
  /// bytes in memory.
  std::string reopen_path() const;

  std::uint64_t size() const noexcept { return size_; }

  /// Fills `bytes` from `position` on and returns how many there were: fewer only at the end of the
  /// file. Throws Error (kSystem) where the system cannot read.
  std::size_t read_at(std::uint64_t position, std::span<std::byte> bytes) const;

 private:
  std::string name_;
  std::string path_;     // empty for a copy
  int descriptor_ = -1;  // -1: the bytes are in memory
  std::string_view memory_;
  std::uint64_t size_ = 0;
};

}  // namespace tristim::detail
