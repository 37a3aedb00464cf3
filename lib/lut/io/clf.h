#pragma once

#include <array>
#include <string>
#include <vector>

#include "tristim/lut/lut.h"

// Parts of the Common LUT Format [CLF].
namespace tristim::detail {

/// The steps of a Lut, but LutPoints, as nodes. `ctf`: in the dialect of CTF.
std::string clf_nodes(const Lut& lut, bool ctf);

/// A node of curves whose index is a half float: `curve` has the values at the 31744 finite ones
/// from 0 on; what is below 0 is as 0, infinity as the last one.
std::string half_domain_node(const std::array<std::vector<float>, 3>& curve);

/// A node of curves at equal steps from 0 to 1, all of one size.
std::string curves_node(const std::array<std::vector<float>, 3>& curve);

/// A CLF file of nodes.
std::string clf_text(const std::string& title, const std::string& nodes);

inline constexpr std::size_t kHalfs = 65536;

/// The value of the half float with these bits; infinities and NaN too.
float half_value(unsigned bits) noexcept;

/// The finite half floats from 0 on, ascending.
std::vector<float> positive_halfs();

}  // namespace tristim::detail
