#include "tristim/device/characterize.h"

#include <stdexcept>
#include <string>

#include "tristim/color/difference.h"
#include "tristim/color/lab.h"

namespace tristim {
namespace {

Xyz sum(Xyz a, Xyz b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Xyz less(Xyz a, Xyz b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

Chromaticity chromaticity(Xyz light, const char* what) {
  const double total = light.x + light.y + light.z;
  if (light.y > 0 && total > 0) return {light.x / total, light.y / total};
  throw std::invalid_argument(std::string(what) + ": it gives no light above the black");
}

// All three, with the black that each of them has on top counted once.
Xyz sum_of(const MeasuredPrimaries& m) {
  const Xyz black = m.black.value_or(Xyz{});
  return less(sum(sum(m.red, m.green), m.blue), sum(black, black));
}

}  // namespace

Primaries primaries_of(const MeasuredPrimaries& m) {
  const Xyz black = m.black.value_or(Xyz{});
  const Primaries primaries{
      .red = chromaticity(less(m.red, black), "red"),
      .green = chromaticity(less(m.green, black), "green"),
      .blue = chromaticity(less(m.blue, black), "blue"),
      .white = chromaticity(less(m.white.value_or(sum_of(m)), black), "white")};
  (void)xyz_from_rgb(primaries);  // throws where they lie on a line
  return primaries;
}

std::optional<Additivity> additivity_of(const MeasuredPrimaries& m) {
  if (!m.white) return std::nullopt;
  const Xyz all = sum_of(m);
  const Xyz white = *m.white;
  return Additivity{.sum = all,
                    .white = white,
                    .excess = {all.x / white.x - 1, all.y / white.y - 1, all.z / white.z - 1},
                    .ciede2000 = ciede2000(xyz_to_lab(all, white), xyz_to_lab(white, white))};
}

}  // namespace tristim
