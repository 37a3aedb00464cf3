#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "tristim/dither/error_rows.h"
#include "tristim/dither/levels.h"
#include "tristim/dither/threshold_matrix.h"
#include "tristim/palette/hull.h"
#include "tristim/palette/nearest.h"

namespace tristim {

namespace detail {
class EntryEquals;
class EntryGrid;
}  // namespace detail

/// In which numbers colours are mixed and errors counted.
enum class Mix {
  kLight,    ///< linear light: what the eye averages
  kEncoded,  ///< numbers behind the sRGB curve, as most programs do it: mid greys come out too
             ///< bright
};

struct NamedMix {
  std::string_view name;
  Mix mix;
};
inline constexpr NamedMix kMixes[] = {{"light", Mix::kLight}, {"encoded", Mix::kEncoded}};

/// What becomes of colours that a palette cannot mix.
enum class Beyond {
  kMoved,   ///< they come inside its hull: what it can mix keeps its tone exactly
  kDamped,  ///< they stay, and a twentieth of each error is dropped so that what they owe fades:
            ///< for palettes chosen for a picture, with colours all around their hull
};

/// A palette to reduce to: chosen in a metric, mixed in light or in encoded numbers.
class MixPalette {
 public:
  /// `palette` in linear sRGB, 1 to 65536 entries.
  MixPalette(std::span<const Rgb> palette, const Metric& metric, Mix mix,
             Beyond beyond = Beyond::kMoved);

  using Color = std::array<float, 3>;

  /// Linear sRGB, clipped to [0, 1], in the numbers of the mix, inside what the palette can mix.
  Color from_light(const float* rgb) const noexcept;

  /// The same of a row of pixels, to a plane for each number.
  void from_light_row(std::span<const float> rgb,
                      const std::array<float*, 3>& planes) const noexcept;

  /// The nearest entry of a colour given in the numbers of the mix.
  int nearest(const Color& color) const noexcept;

  /// The nearest entry of each pixel of a row of light.
  void nearest_row(std::span<const float> light, std::span<std::uint16_t> indices) const {
    nearest_.find_row(light, indices);
  }

  /// Where the metric places a colour given in the numbers of the mix.
  std::array<float, 3> place(const Color& color) const noexcept;

  /// Whether colours are placed by `how`, and mixed in light.
  bool places_light_by(std::array<float, 3> (*how)(Rgb) noexcept) const noexcept {
    return mix_ == Mix::kLight && metric_.place == how;
  }

  /// How near a colour must be to an entry to be it: what the way through XYZ leaves.
  static constexpr float kEqual = 1e-5F;

  /// Whether `color`, in the numbers of the mix, is that entry already.
  bool equals(int index, const Color& color) const noexcept;

  /// The first entry that `color` is already; -1 where it is none.
  int equal_entry(const Color& color) const noexcept;

  const Color& entry(int index) const noexcept { return entries_[static_cast<std::size_t>(index)]; }
  int size() const noexcept { return static_cast<int>(entries_.size()); }

  /// `color` held near the palette: errors of colours that it can mix never reach that bound,
  /// others must not run away.
  Color bounded(const Color& color) const noexcept;
  const Color& lowest() const noexcept { return low_; }
  const Color& highest() const noexcept { return high_; }

  /// A step between entries, as far as a palette has one: its range through the number of entries
  /// less one.
  const Color& step() const noexcept { return step_; }

  /// The share of an error that diffusion passes on.
  float passed_on() const noexcept { return passed_on_; }

  /// Order of the entries by luminance, for ordered dither: position in it.
  int luminance_rank(int index) const noexcept { return rank_[static_cast<std::size_t>(index)]; }

 private:
  NearestColor nearest_;
  Metric metric_;
  Mix mix_;
  PaletteHull hull_;
  std::vector<Color> entries_;
  std::vector<int> rank_;
  Color low_{}, high_{}, step_{};
  float passed_on_ = 1;
};

/// The nearest entry of each pixel.
void palette_nearest_row(const MixPalette& palette, std::span<const float> rgb,
                         std::span<std::uint16_t> indices);

/// Ordered dither to any palette: of the mixtures of entries whose mean is a colour that of least
/// spread, brightest entry first, the matrix's threshold picking one; docs/palettes.md. Entries are
/// shown as themselves. Of a palette of two it is the levels' rule of ordered dither. Palettes of
/// more than 1024 entries mix by plans of 16 nearest to what is owed yet in the metric [Knoll08].
class PaletteOrdered {
 public:
  PaletteOrdered(const MixPalette& palette, const ThresholdMatrix& matrix);
  PaletteOrdered(PaletteOrdered&&) noexcept;
  ~PaletteOrdered();

  /// Row `y` of the picture, of light. `strength`, pixel by pixel, 0 .. 1, draws the colour to its
  /// nearest entry first; empty: 1. May be called from several threads.
  void row(int y, std::span<const float> rgb, std::span<std::uint16_t> indices,
           std::span<const float> strength = {}) const;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

/// Error diffusion to a palette [FloydSteinberg76]: the nearest entry in the metric, the error in
/// the numbers of the mix. Colours that the palette cannot mix are moved inside its hull first, see
/// Beyond. Rows must come in order.
class PaletteDiffusion {
 public:
  PaletteDiffusion(const MixPalette& palette, int width, const DiffusionOptions& options);
  PaletteDiffusion(PaletteDiffusion&&) noexcept;
  ~PaletteDiffusion();

  /// The next row. `strength`, pixel by pixel, 0 .. 1, is the share of the errors that a pixel
  /// takes and passes on; empty: 1.
  void row(std::span<const float> rgb, std::span<std::uint16_t> indices,
           std::span<const float> strength = {});

  /// The next rows of three channels: what row() makes of them one after the other, many at a time
  /// where they go one way, on up to `threads` threads.
  void rows(ImageView<const float> rgb, ImageView<std::uint16_t> indices, int threads = 1);

 private:
  struct Row {
    std::span<const float> rgb;
    int y;
    float jitter;
    std::span<const float> strength;
    std::span<const std::uint8_t> taking_part;  // empty: all
    std::uint16_t* indices;                     // or nullptr
  };
  MixPalette::Color threshold(int x, int y, const float* rgb, float jitter) const noexcept;
  void diffuse_row(const Row& row);
  void settle(std::span<const float> first, std::span<const float> strength);

  const MixPalette* palette_;  // outlives this
  std::unique_ptr<const detail::EntryGrid> grid_;
  std::unique_ptr<const detail::EntryEquals> equal_entry_;
  DiffusionOptions options_;
  std::span<const ToneWeights> tones_;
  std::uint32_t seed_;
  int width_;
  int y_ = 0;
  ErrorRows errors_;
};

}  // namespace tristim
