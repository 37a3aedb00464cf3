#pragma once

#include "tristim/color/rgb.h"

namespace tristim {

/// ICtCp [BT2100 table 7]: intensity, blue-yellow, red-green.
struct Ictcp {
  double i = 0, ct = 0, cp = 0;
  friend constexpr bool operator==(const Ictcp&, const Ictcp&) = default;
};

/// Light of a display with the BT.2020 primaries, in cd/m2, to ICtCp of PQ. I is in [0, 1] up to
/// 10000 cd/m2. Greys have Ct and Cp exactly 0.
Ictcp bt2020_to_ictcp_pq(Rgb cd_m2) noexcept;

/// The inverse, with the exact inverses of its matrices.
Rgb ictcp_pq_to_bt2020(Ictcp ictcp) noexcept;

/// Light of a scene with the BT.2020 primaries, [0, 1], to ICtCp of HLG, and back.
Ictcp bt2020_to_ictcp_hlg(Rgb scene) noexcept;
Rgb ictcp_hlg_to_bt2020(Ictcp ictcp) noexcept;

}  // namespace tristim
