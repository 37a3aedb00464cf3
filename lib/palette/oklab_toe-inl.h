// Places in Oklab with a toe, for one colour or a vector of them. To be included by files that
// hwy/foreach_target.h includes, once for each instruction set.

#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "lib/color/oklab_matrices.h"
#include "lib/palette/oklab_toe.h"

#if defined(TRISTIM_OKLAB_TOE) == defined(HWY_TARGET_TOGGLE)
#ifdef TRISTIM_OKLAB_TOE
#undef TRISTIM_OKLAB_TOE
#else
#define TRISTIM_OKLAB_TOE
#endif

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::HWY_NAMESPACE {

inline float larger(float a, float b) noexcept { return a > b ? a : b; }

/// About x^(-1/3) of a normal x > 0: a third of the bits' logarithm.
constexpr float kInverseRootBits = 1419967104;
inline float inverse_root_guess(float x) noexcept {
  const auto bits = static_cast<float>(std::bit_cast<std::int32_t>(x));
  return std::bit_cast<float>(static_cast<std::int32_t>(kInverseRootBits - bits * (1 / 3.0F)));
}

#if HWY_TARGET != HWY_SCALAR

using ToeTag = hwy::HWY_NAMESPACE::ScalableTag<float>;
using ToeVec = hwy::HWY_NAMESPACE::Vec<ToeTag>;

HWY_INLINE ToeVec larger(ToeVec a, ToeVec b) { return hwy::HWY_NAMESPACE::IfThenElse(a > b, a, b); }

HWY_INLINE ToeVec inverse_root_guess(ToeVec x) {
  namespace hn = hwy::HWY_NAMESPACE;
  const ToeTag floats;
  const hn::RebindToSigned<ToeTag> ints;
  const ToeVec bits = hn::ConvertTo(floats, hn::BitCast(ints, x));
  const ToeVec guess = hn::Set(floats, kInverseRootBits) - bits * hn::Set(floats, 1 / 3.0F);
  return hn::BitCast(floats, hn::ConvertTo(ints, guess));
}

#endif

/// oklab_toe_place() in floats, within 3e-6 of what it is on [-2, 3], where errors push colours,
/// and with one order of operations: F is a float or a vector of them, for which larger() and
/// inverse_root_guess() are there. `set` makes an F of a float.
template <typename F>
struct OklabToe {
  std::array<std::array<F, 3>, 3> lms, lab;
  F zero, toe, root, slope, third, four_thirds;

  template <typename Set>
  HWY_INLINE OklabToe(Set set, float root_of_toe)
      : zero(set(0)),
        toe(set(static_cast<float>(kToe))),
        root(set(root_of_toe)),
        slope(set(1 / (3 * root_of_toe * root_of_toe))),
        third(set(1 / 3.0F)),
        four_thirds(set(4 / 3.0F)) {
    for (std::size_t row = 0; row < 3; ++row) {
      const double weight = row == 0 ? kLightness : 1;
      for (std::size_t c = 0; c < 3; ++c) {
        lms[row][c] = set(static_cast<float>(kLmsFromSrgb[row][c]));
        lab[row][c] = set(static_cast<float>(weight * kLabFromRoots[row][c]));
      }
    }
  }

  // The cube root of x + toe less that of the toe; its tangent below 0.
  HWY_INLINE F compressed(F x) const {
    const F above = larger(x, zero);
    const F m = above + toe;
    F r = inverse_root_guess(m);
    for (int i = 0; i < 3; ++i) r = r * (four_thirds - (m * third) * ((r * r) * r));
    return (m * (r * r) - root) + slope * (x - above);
  }

  HWY_INLINE std::array<F, 3> operator()(F r, F g, F b) const {
    std::array<F, 3> roots{zero, zero, zero};
    std::array<F, 3> place{zero, zero, zero};
    for (std::size_t i = 0; i < 3; ++i) {
      roots[i] = compressed((r * lms[i][0] + g * lms[i][1]) + b * lms[i][2]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      place[i] = (roots[0] * lab[i][0] + roots[1] * lab[i][1]) + roots[2] * lab[i][2];
    }
    return place;
  }
};

}  // namespace tristim::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
