#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

struct libdeflate_compressor;
struct libdeflate_decompressor;

namespace tristim::detail {

/// The ZIP and ZIPS compression of OpenEXR [OpenEXR layout]: bytes of even and odd places apart,
/// each the difference from the one before, then zlib; by libdeflate, in half the time of zlib. One
/// object for each thread.
class ExrZip {
 public:
  ExrZip();
  ~ExrZip();
  ExrZip(const ExrZip&) = delete;
  ExrZip& operator=(const ExrZip&) = delete;

  /// Fills `raw` exactly, or returns false where `packed` is damaged.
  bool unpack(std::span<const std::byte> packed, std::span<std::byte> raw);

  /// The packed bytes, valid until the next call; `raw` itself where packing does not make it
  /// smaller.
  std::span<const std::byte> pack(std::span<const std::byte> raw);

 private:
  libdeflate_decompressor* decompressor_ = nullptr;  // made at first use
  libdeflate_compressor* compressor_ = nullptr;
  std::vector<std::byte> shuffled_;
  std::vector<std::byte> packed_;
};

}  // namespace tristim::detail
