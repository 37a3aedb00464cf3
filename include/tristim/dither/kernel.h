#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace tristim {

/// How the error of a pixel of some tone is shared out where the weights follow the tone: to the
/// next pixel, to the one below the last and to the one below. They sum to 1.
struct ToneWeights {
  float next = 0, below_last = 0, below = 0;
  float raise = 0;  // by how much of a step between levels chance raises the threshold at most
};

/// How the error of a pixel is shared out: four rows from the pixel's own on, the pixel in the
/// middle column; or by its tone.
struct DiffusionKernel {
  std::string_view name;
  int divisor = 1;
  std::array<std::array<int, 7>, 4> weight{};
  std::string_view source;
  bool serpentine = false;  // turns round at every row unless told otherwise
  float jitter = 0;         // of the threshold unless told otherwise, see DiffusionOptions
  bool closed = false;      // keeps what falls off the sides, and begins settled in any picture

  /// In place of `weight`: of tone i/255 of the way between the levels that bracket the input, and
  /// of tone 1 - i/255. kTones of them.
  std::span<const ToneWeights> (*tones)() = nullptr;
};

/// The share of the error that a kernel passes on: 1, of Atkinson's 6/8. Less loses tone.
constexpr double passed_on(const DiffusionKernel& kernel) noexcept {
  if (kernel.tones != nullptr) return 1;
  int sum = 0;
  for (const auto& row : kernel.weight) {
    for (const int weight : row) sum += weight;
  }
  return static_cast<double>(sum) / kernel.divisor;
}

inline constexpr int kTones = 128;

/// Which of kTones weights a pixel takes whose light is `fraction` of the way from the level below
/// to the one above; below 0 and above 1 the ends.
std::size_t tone_index(float fraction) noexcept;

/// The author's table, by 8-bit input [Ostromoukhov01].
std::span<const ToneWeights> ostromoukhov_tones();

/// Between key levels, with the threshold raised by chance [ZhouFang03].
std::span<const ToneWeights> zhou_fang_tones();

// clang-format off
inline constexpr DiffusionKernel kFloydSteinberg{.name = "floyd-steinberg", .divisor = 16,
                                                 .weight = {{{0, 0, 0, 0, 7, 0, 0},
                                                             {0, 0, 3, 5, 1, 0, 0}}},
                                                 .source = "[FloydSteinberg76]"};

inline constexpr DiffusionKernel kJarvisJudiceNinke{.name = "jarvis-judice-ninke", .divisor = 48,
                                                    .weight = {{{0, 0, 0, 0, 7, 5, 0},
                                                                {0, 3, 5, 7, 5, 3, 0},
                                                                {0, 1, 3, 5, 3, 1, 0}}},
                                                    .source = "[Jarvis76]", .serpentine = true};

inline constexpr DiffusionKernel kStucki{.name = "stucki", .divisor = 42,
                                         .weight = {{{0, 0, 0, 0, 8, 4, 0},
                                                     {0, 2, 4, 8, 4, 2, 0},
                                                     {0, 1, 2, 4, 2, 1, 0}}},
                                         .source = "[Stucki81]", .serpentine = true};

inline constexpr DiffusionKernel kBurkes{.name = "burkes", .divisor = 32,
                                         .weight = {{{0, 0, 0, 0, 8, 4, 0},
                                                     {0, 2, 4, 8, 4, 2, 0}}},
                                         .source = "[Burkes88]", .serpentine = true};

inline constexpr DiffusionKernel kSierra3{.name = "sierra-3", .divisor = 32,
                                          .weight = {{{0, 0, 0, 0, 5, 3, 0},
                                                      {0, 2, 4, 5, 4, 2, 0},
                                                      {0, 0, 2, 3, 2, 0, 0}}},
                                          .source = "[Sierra89]", .serpentine = true};

inline constexpr DiffusionKernel kSierra2{.name = "sierra-2", .divisor = 16,
                                          .weight = {{{0, 0, 0, 0, 4, 3, 0},
                                                      {0, 1, 2, 3, 2, 1, 0}}},
                                          .source = "[Sierra89]", .serpentine = true};

inline constexpr DiffusionKernel kSierraLite{.name = "sierra-lite", .divisor = 4,
                                             .weight = {{{0, 0, 0, 0, 2, 0, 0},
                                                         {0, 0, 1, 1, 0, 0, 0}}},
                                             .source = "[Sierra89]", .serpentine = true};

// Passes on six eighths of the error: contrast for tone.
inline constexpr DiffusionKernel kAtkinson{.name = "atkinson", .divisor = 8,
                                           .weight = {{{0, 0, 0, 0, 1, 1, 0},
                                                       {0, 0, 1, 1, 1, 0, 0},
                                                       {0, 0, 0, 1, 0, 0, 0}}},
                                           .source = "[Atkinson03]", .serpentine = true};

inline constexpr DiffusionKernel kShiauFan{.name = "shiau-fan", .divisor = 8,
                                           .weight = {{{0, 0, 0, 0, 4, 0, 0},
                                                       {0, 1, 1, 2, 0, 0, 0}}},
                                           .source = "[Shiau93]", .serpentine = true};

inline constexpr DiffusionKernel kShiauFan2{.name = "shiau-fan-2", .divisor = 16,
                                            .weight = {{{0, 0, 0, 0, 8, 0, 0},
                                                        {1, 1, 2, 4, 0, 0, 0}}},
                                            .source = "[Shiau96]", .serpentine = true};

// Made for hexagonal grids: on a square one every second pixel of a row, in two sets that never meet.
inline constexpr DiffusionKernel kStevensonArce{.name = "stevenson-arce", .divisor = 200,
                                                .weight = {{{ 0,  0,  0, 0,  0, 32,  0},
                                                            {12,  0, 26, 0, 30,  0, 16},
                                                            { 0, 12,  0, 26, 0, 12,  0},
                                                            { 5,  0, 12, 0, 12,  0,  5}}},
                                                .source = "[StevensonArce85]",
                                                .serpentine = true};
// clang-format on

inline constexpr DiffusionKernel kOstromoukhov{.name = "ostromoukhov",
                                               .source = "[Ostromoukhov01]",
                                               .serpentine = true,
                                               .tones = ostromoukhov_tones};

inline constexpr DiffusionKernel kZhouFang{
    .name = "zhou-fang", .source = "[ZhouFang03]", .serpentine = true, .tones = zhou_fang_tones};

// Found by search: of ten weights, those whose noise the eye sees least in two photographs, see
// docs/diffusion.md. Weights below zero push the noise to where the eye is blind.
// clang-format off
inline constexpr DiffusionKernel kBlueDiffusion{.name = "blue-diffusion", .divisor = 64,
                                                .weight = {{{0, 0,  0,  0, 45, -5,  0},
                                                            {0, 1, 19, 26, -6, -5,  0},
                                                            {0, 0, -8, -7,  4,  0,  0}}},
                                                .source = "weights found by search, docs/diffusion.md",
                                                .serpentine = true, .jitter = 0.15F,
                                                .closed = true};
// clang-format on

/// Every kernel. The command line, the docs and the property tests read this list.
inline constexpr std::array kDiffusionKernels{
    kFloydSteinberg, kJarvisJudiceNinke, kStucki,   kBurkes,        kSierra3,
    kSierra2,        kSierraLite,        kAtkinson, kShiauFan,      kShiauFan2,
    kStevensonArce,  kOstromoukhov,      kZhouFang, kBlueDiffusion,
};

}  // namespace tristim
