#include <array>

#include "lib/core/math.h"
#include "tristim/color/transfer.h"
#include "tristim/palette/quantize.h"

namespace tristim {
namespace {

std::uint8_t code_of(double light) {
  const double code = srgb_encode(light) * 255 + 0.5;
  return static_cast<std::uint8_t>(code);
}

// Light of paper, 1, where each ink covers a part and lets through what it does [Demichel24]: a
// product of means, as parts that are printed one over another are independent.
Color8 print(const std::vector<Color8>& inks, double darkness) {
  std::array<double, 3> light{1, 1, 1};
  double part = 1;
  for (const Color8& ink : inks) {
    part *= darkness;  // the first in all tones, each further one deeper in the shadows
    const std::array<std::uint8_t, 3> codes{ink.r, ink.g, ink.b};
    for (std::size_t c = 0; c < 3; ++c) {
      light[c] *= 1 - part + part * srgb_decode(codes[c] / 255.0);
    }
  }
  return {code_of(light[0]), code_of(light[1]), code_of(light[2])};
}

double luminance(const std::vector<Color8>& inks, double darkness) {
  const Color8 c = print(inks, darkness);
  return 0.2126 * srgb_decode(c.r / 255.0) + 0.7152 * srgb_decode(c.g / 255.0) +
         0.0722 * srgb_decode(c.b / 255.0);
}

// The darkness that has a lightness, as the cube root of luminance sees it.
double darkness_of(const std::vector<Color8>& inks, double lightness) {
  double low = 0;
  double high = 1;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (detail::cbrt(luminance(inks, middle)) > lightness ? low : high) = middle;
  }
  return high;
}

}  // namespace

std::vector<Color8> choose_inks(const PaletteTask& task) {
  std::vector<Color8> palette;
  const double darkest = detail::cbrt(luminance(task.inks, 1));
  const int last = task.colors - 1;
  for (int i = 0; i < task.colors; ++i) {
    const double darkness = i == 0 ? 1
                            : i == last
                                ? 0
                                : darkness_of(task.inks, darkest + (1 - darkest) * i / last);
    const Color8 color = print(task.inks, darkness);
    if (palette.empty() || palette.back() != color) palette.push_back(color);
  }
  return palette;
}

}  // namespace tristim
