#include <algorithm>
#include <array>
#include <vector>

#include "lib/frame/io/file_sink.h"
#include "lib/frame/io/formats.h"
#include "tristim/core/error.h"
#include "tristim/frame/pack.h"

namespace tristim::detail {
namespace {

/// A type of the PNM family [Netpbm].
enum class Type { kPbm, kPgm, kPpm };

bool is_grey(const PaletteEntry& entry) {
  return entry.srgb[0] == entry.srgb[1] && entry.srgb[1] == entry.srgb[2];
}

/// Luma of an entry times 10000 [BT709].
int luma(const PaletteEntry& entry) {
  return 2126 * entry.srgb[0] + 7152 * entry.srgb[1] + 722 * entry.srgb[2];
}

/// The position that PBM shows black: the darker of two entries, a single one where it is dark.
unsigned darker_position(std::span<const PaletteEntry> palette) {
  if (palette.empty()) return 0;
  const int other = palette.size() > 1 ? luma(palette[1]) : 255 * 10000 / 2;
  return luma(palette[0]) <= other ? 0 : 1;
}

/// The smallest type that keeps the codes apart.
Type fitting_type(const FrameInfo& info) {
  if (info.layout.packing.samples == 3) return Type::kPpm;
  if (info.palette.empty()) return info.layout.packing.bits[0] == 1 ? Type::kPbm : Type::kPgm;
  if (info.palette.size() <= 2) return Type::kPbm;
  return std::ranges::all_of(info.palette, is_grey) ? Type::kPgm : Type::kPpm;
}

[[noreturn]] void fail_unfit(const std::string& path, std::string_view type, Type fitting) {
  throw Error(ErrorKind::kMisuse, path,
              type == "pbm" ? "PBM holds one bit a pixel, these codes have more"
                            : "PGM holds greys only, these codes are colours",
              fitting == Type::kPgm ? "use .pgm or .pnm" : "use .ppm or .pnm");
}

/// The type that the extension asks for.
Type type_of(const std::string& path, const FrameInfo& info) {
  const Type fitting = fitting_type(info);
  const std::string extension = extension_of(path);
  if (extension == "ppm") return Type::kPpm;
  if (extension == "pgm") {
    const bool colours = fitting == Type::kPpm || !std::ranges::all_of(info.palette, is_grey);
    if (colours) fail_unfit(path, extension, Type::kPpm);
    return Type::kPgm;
  }
  if (extension == "pbm" && fitting != Type::kPbm) fail_unfit(path, extension, fitting);
  return fitting;
}

/// Bits of the file's samples: its highest sample is 2^bits - 1.
int sample_bits(Type type, const FrameInfo& info) {
  if (type == Type::kPbm) return 1;
  if (!info.palette.empty()) return 8;
  const auto& bits = info.layout.packing.bits;
  const bool equal = info.layout.packing.samples == 1 || (bits[0] == bits[1] && bits[1] == bits[2]);
  return equal ? bits[0] : std::max(8, *std::ranges::max_element(bits));
}

class PnmSink final : public FileSink {
 public:
  PnmSink(const std::string& path, const FrameInfo& info, bool replace, Type type)
      : FileSink(path, info, replace), type_(type), bits_(sample_bits(type, info)) {
    const int samples = type == Type::kPpm ? 3 : 1;
    const int stored = type == Type::kPbm ? 1 : bits_ <= 8 ? 8 : 16;
    packed_.packing = {
        "", samples, {stored, samples == 3 ? stored : 0, samples == 3 ? stored : 0}, false, false};
    row_.resize(static_cast<std::size_t>(info.width) * static_cast<unsigned>(samples));
    bytes_.resize(packed_row_bytes(packed_.packing, info.width));
    darker_ = darker_position(info.palette);
    write_header();
  }

 private:
  void write_header() {
    const char magic[] = {'P',
                          type_ == Type::kPbm   ? '4'
                          : type_ == Type::kPgm ? '5'
                                                : '6',
                          '\n', 0};
    std::string header = magic;
    header += std::to_string(info().width) + " " + std::to_string(info().height) + "\n";
    if (type_ != Type::kPbm) header += std::to_string(max_code(bits_)) + "\n";
    file().write(header);
  }

  void write_row(std::span<const std::uint16_t> codes) override {
    if (type_ == Type::kPbm) {
      for (std::size_t i = 0; i < codes.size(); ++i) row_[i] = codes[i] == darker_;  // 1 is black
    } else if (!info().palette.empty()) {
      put_colours(codes);
    } else if (codes.size() < row_.size()) {
      for (std::size_t i = 0; i < row_.size(); ++i) row_[i] = codes[i / 3];
    } else {
      put_samples(codes);
    }
    pack_row(row_, packed_, bytes_);
    file().write(std::as_bytes(std::span(bytes_)));
  }

  void put_colours(std::span<const std::uint16_t> positions) {
    const std::size_t samples = type_ == Type::kPpm ? 3 : 1;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const auto& srgb = info().palette[positions[i]].srgb;
      std::copy_n(srgb.begin(), samples, row_.begin() + static_cast<std::ptrdiff_t>(i * samples));
    }
  }

  void put_samples(std::span<const std::uint16_t> codes) {
    const auto& from = info().layout.packing.bits;
    const std::size_t samples = static_cast<std::size_t>(info().layout.packing.samples);
    for (std::size_t k = 0; k < samples; ++k) {
      for (std::size_t i = k; i < codes.size(); i += samples) {
        row_[i] = from[k] == bits_ ? codes[i] : widen(codes[i], from[k], bits_);
      }
    }
  }

  Type type_;
  int bits_;
  unsigned darker_ = 0;  // the code, or the position in the palette, that PBM shows black
  FrameLayout packed_;   // PNM's own: most significant bit and byte first
  std::vector<std::uint16_t> row_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::unique_ptr<CodeSink> open_pnm(const std::string& path, const FrameInfo& info,
                                   const FrameWriteOptions& options) {
  return std::make_unique<PnmSink>(path, info, options.replace, type_of(path, info));
}

}  // namespace tristim::detail
