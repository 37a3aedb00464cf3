#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "tristim/color/primaries.h"
#include "tristim/color/rgb_curve.h"

namespace tristim {

/// A colour in whatever model: its components in the model's order, those it has no use for 0.
using Components = std::array<double, 4>;

/// Up to two numbers that a model's definition leaves open.
using ModelParameters = std::array<double, 2>;

/// What the numbers on an edge are relative to.
struct ModelContext {
  Primaries primaries;           // of RGB models
  RgbCurve curve;                // of encoded RGB models
  Chromaticity white = kD65;     // of XYZ (Y = 1) and what comes from it; that of the primaries
  ModelParameters parameters{};  // in the order of the model's list
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();  // of edges that are one: ConversionStep
};

/// A number that a model's definition leaves open, given as "name=value".
struct ModelParameter {
  std::string_view name;
  double value = 0;  // unless given
  double least = 0, most = 0;
  std::string_view meaning;
};

using Edge = Components (*)(const Components& c, const ModelContext& context);

/// A colour model, and its edges to and from the model that it is defined by.
///
/// The models make a tree with XYZ at its root. Models with variants are one row for each, named
/// "yiq:fcc1953"; "yiq" alone is the first of them. To add a model: its edges in
/// lib/color/edges.h, and one row in lib/color/models.cpp.
struct ColorModel {
  std::string_view name;
  std::string_view components;  // their names, separated by spaces: "L* a* b*"
  std::string_view ranges;      // in words
  std::string_view base;        // "" for the root
  Edge to_base = nullptr;       // nullptr where nothing leads from this model
  Edge from_base = nullptr;     // nullptr where nothing leads to it
  std::string_view formula;
  std::string_view source;
  std::string_view alias = {};  // another name that it goes by

  int hue = -1;           // which component is a hue, undefined for greys; -1: none
  double hue_turn = 360;  // what a whole turn of it counts

  // What its edges read of the context. Their base's edges read more.
  bool reads_primaries = false;
  bool reads_curve = false;
  std::string_view fixed_primaries = {};  // where the model is defined for one set
  std::string_view fixed_white = {};      // where it is defined under one white
  std::span<const ModelParameter> parameters = {};

  // The numbers behind the formula, for explanations; nullptr: none but the matrix.
  std::string (*numbers)(const ModelContext& context) = nullptr;

  // Of models whose colours are words, such as names: then the components are numbers that only
  // these know. A model of numbers may read words as well, with from_text alone. Nothing where the
  // text is no colour of the model.
  std::string (*to_text)(const Components& c) = nullptr;
  std::optional<Components> (*from_text)(std::string_view text) = nullptr;
  std::string (*text_hint)(std::string_view text) = nullptr;  // what to do about such a text

  // Why an edge has no value, all NaN, for a colour without NaN; nullptr where that cannot be.
  std::string (*why_none_to_base)(const Components& c) = nullptr;
  std::string (*why_none_from_base)(const Components& c) = nullptr;
};

/// Every model, bases first. The command line, the docs and the property tests read this list.
std::span<const ColorModel> color_models() noexcept;

/// How many numbers a colour of the model has, 1 to 4.
std::size_t component_count(const ColorModel& model) noexcept;

/// The model that `model` is defined by; nullptr for the root.
const ColorModel* base_of(const ColorModel& model) noexcept;

/// Whether RGB lies between the model and XYZ, so that primaries can be named for it; whether its
/// white can be named; whether a curve can.
bool takes_primaries(const ColorModel& model) noexcept;
bool takes_white(const ColorModel& model) noexcept;
bool takes_curve(const ColorModel& model) noexcept;

/// A model with what its name says of its context.
struct ModelReference {
  const ColorModel* model = nullptr;
  std::optional<Primaries> primaries = {};
  std::optional<RgbCurve> curve = {};
  std::optional<Chromaticity> white = {};  // also that of the primaries
  ModelParameters parameters{};
};

/// Parses "model", "model:variant", and behind either, in this order, what the model takes:
///
///   :SET              "rgb:ntsc1953", "hsv:display-p3", "yiq:fcc1953:ntsc1953"
///   :xr,yr,...,xw,yw  red, green, blue and white chromaticities; with nine numbers the last three
///                     are the luminances Yr, Yg, Yb that make the white
///   :SET/CURVE        "rgb:bt2020/pq", "rgb:srgb/gamma2.2": another curve than the set's own
///   :name=value       "cmyk:normalised:replacement=0.5:limit=3"
///   @WHITE            "lab@d50", "lab@0.31,0.33"
///
/// Throws Error (kMisuse) "<thing>: ..." for what it does not know, with the nearest name.
ModelReference parse_model(std::string_view text, std::string_view thing);

}  // namespace tristim
