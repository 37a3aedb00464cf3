#pragma once

#include <span>
#include <string_view>

#include "tristim/color/munsell.h"

namespace tristim {

/// A colour name of the ISCC-NBS system, level 3, such as "strong greenish blue".
struct IsccNbsName {
  int number = 0;  // 1 to 267
  std::string_view name;
  Munsell center;  // the central colour of its block [Kelly58]
};

/// All 267 by their numbers [Kelly76], from luts/iscc_nbs_names.csv. The command line and the tests
/// read it.
std::span<const IsccNbsName> iscc_nbs_names() noexcept;

/// The name of a colour, by the 932 boxes of hue, value and chroma [Kelly76 section 13], which fill
/// the whole space: of a chroma however large, of a hue undefined for neutrals. On a boundary,
/// where the publication gives both names, begin <= number < end decides.
///
/// nullptr where value or chroma is below 0 or NaN, or a colour of chroma .5 or more has no hue.
const IsccNbsName* iscc_nbs_name(Munsell munsell) noexcept;

}  // namespace tristim
