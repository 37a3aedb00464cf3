#pragma once

#include <span>
#include <string_view>

#include "tristim/light/fresnel.h"

namespace tristim {

/// The measured index of a metal at a wavelength.
struct MetalIndex {
  double lambda_nm, eta, k;
};

/// A metal, whose index n + ik colours its highlights.
struct Metal {
  std::string_view name;
  std::string_view source;
  std::span<const MetalIndex> table;  // at rising wavelengths
};

/// Every metal. The scene files and the figures read this list.
std::span<const Metal> metals() noexcept;

/// Linear between the rows; the ends go on as they are.
Conductor conductor_at(const Metal& metal, double lambda_nm) noexcept;

}  // namespace tristim
