#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "lib/dither/floyd_steinberg_rows.h"

// Nothing older than SSE4 has what these need.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/dither/floyd_steinberg_rows_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lib/core/every_target.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

FloydSteinbergRows vector_rows() { return {}; }

#else

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Ints = hn::RebindToSigned<Floats>;
using Vec = hn::Vec<Floats>;
using IntVec = hn::Vec<Ints>;
using Indices = decltype(hn::SetTableIndices(Floats(), static_cast<const std::int32_t*>(nullptr)));

constexpr int kLanes = static_cast<int>(HWY_LANES(float));
constexpr int kSteps = 32;  // of a block

// What a step takes and gives, in step order; rows beside each other.
template <int kRows>
struct Block {
  alignas(64) float in[kSteps][kRows];
  alignas(64) std::int32_t code[kSteps][kRows];
  alignas(64) float error[kSteps][kRows];
};

// 4 x 4 numbers from rows to columns, or back.
template <class V>
HWY_INLINE void transpose(V& a, V& b, V& c, V& d) {
  const hn::DFromV<V> tag;
  const hn::Repartition<double, hn::DFromV<V> > wide;
  const auto ac0 = hn::BitCast(wide, hn::InterleaveLower(tag, a, b));
  const auto ac1 = hn::BitCast(wide, hn::InterleaveUpper(tag, a, b));
  const auto bd0 = hn::BitCast(wide, hn::InterleaveLower(tag, c, d));
  const auto bd1 = hn::BitCast(wide, hn::InterleaveUpper(tag, c, d));
  a = hn::BitCast(tag, hn::InterleaveLower(wide, ac0, bd0));
  b = hn::BitCast(tag, hn::InterleaveUpper(wide, ac0, bd0));
  c = hn::BitCast(tag, hn::InterleaveLower(wide, ac1, bd1));
  d = hn::BitCast(tag, hn::InterleaveUpper(wide, ac1, bd1));
}

// The rows of a picture that are worked on together, and how far.
struct Place {
  ImageView<const float> in;
  ImageView<std::uint16_t> out;
  int t = 0;  // step: the pixel of the first row

  bool within(int row) const { return t - 2 * row >= 0 && t - 2 * row + kSteps <= in.width; }
  // Whether four rows from `row` on have pixels in each step of the block.
  bool all_within(int row) const { return row + 4 <= in.height && within(row) && within(row + 3); }
};

template <int kRows>
HWY_INLINE void read_block(const Place& place, float low, float high, Block<kRows>& block) {
  const hn::FixedTag<float, 4> tag;
  const auto lowest = hn::Set(tag, low);
  const auto highest = hn::Set(tag, high);
  for (int row = 0; row < kRows; row += 4) {
    if (!place.all_within(row)) {
      for (int l = row; l < row + 4; ++l) {
        for (int s = 0; s < kSteps; ++s) {
          const int x = place.t + s - 2 * l;
          const bool inside = l < place.in.height && x >= 0 && x < place.in.width;
          block.in[s][l] = inside ? std::clamp(*place.in.pixel(x, l), low, high) : low;
        }
      }
      continue;
    }
    const float* from[4];
    for (int l = 0; l < 4; ++l) from[l] = place.in.pixel(place.t - 2 * (row + l), row + l);
    for (int s = 0; s < kSteps; s += 4) {
      auto a = hn::LoadU(tag, from[0] + s);
      auto b = hn::LoadU(tag, from[1] + s);
      auto c = hn::LoadU(tag, from[2] + s);
      auto d = hn::LoadU(tag, from[3] + s);
      transpose(a, b, c, d);
      // The order of the operands lets NaN through, as std::clamp does.
      hn::Store(hn::Min(highest, hn::Max(lowest, a)), tag, &block.in[s][row]);
      hn::Store(hn::Min(highest, hn::Max(lowest, b)), tag, &block.in[s + 1][row]);
      hn::Store(hn::Min(highest, hn::Max(lowest, c)), tag, &block.in[s + 2][row]);
      hn::Store(hn::Min(highest, hn::Max(lowest, d)), tag, &block.in[s + 3][row]);
    }
  }
}

