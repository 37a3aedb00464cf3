#include "lib/image/io/exr_colour.h"

#include <cmath>

namespace tristim::detail {
namespace {

// Files hold floats, and some programs write 1e-6 for 0.
bool near(Chromaticity a, Chromaticity b) {
  constexpr double kTolerance = 1e-5;
  return std::fabs(a.x - b.x) < kTolerance && std::fabs(a.y - b.y) < kTolerance;
}

bool are_xyz_axes(const Primaries& p) {
  return near(p.red, {1, 0}) && near(p.green, {0, 1}) && near(p.blue, {0, 0});
}

bool same_floats(Chromaticity a, Chromaticity b) {
  return static_cast<float>(a.x) == static_cast<float>(b.x) &&
         static_cast<float>(a.y) == static_cast<float>(b.y);
}

// The set of which a file holds the floats, in all its digits: sRGB to sRGB is then no conversion
// at all.
Primaries published(const Primaries& p) {
  for (const NamedPrimaries& set : primaries_list()) {
    const Primaries& q = set.primaries;
    const bool same = same_floats(p.red, q.red) && same_floats(p.green, q.green) &&
                      same_floats(p.blue, q.blue) && same_floats(p.white, q.white);
    if (same) return q;
  }
  return p;
}

}  // namespace

ExrColour exr_colour(const std::string& name, const ExrPart& part, ExrColourModel model) {
  const bool xyz =
      model == ExrColourModel::kXyz || (part.chromaticities && are_xyz_axes(*part.chromaticities));
  ExrColour colour;
  if (xyz) {
    colour.words = "XYZ-encoded, delivered in sRGB primaries, white D65";
  } else if (part.chromaticities) {
    colour.primaries = published(*part.chromaticities);
    colour.words = "chromaticities of the file";
  } else {
    colour.words = "sRGB primaries, white D65: the file does not say";
  }
  check_primaries(name, colour.primaries);
  const Primaries stored = colour.primaries;
  if (part.adopted_neutral) {
    const Primaries adopted{stored.red, stored.green, stored.blue, *part.adopted_neutral};
    colour.primaries = published(adopted);
    colour.words += "; white from its adoptedNeutral";
    check_primaries(name, colour.primaries);
  }
  if (model == ExrColourModel::kGrey) return colour;  // one channel is the white's light
  if (xyz) {
    colour.delivered = rgb_from_xyz(colour.primaries);
  } else if (stored.white != colour.primaries.white) {
    colour.delivered = rgb_from_xyz(colour.primaries) * xyz_from_rgb(stored);
  }
  return colour;
}

void convert_pixels(const Eigen::Matrix3d& delivered, int pixels, int channels,
                    float* samples) noexcept {
  const Eigen::Matrix3d& m = delivered;
  for (int i = 0; i < pixels; ++i, samples += channels) {
    const auto r = static_cast<double>(samples[0]);
    const auto g = static_cast<double>(samples[1]);
    const auto b = static_cast<double>(samples[2]);
    for (int c = 0; c < 3; ++c) {
      samples[c] = static_cast<float>((m(c, 0) * r + m(c, 1) * g) + m(c, 2) * b);
    }
  }
}

}  // namespace tristim::detail
