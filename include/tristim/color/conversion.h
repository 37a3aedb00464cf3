#pragma once

#include <string>
#include <vector>

#include "tristim/color/models.h"

namespace tristim {

/// One step of a conversion.
///
/// Steps up and down the tree are its edges. Others are direct: from linear RGB to linear RGB, Lab
/// or Luv and back, where greys stay neutral exactly; and from XYZ to XYZ of another white.
struct ConversionStep {
  const ColorModel* from = nullptr;
  const ColorModel* to = nullptr;
  Edge apply = nullptr;

  /// Its matrix is xyz_from_rgb or rgb_from_xyz between linear RGB and XYZ; the adaptation from XYZ
  /// to XYZ; and on a direct edge all matrices between the two in one.
  ModelContext context;
  bool has_matrix = false;
  std::string_view formula, source;
};

/// One way from a model to another: up the tree to the nearest common base that means the same on
/// both sides, and down.
///
/// A side that names no primaries takes the other's with their curve; where neither does, sRGB. A
/// side that names no white takes the other's, so that nothing is adapted; where neither does, D65.
/// Where the whites differ the way leads through XYZ and is adapted there.
class ColorConversion {
 public:
  /// Throws Error (kMisuse) where a model on the way has no edge in that direction, and
  /// std::invalid_argument where primaries lie on a line or a white has y = 0.
  ColorConversion(const ModelReference& from, const ModelReference& to, Adaptation adaptation);

  /// Any numbers; NaN in gives NaN out.
  Components operator()(const Components& c) const;

  const ColorModel& from() const noexcept { return *from_; }
  const ColorModel& to() const noexcept { return *to_reference_.model; }

  /// `to` with the primaries, curve and white that it turned out to be relative to.
  const ModelReference& to_reference() const noexcept { return to_reference_; }

  /// The whites that XYZ and its kin are relative to, on each side.
  Chromaticity from_white() const noexcept { return from_white_; }
  Chromaticity to_white() const noexcept { return to_white_; }

  /// Empty where the two are the same.
  const std::vector<ConversionStep>& steps() const noexcept { return steps_; }

  /// The steps in words, with their numbers: "rgb to linear: formula [source]; numbers".
  std::vector<std::string> explain() const;

 private:
  std::string explain_whites() const;

  const ColorModel* from_;
  ModelReference to_reference_;
  Adaptation adaptation_;
  Chromaticity from_white_, to_white_;
  std::vector<ConversionStep> steps_;
};

}  // namespace tristim