template <int kRows>
HWY_INLINE void write_block(const Place& place, const Block<kRows>& block) {
  const hn::FixedTag<std::int32_t, 4> tag;
  const hn::FixedTag<std::uint16_t, 4> narrow;
  for (int row = 0; row < place.out.height; row += 4) {
    if (!place.all_within(row)) {
      for (int l = row; l < std::min(row + 4, place.out.height); ++l) {
        const int start = std::max(0, 2 * l - place.t);
        const int end = std::min(kSteps, place.out.width + 2 * l - place.t);
        for (int s = start; s < end; ++s) {
          *place.out.pixel(place.t + s - 2 * l, l) = static_cast<std::uint16_t>(block.code[s][l]);
        }
      }
      continue;
    }
    std::uint16_t* to[4];
    for (int l = 0; l < 4; ++l) to[l] = place.out.pixel(place.t - 2 * (row + l), row + l);
    for (int s = 0; s < kSteps; s += 4) {
      auto a = hn::Load(tag, &block.code[s][row]);
      auto b = hn::Load(tag, &block.code[s + 1][row]);
      auto c = hn::Load(tag, &block.code[s + 2][row]);
      auto d = hn::Load(tag, &block.code[s + 3][row]);
      transpose(a, b, c, d);
      hn::StoreU(hn::DemoteTo(narrow, a), narrow, to[0] + s);
      hn::StoreU(hn::DemoteTo(narrow, b), narrow, to[1] + s);
      hn::StoreU(hn::DemoteTo(narrow, c), narrow, to[2] + s);
      hn::StoreU(hn::DemoteTo(narrow, d), narrow, to[3] + s);
    }
  }
}

struct Choice {
  Vec light;
  IntVec code;
};

// The level of a light: among few, one comparison for each. What a table has less is never reached.
template <int kThresholds>
struct FewLevels {
  Vec light[kThresholds + 1], threshold[kThresholds];
  IntVec code[kThresholds + 1];

  HWY_INLINE explicit FewLevels(const LevelTable& table) {
    light[0] = hn::Set(Floats(), table.light[0]);
    code[0] = hn::Set(Ints(), table.code[0]);
    for (std::size_t i = 0; i < kThresholds; ++i) {
      const bool is = i < table.threshold.size();
      threshold[i] = hn::Set(Floats(), is ? table.threshold[i] : hwy::HighestValue<float>());
      light[i + 1] = hn::Set(Floats(), is ? table.light[i + 1] : 0);
      code[i + 1] = hn::Set(Ints(), is ? table.code[i + 1] : 0);
    }
  }

  HWY_INLINE Choice choose(Vec wanted) const {
    Choice choice{light[0], code[0]};
    for (std::size_t i = 0; i < kThresholds; ++i) {
      const auto above = hn::Ge(wanted, threshold[i]);
      choice.light = hn::IfThenElse(above, light[i + 1], choice.light);
      choice.code = hn::IfThenElse(hn::RebindMask(Ints(), above), code[i + 1], choice.code);
    }
    return choice;
  }
};

// Among many: two by the leading bits, then the one beyond half way.
struct ManyLevels {
  IntVec first, last;
  int shift;
  const double* pair;  // 64 bits that are two floats
  const std::int32_t* codes;

  HWY_INLINE explicit ManyLevels(const LevelTable& table)
      : first(hn::Set(Ints(), table.first)),
        last(hn::Set(Ints(), table.last)),
        shift(table.shift),
        pair(reinterpret_cast<const double*>(table.pair.data())),
        codes(table.codes.data()) {}

