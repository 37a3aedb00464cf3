#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

#include "tristim/color/rgb.h"
#include "tristim/light/samples.h"

namespace tristim {

/// How much of what lies behind shows through a surface. kt is its transmission coefficient, 0..1;
/// 1 - kt is its opacity. Nothing is clamped.
template <typename Color>
struct TransparentSurfaceOf {
  double kt = 0;
  Color tint = kWhiteOf<Color>;  // Ot, the colour of what passes
};
using TransparentSurface = TransparentSurfaceOf<Rgb>;
using SpectralTransparentSurface = TransparentSurfaceOf<SpectralColor>;

/// (1 - kt) I1 + kt I2, surface 1 in front of surface 2 [Shoaff 4.4]; the tint does not count.
Rgb interpolated_transparency(const TransparentSurface& surface, const Rgb& front,
                              const Rgb& behind) noexcept;
SpectralColor interpolated_transparency(const SpectralTransparentSurface& surface,
                                        const SpectralColor& front,
                                        const SpectralColor& behind) noexcept;

/// I1 + kt Ot I2 [Shoaff 4.4]; may be brighter than either surface.
Rgb filtered_transparency(const TransparentSurface& surface, const Rgb& front,
                          const Rgb& behind) noexcept;
SpectralColor filtered_transparency(const SpectralTransparentSurface& surface,
                                    const SpectralColor& front,
                                    const SpectralColor& behind) noexcept;

/// What a translucent surface spreads of the light that falls on its far side: Lambert's -N.L, 0
/// where the light is on the near side [Shoaff 4.4]. A transparent surface refracts instead.
double diffuse_transmission(const Eigen::Vector3d& normal,
                            const Eigen::Vector3d& to_light) noexcept;

}  // namespace tristim
