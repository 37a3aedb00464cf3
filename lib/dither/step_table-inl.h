// How many thresholds of a StepTable are not above a light, of each lane. Included inside of
// HWY_NAMESPACE by files that hwy/foreach_target.h includes, once for each instruction set.

template <class V>
HWY_INLINE auto step_counts(const StepTable& table, V light) {
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::RebindToSigned<hn::DFromV<V> > words;
  const hn::RebindToUnsigned<hn::DFromV<V> > unsigned_words;
  const V zero = hn::Zero(hn::DFromV<V>());
  const auto positive = hn::BitCast(words, hn::IfThenElseZero(light > zero, light));
  const auto first = hn::Set(words, table.first);
  const auto bits = hn::Min(hn::Max(positive, first), hn::Set(words, table.last));
  const auto stretch = hn::ShiftRightSame(bits - first, table.shift);
  const auto* entries = reinterpret_cast<const std::int32_t*>(table.entry.data());
  const auto entry = hn::GatherIndex(words, entries, stretch);
  const auto low = hn::And(bits, hn::Set(words, (std::int32_t{1} << table.shift) - 1));
  const auto sum = hn::BitCast(unsigned_words, entry + low);
  return hn::BitCast(words, hn::ShiftRightSame(sum, table.shift));
}
