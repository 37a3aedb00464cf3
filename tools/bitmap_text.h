#pragma once

#include <cstdint>
#include <string_view>

#include "tristim/image/view.h"

namespace tristim::tools {

/// The size of a character of draw_text.
inline constexpr int kGlyphWidth = 6;
inline constexpr int kGlyphHeight = 13;

/// Writes black letters into 8-bit codes of any number of channels; (x, y) is the top left corner.
/// What lies outside of the picture is left out; other characters than ASCII's are '?'.
void draw_text(ImageView<std::uint16_t> picture, int x, int y, std::string_view text) noexcept;

}  // namespace tristim::tools
