#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "lib/dither/level_rows.h"

// Nothing older than SSE4 has what these need.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/dither/level_rows_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lib/core/every_target.h"
#include "lib/core/instruction_set.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::levels::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

LevelRows vector_rows() { return {}; }

#else

#include "lib/dither/error_lanes-inl.h"
#include "lib/dither/row_blocks-inl.h"
#include "lib/dither/step_table-inl.h"

// Chains that a processor overlaps, each waiting for its last error.
constexpr int kMostVectors = 4;

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
      light[i + 1] = hn::Set(Floats(), is ? table.light[i + 1] : table.light.front());
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

  // From the level below a light, which is within them, to the next.
  HWY_INLINE Vec step_at(Vec within) const {
    Vec step = light[1] - light[0];
    for (std::size_t i = 1; i < kThresholds; ++i) {
      const auto used = hn::And(within >= light[i], light[i + 1] > light[i]);
      step = hn::IfThenElse(used, light[i + 1] - light[i], step);
    }
    return step;
  }
};

// Among many: by the tables.
struct ManyLevels {
  const LevelTable& table;

  HWY_INLINE explicit ManyLevels(const LevelTable& levels) : table(levels) {}

  HWY_INLINE Choice choose(Vec wanted) const {
    const IntVec level = step_counts(*table.nearest, wanted);
    const IntVec code = table.nearest->codes_count
                            ? level + hn::Set(Ints(), table.code[0])
                            : hn::GatherIndex(Ints(), table.code.data(), level);
    return {light(level), code};
  }

  HWY_INLINE Vec step_at(Vec within) const {
    const IntVec below = step_counts(*table.below, within);
    return light(below + hn::Set(Ints(), 1)) - light(below);
  }

 private:
  HWY_INLINE Vec light(IntVec level) const {
    return hn::GatherIndex(Floats(), table.light.data(), level);
  }
};

// Rows side by side in lanes.
template <int kVectors, class Levels>
class Group {
  static constexpr int kRows = kVectors * kLanes;

 public:
  Group(const LevelRowsPlan& plan, const LevelRowsBand& band, const MeetingRows& above,
        MeetingRows& below)
      : plan_(plan),
        band_(band),
        levels_(*plan.table),
        low_(set(plan.table->light.front())),
        high_(set(plan.table->light.back())),
        errors_(plan.rows, band.in.width, band.in.height, above, below) {}

  void run() {
    for (int t = errors_.kFirstStep; t < errors_.end(); t += kSteps) {
      errors_.meet(t);
      read_block(band_.in, plan_.rows.skew, t, light_);
      const bool ends = errors_.at_ends(t);
      for (int s = 0; s < kSteps; ++s) ends ? step<true>(t, s) : step<false>(t, s);
      write_block(code_, plan_.rows.skew, t, band_.out);
      errors_.leave(t);
    }
    errors_.end_rows();
  }

 private:
  template <bool kEnds>
  HWY_INLINE void step(int t, int s) {
    Vec within[kVectors], raise[kVectors], error[kVectors];
    errors_.template receive<kEnds>(t + s, error);
    for (int v = 0; v < kVectors; ++v) {
      // The order of the operands lets NaN through, as std::clamp does.
      within[v] = hn::Min(high_, hn::Max(low_, hn::Load(Floats(), light_[s] + v * kLanes)));
      raise[v] = set(0);
    }
    if (plan_.jitter != 0) by_chance(t + s, within, raise);
    for (int v = 0; v < kVectors; ++v) {
      const Vec wanted = within[v] + error[v];
      const Choice choice = levels_.choose(wanted - raise[v]);
      hn::Store(choice.code, Ints(), code_[s] + v * kLanes);
      error[v] = wanted - choice.light;
    }
    if (kEnds) errors_.drop_outside(t + s, error);
    errors_.give(t + s, error);
  }

  // Where chance moves the thresholds.
  HWY_INLINE void by_chance(int t, const Vec (&within)[kVectors], Vec (&raise)[kVectors]) const {
    for (int v = 0; v < kVectors; ++v) {
      const IntVec y = errors_.row_of(v) + set_int(band_.y0);
      const Vec noise = noise_at(errors_.x_at(v, t), y, plan_.seed);
      raise[v] = levels_.step_at(within[v]) * set(plan_.jitter) * (noise - set(0.5F));
    }
  }

  const LevelRowsPlan& plan_;
  const LevelRowsBand& band_;
  Levels levels_;
  Vec low_, high_;
  ErrorLanes<kVectors> errors_;
  alignas(64) float light_[kSteps][kRows];
  alignas(64) std::int32_t code_[kSteps][kRows];
};

template <class Levels>
void diffuse(const LevelRowsPlan& plan, const LevelRowsBand& band, const MeetingRows& above,
             MeetingRows& below) {
  if (band.in.height <= kLanes) return Group<1, Levels>(plan, band, above, below).run();
  if (band.in.height <= 2 * kLanes) return Group<2, Levels>(plan, band, above, below).run();
  Group<kMostVectors, Levels>(plan, band, above, below).run();
}

void run_rows(const LevelRowsPlan& plan, const LevelRowsBand& band, const MeetingRows& above,
              MeetingRows& below) {
  const LevelTable& levels = *plan.table;
  if (!levels.few()) return diffuse<ManyLevels>(plan, band, above, below);
  if (levels.threshold.size() <= 1) return diffuse<FewLevels<1> >(plan, band, above, below);
  if (levels.threshold.size() <= 3) return diffuse<FewLevels<3> >(plan, band, above, below);
  diffuse<FewLevels<7> >(plan, band, above, below);
}

LevelRows vector_rows() { return {hwy::TargetName(HWY_TARGET), kMostVectors * kLanes, run_rows}; }

#endif

}  // namespace tristim::detail::levels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {
namespace levels {
namespace {

HWY_EXPORT(vector_rows);

}  // namespace
}  // namespace levels

std::span<const LevelRows> all_level_rows() {
  static const std::vector<LevelRows> rows =
      of_every_target(levels::HWY_DISPATCH_TABLE(vector_rows));
  return rows;
}

const LevelRows* level_rows() { return chosen_instruction_set(all_level_rows()); }

}  // namespace tristim::detail
#endif
