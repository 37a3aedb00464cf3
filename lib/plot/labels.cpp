#include "lib/plot/labels.h"

#include <algorithm>
#include <cmath>

namespace tristim::detail {
namespace {

constexpr double kWider = 1.12;      // DejaVu Sans, where there is no Helvetica
constexpr double kCapHeight = 0.73;  // of the font size
constexpr double kSideways = 0.3;    // of a direction: less is above or below
constexpr double kDiagonal = 0.70710678118654752;

// Right, left and the rest: the order in which an eye looks for a label.
constexpr SvgPoint kSides[] = {{1, 0},
                               {-1, 0},
                               {kDiagonal, -kDiagonal},
                               {kDiagonal, kDiagonal},
                               {-kDiagonal, -kDiagonal},
                               {-kDiagonal, kDiagonal},
                               {0, -1},
                               {0, 1}};

}  // namespace

LabelPlacer::LabelPlacer(SvgDrawing& svg, SvgPoint corner, double width, double height)
    : svg_(svg), frame_{corner.x, corner.y, corner.x + width, corner.y + height} {}

void LabelPlacer::occupy(SvgPoint centre, double radius) {
  occupy({centre.x - radius, centre.y - radius}, 2 * radius, 2 * radius);
}

void LabelPlacer::occupy(SvgPoint corner, double width, double height) {
  taken_.push_back({corner.x, corner.y, corner.x + width, corner.y + height});
}

bool LabelPlacer::free(const Box& box) const noexcept {
  if (!(box.left >= frame_.left && box.right <= frame_.right && box.top >= frame_.top &&
        box.bottom <= frame_.bottom)) {
    return false;
  }
  return std::none_of(taken_.begin(), taken_.end(), [&](const Box& b) {
    return box.left < b.right && b.left < box.right && box.top < b.bottom && b.top < box.bottom;
  });
}

bool LabelPlacer::place_towards(SvgPoint mark, double dx, double dy, double gap,
                                std::string_view text, const SvgFont& font) {
  const double half_width = kWider * font.size * text_width(text) / 2;
  const double half_height = kCapHeight * font.size / 2;
  // The nearest place in that direction whose box leaves the gap.
  const double reach = std::min(std::fabs(dx) > 1e-9 ? (half_width + gap) / std::fabs(dx) : 1e9,
                                std::fabs(dy) > 1e-9 ? (half_height + gap) / std::fabs(dy) : 1e9);
  const SvgPoint middle{mark.x + dx * reach, mark.y + dy * reach};
  const Box box{middle.x - half_width - 1, middle.y - half_height - 1.5, middle.x + half_width + 1,
                middle.y + half_height + 1.5};
  if (!free(box)) return false;
  taken_.push_back(box);
  // The side next to the mark is where it should be, however wide the letters turn out.
  SvgFont anchored = font;
  anchored.anchor = dx > kSideways    ? SvgAnchor::kStart
                    : dx < -kSideways ? SvgAnchor::kEnd
                                      : SvgAnchor::kMiddle;
  const double x = dx > kSideways    ? middle.x - half_width
                   : dx < -kSideways ? middle.x + half_width
                                     : middle.x;
  svg_.text({x, middle.y + half_height}, text, anchored);
  return true;
}

bool LabelPlacer::place_beside(SvgPoint mark, double gap, std::string_view text,
                               const SvgFont& font, bool needed) {
  for (const double away : {gap, gap + 0.8 * font.size}) {
    for (const SvgPoint& side : kSides) {
      if (place_towards(mark, side.x, side.y, away, text, font)) return true;
    }
  }
  if (needed) svg_.text({mark.x + gap, mark.y + kCapHeight * font.size / 2}, text, font);
  return false;
}

}  // namespace tristim::detail
