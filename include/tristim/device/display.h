#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tristim/color/primaries.h"
#include "tristim/color/rgb.h"
#include "tristim/color/xyz.h"
#include "tristim/device/dot_gain.h"
#include "tristim/device/levels.h"
#include "tristim/device/press.h"
#include "tristim/device/response.h"
#include "tristim/frame/layout.h"

namespace tristim {

enum class DisplayKind { kEmissive, kReflective, kPrint };

struct NamedDisplayKind {
  std::string_view name;
  DisplayKind kind;
};
inline constexpr NamedDisplayKind kDisplayKinds[] = {{"emissive", DisplayKind::kEmissive},
                                                     {"reflective", DisplayKind::kReflective},
                                                     {"print", DisplayKind::kPrint}};

/// An entry of a fixed palette, in two columns: what the code looks like, and what the code is.
struct CodeColor {
  std::uint16_t code = 0;
  Xyz appearance;    // under the viewing white, any scale
  std::string name;  // may be empty
};

struct PanelSize {
  int width = 0;
  int height = 0;
};

/// The marks of a printer.
struct Dots {
  double dpi = 0;        // dots an inch; 0: not known
  bool isolated = true;  // whether a single dot holds by itself
  double lpi = 0;        // ruling of its screens; 0: usual_lpi of its resolution
  DotGain gain;
};

/// A display, panel or printer: everything that decides which code a colour becomes.
struct Display {
  std::string name;
  std::string source;
  DisplayKind kind = DisplayKind::kEmissive;
  FrameLayout frame;
  std::optional<PanelSize> panel;
  Chromaticity viewing_white = kD65;              // of the palette's XYZ
  Adaptation adaptation = Adaptation::kBradford;  // of the palette's XYZ to other whites
  std::vector<CodeColor> palette;                 // empty: codes are levels of channels
  bool palette_has_white =
      true;  // its lightest entry is the device's white, its darkest the black; else (a palette
             // chosen for a picture) appearances are relative to the viewing white, Y = 1
  Primaries primaries;  // phosphors and white; of a palette: the space in which it mixes
  Response response = SrgbResponse{};
  std::array<std::optional<Response>, 3>
      channel_response;              // of red, green, blue where they have one of their own
  std::optional<LevelTable> levels;  // codes are these intensity levels
  std::optional<Dots> dots;
  std::optional<Press>
      press;  // of several inks: codes are those of Press, the palette their overprints
};

/// Whether the codes carry no colour: one grey channel, with a palette or without.
bool is_monochrome(const Display& display) noexcept;

/// How the codes of a channel, 0..2, become light.
const Response& response_of(const Display& display, int channel) noexcept;

/// Whether all channels have one response.
bool has_one_response(const Display& display) noexcept;

/// One line of formula with its numbers; of each channel where they differ.
std::string describe_responses(const Display& display);

/// What picture black and the device's black have to do with each other.
enum class BlackPoint {
  kRelative,  ///< picture [0, 1] spans the device's black..white, in light
  kAbsolute,  ///< picture light is the device's light: what is below its black is lost
};

struct NamedBlackPoint {
  std::string_view name;
  BlackPoint point;
};
inline constexpr NamedBlackPoint kBlackPoints[] = {{"relative", BlackPoint::kRelative},
                                                   {"absolute", BlackPoint::kAbsolute}};

/// The levels of one channel as the device shows them.
struct LevelScale {
  // For mixing: distinct levels, ascending in picture light. [Relative: from 0 to 1.]
  std::vector<float> light;
  std::vector<std::uint16_t> code;
  // For the nearest level: entry i + 1 of `nearest` from picture light `threshold[i]` on.
  std::vector<float> threshold;
  std::vector<std::uint16_t> nearest;
};

/// The scale of a channel with `bits` bits of a display without palette.
///
/// A curve without levels decides at the exact curve rounded half up: the thresholds are the
/// smallest floats whose code, not rounded, reaches c - 1/2. Intensity levels decide by the nearest
/// level (nearest_level); mixing uses the light of the codes V_j, which is what the device emits.
LevelScale level_scale(const Display& display, int bits, BlackPoint black_point, int channel = 0);

/// Light relative to the white of every code of a channel with `bits` bits, as the frame buffer
/// holds it.
std::vector<double> light_of_codes(const Display& display, int bits, int channel = 0);

/// The palette as linear RGB of the display's primaries, adapted (Bradford) so that its lightest
/// entry is (1, 1, 1); with kRelative its darkest is (0, 0, 0) too. Empty without a palette.
std::vector<Rgb> palette_light(const Display& display, BlackPoint black_point);

/// The code table of a channel of a display with intensity levels: V_j of each level.
/// Throws std::invalid_argument where the display has none.
std::vector<int> display_level_codes(const Display& display, int bits, int channel = 0);

}  // namespace tristim
