#pragma once

#include <string_view>
#include <vector>

#include "tristim/plot/svg.h"

namespace tristim::detail {

/// Puts labels on a drawing where they cover nothing that came before.
class LabelPlacer {
 public:
  LabelPlacer(SvgDrawing& svg, SvgPoint corner, double width, double height);

  /// Keeps the square about a mark free.
  void occupy(SvgPoint centre, double radius);
  void occupy(SvgPoint corner, double width, double height);

  /// Puts the middle of a label beside `mark`, away from it in the direction (dx, dy) of length 1;
  /// `gap` is left between. False where there is no room.
  bool place_towards(SvgPoint mark, double dx, double dy, double gap, std::string_view text,
                     const SvgFont& font);

  /// Puts a label on whichever side of a mark there is room; beside it where there is none at all,
  /// if `needed`.
  bool place_beside(SvgPoint mark, double gap, std::string_view text, const SvgFont& font,
                    bool needed);

 private:
  struct Box {
    double left, top, right, bottom;
  };
  bool free(const Box& box) const noexcept;

  SvgDrawing& svg_;
  Box frame_;
  std::vector<Box> taken_;
};

}  // namespace tristim::detail
