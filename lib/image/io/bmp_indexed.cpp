#include <algorithm>
#include <array>

#include "lib/image/io/indexed_readers.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

enum class Compression { kNone = 0, kRle8 = 1, kRle4 = 2 };

/// What the headers say [BMP].
struct Header {
  std::uint32_t pixels_at = 0;
  std::uint32_t palette_at = 0;
  std::size_t entry_bytes = 4;  // 3 of OS/2
  std::int64_t width = 0, height = 0;
  bool from_top = false;
  std::uint32_t bits = 0;
  std::uint32_t compression = 0;
  std::uint32_t colors = 0;  // 0: as many as the bits allow
};

constexpr std::uint32_t kCoreBytes = 12;  // BITMAPCOREHEADER of OS/2
constexpr std::uint32_t kInfoBytes = 40;  // BITMAPINFOHEADER; later ones go on behind it
constexpr std::uint32_t kFileBytes = 14;

std::uint32_t little(std::span<const std::byte> bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = count - 1; i >= 0; --i) {
    value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + static_cast<std::size_t>(i)]);
  }
  return value;
}

[[noreturn]] void fail(const InputFile& file, const std::string& why) {
  throw Error(ErrorKind::kContent, file.name(), why, "write or copy it again");
}

Header read_header(const InputFile& file) {
  std::array<std::byte, kFileBytes + kInfoBytes> bytes{};
  const std::size_t count = file.read_at(0, bytes);
  Header header;
  const std::uint32_t size = count < kFileBytes + 4 ? 0 : little(bytes, kFileBytes, 4);
  const bool core = size == kCoreBytes;
  if (count < kFileBytes + (core ? kCoreBytes : kInfoBytes) || (!core && size < kInfoBytes)) {
    fail(file, "its BMP header is damaged or cut off");
  }
  header.pixels_at = little(bytes, 10, 4);
  header.palette_at = kFileBytes + size;
  if (core) {
    header.entry_bytes = 3;
    header.width = little(bytes, 18, 2);
    header.height = little(bytes, 20, 2);
    header.bits = little(bytes, 24, 2);
    return header;
  }
  header.width = static_cast<std::int32_t>(little(bytes, 18, 4));
  header.height = static_cast<std::int32_t>(little(bytes, 22, 4));
  header.from_top = header.height < 0;
  if (header.from_top) header.height = -header.height;
  header.bits = little(bytes, 28, 2);
  header.compression = little(bytes, 30, 4);
  header.colors = little(bytes, 46, 4);
  return header;
}

void read_palette(const InputFile& file, const Header& header, IndexedPicture& picture) {
  const std::uint32_t most = 1u << header.bits;
  const std::uint32_t count = header.colors == 0 ? most : std::min(header.colors, most);
  std::vector<std::byte> bytes(count * header.entry_bytes);
  if (file.read_at(header.palette_at, bytes) < bytes.size()) fail(file, "its palette is cut off");
  for (std::size_t at = 0; at < bytes.size(); at += header.entry_bytes) {
    const auto byte = [&](std::size_t i) { return std::to_integer<std::uint8_t>(bytes[at + i]); };
    picture.palette.push_back({byte(2), byte(1), byte(0), 255});
  }
}

/// Fills rows in the order of the file; a picture in the making.
class Rows {
 public:
  Rows(const InputFile& file, const Header& header, ImageView<std::uint8_t> view)
      : file_(file), header_(header), view_(view), at_(header.pixels_at) {}

  void read_plain() {
    const std::uint32_t bits = header_.bits;
    std::vector<std::byte> bytes((static_cast<std::size_t>(view_.width) * bits + 31) / 32 * 4);
    for (int y = 0; y < view_.height; ++y, at_ += bytes.size()) {
      const std::size_t used = (static_cast<std::size_t>(view_.width) * bits + 7) / 8;
      if (file_.read_at(at_, bytes) < used) fail_at_row(file_.name(), y, "the file ends early");
      for (int x = 0; x < view_.width; ++x) {
        const std::uint32_t first = static_cast<std::uint32_t>(x) * bits;
        const auto byte = std::to_integer<std::uint32_t>(bytes[first / 8]);
        put(x, y, byte >> (8 - bits - first % 8) & ((1u << bits) - 1));
      }
    }
  }

  // Runs: a count and the position (two of 4 bits in turn); 0 and a code: end of row, end of
  // picture, a jump, or so many positions as they are.
  void read_runs() {
    int x = 0;
    int y = 0;
    for (;;) {
      const std::uint32_t count = next(y);
      const std::uint32_t value = next(y);
      if (count > 0) {
        for (std::uint32_t i = 0; i < count; ++i) put(x++, y, part(value, i));
      } else if (value == 0) {
        x = 0;
        ++y;
      } else if (value == 1) {
        return;
      } else if (value == 2) {
        x += static_cast<int>(next(y));
        y += static_cast<int>(next(y));
      } else {
        copy(x, y, value);
      }
      if (y > view_.height) fail_at_row(file_.name(), view_.height, "its runs go on");
    }
  }

 private:
  bool is_4_bits() const { return header_.bits == 4; }

  std::uint32_t part(std::uint32_t value, std::uint32_t i) const {
    if (!is_4_bits()) return value;
    return i % 2 == 0 ? value >> 4 : value & 15;
  }

  void copy(int& x, int y, std::uint32_t count) {
    std::uint32_t value = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!is_4_bits() || i % 2 == 0) value = next(y);
      put(x++, y, part(value, i));
    }
    const std::uint32_t bytes = is_4_bits() ? (count + 1) / 2 : count;
    if (bytes % 2 == 1) (void)next(y);  // words are whole
  }

  std::uint32_t next(int y) {
    if (in_buffer_ == buffer_size_) {
      buffer_size_ = file_.read_at(at_, buffer_);
      at_ += buffer_size_;
      in_buffer_ = 0;
      if (buffer_size_ == 0) fail_at_row(file_.name(), y, "the file ends early");
    }
    return std::to_integer<std::uint32_t>(buffer_[in_buffer_++]);
  }

  // What runs over an edge is dropped, as other readers do.
  void put(int x, int y, std::uint32_t position) {
    if (x < 0 || x >= view_.width || y >= view_.height) return;
    *view_.pixel(x, header_.from_top ? y : view_.height - 1 - y) =
        static_cast<std::uint8_t>(position);
  }

  const InputFile& file_;
  const Header& header_;
  ImageView<std::uint8_t> view_;
  std::uint64_t at_;
  std::array<std::byte, 4096> buffer_{};
  std::size_t in_buffer_ = 0, buffer_size_ = 0;
};

}  // namespace

std::optional<IndexedPicture> read_indexed_bmp(InputFilePtr file) {
  const Header header = read_header(*file);
  const bool indexed = header.bits == 1 || header.bits == 2 || header.bits == 4 || header.bits == 8;
  if (!indexed) return std::nullopt;
  const bool runs =
      (header.compression == static_cast<std::uint32_t>(Compression::kRle8) && header.bits == 8) ||
      (header.compression == static_cast<std::uint32_t>(Compression::kRle4) && header.bits == 4);
  if (header.compression != 0 && !runs) {
    fail(*file, "has the unknown compression " + std::to_string(header.compression));
  }
  IndexedPicture picture;
  picture.positions = position_raster(file->name(), header.width, header.height);
  read_palette(*file, header, picture);
  Rows rows(*file, header, picture.positions.view());
  runs ? rows.read_runs() : rows.read_plain();
  return picture;
}

}  // namespace tristim::detail
