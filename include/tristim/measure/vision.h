#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tristim/measure/pictures.h"

namespace tristim {

/// S-CIELAB differences over a picture: dE*ab of 1976 of what a viewer resolves.
struct VisibleDifference {
  double mean = 0;
  double p95 = 0;  // 95 of 100 pixels are nearer
};

/// S-CIELAB [ZhangWandell96]: both pictures are blurred in an opponent space as the eye does at
/// `samples_per_degree` of visual angle, which must be above 0, and compared in L*a*b*. Around its
/// edges a picture is mirrored for a degree, or half of its shorter side where that is less.
VisibleDifference scielab(const PicturePair& pictures, double samples_per_degree);

/// A contrast sensitivity of the eye as a low pass.
struct VisionFilter {
  std::string_view name;
  double (*response)(double fx, double fy) noexcept;  // at cycles per degree, both >= 0; 1 at 0
  std::string_view source;
};

/// Nasanen's exponential for a luminance of 11 cd/m2: exp(-f / (0.525 ln 11 + 3.91)).
double nasanen_response(double fx, double fy) noexcept;

/// Mannos and Sakrison's band pass without its fall below 7.89 cycles per degree, and less
/// sensitive in oblique directions.
double campbell_response(double fx, double fy) noexcept;

inline constexpr VisionFilter kNasanenFilter{"nasanen", nasanen_response,
                                             "[Nasanen84] [KimAllebach02]"};
inline constexpr VisionFilter kCampbellFilter{"campbell", campbell_response, "[Sullivan91]"};

/// Every filter; the first is the default.
inline constexpr VisionFilter kVisionFilters[] = {kNasanenFilter, kCampbellFilter};

/// How a viewer looks: an eye, and the samples of the picture in a degree of visual angle.
struct Viewing {
  const VisionFilter* filter = &kVisionFilters[0];
  double samples_per_degree = 40;  // above 0
};

/// Signal to noise in dB as each viewer sees it: power of the filtered reference over that of the
/// filtered error, luminance; +inf for equal pictures. Around its edges a picture is mirrored for
/// 64 pixels, or half of its shorter side where that is less.
///
/// Throws std::invalid_argument where the sizes differ or are 0.
std::vector<double> hvs_snr(const LuminanceMap& reference, const LuminanceMap& result,
                            std::span<const Viewing> viewings);

}  // namespace tristim
