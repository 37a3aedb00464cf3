#include <algorithm>
#include <cmath>

#include "tristim/color/transfer.h"
#include "tristim/pipeline/reduce.h"

namespace tristim {
namespace {

std::uint8_t srgb_byte(double light) {
  return static_cast<std::uint8_t>(
      std::floor(255 * srgb_encode(std::clamp(light, 0.0, 1.0)) + 0.5));
}

std::array<std::uint8_t, 3> srgb_bytes(const Rgb& light, const Eigen::Matrix3d& srgb_from_device) {
  const Eigen::Vector3d c = srgb_from_device * Eigen::Vector3d(light.r, light.g, light.b);
  return {srgb_byte(c.x()), srgb_byte(c.y()), srgb_byte(c.z())};
}

// The look-up table of a frame buffer that holds levels: entry j is the grey V_j, scaled to 8 bits.
std::vector<PaletteEntry> colour_table(const Display& display) {
  const int bits = display.frame.packing.bits[0];
  const int code_max = (1 << bits) - 1;
  std::vector<PaletteEntry> table;
  for (const int value : display_level_codes(display, bits)) {
    const auto grey = static_cast<std::uint8_t>((value * 255 * 2 + code_max) / (2 * code_max));
    const auto j = static_cast<std::uint16_t>(table.size());
    table.push_back({{grey, grey, grey}, j, {}});
  }
  return table;
}

// The curve of the codes, where a tag of the file formats describes it.
void tag_curve(const Display& display, FrameInfo& info) {
  if (!has_one_response(display)) return;
  const bool srgb_curve = std::holds_alternative<SrgbResponse>(display.response);
  info.srgb = srgb_curve && display.primaries == Primaries{};
  if (const auto* gamma = std::get_if<GammaResponse>(&display.response)) info.gamma = gamma->gamma;
  if (std::holds_alternative<LinearResponse>(display.response)) info.gamma = 1;
  if (std::holds_alternative<Bt1886Response>(display.response)) info.gamma = 2.4;
}

}  // namespace

Decoder::Decoder(const Display& display) : samples_(display.frame.packing.samples) {
  if (!display.palette.empty()) {
    entries_ = palette_light(display, BlackPoint::kAbsolute);
    return;
  }
  if (samples_ == 1) {
    for (const double light : light_of_codes(display, display.frame.packing.bits[0])) {
      entries_.push_back({light, light, light});
    }
    return;
  }
  for (std::size_t c = 0; c < 3; ++c) {
    for (const double light :
         light_of_codes(display, display.frame.packing.bits[c], static_cast<int>(c))) {
      channel_[c].push_back(static_cast<float>(light));
    }
  }
}

Rgb Decoder::light(const std::uint16_t* samples) const noexcept {
  if (!entries_.empty()) return entries_[samples[0]];
  return {channel_[0][samples[0]], channel_[1][samples[1]], channel_[2][samples[2]]};
}

void Decoder::decode(ImageView<const std::uint16_t> codes, ImageView<float> light) const {
  for (int y = 0; y < codes.height; ++y) {
    const std::uint16_t* from = codes.row(y).data();
    float* to = light.row(y).data();
    for (int x = 0; x < codes.width; ++x, from += samples_, to += 3) {
      const Rgb c = this->light(from);
      to[0] = static_cast<float>(c.r);
      to[1] = static_cast<float>(c.g);
      to[2] = static_cast<float>(c.b);
    }
  }
}

FrameInfo frame_info(const Display& display, int width, int height) {
  FrameInfo info;
  info.width = width;
  info.height = height;
  info.layout = display.frame;
  info.primaries = display.primaries;
  info.device = display.name;
  if (display.dots) info.dpi = display.dots->dpi;
  const bool indices = display.levels && display.frame.store == Store::kIndex;
  if (!indices) tag_curve(display, info);
  if (indices && is_monochrome(display)) {
    info.palette = colour_table(display);
    return info;
  }
  const Eigen::Matrix3d srgb_from_device =
      rgb_from_rgb(Primaries{}, display.primaries, Adaptation::kBradford);
  const std::vector<Rgb> light = palette_light(display, BlackPoint::kAbsolute);
  for (std::size_t i = 0; i < light.size(); ++i) {
    info.palette.push_back(
        {srgb_bytes(light[i], srgb_from_device), display.palette[i].code, display.palette[i].name});
  }
  return info;
}

}  // namespace tristim
