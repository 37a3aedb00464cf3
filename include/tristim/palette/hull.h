#pragma once

#include <array>
#include <span>
#include <vector>

namespace tristim {

/// The colours that a palette can mix: the convex hull of its entries, as half-spaces.
///
/// A colour outside of it owes an error for ever, which diffusion would carry across the picture;
/// such colours are moved inside before they are dithered.
class PaletteHull {
 public:
  using Color = std::array<float, 3>;

  /// `entries` in the linear numbers of the mix. Hulls without volume (greys, duotones) and
  /// palettes of more than kMost entries, which span a picture's colours anyway, leave every colour
  /// as it is.
  explicit PaletteHull(std::span<const Color> entries);

  /// `color` itself where it can be mixed, else the nearest such colour on the way to the grey of
  /// its luminance, which keeps luminance and dominant wavelength.
  Color inside(const Color& color) const noexcept;

  static constexpr std::size_t kMost = 64;

 private:
  struct HalfSpace {  // n . x <= d
    std::array<float, 3> n;
    float d;
  };
  Color towards(const Color& color, const Color& anchor) const noexcept;

  std::vector<HalfSpace> faces_;
  Color centre_{};  // the mean of the entries: inside
};

}  // namespace tristim
