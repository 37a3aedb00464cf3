#pragma once

#include <array>
#include <span>
#include <string_view>

#include "tristim/color/rgb.h"

namespace tristim {

/// A space in which the distance of two colours is measured.
struct Metric {
  std::string_view name;
  std::array<float, 3> (*place)(Rgb linear_srgb) noexcept;
  std::string_view source;
  /// Pixels of three channels to their places, in place, within 1e-6 of `place` and faster; nullptr
  /// where there is nothing faster.
  void (*place_row)(std::span<float> pixels) = nullptr;
};

/// Pixels of linear sRGB to their places, in place.
void place_row(const Metric& metric, std::span<float> pixels);

std::array<float, 3> oklab_place(Rgb linear_srgb) noexcept;
/// Oklab with a toe: without the infinite slope at black, at which a diffused error flips between
/// entries, and with more weight on lightness. For choosing while dithering, where colours
/// go below black.
std::array<float, 3> oklab_toe_place(Rgb linear_srgb) noexcept;
std::array<float, 3> lab_place(Rgb linear_srgb) noexcept;
std::array<float, 3> luv_place(Rgb linear_srgb) noexcept;  // clipped below 0
std::array<float, 3> linear_place(Rgb linear_srgb) noexcept;
std::array<float, 3> encoded_place(Rgb linear_srgb) noexcept;  // of [0, 1]; clipped beyond
/// Between what the eye calls equal and equal codes: docs/palettes.md. Of [0, 1]; clipped beyond.
std::array<float, 3> balanced_place(Rgb linear_srgb) noexcept;
void oklab_place_row(std::span<float> pixels);
void balanced_place_row(std::span<float> pixels);

/// Every metric; the first is the default. The command line, the docs and the tests read this list.
inline constexpr std::array kMetrics{
    Metric{"oklab", oklab_place, "[Ottosson20]", oklab_place_row},
    Metric{"oklab-toe", oklab_toe_place, "[Ottosson20] with a toe"},
    Metric{"lab", lab_place, "[CIE15 8.2.1]"},
    Metric{"luv", luv_place, "[CIE15 8.2.2]"},
    Metric{"linear", linear_place, "linear sRGB"},
    Metric{"encoded", encoded_place, "[IEC61966]"},
    Metric{"balanced", balanced_place, "docs/palettes.md", balanced_place_row}};

}  // namespace tristim
