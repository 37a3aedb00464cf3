#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace tristim::detail {

/// Where lights lie among levels, by a quartic for each of 32 stretches of floats: near enough to
/// tell how many thresholds most lights have reached; the others have to be looked up.
///
/// With the thresholds at a fraction f of the way between levels a light x has reached
/// quartic(x) - f - half_bend(x) f (1 - f) of them, rounded to nearest. The last term is what the
/// chord between two levels departs from the curve on which all of them lie.
struct LevelGuess {
  static constexpr std::size_t kStretches = 32;  // floats of two of the longest registers
  static constexpr std::size_t kCoefficients = 5;

  alignas(64)
      std::array<std::array<float, kStretches>, kCoefficients> coefficient;  // of x^k; NaN: look up
  alignas(64) std::array<float, kStretches> half_bend;

  // A stretch is an octave, from some octave on half of one; all below the first belong to it.
  std::int32_t first = 0;   // number of the first; they are numbered modulo kStretches
  std::int32_t halved = 0;  // exponent, as floats hold it, of the first octave of two stretches
  float highest = 0;        // lights above count as this one

  /// Numbers nearer than this to a whole one are right: half less what the guess is wrong by.
  float sure = 0;

  /// Whether there are stretches of whole octaves.
  bool octaves() const noexcept { return first + 1 < 2 * halved; }

  /// The stretch of a light from 0 to `highest`.
  std::int32_t stretch(float light) const noexcept;
};

/// A guess for `threshold`, ascending, without fractions: f is 0. None where they lie on no smooth
/// curve, or over too many octaves.
std::optional<LevelGuess> guess_thresholds(std::span<const float> threshold);

/// A guess for the thresholds between each two of the levels at `light`, ascending.
std::optional<LevelGuess> guess_between(std::span<const float> light);

}  // namespace tristim::detail
