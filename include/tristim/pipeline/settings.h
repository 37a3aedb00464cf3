#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tristim/color/rgb.h"
#include "tristim/device/display.h"
#include "tristim/image/fit.h"
#include "tristim/palette/quantize.h"
#include "tristim/pipeline/reduce.h"
#include "tristim/pipeline/stage.h"

namespace tristim {

/// A palette to be chosen for the picture instead of the device's own.
struct PaletteChoice {
  const PaletteMethod* method = nullptr;  // nullptr: the device's
  int colors = 0;                         // 0: as many as the packing holds
  std::array<int, 3> bits{};              // of "fixed"; 0: as many as there are colours for
  std::vector<Color8> inks;               // of "inks"; none: black
  std::string file = {};                  // of a palette to take as it is; then there is no method
};

/// What makes a colour count for a chosen palette.
enum class PaletteWeights {
  kCount,     ///< its pixels
  kContrast,  ///< its pixels, those in flat areas more
};

struct NamedPaletteWeights {
  std::string_view name;
  PaletteWeights weights;
};
inline constexpr std::array kPaletteWeights{
    NamedPaletteWeights{"count", PaletteWeights::kCount},
    NamedPaletteWeights{"contrast", PaletteWeights::kContrast}};

/// How a picture is processed for a device; the defaults leave it as it is.
struct Settings {
  std::string layer;          // of a file with several; see ReadOptions
  int width = 0, height = 0;  // 0: the panel's size, else the picture's
  FitMode fit = FitMode::kContain;
  ResampleFilter filter = kHermiteFilter;
  int rotate_deg = 0;
  EncodedRgb background;  // under transparent pixels and beside a fitted picture
  double exposure_stops = 0;
  const ToneOperator* tone = nullptr;  // nullptr: none
  double tone_white = 0;
  Adaptation adaptation = Adaptation::kBradford;
  GamutMethod gamut = kClip;
  BlackPoint black_point = BlackPoint::kRelative;
  std::optional<NamedDither> dither;  // empty: what suits the device
  std::string dither_file;            // of a matrix, for the caller to read into `dither`
  DitherParameters dither_parameters;
  std::string dither_mask;              // a picture of the dither's strength; empty: none
  std::string spot_picture;             // of a screen's cell, for the caller to read; empty: none
  int cell_width = 1, cell_height = 1;  // device pixels for each of the picture's [Shoaff 2.1.2]
  PaletteChoice palette;
  PaletteWeights palette_weights = PaletteWeights::kCount;
  int colors = 0;                  // where the choice names no number; 0: as the packing holds
  std::optional<int> transparent;  // position of an entry for transparent pixels; -1: the last
  const Metric* metric =
      nullptr;  // nullptr: oklab-toe with dither, balanced for chosen palettes, oklab
  Mix mix = Mix::kLight;
};

/// Why a value was not taken.
struct Refusal {
  std::string wrong;
  std::string remedy;
};

/// One setting as the command line, pipeline files and their documentation know it.
struct Setting {
  std::string_view name;
  std::string argument;  // what it takes; empty: true or false, a flag on the command line
  std::string help;
  std::optional<Refusal> (*set)(Settings& settings, std::string_view value);
};

/// Every setting. Options of the command line are "--<name>", keys of a pipeline file "<name>".
std::span<const Setting> settings_list();

/// Sets from a pipeline file: a TOML table of settings. Throws Error: kSystem for a missing file;
/// kContent
/// "<file>:<line>:<column>: ..." for unknown keys and values.
void read_pipeline_file(const std::string& path, Settings& settings);

}  // namespace tristim
