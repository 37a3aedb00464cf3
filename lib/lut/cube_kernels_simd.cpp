// The rows of cube_kernels.cpp in vectors, for each instruction set: cells and weights of a vector
// of pixels at once, then a load of four floats for each corner of each pixel, which takes half the
// time of gathers.
// Nothing older than SSE4 has what these need: it takes the emulation.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/lut/cube_kernels_simd.cpp"
// clang-format off: foreach_target.h comes before highway.h
#include <hwy/foreach_target.h>
// clang-format on
#include <hwy/highway.h>

#include <algorithm>
#include <vector>

#include "lib/core/every_target.h"
#include "lib/lut/cube_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::cube::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

// Without vectors: the definition.
CubeKernels vector_kernels() { return scalar_cube_kernels(); }

#else

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Doubles = hn::ScalableTag<double>;
using Words = hn::RebindToSigned<Floats>;
using HalfFloats = hn::Half<Floats>;
using Float = hn::Vec<Floats>;
using Double = hn::Vec<Doubles>;
using Word = hn::Vec<Words>;

constexpr std::size_t kPixels = hn::MaxLanes(Floats());  // of a vector, worked on at once
constexpr std::size_t kGroups = 4;                       // of pixels whose colours fill a vector
constexpr std::size_t kGroup = kPixels / kGroups;

HWY_INLINE Float constant(float x) { return hn::Set(Floats(), x); }

// NaN becomes 0. x86's Max takes its second argument then, others may not.
template <class D, class V = hn::Vec<D> >
HWY_INLINE V held(D d, V x, V most) {
#if HWY_ARCH_X86
  return hn::Min(hn::Max(x, hn::Zero(d)), most);
#else
  return hn::Min(hn::IfThenElseZero(x > hn::Zero(d), x), most);
#endif
}

struct Place {
  Float index, fraction;
};

HWY_INLINE Place place_in_whole_steps(const CubeTable& cube, Float x) {
  const Float position = held(Floats(), x, constant(1)) * constant(cube.last);
  const Float index = hn::Min(hn::Floor(position), constant(cube.last - 1));
  return {index, position - index};
}

struct WidePlace {
  Double index, fraction;
};

HWY_INLINE WidePlace wide_place(const CubeTable& cube, std::size_t channel, Double x) {
  const Doubles d;
  const Double along = (x - hn::Set(d, cube.low[channel])) * hn::Set(d, cube.per_unit[channel]);
  const Double position = held(d, along, hn::Set(d, static_cast<double>(cube.last)));
  const Double whole = hn::Floor(position);
  const Double most = hn::Set(d, static_cast<double>(cube.last) - 1);
  const Double index = hn::Min(whole, most);
  return {index, position - index};
}

HWY_INLINE Float narrow(Double low, Double high) {
  const HalfFloats half;
  return hn::Combine(Floats(), hn::DemoteTo(half, high), hn::DemoteTo(half, low));
}

template <bool kWholeSteps>
HWY_INLINE Place place(const CubeTable& cube, std::size_t channel, Float x) {
  if constexpr (kWholeSteps) {
    return place_in_whole_steps(cube, x);
  } else {
    const HalfFloats half;
    const Doubles d;
    const WidePlace low = wide_place(cube, channel, hn::PromoteTo(d, hn::LowerHalf(half, x)));
    const WidePlace high = wide_place(cube, channel, hn::PromoteTo(d, hn::UpperHalf(half, x)));
    return {narrow(low.index, high.index), narrow(low.fraction, high.fraction)};
  }
}

struct Cells {
  Word offset;  // of the lowest corner
  Float r, g, b;
};

template <bool kWholeSteps>
HWY_INLINE Cells cells(const CubeTable& cube, const float* in) {
  Float r, g, b;
  hn::LoadInterleaved3(Floats(), in, r, g, b);
  const Place pr = place<kWholeSteps>(cube, 0, r);
  const Place pg = place<kWholeSteps>(cube, 1, g);
  const Place pb = place<kWholeSteps>(cube, 2, b);
  const Float offset = pr.index * constant(cube.index_step[0]) +
                       pg.index * constant(cube.index_step[1]) +
                       pb.index * constant(cube.index_step[2]);
  return {hn::ConvertTo(Words(), offset), pr.fraction, pg.fraction, pb.fraction};
}

