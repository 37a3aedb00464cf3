#include "lib/palette/io/byte_reader.h"
#include "lib/palette/io/formats.h"
#include "lib/palette/io/text_rows.h"

namespace tristim::detail {
namespace {

constexpr std::uint32_t kVersion = 0x0300;

}  // namespace

// RIFF with a chunk that is a LOGPALETTE [RIFF]: entries of red, green, blue and flags.
Palette read_riff(std::string_view bytes, const std::string& file) {
  ByteReader in(bytes, file);
  if (in.text(4) != "RIFF") in.fail("does not begin with 'RIFF'");
  (void)in.little32();  // some writers count wrongly
  if (in.text(4) != "PAL ") in.fail("is a RIFF file, but not of a palette");
  for (;;) {
    const std::string_view name = in.text(4);
    const std::uint32_t size = in.little32();
    if (name == "data") break;
    in.skip(std::size_t{size} + size % 2);
  }
  if (in.little16() != kVersion) in.fail("the version of the palette is not known");
  const std::size_t count = in.little16();
  Palette palette;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t r = in.byte();
    const std::uint8_t g = in.byte();
    const std::uint8_t b = in.byte();
    in.skip(1);
    palette.colors.push_back({color_of_codes(r, g, b)});
  }
  return palette;
}

std::string write_riff(const Palette& palette) {
  const auto count = static_cast<std::uint32_t>(palette.colors.size());
  std::string bytes = "RIFF";
  put_little(bytes, 4 + 8 + 4 + 4 * count, 4);
  bytes += "PAL data";
  put_little(bytes, 4 + 4 * count, 4);
  put_little(bytes, kVersion, 2);
  put_little(bytes, count, 2);
  for (const PaletteColor& entry : palette.colors) {
    for (const std::uint8_t code : color_codes8(entry.color)) put_little(bytes, code, 1);
    put_little(bytes, 0, 1);
  }
  return bytes;
}

}  // namespace tristim::detail
