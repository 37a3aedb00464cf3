#include "lib/color/name_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/color/edges.h"
#include "lib/color/name_text.h"
#include "tristim/color/cns.h"
#include "tristim/color/iscc_nbs.h"
#include "tristim/color/munsell.h"
#include "tristim/color/oklab.h"
#include "tristim/color/parse.h"
#include "tristim/color/transfer.h"
#include "tristim/core/find.h"

namespace tristim::detail {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr Components kNoName{kNone, 0, 0, 0};

std::size_t index_of(const Components& c) { return static_cast<std::size_t>(c[0]); }

CnsName cns_of(const Components& c) {
  CnsName name{static_cast<int>(c[0]), static_cast<int>(c[1]), std::nullopt};
  if (!std::isnan(c[2])) name.hue = static_cast<int>(c[2]);
  return name;
}

Components components_of_cns(const CnsName& name) {
  return {double(name.lightness), double(name.saturation), name.hue ? double(*name.hue) : kNone, 0};
}

Oklab oklab_of(const Components& c) {
  return linear_srgb_to_oklab({srgb_decode(c[0]), srgb_decode(c[1]), srgb_decode(c[2])});
}

}  // namespace

Components munsell_to_iscc_nbs(const Components& c, const ModelContext& /*context*/) {
  const IsccNbsName* name = iscc_nbs_name(color_of<Munsell>(c));
  return name == nullptr ? kNoName : Components{double(name->number)};
}

Components iscc_nbs_to_munsell(const Components& c, const ModelContext& /*context*/) {
  if (std::isnan(c[0])) return {kNone, kNone, kNone};
  return components_of(iscc_nbs_names()[index_of(c) - 1].center);
}

std::string iscc_nbs_to_text(const Components& c) {
  return std::isnan(c[0]) ? "none" : std::string(iscc_nbs_names()[index_of(c) - 1].name);
}

std::optional<Components> iscc_nbs_from_text(std::string_view text) {
  const IsccNbsName* name = find_by_name(iscc_nbs_names(), normal_name(text));
  if (name == nullptr) return std::nullopt;
  return Components{double(name->number)};
}

std::string iscc_nbs_hint(std::string_view text) {
  const std::string hint = name_hint(iscc_nbs_names(), normal_name(text));
  return hint.starts_with("did you mean") ? hint : "a name is such as 'strong greenish blue'";
}

Components munsell_to_cns(const Components& c, const ModelContext& /*context*/) {
  const auto name = cns_name(color_of<Munsell>(c));
  return name ? components_of_cns(*name) : kNoName;
}

Components cns_to_munsell(const Components& c, const ModelContext& /*context*/) {
  if (std::isnan(c[0])) return {kNone, kNone, kNone};
  return components_of(cns_color(cns_of(c)));
}

std::string cns_to_text(const Components& c) {
  return std::isnan(c[0]) ? "none" : cns_text(cns_of(c));
}

std::optional<Components> cns_from_text(std::string_view text) {
  const auto name = parse_cns(text);
  if (!name) return std::nullopt;
  return components_of_cns(*name);
}

Components rgb_to_css(const Components& c, const ModelContext& /*context*/) {
  const Oklab color = oklab_of(c);
  Components nearest = kNoName;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < css_colors().size(); ++i) {
    const Oklab other = oklab_of(css_to_rgb({double(i)}, {}));
    const double dl = color.l - other.l;
    const double da = color.a - other.a;
    const double db = color.b - other.b;
    const double square = dl * dl + da * da + db * db;
    if (square < least) nearest = {double(i)};
    least = std::min(least, square);
  }
  return nearest;
}

Components css_to_rgb(const Components& c, const ModelContext& /*context*/) {
  if (std::isnan(c[0])) return {kNone, kNone, kNone};
  const EncodedRgb rgb = encoded_rgb(css_colors()[index_of(c)]);
  return components_of(rgb);
}

std::string css_to_text(const Components& c) {
  return std::isnan(c[0]) ? "none" : std::string(css_colors()[index_of(c)].name);
}

std::optional<Components> css_from_text(std::string_view text) {
  const NamedColor* color = find_by_name(css_colors(), text);
  if (color == nullptr) return std::nullopt;
  return Components{double(color - css_colors().data())};
}

std::string munsell_to_text(const Components& c) { return munsell_notation(color_of<Munsell>(c)); }

std::optional<Components> munsell_from_text(std::string_view text) {
  const auto munsell = parse_munsell(text);
  if (!munsell) return std::nullopt;
  return components_of(*munsell);
}

}  // namespace tristim::detail
