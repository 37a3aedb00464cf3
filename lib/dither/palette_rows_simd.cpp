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

#include "lib/dither/error_lanes-inl.h"

using detail::HWY_NAMESPACE::larger;
using detail::HWY_NAMESPACE::OklabToe;

struct SetAll {
  HWY_INLINE Vec operator()(float x) const { return set(x); }
};

HWY_INLINE Vec smaller(Vec a, Vec b) { return hn::IfThenElse(a < b, a, b); }

using Color = std::array<Vec, 3>;

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

// Rows side by side in lanes.
class Group {
 public:
  Group(const PaletteRowsPlan& plan, const PaletteRowsBand& band, const PaletteMeetingRows& above,
        PaletteMeetingRows& below)
      : plan_(plan),
        band_(band),
        places_(*plan.grid),
        errors_{lanes(above, below, 0), lanes(above, below, 1), lanes(above, below, 2)} {}

  void run() {
    for (int t = Lanes::kFirstStep; t < errors_[0].end(); t += kSteps) {
      for (Lanes& errors : errors_) errors.meet(t);
      const bool ends = errors_[0].at_ends(t);
      for (int s = 0; s < kSteps; ++s) ends ? step<true>(t + s, s) : step<false>(t + s, s);
      write(t);
      for (Lanes& errors : errors_) errors.leave(t);
    }
    for (Lanes& errors : errors_) errors.end_rows();
  }

 private:
  using Lanes = ErrorLanes<1>;

  Lanes lanes(const PaletteMeetingRows& above, PaletteMeetingRows& below, std::size_t c) const {
    const ImageView<std::uint16_t>& rows = band_.indices;
    return {plan_.rows, rows.width, rows.height, above.channel[c], below.channel[c]};
  }

  // Where the wanted numbers of the lanes' pixels are; of some pixel where there is none.
  template <bool kEnds>
  HWY_INLINE IntVec place_of(IntVec x) const {
    IntVec row = Lanes::row_of(0);
    if (kEnds) {
      x = hn::Min(hn::Max(x, set_int(0)), set_int(band_.indices.width - 1));
      row = hn::Min(row, set_int(band_.indices.height - 1));
    }
    return row * set_int(static_cast<int>(band_.fixed.stride)) + x;
  }

  template <bool kEnds>
  HWY_INLINE void step(int t, int s) {
    const Floats f;
    const Ints n;
    const IntVec x = errors_[0].x_at(0, t);
    const IntVec at = place_of<kEnds>(x);
    const IntVec fixed = hn::GatherIndex(n, band_.fixed.data, at);
    Mask chosen = hn::RebindMask(f, fixed < set_int(0));
    if (kEnds) chosen = hn::And(chosen, errors_[0].inside(0, x));
    Color color;
    for (std::size_t c = 0; c < 3; ++c) {
      Vec received[1];
      errors_[c].receive<kEnds>(t, received);
      color[c] = hn::GatherIndex(f, band_.wanted[c].data, at) + received[0];
      color[c] = hn::Min(hn::Max(color[c], set(plan_.low[c])), set(plan_.high[c]));
    }
    Color compared = color;
    if (plan_.jitter[0] != 0 || plan_.jitter[1] != 0 || plan_.jitter[2] != 0) {
      const IntVec y = Lanes::row_of(0) + set_int(band_.y0);
      const Vec chance = noise_at(x, y, plan_.seed) - set(0.5F);
      for (std::size_t c = 0; c < 3; ++c) compared[c] = compared[c] - set(plan_.jitter[c]) * chance;
    }
    const IntVec found = nearest(*plan_.grid, places_(compared), chosen);
    hn::Store(hn::IfThenElse(hn::RebindMask(n, chosen), found, fixed), n, index_[s]);
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec got = hn::GatherIndex(f, plan_.entry[c].data(), found);
      const Vec passed = (color[c] - got) * set(plan_.passed_on);
      const Vec error[1] = {hn::IfThenElseZero(chosen, passed)};
      errors_[c].give(t, error);
    }
  }

  void write(int t) {
    const ImageView<std::uint16_t>& out = band_.indices;
    for (int row = 0; row < out.height; ++row) {
      const int x = t - plan_.rows.skew * row;
      const int last = std::min(kSteps, out.width - x);
      for (int s = std::max(0, -x); s < last; ++s) {
        *out.pixel(x + s, row) = static_cast<std::uint16_t>(index_[s][row]);
      }
    }
  }

  const PaletteRowsPlan& plan_;
  const PaletteRowsBand& band_;
  Places places_;
  Lanes errors_[3];
  alignas(64) std::int32_t index_[kSteps][kLanes];
};

void run_rows(const PaletteRowsPlan& plan, const PaletteRowsBand& band,
              const PaletteMeetingRows& above, PaletteMeetingRows& below) {
  Group(plan, band, above, below).run();
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
