#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tristim/dither/kernel.h"
#include "tristim/dither/levels.h"
#include "tristim/dither/screen_recipe.h"
#include "tristim/dither/threshold_matrix.h"
#include "tristim/dither/whole_picture.h"

namespace tristim {

/// No dither: the nearest code.
struct NoDither {
  std::string_view name = "none";
  std::string_view source = "the nearest code";
};

/// What stands between light and codes: nothing, a threshold matrix by recipe or the user's own, a
/// screen, a diffusion kernel, or a method that needs the whole picture at once.
using DitherMethod = std::variant<NoDither, MatrixRecipe, ThresholdMatrix, ScreenRecipe,
                                  DiffusionKernel, WholePictureDither>;

/// A dither method as the command line names it.
struct NamedDither {
  std::string name;
  DitherMethod method;
  std::string source;
};

/// What a dither may be told; each method heeds what concerns it.
struct DitherParameters {
  int size = 0;                    // side of a matrix that comes in sizes; 0: its own
  std::uint64_t seed = 0;          // of what is left to chance
  std::optional<int> frame;        // of an animation
  std::optional<bool> serpentine;  // diffusion, see DiffusionOptions; empty: the kernel's own
  std::optional<float> jitter;     // diffusion, see DiffusionOptions; empty: the kernel's own
  bool settled = true;             // diffusion, see DiffusionOptions
  float strength = 1;              // 0: the nearest code, 1: the whole dither
  int effort = 0;                  // how long a method that searches does so; 0: its own
  ScreenParameters screen;         // of screens
};

/// "none", every matrix, every screen, every kernel, every method for whole pictures.
const std::vector<NamedDither>& dither_methods();

/// How a kernel diffuses the errors of a channel when told so.
DiffusionOptions diffusion_options(const DiffusionKernel& kernel,
                                   const DitherParameters& parameters, int channel = 0);

/// The method called `name`, or a matrix with its size behind its name, "magic5". Nothing where
/// there is none.
std::optional<NamedDither> find_dither(std::string_view name);

/// Whether one matrix dithers all channels. Dots of inks fall on one another then, not by chance.
bool has_one_matrix(const DitherMethod& method) noexcept;

/// The matrices that an ordered method dithers with, one for each of `channels` channels; empty for
/// methods of other kinds. Throws std::invalid_argument for a size or a frame that the method does
/// not come in.
std::vector<ThresholdMatrix> dither_matrices(const DitherMethod& method,
                                             const DitherParameters& parameters, int channels);

}  // namespace tristim
