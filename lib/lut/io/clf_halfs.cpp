#include "lib/lut/io/clf.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/lut/io/text_lines.h"

namespace tristim::detail {
namespace {

constexpr unsigned kInfinity = 0x7c00;  // the bits of the first half float that is not finite
constexpr unsigned kSign = 0x8000;

// Which of the positive finite ones stands for any half float.
std::size_t place_of(unsigned bits) {
  if ((bits & kSign) != 0 || bits > kInfinity) return 0;  // NaN too
  return std::min(bits, kInfinity - 1);
}

// A LUT1D of `size` entries; entry i is that at `place(i)` of the curves.
template <typename Place>
std::string node(const std::array<std::vector<float>, 3>& curve, const char* attribute,
                 std::size_t size, const Place& place) {
  const bool grey = curve[0] == curve[1] && curve[0] == curve[2];
  std::string text = std::string("  <LUT1D inBitDepth=\"32f\" outBitDepth=\"32f\"") + attribute +
                     ">\n    <Array dim=\"" + std::to_string(size) + (grey ? " 1" : " 3") + "\">\n";
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = place(i);
    const float rgb[] = {curve[0][at], curve[1][at], curve[2][at]};
    if (grey) {
      append_float(text, rgb[0]);
      text += '\n';
    } else {
      append_row(text, rgb);
    }
  }
  return text + "    </Array>\n  </LUT1D>\n";
}

}  // namespace

float half_value(unsigned bits) noexcept {
  const int exponent = static_cast<int>(bits >> 10 & 31);
  const auto fraction = static_cast<float>(bits & 1023);
  float value =
      exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
  if (exponent == 31) {
    value = fraction == 0 ? std::numeric_limits<float>::infinity()
                          : std::numeric_limits<float>::quiet_NaN();
  }
  return (bits & kSign) != 0 ? -value : value;
}

std::vector<float> positive_halfs() {
  std::vector<float> values;
  values.reserve(kInfinity);
  for (unsigned bits = 0; bits < kInfinity; ++bits) values.push_back(half_value(bits));
  return values;
}

std::string half_domain_node(const std::array<std::vector<float>, 3>& curve) {
  return node(curve, " halfDomain=\"true\"", kHalfs,
              [](std::size_t i) { return place_of(static_cast<unsigned>(i)); });
}

std::string curves_node(const std::array<std::vector<float>, 3>& curve) {
  return node(curve, "", curve[0].size(), [](std::size_t i) { return i; });
}

std::string clf_text(const std::string& title, const std::string& nodes) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<ProcessList id=\"tristim\" compCLFversion=\"3.0\">\n  <Description>" +
         xml_text(title) + "</Description>\n" + nodes + "</ProcessList>\n";
}

}  // namespace tristim::detail
