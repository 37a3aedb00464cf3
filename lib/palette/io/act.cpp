#include "lib/palette/io/byte_reader.h"
#include "lib/palette/io/formats.h"
#include "lib/palette/io/text_rows.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr std::size_t kEntries = 256;
constexpr std::size_t kTableBytes = 3 * kEntries;
constexpr std::uint32_t kNone = 0xffff;  // of the transparent position

}  // namespace

// 256 entries [Adobe]; where 4 bytes follow, how many of them count, and the transparent one.
Palette read_act(std::string_view bytes, const std::string& file) {
  if (bytes.size() != kTableBytes && bytes.size() != kTableBytes + 4) {
    throw Error(ErrorKind::kContent, file,
                "is " + std::to_string(bytes.size()) + " bytes long, a colour table has 768 or 772",
                "write or copy it again");
  }
  ByteReader in(bytes, file);
  Palette palette;
  for (std::size_t i = 0; i < kEntries; ++i) {
    const std::uint8_t r = in.byte();
    const std::uint8_t g = in.byte();
    const std::uint8_t b = in.byte();
    palette.colors.push_back({color_of_codes(r, g, b)});
  }
  if (in.left() == 0) return palette;
  const std::size_t count = in.big16();
  if (count > kEntries) in.fail("says that " + std::to_string(count) + " of 256 colours count");
  if (count > 0) palette.colors.resize(count);
  const std::size_t transparent = in.big16();
  if (transparent < palette.colors.size()) palette.colors[transparent].alpha = 0;
  return palette;
}

std::string write_act(const Palette& palette) {
  std::string bytes;
  std::uint32_t transparent = kNone;
  for (std::size_t i = 0; i < palette.colors.size(); ++i) {
    const PaletteColor& entry = palette.colors[i];
    for (const std::uint8_t code : color_codes8(entry.color)) put_big(bytes, code, 1);
    if (entry.alpha == 0 && transparent == kNone) transparent = static_cast<std::uint32_t>(i);
  }
  bytes.resize(kTableBytes);
  put_big(bytes, static_cast<std::uint32_t>(palette.colors.size()), 2);
  put_big(bytes, transparent, 2);
  return bytes;
}

}  // namespace tristim::detail
