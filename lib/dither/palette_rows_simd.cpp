#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "lib/dither/palette_rows.h"

// Nothing older than SSE4 has what these need.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/dither/palette_rows_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lib/core/every_target.h"
#include "lib/palette/oklab_toe-inl.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::palettes::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

PaletteRows vector_rows() { return {}; }

#else

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Ints = hn::RebindToSigned<Floats>;
using Bits = hn::RebindToUnsigned<Floats>;
using Vec = hn::Vec<Floats>;
using IntVec = hn::Vec<Ints>;
using Mask = hn::Mask<Floats>;

using detail::HWY_NAMESPACE::larger;
using detail::HWY_NAMESPACE::OklabToe;

constexpr int kLanes = static_cast<int>(HWY_LANES(float));
constexpr int kSteps = 32;                   // of a block
constexpr int kBack = 16;                    // steps back that a row above is asked for, and more
constexpr int kReach = ErrorRows::kReach;    // rows
constexpr int kMargin = ErrorRows::kMargin;  // pixels

HWY_INLINE Vec set(float x) { return hn::Set(Floats(), x); }
HWY_INLINE IntVec set_int(int x) { return hn::Set(Ints(), x); }

struct SetAll {
  HWY_INLINE Vec operator()(float x) const { return set(x); }
};

HWY_INLINE Vec smaller(Vec a, Vec b) { return hn::IfThenElse(a < b, a, b); }

using Color = std::array<Vec, 3>;

// position_noise() of each lane.
HWY_INLINE Vec noise_at(IntVec x, IntVec y, std::uint32_t seed) {
  const Bits b;
  const auto set_bits = [&b](std::uint32_t v) { return hn::Set(b, v); };
  auto h = hn::Xor(hn::BitCast(b, x) * set_bits(0x9E3779B1U),
                   hn::BitCast(b, y) * set_bits(0x85EBCA77U) + set_bits(seed * 0xC2B2AE3DU));
  h = hn::Xor(h, hn::ShiftRight<16>(h)) * set_bits(0x7FEB352DU);
  h = hn::Xor(h, hn::ShiftRight<15>(h)) * set_bits(0x846CA68BU);
  h = hn::Xor(h, hn::ShiftRight<16>(h));
  return hn::ConvertTo(Floats(), hn::BitCast(Ints(), hn::ShiftRight<8>(h))) * set(0x1p-24F);
}

// The places of colours: by the formula, or one after the other by any metric.
class Places {
 public:
  HWY_INLINE explicit Places(const EntryGrid& grid) : grid_(&grid), toe_(SetAll(), root_of_toe()) {}

  HWY_INLINE Color operator()(const Color& color) const {
    if (grid_->toe()) return toe_(color[0], color[1], color[2]);
    alignas(64) float numbers[3][kLanes];
    for (std::size_t c = 0; c < 3; ++c) hn::Store(color[c], Floats(), numbers[c]);
    for (int l = 0; l < kLanes; ++l) {
      const auto place = grid_->place({numbers[0][l], numbers[1][l], numbers[2][l]});
      for (std::size_t c = 0; c < 3; ++c) numbers[c][l] = place[c];
    }
    return {hn::Load(Floats(), numbers[0]), hn::Load(Floats(), numbers[1]),
            hn::Load(Floats(), numbers[2])};
  }

 private:
  const EntryGrid* grid_;
  OklabToe<Vec> toe_;
};

