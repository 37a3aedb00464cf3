#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tristim/color/primaries.h"

namespace tristim {

/// A colour in whatever model: its components in the model's order.
using Components = std::array<double, 3>;

/// What the numbers of a model are relative to.
struct ModelContext {
  Primaries primaries;        // of RGB models
  Chromaticity white = kD65;  // of the others; RGB models take their primaries' white
};

/// A colour model with its two edges to XYZ. XYZ is relative to the context's white, Y = 1.
struct ColorModel {
  std::string_view name;
  std::string_view components;  // "L a b"
  std::string_view ranges;      // in words
  bool has_primaries;           // named as rgb:srgb
  bool fixed_white;             // always D65; else named as lab@d50
  Xyz (*to_xyz)(const Components& c, const ModelContext& context);
  Components (*from_xyz)(Xyz xyz, const ModelContext& context);
  std::string_view formula;
  std::string_view source;
};

/// Every model. The command line, the docs and the property tests read this list.
std::span<const ColorModel> color_models() noexcept;

/// A model as text names it: "rgb:ntsc1953", "lab@d50", "xyz", "oklab".
struct ModelReference {
  const ColorModel* model = nullptr;
  Primaries primaries;
  std::optional<Chromaticity> white;  // where the name or the model fixes one
};

/// Parses a reference. Throws Error (kMisuse) "<thing>: ..." for unknown models, primaries and
/// whites, with the nearest name.
ModelReference parse_model(std::string_view text, std::string_view thing);

/// One way from a model to another: to XYZ, adapted from white to white where both are fixed and
/// differ, and on. Where one side has no white of its own it takes the other's, so that nothing is
/// adapted; where neither has, D65.
class ColorConversion {
 public:
  /// Throws std::invalid_argument where primaries lie on a line.
  ColorConversion(const ModelReference& from, const ModelReference& to, Adaptation adaptation);

  /// Any numbers; NaN in gives NaN out.
  Components operator()(const Components& c) const;

  /// The steps in words, with their numbers: "step: formula [source]".
  std::vector<std::string> explain() const;

 private:
  ModelReference from_, to_;
  ModelContext from_context_, to_context_;
  Adaptation adaptation_;
  Eigen::Matrix3d matrix_;  // white to white
  bool adapts_ = false;
  bool one_white_ = true;
};

}  // namespace tristim
