#include "lib/frame/io/paeth.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/frame/io/paeth_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void paeth_bytes(const std::uint8_t* row, const std::uint8_t* above, std::size_t size,
                 std::size_t pixel_bytes, std::uint8_t* out) {
  filter_paeth_scalar({row, size}, {above, size}, pixel_bytes, out);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using Bytes = hn::ScalableTag<std::uint8_t>;
using Byte = hn::Vec<Bytes>;

HWY_INLINE Byte distance(Byte a, Byte b) { return hn::Max(a, b) - hn::Min(a, b); }

// In bytes: the corner is near only where it lies between the other two; its distance to what is
// expected, left + above - corner, is then how much nearer it is to one than to the other.
HWY_INLINE Byte expected(Byte left, Byte above, Byte corner) {
  const Byte to_left = distance(above, corner);
  const Byte to_above = distance(left, corner);
  const Byte near = hn::IfThenElse(to_above < to_left, above, left);
  const auto between = hn::And(corner > hn::Min(left, above), corner < hn::Max(left, above));
  const auto nearer = hn::Min(to_left, to_above) > distance(to_left, to_above);
  return hn::IfThenElse(hn::And(between, nearer), corner, near);
}

void paeth_bytes(const std::uint8_t* row, const std::uint8_t* above, std::size_t size,
                 std::size_t pixel_bytes, std::uint8_t* out) {
  const Bytes tag;
  const std::size_t lanes = hn::Lanes(tag);
  const auto one = [&](std::size_t i) {
    const Byte from = expected(hn::LoadU(tag, row + i - pixel_bytes), hn::LoadU(tag, above + i),
                               hn::LoadU(tag, above + i - pixel_bytes));
    hn::StoreU(hn::LoadU(tag, row + i) - from, tag, out + i);
  };
  if (size < pixel_bytes + lanes) {
    return filter_paeth_scalar({row, size}, {above, size}, pixel_bytes, out);
  }
  filter_paeth_scalar({row, pixel_bytes}, {above, pixel_bytes}, pixel_bytes, out);
  for (std::size_t i = pixel_bytes; i + lanes <= size; i += lanes) one(i);
  one(size - lanes);  // some of them once more
}

#endif

}  // namespace tristim::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {

HWY_EXPORT(paeth_bytes);

void filter_paeth(std::span<const std::uint8_t> row, std::span<const std::uint8_t> above,
                  std::size_t pixel_bytes, std::uint8_t* out) noexcept {
  HWY_DYNAMIC_DISPATCH(paeth_bytes)(row.data(), above.data(), row.size(), pixel_bytes, out);
}

}  // namespace tristim::detail
#endif