  HWY_INLINE Choice choose(Vec wanted) const {
    const Ints ints;
    const auto leading = hn::ShiftRightSame(hn::BitCast(ints, wanted), shift);
    const auto bin = hn::Max(hn::Min(leading, last), first) - first;
    const hn::Half<Ints> half;
    const auto low_pairs = pairs(hn::LowerHalf(half, bin));
    const auto high_pairs = pairs(hn::UpperHalf(half, bin));
    const Vec lower = hn::ConcatEven(Floats(), high_pairs, low_pairs);
    const Vec upper = hn::ConcatOdd(Floats(), high_pairs, low_pairs);
    const auto above = wanted > (lower + upper) * hn::Set(Floats(), 0.5F);
    const IntVec both = hn::GatherIndex(ints, codes, bin);
    const IntVec low_code = hn::And(both, hn::Set(ints, 0xFFFF));
    const IntVec high_code =
        hn::BitCast(ints, hn::ShiftRight<16>(hn::BitCast(hn::RebindToUnsigned<Ints>(), both)));
    return {hn::IfThenElse(above, upper, lower),
            hn::IfThenElse(hn::RebindMask(ints, above), high_code, low_code)};
  }

 private:
  // Lower and upper lights in turn.
  template <class V>
  HWY_INLINE Vec pairs(V bins) const {
    const hn::Repartition<double, Floats> doubles;
    const hn::RebindToSigned<decltype(doubles)> longs;
    return hn::BitCast(Floats(), hn::GatherIndex(doubles, pair, hn::PromoteTo(longs, bins)));
  }
};

// The errors of the last steps, each moved to the lane of the row below.
template <int kVectors>
struct Errors {
  Vec last[kVectors];      // of the pixels beside
  Vec above[3][kVectors];  // of the pixels above on the right, above, above on the left

  HWY_INLINE Errors() {
    for (int v = 0; v < kVectors; ++v) {
      last[v] = above[0][v] = above[1][v] = above[2][v] = hn::Zero(Floats());
    }
  }
};

struct Lanes {
  hn::Mask<Floats> first;
  Indices up;  // lane l takes lane l - 1, the first the last

  HWY_INLINE Lanes() : first(hn::FirstN(Floats(), 1)), up(indices()) {}

  static HWY_INLINE Indices indices() {
    alignas(64) std::int32_t index[kLanes];
    for (int i = 0; i < kLanes; ++i) index[i] = (i + kLanes - 1) % kLanes;
    return hn::SetTableIndices(Floats(), index);
  }
};

// One step: a pixel of each row. Sums as LevelDiffusion adds them up: what comes from above, from
// the left to the right, then what comes from beside.
template <bool kEnds, int kVectors, class Levels>
HWY_INLINE void step(const Levels& levels, const Lanes& lanes, int t, int width,
                     const float* received, int s, Block<kVectors * kLanes>& block,
                     Errors<kVectors>& e) {
  const Floats tag;
  const Vec w1 = hn::Set(tag, 1 / 16.0F);
  const Vec w3 = hn::Set(tag, 3 / 16.0F);
  const Vec w5 = hn::Set(tag, 5 / 16.0F);
  const Vec w7 = hn::Set(tag, 7 / 16.0F);
  Vec moved[kVectors];
  for (int v = 0; v < kVectors; ++v) {
    Vec sum = (e.above[2][v] * w1 + e.above[1][v] * w5) + e.above[0][v] * w3;
    if (v == 0) {
      const float first = !kEnds || t < width ? received[t] : 0;
      sum = hn::IfThenElse(lanes.first, hn::Set(tag, first), sum);
    }
    sum = sum + e.last[v] * w7;
    const Vec wanted = hn::Load(tag, &block.in[s][v * kLanes]) + sum;
    const Choice choice = levels.choose(wanted);
    hn::Store(choice.code, Ints(), &block.code[s][v * kLanes]);
    Vec error = wanted - choice.light;
    if (kEnds) {
      const Ints ints;
      const auto x =
          hn::Sub(hn::Set(ints, t - 2 * v * kLanes), hn::Add(hn::Iota(ints, 0), hn::Iota(ints, 0)));
      const auto inside = hn::And(hn::Gt(x, hn::Set(ints, -1)), hn::Lt(x, hn::Set(ints, width)));
      error = hn::IfThenElseZero(hn::RebindMask(tag, inside), error);
    }
    hn::Store(error, Floats(), &block.error[s][v * kLanes]);
    e.last[v] = error;
    moved[v] = hn::TableLookupLanes(error, lanes.up);
  }
  for (int v = 0; v < kVectors; ++v) {
    e.above[2][v] = e.above[1][v];
    e.above[1][v] = e.above[0][v];
    e.above[0][v] = v == 0 ? moved[0] : hn::IfThenElse(lanes.first, moved[v - 1], moved[v]);
  }
}

