#include "lib/palette/hull_rows.h"

// Nothing older than SSE4 is worth it.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/palette/hull_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::hulls::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Vec = hn::Vec<Floats>;

HWY_INLINE Vec set(float x) { return hn::Set(Floats(), x); }

struct Color {
  Vec r, g, b;
};

HWY_INLINE Vec height(const HullFace& face, const Color& c) {
  return ((set(face.n[0]) * c.r + set(face.n[1]) * c.g) + set(face.n[2]) * c.b) - set(face.d);
}

// How far to go from a colour to one that is inside until it is too, `part` being what is known as
// yet: the step of PaletteHull::towards() for one face.
HWY_INLINE Vec farther(Vec part, Vec outside, Vec at_anchor, float rounding) {
  const auto is_outside = outside > set(rounding);
  if (hn::AllFalse(Floats(), is_outside)) return part;
  const Vec way = outside / (outside - hn::Min(at_anchor, set(0)));
  return hn::IfThenElse(is_outside, hn::Max(part, way), part);
}

HWY_INLINE Vec moved(Vec from, Vec to, Vec part) {
  return hn::IfThenElse(hn::Eq(part, set(0)), from, from + part * (to - from));
}

void inside(std::span<const HullFace> faces, const std::array<float, 3>& centre, float rounding,
            float* r, float* g, float* b) {
  const Floats f;
  const Color color{hn::LoadU(f, r), hn::LoadU(f, g), hn::LoadU(f, b)};
  auto mixable = hn::FirstN(f, hn::Lanes(f));
  for (const HullFace& face : faces) {
    mixable = hn::And(mixable, height(face, color) <= set(rounding));
  }
  if (hn::AllTrue(f, mixable)) return;
  const Vec grey = (set(0.2126F) * color.r + set(0.7152F) * color.g) + set(0.0722F) * color.b;
  const Color neutral{grey, grey, grey};
  const Color middle{set(centre[0]), set(centre[1]), set(centre[2])};
  Vec part = set(0);
  for (const HullFace& face : faces) {
    part = farther(part, height(face, neutral), height(face, middle), rounding);
  }
  const Color anchor{moved(grey, middle.r, part), moved(grey, middle.g, part),
                     moved(grey, middle.b, part)};
  part = set(0);
  for (const HullFace& face : faces) {
    part = farther(part, height(face, color), height(face, anchor), rounding);
  }
  hn::StoreU(moved(color.r, anchor.r, part), f, r);
  hn::StoreU(moved(color.g, anchor.g, part), f, g);
  hn::StoreU(moved(color.b, anchor.b, part), f, b);
}

void inside_row(std::span<const HullFace> faces, const std::array<float, 3>& centre, float rounding,
                const std::array<float*, 3>& planes, std::size_t count) {
  const std::size_t lanes = hn::Lanes(Floats());
  std::size_t x = 0;
  for (; x + lanes <= count; x += lanes) {
    inside(faces, centre, rounding, planes[0] + x, planes[1] + x, planes[2] + x);
  }
  if (x == count) return;
  float rest[3][HWY_MAX_BYTES / sizeof(float)] = {};
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; x + i < count; ++i) rest[c][i] = planes[c][x + i];
  }
  inside(faces, centre, rounding, rest[0], rest[1], rest[2]);
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; x + i < count; ++i) planes[c][x + i] = rest[c][i];
  }
}

}  // namespace tristim::detail::hulls::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim::detail {
namespace hulls {
HWY_EXPORT(inside_row);
}  // namespace hulls

void hull_inside_row(std::span<const HullFace> faces, const std::array<float, 3>& centre,
                     float rounding, const std::array<float*, 3>& planes, std::size_t count) {
  using namespace hulls;
  HWY_DYNAMIC_DISPATCH(inside_row)(faces, centre, rounding, planes, count);
}

}  // namespace tristim::detail
#endif
