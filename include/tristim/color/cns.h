#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tristim/color/munsell.h"

namespace tristim {

/// A hue of the Color Naming System [Berk82].
struct CnsHue {
  std::string_view name;
  int quarter = 0;  // on the ring: red 0, orange 4, yellow 8, green 12, blue 16, purple 20 of 24
  bool brown =
      false;  // one of the seven browns, the dark ones from orangish red to orangish yellow
};

/// All 31, from luts/cns_hues.csv: the ring, then the browns.
std::span<const CnsHue> cns_hues() noexcept;

inline constexpr std::string_view kCnsLightness[] = {"very dark", "dark", "medium", "light",
                                                     "very light"};
inline constexpr std::string_view kCnsSaturation[] = {"grayish", "moderate", "strong", "vivid"};

/// A colour name: a lightness, a saturation and a hue, or black, one of five grays, or white.
struct CnsName {
  int lightness = 2;         // of kCnsLightness; without hue also -1, black, and 5, white
  int saturation = 3;        // of kCnsSaturation; 0 without hue
  std::optional<int> hue{};  // of cns_hues(); none: black, gray, white
  friend constexpr bool operator==(const CnsName&, const CnsName&) = default;
};

/// All 627: 5 x 4 x 31, and the seven without hue.
std::vector<CnsName> cns_names();

/// Text to a name: [lightness] [saturation] hue, [lightness] gray, black or white. Unstated
/// lightness is medium, unstated saturation vivid. Cases do not count, grey is gray, red-orange is
/// orange-red, yellowish-green yellowish green. Nothing for other texts: only neighbours on the
/// ring combine, brown with red and yellow.
std::optional<CnsName> parse_cns(std::string_view text);

/// What to do about a text that is no name.
std::string cns_hint(std::string_view text);

/// A name in words, a medium lightness left out: "vivid red", "light grayish greenish blue".
std::string cns_text(const CnsName& name);

/// The colour that stands for a name; docs/color-names.md has the anchors and the reasons for
/// them. All are inside of the sRGB gamut, and cns_name gives the name back.
Munsell cns_color(const CnsName& name);

/// The name of a colour; nothing where value or chroma is NaN or outside of 0 to 10 and of 0 on, or
/// a colour with chroma has no hue.
std::optional<CnsName> cns_name(Munsell munsell);

}  // namespace tristim