// EntryGrid::nearest(). Lanes that are not `active` cost nothing and give anything.
HWY_INLINE IntVec nearest(const EntryGrid& grid, const Color& place, Mask active) {
  const Floats f;
  const Ints n;
  Color at = place;
  IntVec cell = hn::Zero(n);
  for (std::size_t a = 0; a < 3; ++a) {
    const EntryGrid::Axis& axis = grid.axes()[a];
    at[a] = smaller(larger(at[a], set(axis.knot.front())), set(axis.knot.back()));
    Vec cells = set(0);
    for (std::size_t i = 0; i < EntryGrid::kZones; ++i) {
      const Vec inside = (at[a] - set(axis.knot[i])) * set(axis.cells_per_unit[i]);
      const Vec most = set(static_cast<float>(EntryGrid::kCells[i]));
      cells = cells + hn::Min(hn::Max(inside, set(0)), most);
    }
    const IntVec number = hn::ConvertTo(n, cells);
    cell = hn::ShiftLeft<5>(cell) + hn::Min(number, set_int(EntryGrid::kSide - 1));
  }
  static_assert(EntryGrid::kSide == 1 << 5);
  const IntVec first = hn::GatherIndex(n, grid.first().data(), cell);
  const IntVec count = hn::IfThenElse(hn::RebindMask(n, active),
                                      hn::GatherIndex(n, grid.count().data(), cell), set_int(1));
  const IntVec last = first + count - set_int(1);
  const int most = hn::GetLane(hn::MaxOfLanes(n, count));
  IntVec best = hn::GatherIndex(n, grid.list().data(), first);
  if (most == 1) return best;
  Vec least = set(hwy::HighestValue<float>());
  IntVec candidate = best;
  for (int i = 0; i < most; ++i) {
    if (i > 0) {
      candidate = hn::GatherIndex(n, grid.list().data(), hn::Min(first + set_int(i), last));
    }
    Color d;
    for (std::size_t a = 0; a < 3; ++a) {
      d[a] = hn::GatherIndex(f, grid.axes()[a].place.data(), candidate) - at[a];
    }
    const Vec distance2 = (d[0] * d[0] + d[1] * d[1]) + d[2] * d[2];
    const Mask nearer = distance2 < least;
    least = hn::IfThenElse(nearer, distance2, least);
    best = hn::IfThenElse(hn::RebindMask(n, nearer), candidate, best);
  }
  return best;
}

struct Tap {
  std::size_t row;  // less 1
  int back;         // steps
  float weight;
};

// The errors of rows above, as they come by: [row][channel][step], each in the lane that needs it.
struct History {
  alignas(64) float error[kReach][3][kBack + kSteps][kLanes];

  // The last steps of a block go before the next.
  void move_on(int rows) {
    for (int r = 0; r < rows; ++r) {
      for (auto& channel : error[r])
        std::memcpy(channel[0], channel[kSteps], kBack * sizeof(channel[0]));
    }
  }
};

struct Block {
  alignas(64) std::int32_t index[kSteps][kLanes];
  alignas(64) float error[3][kSteps][kLanes];
};

using Indices = decltype(hn::SetTableIndices(Floats(), static_cast<const std::int32_t*>(nullptr)));

// Lane l takes lane l - 1, the first the last.
HWY_INLINE Indices up_lanes() {
  alignas(64) std::int32_t index[kLanes];
  for (int i = 0; i < kLanes; ++i) index[i] = (i + kLanes - 1) % kLanes;
  return hn::SetTableIndices(Floats(), index);
}

// Rows side by side in lanes.
class Group {
 public:
  Group(const PaletteRowsPlan& plan, const PaletteRowsBand& band, PaletteRowsErrors& errors)
      : plan_(plan),
        band_(band),
        errors_(errors),
        width_(band.indices.width),
        rows_(band.indices.height),
        places_(*plan.grid) {
    for (const ErrorRows::Tap& tap : plan.taps) {
      taps_.push_back(
          {static_cast<std::size_t>(tap.row) - 1, tap.row * plan.skew + tap.dx, tap.weight});
      reach_ = std::max(reach_, tap.row);
    }
    std::memset(&history_, 0, sizeof(history_));
    for (auto& channel : above_) {
      for (auto& row : channel) row.assign(row_size(), 0);
    }
    for (auto& channel : left_) {
      for (auto& row : channel) row.assign(static_cast<std::size_t>(width_), 0);
    }
    for (int r = 0; r < kReach; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::span<float> row = errors.row[static_cast<std::size_t>(r)][c].subspan(
            kMargin, static_cast<std::size_t>(width_));
        std::copy(row.begin(), row.end(), above_[static_cast<std::size_t>(r)][c].begin() + kBack);
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      weight_[c] = set(plan.weight_before[c]);
      last_[c] = second_[c] = third_[c] = turned_in_[c] = overflow_[c] = set(0);
    }
  }

