#include "tristim/color/lch.h"

#include "lib/color/polar.h"

namespace tristim {

Lch lab_to_lch(Lab lab) noexcept {
  const detail::Polar polar = detail::to_polar({lab.a, lab.b});
  return {lab.l, polar.chroma, polar.hue_deg};
}

Lab lch_to_lab(Lch lch) noexcept {
  const detail::Plane plane = detail::from_polar({lch.c, lch.h});
  return {lch.l, plane.a, plane.b};
}

LchUv luv_to_lch(Luv luv) noexcept {
  const detail::Polar polar = detail::to_polar({luv.u, luv.v});
  return {luv.l, polar.chroma, polar.hue_deg};
}

Luv lch_to_luv(LchUv lch) noexcept {
  const detail::Plane plane = detail::from_polar({lch.c, lch.h});
  return {lch.l, plane.a, plane.b};
}

bool same(const Lch& first, const Lch& second) noexcept {
  return detail::same_polar(first, second);
}
bool same(const LchUv& first, const LchUv& second) noexcept {
  return detail::same_polar(first, second);
}

}  // namespace tristim
