#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tristim/core/file.h"
#include "tristim/frame/code.h"
#include "tristim/frame/io/write.h"

namespace tristim::detail {

/// What the writers of all formats share: the file, the count of the rows and the check of the
/// codes.
class FileSink : public CodeSink {
 public:
  /// `seekable`: the writer goes back in the file. Throws Error as OutputFile does.
  FileSink(const std::string& path, const FrameInfo& info, bool replace, bool seekable = false);

  /// Throws std::invalid_argument for rows of another shape, too many rows or a code out of range.
  void write(ImageView<const std::uint16_t> rows) final;

  /// Throws std::logic_error when rows are missing.
  void finish() final;

 protected:
  virtual void write_row(std::span<const std::uint16_t> codes) = 0;
  virtual void write_end() {}

  const FrameInfo& info() const noexcept { return info_; }
  OutputFile& file() noexcept { return file_; }

 private:
  void check_codes(std::span<const std::uint16_t> codes) const;
  std::int64_t all_rows() const noexcept;  // of all pictures

  FrameInfo info_;
  OutputFile file_;
  std::int64_t rows_ = 0;  // written
};

/// Throws std::invalid_argument for a size below 1x1, no pictures, a palette of RGB codes or a
/// gamma that is not above 0.
void check_frame(const FrameInfo& info);

inline unsigned max_code(int bits) noexcept { return (1u << bits) - 1; }

/// A code of `from` bits as one of `to` bits that means the same part of the range, rounded half
/// up.
inline std::uint16_t widen(unsigned code, int from, int to) noexcept {
  const unsigned long long old_max = max_code(from);
  return static_cast<std::uint16_t>((code * 2ull * max_code(to) + old_max) / (2 * old_max));
}

/// Throws Error (kMisuse) where a palette entry's code has more bits than the packing.
void check_palette_codes(const std::string& path, const FrameInfo& info);

/// One row as the frame buffer holds it: positions in a palette become the codes of its entries.
/// `scratch` is a row that is kept between calls.
void pack_device_row(std::span<const std::uint16_t> codes, const FrameInfo& info,
                     std::vector<std::uint16_t>& scratch, std::span<std::uint8_t> bytes);

/// The name of a path's last part after the dot, in small letters; "" where there is none.
std::string extension_of(const std::string& path);

}  // namespace tristim::detail