  void run() {
    const int end = width_ + kMargin + plan_.skew * (rows_ - 1);
    for (int t = -kBack; t < end; t += kSteps) {
      const bool ends = t <= plan_.skew * (kLanes - 1) || t + kSteps >= width_;
      for (int s = 0; s < kSteps; ++s) {
        if (ends || rows_ < kLanes) {
          step<true>(t + s, s);
        } else {
          step<false>(t + s, s);
        }
      }
      write(t);
      history_.move_on(reach_);
    }
    leave_errors();
  }

 private:
  std::size_t row_size() const {
    return static_cast<std::size_t>(kBack + width_ + kMargin + plan_.skew * (kLanes + kReach) +
                                    2 * kSteps);
  }

  // What the lanes' pixels receive from the rows above.
  HWY_INLINE Vec from_above(std::size_t c, int s) const {
    Vec sum = set(0);
    for (const Tap& tap : taps_) {
      sum = sum +
            hn::Load(Floats(), history_.error[tap.row][c][kBack + s - tap.back]) * set(tap.weight);
    }
    return sum;
  }

  template <bool kEnds>
  HWY_INLINE void step(int t, int s) {
    const Floats f;
    const Ints n;
    const IntVec lane = hn::Iota(n, 0);
    const IntVec x = set_int(t) - lane * set_int(plan_.skew);
    Mask inside = hn::FirstN(f, kLanes);
    IntVec held = x;
    IntVec held_lane = lane;
    if (kEnds) {
      const auto on = hn::And(hn::And(x > set_int(-1), x < set_int(width_)), lane < set_int(rows_));
      inside = hn::RebindMask(f, on);
      held = hn::Min(hn::Max(x, hn::Zero(n)), set_int(width_ - 1));
      held_lane = hn::Min(lane, set_int(rows_ - 1));
    }
    const IntVec at = held_lane * set_int(static_cast<int>(band_.fixed.stride)) + held;
    const IntVec fixed = hn::GatherIndex(n, band_.fixed.data, at);
    const Mask chosen = hn::And(inside, hn::RebindMask(f, fixed < hn::Zero(n)));
    Color color;
    for (std::size_t c = 0; c < 3; ++c) {
      Vec above = from_above(c, s);
      if (kEnds && plan_.closed) above = with_turned_in(c, x, above);
      const Vec received =
          ((above + third_[c] * weight_[2]) + second_[c] * weight_[1]) + last_[c] * weight_[0];
      if (kEnds && plan_.closed) keep_overflow(c, x, received);
      color[c] = hn::GatherIndex(f, band_.wanted[c].data, at) + received;
      color[c] = hn::Min(hn::Max(color[c], set(plan_.low[c])), set(plan_.high[c]));
    }
    Color compared = color;
    if (plan_.jitter[0] != 0 || plan_.jitter[1] != 0 || plan_.jitter[2] != 0) {
      const Vec chance = noise_at(x, lane + set_int(band_.y0), plan_.seed) - set(0.5F);
      for (std::size_t c = 0; c < 3; ++c) compared[c] = compared[c] - set(plan_.jitter[c]) * chance;
    }
    const IntVec found = nearest(*plan_.grid, places_(compared), chosen);
    hn::Store(hn::IfThenElse(hn::RebindMask(n, chosen), found, fixed), n, block_.index[s]);
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec got = hn::GatherIndex(f, plan_.entry[c].data(), found);
      const Vec error = hn::IfThenElseZero(chosen, (color[c] - got) * set(plan_.passed_on));
      hn::Store(error, f, block_.error[c][s]);
      third_[c] = second_[c];
      second_[c] = last_[c];
      last_[c] = error;
      pass_down(c, t, s, error);
    }
  }

  // An error goes to the lane of the row below, and on to those of the rows after that.
  HWY_INLINE void pass_down(std::size_t c, int t, int s, Vec error) {
    const Floats f;
    Vec moved = error;
    for (int r = 0; r < reach_; ++r) {
      const auto row = static_cast<std::size_t>(r);
      moved = hn::TableLookupLanes(moved, up_);
      const float above =
          above_[row][c][static_cast<std::size_t>(kBack + t + (r + 1) * plan_.skew)];
      moved = hn::IfThenElse(first_lane_, set(above), moved);
      hn::Store(moved, f, history_.error[row][c][kBack + s]);
    }
  }

  HWY_INLINE Vec with_turned_in(std::size_t c, IntVec x, Vec above) {
    const Ints n;
    const Floats f;
    const auto before = hn::And(x<hn::Zero(n), x> set_int(-1 - kMargin));
    turned_in_[c] = turned_in_[c] + hn::IfThenElseZero(hn::RebindMask(f, before), above);
    const Mask is_first = hn::RebindMask(f, hn::Eq(x, hn::Zero(n)));
    above = above + hn::IfThenElseZero(is_first, turned_in_[c]);
    const Vec moved = hn::IfThenElse(first_lane_, set(errors_.overflow[c]),
                                     hn::TableLookupLanes(overflow_[c], up_));
    const Mask is_last = hn::RebindMask(f, hn::Eq(x, set_int(width_ - 1)));
    return above + hn::IfThenElseZero(is_last, moved);
  }

  HWY_INLINE void keep_overflow(std::size_t c, IntVec x, Vec received) {
    const auto beyond = hn::And(x > set_int(width_ - 1), x < set_int(width_ + kMargin));
    overflow_[c] = overflow_[c] + hn::IfThenElseZero(hn::RebindMask(Floats(), beyond), received);
  }

  void write(int t) {
    for (int l = 0; l < rows_; ++l) {
      const int from = std::max(0, plan_.skew * l - t);
      const int to = std::min(kSteps, width_ + plan_.skew * l - t);
      if (from >= to) continue;
      std::uint16_t* out = band_.indices.pixel(t + from - plan_.skew * l, l);
      for (int s = from; s < to; ++s) *out++ = static_cast<std::uint16_t>(block_.index[s][l]);
      const int distance = rows_ - 1 - l;  // above the last row
      if (distance >= kReach) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        float* error =
            left_[static_cast<std::size_t>(distance)][c].data() + t + from - plan_.skew * l;
        for (int s = from; s < to; ++s) *error++ = block_.error[c][s][l];
      }
    }
  }

  void leave_errors() {
    const auto size = static_cast<std::size_t>(width_);
    for (int r = kReach - 1; r >= 0; --r) {
      for (std::size_t c = 0; c < 3; ++c) {
        const auto row = static_cast<std::size_t>(r);
        const std::span<float> to = errors_.row[row][c].subspan(kMargin, size);
        if (r < rows_) {
          std::copy_n(left_[row][c].begin(), size, to.begin());
        } else {
          std::copy_n(above_[static_cast<std::size_t>(r - rows_)][c].begin() + kBack, size,
                      to.begin());
        }
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      alignas(64) float overflow[kLanes];
      hn::Store(overflow_[c], Floats(), overflow);
      errors_.overflow[c] = overflow[rows_ - 1];
    }
  }

  const PaletteRowsPlan& plan_;
  const PaletteRowsBand& band_;
  PaletteRowsErrors& errors_;
  int width_, rows_;
  int reach_ = 1;
  Places places_;
  std::vector<Tap> taps_;
  Mask first_lane_ = hn::FirstN(Floats(), 1);
  Indices up_ = up_lanes();
  Vec weight_[3];                       // of these
  Vec last_[3], second_[3], third_[3];  // errors of the pixels before
  Vec turned_in_[3], overflow_[3];      // of closed kernels
  History history_;
  Block block_;
  std::array<std::array<std::vector<float>, 3>, kReach> above_, left_;
};

void run_rows(const PaletteRowsPlan& plan, const PaletteRowsBand& band, PaletteRowsErrors& errors) {
  Group(plan, band, errors).run();
}

PaletteRows vector_rows() { return {hwy::TargetName(HWY_TARGET), kLanes, run_rows}; }

#endif

}  // namespace tristim::detail::palettes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {
namespace palettes {
namespace {

HWY_EXPORT(vector_rows);

}  // namespace
}  // namespace palettes

std::span<const PaletteRows> all_palette_rows() {
  static const std::vector<PaletteRows> rows =
      of_every_target(palettes::HWY_DISPATCH_TABLE(vector_rows));
  return rows;
}

}  // namespace tristim::detail
#endif
