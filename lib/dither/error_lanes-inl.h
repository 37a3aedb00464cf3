// The errors of rows side by side in the lanes of vectors. Included inside of HWY_NAMESPACE by
// files that hwy/foreach_target.h includes, once for each instruction set.

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Ints = hn::RebindToSigned<Floats>;
using Bits = hn::RebindToUnsigned<Floats>;
using Vec = hn::Vec<Floats>;
using IntVec = hn::Vec<Ints>;
using Mask = hn::Mask<Floats>;
using Indices = decltype(hn::SetTableIndices(Floats(), static_cast<const std::int32_t*>(nullptr)));

constexpr int kLanes = static_cast<int>(HWY_LANES(float));
constexpr int kSteps = 16;  // of a block
constexpr int kMargin = ErrorRows::kMargin;

HWY_INLINE Vec set(float x) { return hn::Set(Floats(), x); }
HWY_INLINE IntVec set_int(int x) { return hn::Set(Ints(), x); }

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

// One channel of up to kVectors x kLanes rows. Row l is in lane l; at step t it is at its pixel
// t - l skew. Steps go from kFirstStep to end().
template <int kVectors>
class ErrorLanes {
 public:
  static constexpr int kRows = kVectors * kLanes;
  static constexpr int kFirstStep = -SkewedRows::kMostBack;

  ErrorLanes(const SkewedRows& rows, int width, int count, const MeetingRows& above,
             MeetingRows& below)
      : rows_(rows), width_(width), count_(count), above_(above), below_(below) {
    std::memset(&error_, 0, sizeof(error_[0]) * static_cast<std::size_t>(rows.reach + 1));
    for (int v = 0; v < kVectors; ++v) turned_in_[v] = overflow_[v] = set(0);
  }

  // Before a block of steps from t on: now and then waits for what the next ones ask of the rows
  // above, and tells the rows below what is there.
  void meet(int t) {
    constexpr int kSeldom = 256;  // steps
    if (t < next_meeting_) return;
    next_meeting_ = t + kSeldom;
    below_.publish(t - rows_.skew * (count_ - 1));
    const int asked = next_meeting_ + rows_.reach * rows_.skew;
    above_.wait_for(asked < width_ ? asked : MeetingRows::kAll);
    if (asked >= width_) overflow_above_ = above_.overflow;
  }

  int end() const { return width_ + kMargin + rows_.skew * (count_ - 1); }

  // Whether a block from step t on has lanes without a pixel, or at the first or last one.
  bool at_ends(int t) const {
    return count_ < kRows || t <= rows_.skew * (kRows - 1) || t + kSteps >= width_;
  }

  // The rows of vector v.
  static HWY_INLINE IntVec row_of(int v) { return hn::Iota(Ints(), v * kLanes); }

  // The pixels at step t.
  HWY_INLINE IntVec x_at(int v, int t) const {
    return set_int(t) - row_of(v) * set_int(rows_.skew);
  }

  // Lanes that have a pixel there.
  HWY_INLINE Mask inside(int v, IntVec x) const {
    const auto on = hn::And(x > set_int(-1), x < set_int(width_));
    return hn::RebindMask(Floats(), hn::And(on, row_of(v) < set_int(count_)));
  }

  // Where there is no pixel there is no error.
  HWY_INLINE void drop_outside(int t, Vec (&error)[kVectors]) const {
    for (int v = 0; v < kVectors; ++v) {
      error[v] = hn::IfThenElseZero(inside(v, x_at(v, t)), error[v]);
    }
  }

  // What the pixels of step t receive.
  template <bool kEnds>
  HWY_INLINE void receive(int t, Vec (&sum)[kVectors]) {
    const bool closed = kEnds && rows_.closed;
    for (int v = 0; v < kVectors; ++v) sum[v] = set(0);
    add(rows_.above, t, sum);
    if (closed) turn_in(t, sum);
    add(rows_.before, t, sum);
    if (closed) keep_overflow(t, sum);
  }

  // The errors that they leave, 0 where there is no pixel: to the rows below, lane by lane.
  HWY_INLINE void give(int t, const Vec (&error)[kVectors]) {
    Vec moved[kVectors];
    for (int v = 0; v < kVectors; ++v) {
      hn::Store(error[v], Floats(), at(0, t) + v * kLanes);
      moved[v] = error[v];
    }
    for (int row = 1; row <= rows_.reach; ++row) {
      float* to = at(row, t);
      Vec first = set(*above_.at(t + row * rows_.skew, row));
      for (int v = 0; v < kVectors; ++v) {
        const Vec turned = hn::TableLookupLanes(moved[v], up_);
        moved[v] = hn::IfThenElse(first_lane_, first, turned);
        first = turned;
        hn::Store(moved[v], Floats(), to + v * kLanes);
      }
    }
  }

