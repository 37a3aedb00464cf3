#pragma once

#include <span>
#include <vector>

#include "tristim/device/levels.h"
#include "tristim/frame/layout.h"

namespace tristim {

// Tables that frame buffers and drivers of lights are loaded with, made of levels.

/// What the frame buffer holds for level j, and what entry k of the colour look-up table behind it
/// holds [Shoaff 2.1.1].
struct LookUpTables {
  std::vector<int> frame_buffer;
  std::vector<int> color_table;
};

/// Both arrangements of the codes V_j: V_j in the frame buffer and each code itself in the colour
/// table (kValue), or j in the frame buffer and V_j in the colour table (kIndex).
LookUpTables look_up_tables(std::span<const int> codes, Store store, int code_max);

/// The codes of the levels without a dead zone, by dead reckoning: each code is the nearest to its
/// level, but at least one above the code before it, and low enough that all that follow find room.
/// Level 0 keeps its code, so that off stays off, unless there is no room above it. With more
/// levels than the hardware has codes some must be equal (shared_runs finds them): then the codes
/// stay the nearest.
std::vector<int> dead_reckoned(std::span<const int> codes, int code_max);

/// Codes of a level over 2^bits frames.
using FrameCodes = std::vector<int>;

/// The codes that show each level over 2^`bits` frames: two neighbouring codes whose mean *light*
/// is nearest to the level, the upper ones spread evenly over the frames. On hardware with a linear
/// response (PWM) that is the code with `bits` more bits. Throws as level_codes does, and where
/// bits is not in 0..8.
std::vector<FrameCodes> temporal_codes(const LevelTable& table, const Response& response,
                                       int code_max, int bits);

/// The mean light of a level's frames, relative to the white.
double mean_light(const FrameCodes& frames, const Response& response, int code_max) noexcept;

/// The constants of L = a max(V + b, 0)^2.4 [BT1886 annex 1]: a in cd/m2, b in units of the signal.
struct Bt1886Constants {
  double a = 0, b = 0;
};

/// a = (Lw^(1/2.4) - Lb^(1/2.4))^2.4 and b = Lb^(1/2.4)/(Lw^(1/2.4) - Lb^(1/2.4)) of the measured
/// luminances of white and black. Throws std::invalid_argument unless 0 <= black < white.
Bt1886Constants bt1886_constants(double white_cd_m2, double black_cd_m2);

}  // namespace tristim
