#include <algorithm>
#include <bit>

#include "lib/dither/mixtures.h"

// Nothing older than SSE4 is worth it.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/dither/mixtures_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::mixed::HWY_NAMESPACE {

using Planes = std::array<const float*, 3>;

#if HWY_TARGET == HWY_SCALAR

void entry_row(const Mixtures& mixtures, const Planes& planes, const float* thresholds,
               std::span<std::uint16_t> indices) {
  for (std::size_t x = 0; x < indices.size(); ++x) {
    indices[x] = mixtures.entry({planes[0][x], planes[1][x], planes[2][x]}, thresholds[x]);
  }
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Ints = hn::RebindToSigned<Floats>;
using Parts = hn::FixedTag<float, Mixture::kParts>;  // of a mixture
using PartsVec = hn::Vec<Parts>;

constexpr std::size_t kBlock = 256;  // pixels whose cells are known before they are mixed

HWY_INLINE hn::Vec<Ints> cells_along(const float* numbers) {
  const Floats f;
  const auto side = hn::Set(f, static_cast<float>(Mixtures::kSide));
  const auto number = hn::LoadU(f, numbers);
  const auto held = hn::IfThenElseZero(number > hn::Zero(f), number);
  const auto cell =
      hn::IfThenElse(held < hn::Set(f, 1), hn::Sqrt(held) * side, side - hn::Set(f, 1));
  return hn::ConvertTo(Ints(), cell);
}

// Reads and writes whole vectors.
void find_cells(const Planes& planes, std::size_t count, std::int32_t* cells) {
  const Ints ints;
  const auto side = hn::Set(ints, Mixtures::kSide);
  for (std::size_t x = 0; x < count; x += hn::Lanes(ints)) {
    auto cell = cells_along(planes[0] + x);
    cell = cell * side + cells_along(planes[1] + x);
    hn::StoreU(cell * side + cells_along(planes[2] + x), ints, cells + x);
  }
}

HWY_INLINE PartsVec shares_of(const Mixture& mixture, PartsVec red, PartsVec green, PartsVec blue) {
  const Parts p;
  const auto by = [&](std::size_t i) HWY_ATTR { return hn::Load(p, mixture.share[i].data()); };
  return ((by(0) * red + by(1) * green) + by(2) * blue) + by(3);
}

// The step of a walk: where to go on from a mixture with these shares.
HWY_INLINE std::size_t next_of(const Mixture& mixture, PartsVec shares) {
  const Parts p;
  std::uint8_t out[8] = {};
  hn::StoreMaskBits(p, shares < hn::Set(p, -Mixtures::kRounding), out);
  return mixture.next[static_cast<std::size_t>(std::countr_zero(out[0] | 1U << Mixture::kParts))];
}

HWY_INLINE std::uint16_t entry_from(const Mixture* list, std::size_t start,
                                    const MixPalette::Color& color, float threshold) {
  const Parts p;
  const PartsVec red = hn::Set(p, color[0]);
  const PartsVec green = hn::Set(p, color[1]);
  const PartsVec blue = hn::Set(p, color[2]);
  // The first step is taken whether it leads on or not: that is less than a guess gone wrong.
  std::size_t at = next_of(list[start], shares_of(list[start], red, green, blue));
  PartsVec shares = shares_of(list[at], red, green, blue);
  std::size_t next = next_of(list[at], shares);
  for (int step = 2; HWY_UNLIKELY(next != at) && step < Mixtures::kMostSteps; ++step) {
    at = next;
    shares = shares_of(list[at], red, green, blue);
    next = next_of(list[at], shares);
  }
  const PartsVec two = shares + hn::ShiftLeftLanes<1>(p, shares);
  const PartsVec sums = two + hn::ShiftLeftLanes<2>(p, two);
  std::uint8_t below[8] = {};
  hn::StoreMaskBits(p, sums < hn::Set(p, threshold), below);
  return list[at].entry[static_cast<std::size_t>(std::popcount(below[0] & 7U))];
}

void entry_block(const Mixtures& mixtures, const Planes& planes, const float* thresholds,
                 std::size_t count, std::uint16_t* indices) {
  alignas(64) std::int32_t cells[kBlock];
  find_cells(planes, count, cells);
  const Mixture* list = mixtures.list().data();
  const std::uint16_t* start = mixtures.start().data();
  for (std::size_t x = 0; x < count; ++x) {
    indices[x] = entry_from(list, start[cells[x]], {planes[0][x], planes[1][x], planes[2][x]},
                            thresholds[x]);
  }
}

void entry_row(const Mixtures& mixtures, const Planes& planes, const float* thresholds,
               std::span<std::uint16_t> indices) {
  const std::size_t whole = indices.size() / kBlock * kBlock;
  const auto from = [&planes](std::size_t x) -> Planes {
    return {planes[0] + x, planes[1] + x, planes[2] + x};
  };
  for (std::size_t x = 0; x < whole; x += kBlock) {
    entry_block(mixtures, from(x), thresholds + x, kBlock, &indices[x]);
  }
  if (whole == indices.size()) return;
  // The rest filled up with zeros.
  float rest[3][kBlock] = {};
  const std::size_t count = indices.size() - whole;
  for (std::size_t c = 0; c < 3; ++c) std::copy_n(planes[c] + whole, count, rest[c]);
  entry_block(mixtures, {rest[0], rest[1], rest[2]}, thresholds + whole, count, &indices[whole]);
}

#endif

}  // namespace tristim::detail::mixed::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {
namespace mixed {
HWY_EXPORT(entry_row);
}  // namespace mixed

void Mixtures::entry_row(const std::array<const float*, 3>& planes, const float* thresholds,
                         std::span<std::uint16_t> indices) const noexcept {
  using namespace mixed;
  HWY_DYNAMIC_DISPATCH(entry_row)(*this, planes, thresholds, indices);
}

}  // namespace tristim::detail
#endif
