#pragma once

#include <array>
#include <span>
#include <vector>

namespace tristim {

/// The colours that a palette can mix: the convex hull of its entries, in the numbers of the mix.
///
/// A colour outside of it owes an error for ever, which diffusion would carry across the picture;
/// such colours are moved inside before they are dithered.
class PaletteHull {
 public:
  using Color = std::array<float, 3>;

  /// Palettes of more than kMost entries, which span a picture's colours anyway, leave every colour
  /// as it is.
  explicit PaletteHull(std::span<const Color> entries);

  /// `color` itself where it can be mixed, within 1e-4 of a line or plane that all entries lie so
  /// near to. Else it comes to the line or plane of a palette without
  /// volume (greys; black, white and red) at the same luminance where that has it, and then goes
  /// towards the grey of its luminance until it is inside, which keeps the dominant wavelength.
  Color inside(const Color& color) const noexcept;

  /// The same of `count` colours, a plane for each number, bit for bit and many at a time.
  void inside_row(const std::array<float*, 3>& planes, std::size_t count) const noexcept;

  static constexpr std::size_t kMost = 64;

  struct HalfSpace {  // n . x <= d
    std::array<float, 3> n;
    float d;
  };

 private:
  Color flattened(const Color& color) const noexcept;
  Color towards(const Color& color, const Color& anchor) const noexcept;

  bool flat_ = false;                              // the palette has no volume
  std::array<std::array<float, 3>, 3> nearest_{};  // onto its line or plane, about the centre
  std::array<std::array<float, 3>, 3> flatten_{};  // the same, at equal luminance
  std::vector<HalfSpace> faces_;                   // within the palette's line or plane, where flat
  Color centre_{};                                 // the mean of the entries: inside
};

}  // namespace tristim
