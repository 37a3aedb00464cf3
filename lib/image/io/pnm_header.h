#pragma once

#include <cstdint>
#include <string>

#include "lib/image/io/input_file.h"

namespace tristim::detail {

/// What stands before the samples of a file of the Netpbm family [Netpbm]: PBM, PGM, PPM, PAM and
/// PFM.
struct PnmHeader {
  std::string format;  // "pbm", "pgm", "ppm", "pam", "pfm"
  std::int64_t width = 0;
  std::int64_t height = 0;
  int samples = 1;             // of a pixel
  bool alpha = false;          // the last of them
  std::int64_t maximum = 1;    // highest value; of PFM 1
  bool text = false;           // samples in digits
  bool packed = false;         // eight pixels a byte, 1 is black
  bool little_endian = false;  // of PFM
  std::uint64_t data = 0;      // where the samples begin
};

/// Throws Error (kContent) where it is damaged.
PnmHeader read_pnm_header(const InputFile& file);

/// Characters of a file in turn.
class CharacterReader {
 public:
  CharacterReader(const InputFile& file, std::uint64_t position)
      : file_(file), position_(position) {}

  /// The next one, or -1 at the end.
  int next();
  /// The next one is read again.
  void back() noexcept { --at_; }
  /// Of the next character.
  std::uint64_t position() const noexcept { return position_ - (size_ - at_); }

 private:
  const InputFile& file_;
  std::uint64_t position_;  // after the block
  std::byte block_[65536];
  std::size_t at_ = 0;
  std::size_t size_ = 0;
};

/// The next number, after white space and comments; -1 where there is none, or it is above 2^40.
std::int64_t read_number(CharacterReader& characters);

}  // namespace tristim::detail
