#include "tristim/light/transparency.h"

#include "lib/light/product.h"
#include "tristim/light/phong.h"

namespace tristim {
namespace {

using detail::product;

template <typename Color>
Color interpolated(const TransparentSurfaceOf<Color>& surface, const Color& front,
                   const Color& behind) noexcept {
  return detail::sum(product(1 - surface.kt, front), product(surface.kt, behind));
}

template <typename Color>
Color filtered(const TransparentSurfaceOf<Color>& surface, const Color& front,
               const Color& behind) noexcept {
  return detail::sum(front, product(product(surface.kt, surface.tint), behind));
}

}  // namespace

Rgb interpolated_transparency(const TransparentSurface& surface, const Rgb& front,
                              const Rgb& behind) noexcept {
  return interpolated(surface, front, behind);
}

SpectralColor interpolated_transparency(const SpectralTransparentSurface& surface,
                                        const SpectralColor& front,
                                        const SpectralColor& behind) noexcept {
  return interpolated(surface, front, behind);
}

Rgb filtered_transparency(const TransparentSurface& surface, const Rgb& front,
                          const Rgb& behind) noexcept {
  return filtered(surface, front, behind);
}

SpectralColor filtered_transparency(const SpectralTransparentSurface& surface,
                                    const SpectralColor& front,
                                    const SpectralColor& behind) noexcept {
  return filtered(surface, front, behind);
}

double diffuse_transmission(const Eigen::Vector3d& normal,
                            const Eigen::Vector3d& to_light) noexcept {
  return lambert(-normal, to_light);
}

}  // namespace tristim
