#pragma once

#include <tiffio.h>

#include <array>
#include <cstdarg>
#include <cstdint>
#include <exception>
#include <string>

#include "tristim/core/file.h"

namespace tristim::detail {

/// libtiff's writer into an OutputFile that was opened seekable. Failures are Errors: of the file
/// as OutputFile::write has them, of libtiff kSystem.
class TiffFile {
 public:
  /// `large`: beyond 4 GiB, with places of 64 bits (BigTIFF).
  TiffFile(OutputFile& file, bool large);
  ~TiffFile();
  TiffFile(const TiffFile&) = delete;
  TiffFile& operator=(const TiffFile&) = delete;

  template <typename... Values>
  void set(std::uint32_t tag, Values... values) {
    check(TIFFSetField(tiff_, tag, values...));
  }

  /// The next row, packed, 16-bit samples in the machine's order; libtiff may change it.
  void put_row(void* row);

  /// Writes what stands behind the rows.
  void end();

 private:
  static tmsize_t read(thandle_t self, void* bytes, tmsize_t size);
  static tmsize_t write(thandle_t self, void* bytes, tmsize_t size);
  static toff_t seek(thandle_t self, toff_t offset, int whence);
  static toff_t size(thandle_t self);
  static int close(thandle_t self);
  static int keep_message(TIFF* tiff, void* self, const char* module, const char* format,
                          va_list arguments);
  static int drop_message(TIFF* tiff, void* self, const char* module, const char* format,
                          va_list arguments);
  void check(int result);

  OutputFile* file_;
  std::size_t position_ = 0;
  std::exception_ptr failure_;
  std::array<char, 128> message_{};
  std::uint32_t next_row_ = 0;
  TIFF* tiff_ = nullptr;
};

}  // namespace tristim::detail
