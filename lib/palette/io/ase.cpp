#include <cmath>

#include "lib/palette/io/adobe_color.h"
#include "lib/palette/io/byte_reader.h"
#include "lib/palette/io/formats.h"

namespace tristim::detail {
namespace {

// Types of a block [ASE].
constexpr std::uint32_t kGroupBegins = 0xc001;
constexpr std::uint32_t kGroupEnds = 0xc002;
constexpr std::uint32_t kColor = 0x0001;
constexpr std::uint32_t kNormal = 2;  // a colour that is neither global nor a spot

EncodedRgb read_model(ByteReader& in) {
  const std::string_view model = in.text(4);
  const auto value = [&in] {
    const double v = in.big_float();
    if (!std::isfinite(v)) in.fail("a colour that is no number");
    return v;
  };
  if (model == "RGB ") {
    const double r = nearest_code16(value());
    const double g = nearest_code16(value());
    return {r, g, nearest_code16(value())};
  }
  if (model == "CMYK") {
    Cmyk ink;
    for (double* part : {&ink.c, &ink.m, &ink.y, &ink.k}) *part = value();
    return color_of_cmyk(ink);
  }
  if (model == "LAB ") {
    Lab lab;
    lab.l = 100 * value();
    lab.a = value();
    lab.b = value();
    return color_of_lab_d50(lab);
  }
  if (model == "Gray" || model == "GRAY") {
    const double grey = nearest_code16(value());
    return {grey, grey, grey};
  }
  in.fail("a colour of an unknown model", "RGB, CMYK, LAB and Gray are read");
}

}  // namespace

Palette read_ase(std::string_view bytes, const std::string& file) {
  ByteReader in(bytes, file);
  if (in.text(4) != "ASEF") in.fail("does not begin with 'ASEF'");
  in.skip(4);  // version
  const std::size_t blocks = in.big32();
  Palette palette;
  for (std::size_t i = 0; i < blocks; ++i) {
    const std::uint32_t type = in.big16();
    const std::size_t size = in.big32();
    if (size > in.left()) in.fail("a block is longer than the file", "write or copy it again");
    const std::size_t end = in.position() + size;
    if (type == kColor) {
      std::string name = in.utf16(in.big16());
      palette.colors.push_back({read_model(in), std::move(name)});
    } else if (type == kGroupBegins && palette.name.empty()) {
      palette.name = in.utf16(in.big16());
    }
    if (in.position() > end) in.fail("a block is longer than it says", "write or copy it again");
    in.skip(end - in.position());
  }
  return palette;
}

std::string write_ase(const Palette& palette) {
  std::string bytes = "ASEF";
  put_big(bytes, 0x00010000, 4);
  put_big(bytes, static_cast<std::uint32_t>(palette.colors.size() + 2), 4);
  const std::u16string group = utf16_of(palette.name);
  put_big(bytes, kGroupBegins, 2);
  put_big(bytes, static_cast<std::uint32_t>(2 + 2 * group.size()), 4);
  put_big(bytes, static_cast<std::uint32_t>(group.size()), 2);
  put_utf16(bytes, group);
  for (const PaletteColor& entry : palette.colors) {
    const std::u16string name = utf16_of(entry.name);
    put_big(bytes, kColor, 2);
    put_big(bytes, static_cast<std::uint32_t>(2 + 2 * name.size() + 4 + 3 * 4 + 2), 4);
    put_big(bytes, static_cast<std::uint32_t>(name.size()), 2);
    put_utf16(bytes, name);
    bytes += "RGB ";
    const EncodedRgb& c = entry.color;
    for (const double channel : {c.r, c.g, c.b}) put_big_float(bytes, static_cast<float>(channel));
    put_big(bytes, kNormal, 2);
  }
  put_big(bytes, kGroupEnds, 2);
  put_big(bytes, 0, 4);
  return bytes;
}

}  // namespace tristim::detail
