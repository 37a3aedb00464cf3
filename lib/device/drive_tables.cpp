#include "tristim/device/drive_tables.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "lib/core/math.h"
#include "lib/core/rounding.h"
#include "lib/device/precise_response.h"
#include "lib/device/spacing.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

using detail::decimal;
using Dd = detail::DoubleDouble;

// The bits of `value`, of which there are `bits`, in reverse: 0, 2, 1, 3 of two bits. In this order
// frames are switched on, so that those that are lie evenly.
unsigned reversed(unsigned value, int bits) {
  unsigned reverse = 0;
  for (int i = 0; i < bits; ++i) reverse |= (value >> i & 1U) << (bits - 1 - i);
  return reverse;
}

// The highest code whose light does not exceed `light`.
int code_below(const Response& response, double light, double code, int code_max) {
  int below = std::clamp(static_cast<int>(code), 0, code_max);
  while (below > 0 && light_of_code(response, below, code_max) > light) --below;
  while (below < code_max && light_of_code(response, below + 1, code_max) <= light) ++below;
  return below;
}

// How many of `frames` have the upper code.
int upper_frames(const Response& response, double light, int below, int code_max, int frames) {
  if (below == code_max) return 0;
  const double dark = light_of_code(response, below, code_max);
  const double bright = light_of_code(response, below + 1, code_max);
  const double share = (light - dark) / (bright - dark) * frames;
  return std::clamp(static_cast<int>(share + 0.5), 0, frames);
}

}  // namespace

LookUpTables look_up_tables(std::span<const int> codes, Store store, int code_max) {
  LookUpTables tables;
  const std::vector<int> values(codes.begin(), codes.end());
  if (store == Store::kValue) {
    tables.frame_buffer = values;
    for (int v = 0; v <= code_max; ++v) tables.color_table.push_back(v);
  } else {
    for (int j = 0; j < static_cast<int>(codes.size()); ++j) tables.frame_buffer.push_back(j);
    tables.color_table = values;
  }
  return tables;
}

std::vector<int> dead_reckoned(std::span<const int> codes, int code_max) {
  std::vector<int> rising(codes.begin(), codes.end());
  const int n = static_cast<int>(codes.size()) - 1;
  if (n > code_max) return rising;
  for (std::size_t j = 1; j < rising.size(); ++j)
    rising[j] = std::max(rising[j], rising[j - 1] + 1);
  int room = code_max;  // what is left for a level and those above it
  for (auto code = rising.rbegin(); code != rising.rend(); ++code, --room) {
    *code = std::min(*code, room);
  }
  return rising;
}

std::vector<FrameCodes> temporal_codes(const LevelTable& table, const Response& response,
                                       int code_max, int bits) {
  if (bits < 0 || bits > 8) {
    throw std::invalid_argument("temporal bits: " + std::to_string(bits) + " is not in 0..8");
  }
  const detail::LevelPositions positions(table);
  const int frames = 1 << bits;
  std::vector<FrameCodes> levels;
  for (int j = 0; j <= table.n; ++j) {
    const Dd wanted = positions.intensity(j);
    const double light = wanted.value();
    const double code = detail::precise_code(response, wanted, code_max).value();
    const int below = code_below(response, light, code, code_max);
    const auto upper =
        static_cast<unsigned>(upper_frames(response, light, below, code_max, frames));
    FrameCodes codes;
    for (int f = 0; f < frames; ++f) {
      codes.push_back(below + (reversed(static_cast<unsigned>(f), bits) < upper ? 1 : 0));
    }
    levels.push_back(std::move(codes));
  }
  return levels;
}

double mean_light(const FrameCodes& frames, const Response& response, int code_max) noexcept {
  double sum = 0;
  for (const int code : frames) sum += light_of_code(response, code, code_max);
  return sum / static_cast<double>(frames.size());
}

Bt1886Constants bt1886_constants(double white, double black) {
  if (!(black >= 0 && black < white && white < 1e9)) {
    throw std::invalid_argument("Lb: " + shortest(black) + " is not from 0 up to Lw, " +
                                shortest(white));
  }
  const auto root = [](double luminance) {
    return luminance > 0 ? detail::pow_precise(decimal(luminance), Dd(5) / 12) : Dd(0);
  };
  const Dd range = root(white) - root(black);
  return {detail::pow_precise(range, Dd(12) / 5).value(), (root(black) / range).value()};
}

}  // namespace tristim
