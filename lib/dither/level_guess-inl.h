// LevelGuess (level_guess.h) in vectors of AVX-512, the only ones whose permutations reach 32
// floats. Included inside of HWY_NAMESPACE by files that hwy/foreach_target.h includes.

#undef TRISTIM_GUESSES
#if HWY_TARGET <= HWY_AVX3
#define TRISTIM_GUESSES 1

// With kOctaves for guesses with stretches of whole octaves, with kBetween for those between
// levels.
template <bool kOctaves, bool kBetween>
class GuessedCounts {
  using F = hn::ScalableTag<float>;
  using W = hn::RebindToSigned<F>;
  using Float = hn::Vec<F>;
  using Word = hn::Vec<W>;

 public:
  explicit GuessedCounts(const LevelGuess& guess)
      : guess_(&guess),
        first_(hn::Set(W(), guess.first)),
        halved_(hn::Set(W(), guess.halved)),
        sure_(hn::Set(F(), guess.sure)) {}

  // The thresholds that `light`, from 0 to the guess's highest, has reached, in the last 16 bits;
  // false where those of one light or another have to be looked up. Fused sums are as good as
  // others.
  HWY_INLINE bool operator()(Float light, Word& counts, Float fraction = hn::Zero(F())) const {
    const Word bits = hn::BitCast(W(), light);
    Word stretch = hn::Max(hn::ShiftRight<22>(bits), first_);
    if (kOctaves) stretch = hn::Max(hn::ShiftRight<23>(bits) + halved_, stretch);
    Float guessed = of_stretch(guess_->coefficient.back(), stretch);
    for (std::size_t k = LevelGuess::kCoefficients - 1; k-- > 0;) {
      guessed = hn::MulAdd(guessed, light, of_stretch(guess_->coefficient[k], stretch));
    }
    if (kBetween) {
      const Float chord = hn::NegMulAdd(fraction, fraction, fraction);
      const Float half_bend = of_stretch(guess_->half_bend, stretch);
      guessed = hn::NegMulAdd(half_bend, chord, guessed - fraction);
    }
    const Float shifter = hn::Set(F(), 0x1.8p23F);  // leaves a whole number in the last bits
    const Float whole = guessed + shifter;
    counts = hn::BitCast(W(), whole);
    return hn::AllTrue(F(), hn::Abs(guessed - (whole - shifter)) < sure_);  // NaN is not
  }

 private:
  static HWY_INLINE Float of_stretch(const std::array<float, LevelGuess::kStretches>& table,
                                     Word stretch) {
    return Float{_mm512_permutex2var_ps(_mm512_load_ps(table.data()), stretch.raw,
                                        _mm512_load_ps(table.data() + 16))};
  }

  const LevelGuess* guess_;
  Word first_, halved_;
  Float sure_;
};

#else
#define TRISTIM_GUESSES 0
#endif
