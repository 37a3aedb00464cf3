// Blocks of rows side by side, from a picture to lanes and back: transposed, 4 x 4 in each 128 bits
// of a vector. Included inside of HWY_NAMESPACE by files that hwy/foreach_target.h includes, after
// error_lanes-inl.h.

constexpr int kQuad = 4;  // numbers in 128 bits

// 4 x 4 numbers from rows to columns, in each 128 bits.
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

// Four numbers of each fourth row.
template <class D>
HWY_INLINE hn::Vec<D> load_quads(D tag, const float* row, std::ptrdiff_t stride) {
  constexpr std::ptrdiff_t kHalf = hn::MaxLanes(D()) / 2;
  if constexpr (2 * kHalf == kQuad) {
    return hn::LoadU(tag, row);
  } else {
    const hn::Half<D> half;
    const auto upper = load_quads(half, row + kHalf * stride, stride);
    return hn::Combine(tag, upper, load_quads(half, row, stride));
  }
}

template <class D>
HWY_INLINE void store_quads(D, hn::Vec<D> quads, std::uint16_t* row, std::ptrdiff_t stride) {
  constexpr std::ptrdiff_t kHalf = hn::MaxLanes(D()) / 2;
  if constexpr (2 * kHalf == kQuad) {
    const hn::Repartition<std::uint16_t, D> narrow;
    hn::StoreU(hn::BitCast(narrow, quads), narrow, row);
  } else {
    const hn::Half<D> half;
    store_quads(half, hn::LowerHalf(half, quads), row, stride);
    store_quads(half, hn::UpperHalf(half, quads), row + kHalf * stride, stride);
  }
}

// A block of steps from t on of the rows that a vector holds from `row` on: where they lie in the
// picture, or beside it as copies where some have not all of these pixels.
template <typename T>
class BlockRows {
 public:
  HWY_INLINE BlockRows(ImageView<T> picture, int row, int skew, int t)
      : picture_(picture), row_(row), skew_(skew), x_(t - row * skew) {
    const int last_x = x_ - skew * (kLanes - 1);
    whole_ = row + kLanes <= picture.height && last_x >= 0 && x_ + kSteps <= picture.width;
  }

  // The first row; the next are stride() farther.
  HWY_INLINE T* data() { return whole_ ? picture_.row(row_).data() + x_ : beside_[0]; }
  HWY_INLINE std::ptrdiff_t stride() const { return whole_ ? picture_.stride - skew_ : kSteps; }
  bool whole() const { return whole_; }

  // Calls copy(beside, in_picture, count) for what each row has of the picture.
  template <typename Copy>
  void each_beside(Copy&& copy) {
    for (int l = 0; l < std::min(kLanes, picture_.height - row_); ++l) {
      const int x = x_ - l * skew_;
      const int first = std::max(0, -x);
      const int last = std::min(kSteps, picture_.width - x);
      if (first < last)
        copy(beside_[l] + first, picture_.row(row_ + l).data() + x + first, last - first);
    }
  }

 private:
  ImageView<T> picture_;
  int row_, skew_, x_;
  bool whole_;
  std::remove_const_t<T> beside_[kLanes][kSteps];
};

// Light of the pixels of a block of steps from t on; anything where there is none.
template <int kRows>
HWY_INLINE void read_block(ImageView<const float> in, int skew, int t, float (*block)[kRows]) {
  for (int row = 0; row < kRows; row += kLanes) {
    BlockRows<const float> rows(in, row, skew, t);
    if (!rows.whole()) {
      rows.each_beside([](float* to, const float* from, int n) { std::copy_n(from, n, to); });
    }
    const float* from = rows.data();
    const std::ptrdiff_t stride = rows.stride();
    for (int s = 0; s < kSteps; s += kQuad) {
      Vec quads[kQuad];
      for (int i = 0; i < kQuad; ++i)
        quads[i] = load_quads(Floats(), from + s + i * stride, stride);
      transpose(quads[0], quads[1], quads[2], quads[3]);
      for (int i = 0; i < kQuad; ++i) hn::Store(quads[i], Floats(), block[s + i] + row);
    }
  }
}

// Codes of a block of steps from t on to where there are pixels. Two of a row at a time are numbers
// of 32 bits.
template <int kRows>
HWY_INLINE void write_block(const std::int32_t (*block)[kRows], int skew, int t,
                            ImageView<std::uint16_t> out) {
  const Ints ints;
  for (int row = 0; row < std::min(kRows, out.height); row += kLanes) {
    BlockRows<std::uint16_t> rows(out, row, skew, t);
    std::uint16_t* to = rows.data();
    const std::ptrdiff_t stride = rows.stride();
    for (int s = 0; s < kSteps; s += 2 * kQuad) {
      IntVec pairs[kQuad];
      for (int i = 0; i < kQuad; ++i) {
        const IntVec first = hn::Load(ints, block[s + 2 * i] + row);
        const IntVec second = hn::Load(ints, block[s + 2 * i + 1] + row);
        pairs[i] = hn::Or(first, hn::ShiftLeft<16>(second));
      }
      transpose(pairs[0], pairs[1], pairs[2], pairs[3]);
      for (int i = 0; i < kQuad; ++i) store_quads(ints, pairs[i], to + s + i * stride, stride);
    }
    if (rows.whole()) continue;
    rows.each_beside([](const std::uint16_t* from, std::uint16_t* to_row, int n) {
      std::copy_n(from, n, to_row);
    });
  }
}
