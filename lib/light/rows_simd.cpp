// The rows of rows.cpp in vectors, for each instruction set; the best one is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/light/rows_simd.cpp"
// clang-format off: foreach_target.h comes before highway.h
#include <hwy/foreach_target.h>
// clang-format on
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "lib/core/lanes_scalar.h"
#include "lib/light/rows_constants.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail {
namespace HWY_NAMESPACE {

#include "lib/core/lanes-inl.h"
// clang-format off: each builds on those before
#include "lib/core/power-inl.h"
#include "lib/light/rows_geometry-inl.h"
#include "lib/light/rows_kernel-inl.h"
#include "lib/light/rows_lobes-inl.h"
// clang-format on

constexpr std::size_t kMostLanes = sizeof(VectorLanes::F) / sizeof(float);
using Padded = std::array<float, kMostLanes>;

std::span<const float> padded(std::span<const float> rest, Padded& buffer) {
  std::copy(rest.begin(), rest.end(), buffer.begin());
  return {buffer.data(), VectorLanes::size()};
}

// The samples behind the last whole vector, as one vector with zeros behind them.
void shade_rest(const RowConstants& c, const SurfaceRows& s, const LightRows& out,
                std::size_t rest) {
  std::array<Padded, 6> in{};
  std::array<Padded, 3> light{};
  const SurfaceRows surface{padded(s.x.last(rest), in[0]),  padded(s.y.last(rest), in[1]),
                            padded(s.z.last(rest), in[2]),  padded(s.nx.last(rest), in[3]),
                            padded(s.ny.last(rest), in[4]), padded(s.nz.last(rest), in[5])};
  shade_with_lobe<VectorLanes>(c, surface, {light[0], light[1], light[2]});
  std::copy_n(light[0].begin(), rest, out.r.last(rest).begin());
  std::copy_n(light[1].begin(), rest, out.g.last(rest).begin());
  std::copy_n(light[2].begin(), rest, out.b.last(rest).begin());
}

void shade(const RowConstants& c, const SurfaceRows& surface, const LightRows& out) {
  const std::size_t rest = shade_with_lobe<VectorLanes>(c, surface, out);
  if (rest > 0) shade_rest(c, surface, out, rest);
}

void power(const float* x, double n, float* out, std::size_t size) {
  const std::size_t step = VectorLanes::size();
  std::size_t i = 0;
  for (; i + step <= size; i += step) VectorLanes::store(power_of<VectorLanes>(x + i, n), out + i);
  if (i == size) return;
  Padded rest{};
  std::copy(x + i, x + size, rest.begin());
  VectorLanes::store(power_of<VectorLanes>(rest.data(), n), rest.data());
  std::copy_n(rest.begin(), size - i, out + i);
}

}  // namespace HWY_NAMESPACE
}  // namespace tristim::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {

HWY_EXPORT(shade);
HWY_EXPORT(power);

void shade_rows_simd(const RowConstants& constants, const SurfaceRows& surface,
                     const LightRows& light) {
  HWY_DYNAMIC_DISPATCH(shade)(constants, surface, light);
}

void power_row_simd(std::span<const float> x, float n, std::span<float> out) noexcept {
  HWY_DYNAMIC_DISPATCH(power)(x.data(), double{n}, out.data(), out.size());
}

}  // namespace tristim::detail
#endif