// What the row below a row of errors receives from it.
void give_below(std::span<const float> errors, std::span<float> received) {
  constexpr float kWeights[3] = {1 / 16.0F, 5 / 16.0F, 3 / 16.0F};
  for (std::size_t x = 0; x < received.size(); ++x) {  // errors[x + 1] is that of pixel x
    received[x] =
        (errors[x] * kWeights[0] + errors[x + 1] * kWeights[1]) + errors[x + 2] * kWeights[2];
  }
}

// As many rows as `kVectors` hold, or fewer. `last_errors` has room for one on either side.
template <int kVectors, class Levels>
void diffuse_together(const LevelTable& table, Place place, std::span<const float> received,
                      std::span<float> last_errors) {
  constexpr int kRows = kVectors * kLanes;
  const Levels levels(table);
  const Lanes lanes;
  const int width = place.in.width;
  const int behind = 2 * (place.in.height - 1);  // pixels of the last row behind the first
  Block<kRows> block;
  Errors<kVectors> errors;
  for (; place.t < width + behind; place.t += kSteps) {
    read_block(place, table.light.front(), table.light.back(), block);
    const bool ends = place.t < 2 * (kRows - 1) || place.t + kSteps > width;
    for (int s = 0; s < kSteps; ++s) {
      if (ends) {
        step<true>(levels, lanes, place.t + s, width, received.data(), s, block, errors);
      } else {
        step<false>(levels, lanes, place.t + s, width, received.data(), s, block, errors);
      }
    }
    write_block(place, block);
    for (int s = 0; s < kSteps; ++s) {
      const int x = place.t + s - behind;
      if (x < 0 || x >= width) continue;
      last_errors[static_cast<std::size_t>(x) + 1] = block.error[s][place.in.height - 1];
    }
  }
}

template <class Levels>
void diffuse(const LevelTable& table, ImageView<const float> in, ImageView<std::uint16_t> out,
             std::span<float> errors) {
  constexpr int kMost = 4;  // chains that a processor overlaps, each waiting for its last error
  std::vector<float> received(errors.size() - 2);
  for (int y = 0; y < in.height;) {
    const int rows = std::min(kMost * kLanes, in.height - y);
    const Place place{in.rows(y, rows), out.rows(y, rows)};
    give_below(errors, received);
    if (rows <= kLanes) {
      diffuse_together<1, Levels>(table, place, received, errors);
    } else if (rows <= 2 * kLanes) {
      diffuse_together<2, Levels>(table, place, received, errors);
    } else {
      diffuse_together<kMost, Levels>(table, place, received, errors);
    }
    y += rows;
  }
}

void run_rows(const LevelTable& levels, ImageView<const float> in, ImageView<std::uint16_t> out,
              std::span<float> errors) {
  if (!levels.few()) return diffuse<ManyLevels>(levels, in, out, errors);
  if (levels.threshold.size() <= 1) return diffuse<FewLevels<1> >(levels, in, out, errors);
  if (levels.threshold.size() <= 3) return diffuse<FewLevels<3> >(levels, in, out, errors);
  diffuse<FewLevels<7> >(levels, in, out, errors);
}

FloydSteinbergRows vector_rows() { return {hwy::TargetName(HWY_TARGET), run_rows}; }

#endif

}  // namespace tristim::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {
namespace {

HWY_EXPORT(vector_rows);

}  // namespace

std::span<const FloydSteinbergRows> all_floyd_steinberg_rows() {
  static const std::vector<FloydSteinbergRows> rows =
      of_every_target(HWY_DISPATCH_TABLE(vector_rows));
  return rows;
}

}  // namespace tristim::detail
#endif