// Offsets of a corner, spilled.
struct Offsets {
  HWY_ALIGN std::int32_t of[kPixels];
  HWY_INLINE void set(Word offset) { hn::Store(offset, Words(), of); }
};

// The points of one corner for as many pixels as fill a vector.
using Four = hn::FixedTag<float, 4>;
HWY_INLINE hn::Vec<Four> points(Four d, const float* table, const std::int32_t* at) {
  return hn::Load(d, table + at[0]);
}
#if HWY_MAX_BYTES >= 32
using Eight = hn::FixedTag<float, 8>;
HWY_INLINE hn::Vec<Eight> points(Eight d, const float* table, const std::int32_t* at) {
  return hn::Combine(d, points(Four(), table, at + 1), points(Four(), table, at));
}
#endif
#if HWY_ARCH_X86 && HWY_MAX_BYTES >= 64
using Sixteen = hn::FixedTag<float, 16>;
HWY_INLINE hn::Vec<Sixteen> points(Sixteen d, const float* table, const std::int32_t* at) {
  const auto pick = [&](int pixel, hn::Vec<Sixteen> before) HWY_ATTR {
    return hn::IfThenElse(hn::Mask<Sixteen>{static_cast<__mmask16>(0xF << 4 * pixel)},
                          hn::LoadDup128(d, table + at[pixel]), before);
  };
  return pick(3, pick(2, pick(1, hn::LoadDup128(d, table + at[0]))));
}
#endif

// Lanes of a group: each pixel's number of a vector of pixels four times; and the first three
// of every four lanes moved together.
struct Shuffles {
  HWY_ALIGN std::int32_t spread[kGroups][kPixels];
  HWY_ALIGN std::int32_t packed[kPixels];
  Shuffles() {
    for (std::size_t lane = 0; lane < kPixels; ++lane) {
      for (std::size_t g = 0; g < kGroups; ++g) {
        spread[g][lane] = static_cast<std::int32_t>(g * kGroup + lane / 4);
      }
      packed[lane] = static_cast<std::int32_t>(lane < 3 * kGroup ? lane / 3 * 4 + lane % 3 : 0);
    }
  }
};

HWY_INLINE Word words(std::size_t x) { return hn::Set(Words(), static_cast<std::int32_t>(x)); }

// The step along the axis of the fraction `which`; of equal ones any.
HWY_INLINE Word step_of(const CubeTable& cube, const Cells& at, Float which) {
  const Words d;
  const auto red = hn::RebindMask(d, at.r == which);
  const auto green = hn::RebindMask(d, at.g == which);
  return hn::IfThenElse(red, words(cube.step[0]),
                        hn::IfThenElse(green, words(cube.step[1]), words(cube.step[2])));
}

// Four corners of each pixel with their weights.
struct Tetrahedra {
  Offsets offsets[3];
  Float weight[4];
  const float* opposite;

  template <bool kWholeSteps>
  HWY_INLINE void find(const CubeTable& cube, const float* table, const float* in) {
    const Cells at = cells<kWholeSteps>(cube, in);
    const Float rg_most = hn::Max(at.r, at.g);
    const Float rg_least = hn::Min(at.r, at.g);
    const Float most = hn::Max(rg_most, at.b);
    const Float least = hn::Min(rg_least, at.b);
    const Float middle = hn::Max(rg_least, hn::Min(rg_most, at.b));
    offsets[0].set(at.offset);
    offsets[1].set(at.offset + step_of(cube, at, most));
    offsets[2].set(at.offset + (words(cube.all) - step_of(cube, at, least)));
    opposite = table + cube.all;
    weight[0] = constant(1) - most;
    weight[1] = most - middle;
    weight[2] = middle - least;
    weight[3] = least;
  }

  template <class Indices>
  HWY_INLINE Float color(const float* table, std::size_t group, Indices spread) const {
    const Floats d;
    const auto part = [&](const float* base, const Offsets& at, Float w) HWY_ATTR {
      return hn::TableLookupLanes(w, spread) * points(d, base, at.of + group * kGroup);
    };
    return (part(table, offsets[0], weight[0]) + part(table, offsets[1], weight[1])) +
           (part(table, offsets[2], weight[2]) + part(opposite, offsets[0], weight[3]));
  }
};

