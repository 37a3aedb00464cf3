#include "lib/dither/planes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/dither/planes_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void split(const float* rgb, std::size_t width, float* r, float* g, float* b) {
  const hn::ScalableTag<float> tag;
  const std::size_t lanes = hn::Lanes(tag);
  std::size_t x = 0;
  for (; x + lanes <= width; x += lanes) {
    hn::Vec<decltype(tag)> red, green, blue;
    hn::LoadInterleaved3(tag, rgb + 3 * x, red, green, blue);
    hn::StoreU(red, tag, r + x);
    hn::StoreU(green, tag, g + x);
    hn::StoreU(blue, tag, b + x);
  }
  for (; x < width; ++x) {
    r[x] = rgb[3 * x];
    g[x] = rgb[3 * x + 1];
    b[x] = rgb[3 * x + 2];
  }
}

void join(const std::uint16_t* r, const std::uint16_t* g, const std::uint16_t* b, std::size_t width,
          std::uint16_t* rgb) {
  const hn::ScalableTag<std::uint16_t> tag;
  const std::size_t lanes = hn::Lanes(tag);
  std::size_t x = 0;
  for (; x + lanes <= width; x += lanes) {
    hn::StoreInterleaved3(hn::LoadU(tag, r + x), hn::LoadU(tag, g + x), hn::LoadU(tag, b + x), tag,
                          rgb + 3 * x);
  }
  for (; x < width; ++x) {
    rgb[3 * x] = r[x];
    rgb[3 * x + 1] = g[x];
    rgb[3 * x + 2] = b[x];
  }
}

}  // namespace tristim::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {

HWY_EXPORT(split);
HWY_EXPORT(join);

void split_row(std::span<const float> rgb, const std::array<float*, 3>& planes) noexcept {
  HWY_DYNAMIC_DISPATCH(split)(rgb.data(), rgb.size() / 3, planes[0], planes[1], planes[2]);
}

void join_row(const std::array<const std::uint16_t*, 3>& planes,
              std::span<std::uint16_t> rgb) noexcept {
  HWY_DYNAMIC_DISPATCH(join)(planes[0], planes[1], planes[2], rgb.size() / 3, rgb.data());
}

}  // namespace tristim::detail
#endif
