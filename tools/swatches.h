#pragma once

#include <string>
#include <string_view>

#include "tristim/color/rgb.h"

namespace tristim::tools {

/// How a terminal shows colours.
enum class TerminalColors { kNone, k256, kTrue };

struct NamedColorWhen {
  std::string_view name;
};
inline constexpr NamedColorWhen kColorWhens[] = {{"auto"}, {"always"}, {"never"}};

/// What standard output can: by `when`, a name of kColorWhens; "auto" shows none where it is no
/// terminal, TERM is dumb or NO_COLOR is set, and all colours where COLORTERM says truecolor.
TerminalColors terminal_colors(std::string_view when);

/// A patch of `width` blanks in that colour, sRGB; blanks alone where there are no colours.
std::string swatch(const EncodedRgb& color, TerminalColors colors, int width = 4);

/// The nearest of a terminal's 256 colours: its cube of 6 x 6 x 6 and its 24 greys.
int terminal_color256(const EncodedRgb& color);

}  // namespace tristim::tools
