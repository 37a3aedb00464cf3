#pragma once

#include <optional>

#include "tristim/color/conversion.h"
#include "tristim/color/gamut_map.h"

namespace tristim::tools {

/// Brings colours that are on their way to a model of RGB into the gamut of its primaries.
class GamutMapping {
 public:
  /// `conversion` from `from`. Throws Error (kMisuse) where it leads to no model of RGB.
  GamutMapping(const ModelReference& from, const ColorConversion& conversion, Adaptation adaptation,
               const GamutMethod& method);

  /// From the source to linear RGB of the primaries, and on from there.
  const ColorConversion& to_light() const noexcept { return to_light_; }
  const ColorConversion& from_light() const noexcept { return from_light_; }
  const GamutMethod& method() const noexcept { return method_; }

  /// The mapped light; nothing where the colour stays as it is, so that it can go its way without
  /// a detour, or has no value.
  std::optional<Components> operator()(const Components& light) const;

 private:
  ColorConversion to_light_, from_light_;
  GamutMethod method_;
  GamutSpace space_;
};

}  // namespace tristim::tools
