#pragma once

#include <Eigen/Core>
#include <string_view>

#include "tristim/color/rgb.h"

namespace tristim {

/// Luma and the two colour signals of NTSC television; Y [0, 1] for RGB in [0, 1].
struct Yiq {
  double y = 0, i = 0, q = 0;
  friend constexpr bool operator==(const Yiq&, const Yiq&) = default;
};

/// A published definition of YIQ. All of them are linear in encoded RGB and send greys to
/// I = Q = 0, so that differences from G are all they see of a colour:
/// Y = G + y_r (R-G) + y_b (B-G), I = i_r (R-G) + i_b (B-G), Q = q_r (R-G) + q_b (B-G).
struct YiqSystem {
  std::string_view name;
  double y_r = 0, y_b = 0, i_r = 0, i_b = 0, q_r = 0, q_b = 0;
  std::string_view definition;
  std::string_view source;
};

/// Every system. The command line and the tests read this list; a test derives the numbers from the
/// definitions.
// clang-format off
inline constexpr YiqSystem kYiqSystems[] = {
    {"smpte170m", 0.299, 0.114,
     0.5959005889209884, -0.3213439173339187, 0.2115366146083217, 0.31119955192262083,
     "Y = .299 R + .587 G + .114 B; U = .492111 (B-Y) and V = .877283 (R-Y) turned by 33 degrees",
     "[SMPTE170M]"},
    {"fcc1953", 0.3, 0.11, 0.599, -0.3217, 0.213, 0.3121,
     "Y = .30 R + .59 G + .11 B; I = -.27 (B-Y) + .74 (R-Y), Q = .41 (B-Y) + .48 (R-Y)",
     "[FCC53]"},
    {"notes", 0.3, 0.11, 0.6, -0.32, 0.21, 0.31,
     "the rows .30 .59 .11 / .60 -.28 -.32 / .21 -.52 .31", "[UBC]"},
    {"ntsc-phosphor", 0.29896661812479, 0.11461217174222663,
     0.595916202577801, -0.32163024754854463, 0.21156634188852427, 0.3106543997764707,
     "as smpte170m, with Y the luminance of the NTSC 1953 primaries under white C", "[FCC53]"},
};
// clang-format on

/// Encoded RGB to YIQ and back, with the exact inverse.
Yiq rgb_to_yiq(EncodedRgb rgb, const YiqSystem& system) noexcept;
EncodedRgb yiq_to_rgb(Yiq yiq, const YiqSystem& system) noexcept;

/// The same as matrices; every entry correctly rounded.
Eigen::Matrix3d yiq_from_rgb(const YiqSystem& system);
Eigen::Matrix3d rgb_from_yiq(const YiqSystem& system);

}  // namespace tristim
