#include "lib/palette/io/adobe_color.h"
#include "lib/palette/io/byte_reader.h"
#include "lib/palette/io/formats.h"
#include "tristim/color/hsv.h"

namespace tristim::detail {
namespace {

constexpr double kMost = 65535;

// The models of a swatch by its number [Adobe]; four values each.
EncodedRgb color_of_values(std::uint32_t model, const std::array<std::uint16_t, 4>& v,
                           const ByteReader& in) {
  const auto part = [&](std::size_t i) { return v[i] / kMost; };
  const auto hundredths = [&](std::size_t i) { return static_cast<std::int16_t>(v[i]) / 100.0; };
  switch (model) {
    case 0:
      return {part(0), part(1), part(2)};
    case 1:
      return hsv_to_rgb({part(0) * 360, part(1), part(2)});
    case 2:  // 0 is all of the ink
      return color_of_cmyk({1 - part(0), 1 - part(1), 1 - part(2), 1 - part(3)});
    case 7:
      return color_of_lab_d50({v[0] / 100.0, hundredths(1), hundredths(2)});
    case 8:
      return {v[0] / 10000.0, v[0] / 10000.0, v[0] / 10000.0};
    default:
      in.fail("a colour of the unknown model " + std::to_string(model),
              "RGB, HSB, CMYK, Lab and grey are read");
  }
}

// A section of version 1, or of 2, which has the names.
std::vector<PaletteColor> read_section(ByteReader& in, std::uint32_t version) {
  const std::size_t count = in.big16();
  std::vector<PaletteColor> colors;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t model = in.big16();
    std::array<std::uint16_t, 4> values{};
    for (std::uint16_t& value : values) value = in.big16();
    PaletteColor color{color_of_values(model, values, in)};
    if (version == 2) color.name = in.utf16(in.big32());
    colors.push_back(std::move(color));
  }
  return colors;
}

void put_section(std::string& bytes, const Palette& palette, std::uint32_t version) {
  put_big(bytes, version, 2);
  put_big(bytes, static_cast<std::uint32_t>(palette.colors.size()), 2);
  for (const PaletteColor& entry : palette.colors) {
    put_big(bytes, 0, 2);
    const EncodedRgb& c = entry.color;
    for (const double channel : {c.r, c.g, c.b}) put_big(bytes, unit_code(channel, 65535), 2);
    put_big(bytes, 0, 2);
    if (version == 1) continue;
    const std::u16string name = utf16_of(entry.name);
    put_big(bytes, static_cast<std::uint32_t>(name.size()), 4);
    put_utf16(bytes, name);
  }
}

}  // namespace

Palette read_aco(std::string_view bytes, const std::string& file) {
  ByteReader in(bytes, file);
  Palette palette;
  for (;;) {
    const std::uint32_t version = in.big16();
    if (version != 1 && version != 2) {
      in.fail("version " + std::to_string(version) + " of colour swatches is not known",
              "1 and 2 are");
    }
    palette.colors = read_section(in, version);
    if (version == 2 || in.left() < 2) return palette;
  }
}

std::string write_aco(const Palette& palette) {
  std::string bytes;
  put_section(bytes, palette, 1);
  put_section(bytes, palette, 2);
  return bytes;
}

}  // namespace tristim::detail
