#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tristim {

/// A place on a drawing, in CSS pixels: x to the right, y down.
struct SvgPoint {
  double x = 0, y = 0;
  friend constexpr bool operator==(const SvgPoint&, const SvgPoint&) = default;
};

/// A line or an outline. Colours are CSS's; width 0 draws nothing.
struct SvgStroke {
  std::string_view color = "#222";
  double width = 0;
  std::string_view dash = {};  // lengths of dashes and gaps, "4 3"; empty: solid
  double opacity = 1;
};

struct SvgPaint {
  std::string_view fill = "none";
  SvgStroke stroke = {};
  double opacity = 1;  // of the fill
};

enum class SvgAnchor { kStart, kMiddle, kEnd };

struct SvgFont {
  double size = 12;
  std::string_view color = "#222";
  SvgAnchor anchor = SvgAnchor::kStart;
  bool bold = false, italic = false;
  double turn_deg = 0;         // clockwise about its place
  std::string_view halo = {};  // colour behind the letters that parts them from lines; empty: none
};

/// A colour of a gradient at `offset`, [0, 1] from the left.
struct SvgStop {
  double offset = 0;
  std::string color;
};

/// A drawing in Scalable Vector Graphics [SVG11], with real text, drawn over what came before.
///
/// The same calls give the same bytes: coordinates have two decimals. Points that are not finite
/// break a line and leave out any other shape.
class SvgDrawing {
 public:
  /// `title` and `description` are for screen readers and tooltips.
  SvgDrawing(double width, double height, std::string_view title,
             std::string_view description = {});

  void polyline(std::span<const SvgPoint> points, const SvgStroke& stroke);
  void line(SvgPoint from, SvgPoint to, const SvgStroke& stroke);
  void polygon(std::span<const SvgPoint> points, const SvgPaint& paint);
  void rectangle(SvgPoint corner, double width, double height, const SvgPaint& paint);
  void circle(SvgPoint centre, double radius, const SvgPaint& paint);

  /// A rectangle whose colour runs from stop to stop, left to right.
  void gradient(SvgPoint corner, double width, double height, std::span<const SvgStop> stops);

  /// `place` is on the baseline; any UTF-8.
  void text(SvgPoint place, std::string_view text, const SvgFont& font);

  /// What is drawn until end_clip() shows inside of the polygon only, with that opacity as a whole.
  /// Clips nest.
  void begin_clip(std::span<const SvgPoint> polygon, double opacity = 1);
  void end_clip();

  double width() const noexcept { return width_; }
  double height() const noexcept { return height_; }

  /// The whole file.
  std::string document() const;

 private:
  double width_, height_;
  std::string head_, body_;
  int ids_ = 0;  // of clips and gradients
};

/// About how wide `text` is at a font size of 1, by the widths of Helvetica [AFM]; other letters
/// than ASCII count as digits.
double text_width(std::string_view text) noexcept;

/// `text` with what XML needs escaped; control characters become '?', bytes that are no UTF-8
/// U+FFFD.
std::string xml_escaped(std::string_view text);

/// `value` with `decimals` decimals, whatever the locale; never "-0".
std::string fixed_text(double value, int decimals);

}  // namespace tristim
