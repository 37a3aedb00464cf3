#pragma once

#include "tristim/color/models.h"

namespace tristim::detail {

// Edges of the models whose colours are words. Their components are what the words stand for; NaN
// where there is no name, whose text is "none".

// ISCC-NBS: the number of the name.
Components munsell_to_iscc_nbs(const Components& c, const ModelContext& context);
Components iscc_nbs_to_munsell(const Components& c, const ModelContext& context);
std::string iscc_nbs_to_text(const Components& c);
std::optional<Components> iscc_nbs_from_text(std::string_view text);
std::string iscc_nbs_hint(std::string_view text);

// CNS: lightness, saturation and hue of CnsName; NaN for no hue.
Components munsell_to_cns(const Components& c, const ModelContext& context);
Components cns_to_munsell(const Components& c, const ModelContext& context);
std::string cns_to_text(const Components& c);
std::optional<Components> cns_from_text(std::string_view text);

// CSS: the place in css_colors().
Components rgb_to_css(const Components& c, const ModelContext& context);
Components css_to_rgb(const Components& c, const ModelContext& context);
std::string css_to_text(const Components& c);
std::optional<Components> css_from_text(std::string_view text);

// Munsell notation, of the components of Munsell.
std::string munsell_to_text(const Components& c);
std::optional<Components> munsell_from_text(std::string_view text);

}  // namespace tristim::detail