// Eight corners of each pixel; red first, then green, then blue.
struct Cuboids {
  Offsets offsets;
  Float fraction[3];
  std::array<std::size_t, 3> step;

  template <bool kWholeSteps>
  HWY_INLINE void find(const CubeTable& cube, const float*, const float* in) {
    const Cells at = cells<kWholeSteps>(cube, in);
    offsets.set(at.offset);
    fraction[0] = at.r;
    fraction[1] = at.g;
    fraction[2] = at.b;
    step = cube.step;
  }

  template <class Indices>
  HWY_INLINE Float color(const float* table, std::size_t group, Indices spread) const {
    const Floats d;
    const Float r = hn::TableLookupLanes(fraction[0], spread);
    const Float g = hn::TableLookupLanes(fraction[1], spread);
    const Float b = hn::TableLookupLanes(fraction[2], spread);
    const Float one = constant(1);
    const std::int32_t* at = offsets.of + group * kGroup;
    const auto along_red = [&](const float* p) HWY_ATTR {
      return (one - r) * points(d, p, at) + r * points(d, p + step[0], at);
    };
    const auto along_green = [&](const float* p) HWY_ATTR {
      return (one - g) * along_red(p) + g * along_red(p + step[1]);
    };
    return (one - b) * along_green(table) + b * along_green(table + step[2]);
  }
};

// kPixels pixels; writes up to a group's fourth floats beyond their 3 kPixels.
template <class Corners, bool kWholeSteps, class Indices>
HWY_INLINE void pixels(const CubeTable& cube, const float* table, const float* in, float* out,
                       const Indices (&spread)[kGroups], Indices packed) {
  Corners corners;
  corners.template find<kWholeSteps>(cube, table, in);
  for (std::size_t g = 0; g < kGroups; ++g) {
    const Float color = corners.color(table, g, spread[g]);
    hn::StoreU(hn::TableLookupLanes(color, packed), Floats(), out + g * 3 * kGroup);
  }
}

template <class Corners, bool kWholeSteps>
void row_in(const CubeTable& cube, const float* in, float* out, std::size_t count) {
  const Floats d;
  const Shuffles shuffles;
  using Indices = decltype(hn::SetTableIndices(d, shuffles.packed));
  const Indices spread[kGroups] = {
      hn::SetTableIndices(d, shuffles.spread[0]), hn::SetTableIndices(d, shuffles.spread[1]),
      hn::SetTableIndices(d, shuffles.spread[2]), hn::SetTableIndices(d, shuffles.spread[3])};
  const Indices packed = hn::SetTableIndices(d, shuffles.packed);
  const float* table = &cube.points.data()->r;
  // The last pixels, behind which pixels() would write, take a way round.
  constexpr std::size_t kBeyond = (kGroup + 2) / 3;
  std::size_t i = 0;
  for (; i + kPixels + kBeyond <= count; i += kPixels) {
    pixels<Corners, kWholeSteps>(cube, table, in + 3 * i, out + 3 * i, spread, packed);
  }
  for (; i < count; i += kPixels) {
    HWY_ALIGN float rest_in[3 * kPixels] = {};
    HWY_ALIGN float rest_out[4 * kPixels];
    const std::size_t rest = 3 * std::min(kPixels, count - i);
    std::copy(in + 3 * i, in + 3 * i + rest, rest_in);
    pixels<Corners, kWholeSteps>(cube, table, rest_in, rest_out, spread, packed);
    std::copy(rest_out, rest_out + rest, out + 3 * i);
  }
}

template <class Corners>
void row(const CubeTable& cube, const float* in, float* out, std::size_t count) {
  if (cube.whole_steps) return row_in<Corners, true>(cube, in, out, count);
  row_in<Corners, false>(cube, in, out, count);
}

CubeKernels vector_kernels() {
  return {hwy::TargetName(HWY_TARGET), row<Tetrahedra>, row<Cuboids>};
}

#endif

}  // namespace tristim::detail::cube::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {
namespace cube {
namespace {

HWY_EXPORT(vector_kernels);

}  // namespace
}  // namespace cube

std::span<const CubeKernels> simd_cube_kernels() {
  static const std::vector<CubeKernels> kernels =
      of_every_target(cube::HWY_DISPATCH_TABLE(vector_kernels));
  return kernels;
}

}  // namespace tristim::detail
#endif