  // The errors of a block of steps from t on to where the next rows find them.
  void leave(int t) {
    for (int distance = 1; distance <= std::min(rows_.reach, count_); ++distance) {
      const int row = count_ - distance;
      const int x = t - rows_.skew * row;
      const int last = std::min(kSteps, width_ - x);
      float* to = below_.at(x, distance);
      const float* from = at(0, t) + row;  // steps of a block follow one another
      for (int s = std::max(0, -x); s < last; ++s) to[s] = from[s * kRows];
    }
  }

  // After the last step: what is not of these rows.
  void end_rows() {
    for (int distance = count_ + 1; distance <= rows_.reach; ++distance) {
      std::copy_n(above_.at(0, distance - count_), width_, below_.at(0, distance));
    }
    alignas(64) float overflow[kRows];
    for (int v = 0; v < kVectors; ++v) hn::Store(overflow_[v], Floats(), overflow + v * kLanes);
    below_.overflow = overflow[count_ - 1];
    below_.publish(MeetingRows::kAll);
  }

 private:
  static constexpr int kKept = 2 * SkewedRows::kMostBack;  // steps, a power of two

  // Of step t: errors of the rows that are `row` above those of the lanes.
  HWY_INLINE float* at(int row, int t) { return error_[row][t & (kKept - 1)]; }

  HWY_INLINE void add(const std::vector<SkewedRows::Tap>& taps, int t, Vec (&sum)[kVectors]) {
    for (const SkewedRows::Tap& tap : taps) {
      const Vec weight = set(tap.weight);
      const float* from = at(tap.row, t - tap.back);
      for (int v = 0; v < kVectors; ++v) {
        sum[v] = sum[v] + hn::Load(Floats(), from + v * kLanes) * weight;
      }
    }
  }

  // See ErrorRows::turn_in().
  HWY_INLINE void turn_in(int t, Vec (&above)[kVectors]) {
    const Floats f;
    Vec first = set(overflow_above_);
    for (int v = 0; v < kVectors; ++v) {
      const IntVec x = x_at(v, t);
      const auto before = hn::And(x<set_int(0), x> set_int(-1 - kMargin));
      turned_in_[v] = turned_in_[v] + hn::IfThenElseZero(hn::RebindMask(f, before), above[v]);
      const Mask is_first = hn::RebindMask(f, hn::Eq(x, set_int(0)));
      above[v] = above[v] + hn::IfThenElseZero(is_first, turned_in_[v]);
      const Vec turned = hn::TableLookupLanes(overflow_[v], up_);
      const Mask is_last = hn::RebindMask(f, hn::Eq(x, set_int(width_ - 1)));
      const Vec from_above = hn::IfThenElse(first_lane_, first, turned);
      above[v] = above[v] + hn::IfThenElseZero(is_last, from_above);
      first = turned;
    }
  }

  HWY_INLINE void keep_overflow(int t, const Vec (&received)[kVectors]) {
    for (int v = 0; v < kVectors; ++v) {
      const IntVec x = x_at(v, t);
      const auto beyond = hn::And(x > set_int(width_ - 1), x < set_int(width_ + kMargin));
      overflow_[v] =
          overflow_[v] + hn::IfThenElseZero(hn::RebindMask(Floats(), beyond), received[v]);
    }
  }

  // Lane l takes lane l - 1, the first the last.
  static HWY_INLINE Indices up_lanes() {
    alignas(64) std::int32_t index[kLanes];
    for (int i = 0; i < kLanes; ++i) index[i] = (i + kLanes - 1) % kLanes;
    return hn::SetTableIndices(Floats(), index);
  }

  const SkewedRows& rows_;
  int width_, count_;
  const MeetingRows& above_;
  MeetingRows& below_;
  Mask first_lane_ = hn::FirstN(Floats(), 1);
  Indices up_ = up_lanes();
  int next_meeting_ = kFirstStep;
  float overflow_above_ = 0;
  Vec turned_in_[kVectors], overflow_[kVectors];  // of closed kernels
  alignas(64) float error_[ErrorRows::kReach + 1][kKept][kRows];
};
