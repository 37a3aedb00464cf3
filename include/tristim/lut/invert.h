#pragma once

#include <memory>

#include "tristim/lut/lut.h"

namespace tristim {

/// The inverse of curves, exactly: its points are theirs with the two coordinates exchanged,
/// rounded to float once.
///
/// Curves rise or fall throughout, or stay level in places: a level stretch goes to that end of it
/// which lies next to smaller values (the first code that gives the light, where a curve rises),
/// and what is just above it to the other end. Values beyond the curve's own go to its ends. Throws
/// std::invalid_argument for a curve that turns, with the entry, or that is level all along.
LutPoints invert(const Lut1D& curves);
LutPoints invert(const LutPoints& curves);

/// Throws std::invalid_argument where the matrix has no inverse.
LutMatrix invert(const LutMatrix& matrix);

/// The inverse of a cube, tetrahedra between its points: of all colours that the cube takes nearest
/// to a colour, by the distance of their numbers, one.
///
/// What it finds is exact to 1e-12 of the cube's range; the first found of several. Any number of
/// threads may use one; copies share what they hold.
class CubeInverse {
 public:
  /// Throws std::invalid_argument as check() does.
  explicit CubeInverse(const Lut3D& cube);

  /// Of NaN the cube's low end.
  Rgb operator()(Rgb rgb) const noexcept;

 private:
  struct Boxes;
  std::shared_ptr<const Boxes> boxes_;
};

/// The inverse of a whole LUT for one colour at a time: its steps' inverses in reverse.
class LutInverse {
 public:
  /// Throws as the inverses of the steps do, and std::invalid_argument as check() does.
  explicit LutInverse(const Lut& lut);
  Rgb operator()(Rgb rgb) const noexcept;

 private:
  std::vector<std::variant<LutStep, CubeInverse>> steps_;
};

/// Whether a LUT holds no cube, so that its inverse is exact and made of steps.
bool inverts_exactly(const Lut& lut) noexcept;

/// The inverse of such a LUT as steps. Throws std::invalid_argument where there is a cube, and as
/// the inverses of the steps do.
Lut invert(const Lut& lut);

}  // namespace tristim
