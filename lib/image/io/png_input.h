#pragma once

#include <png.h>

#include <cstdint>
#include <span>

#include "lib/image/io/png_colour.h"
#include "lib/image/io/readers.h"

namespace tristim::detail {

/// libpng's reader. Its errors jump, so each function below that calls it sets the jump's target
/// and has no object with a destructor in between.
class PngInput {
 public:
  /// `keep_positions`: rows of a palette picture are its positions, a byte each; else its colours.
  explicit PngInput(InputFilePtr file, bool keep_positions = false);
  ~PngInput();
  PngInput(const PngInput&) = delete;
  PngInput& operator=(const PngInput&) = delete;

  /// What stands before the pixels. False where it is damaged.
  bool read_header();
  /// The next row; of an interlaced file, all of them.
  bool read_rows(png_bytepp rows, int count);

  const InputFile& file() const noexcept { return *file_; }
  png_uint_32 width() const noexcept { return width_; }
  png_uint_32 height() const noexcept { return height_; }
  bool interlaced() const noexcept { return interlaced_; }
  int stored_depth() const noexcept { return stored_depth_; }
  int stored_type() const noexcept { return stored_type_; }
  int samples() const noexcept { return samples_; }
  int depth() const noexcept { return depth_; }
  const PngColour& colour() const noexcept { return colour_; }
  double pixel_aspect() const noexcept { return pixel_aspect_; }
  int orientation() const noexcept { return orientation_; }
  /// The colours and, in front, the alphas of a palette picture; valid while this lives.
  std::span<const png_color> palette() const noexcept;
  std::span<const png_byte> alphas() const noexcept;
  const char* message() const noexcept { return message_; }

 private:
  static void fail(png_structp png, png_const_charp text);
  static void ignore(png_structp /*png*/, png_const_charp /*text*/) {}
  static void read_bytes(png_structp png, png_bytep bytes, size_t size);
  void choose_transformations();
  void read_metadata();

  InputFilePtr file_;
  bool keep_positions_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::uint64_t position_ = 0;
  png_uint_32 width_ = 0;
  png_uint_32 height_ = 0;
  bool interlaced_ = false;
  int stored_depth_ = 0;
  int stored_type_ = 0;
  int samples_ = 0;
  int depth_ = 0;
  PngColour colour_;
  double pixel_aspect_ = 1;
  int orientation_ = 1;
  char message_[128] = "";
};

}  // namespace tristim::detail
