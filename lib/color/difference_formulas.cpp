#include <algorithm>
#include <string>

#include "tristim/color/difference.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

using Values = std::array<double, 3>;

Lab lab(const Values& c) noexcept { return {c[0], c[1], c[2]}; }
Oklab oklab(const Values& c) noexcept { return {c[0], c[1], c[2]}; }

std::string range_text(const DifferenceFormula& formula) {
  if (formula.factor_count == 0) return std::string(formula.name) + " has none";
  constexpr std::string_view kForms[] = {":L", ":L:C", ":L:C:H"};
  return "give " + std::string(formula.name) +
         std::string(kForms[static_cast<std::size_t>(formula.factor_count) - 1]) + ", each above 0";
}

}  // namespace

constexpr std::array<DifferenceFormula, 7> kDifferenceFormulas{{
    {"ciede2000",
     "lab",
     [](const Values& a, const Values& b, DifferenceFactors k) noexcept {
       return ciede2000(lab(a), lab(b), k);
     },
     {},
     3,
     true,
     "sqrt((dL'/kL SL)^2 + (dC'/kC SC)^2 + (dH'/kH SH)^2 + RT (dC'/kC SC) (dH'/kH SH))",
     "[Sharma05 eqs 2-22]"},
    {"cie76",
     "lab",
     [](const Values& a, const Values& b, DifferenceFactors) noexcept {
       return cie76(lab(a), lab(b));
     },
     {},
     0,
     true,
     "sqrt(dL*^2 + da*^2 + db*^2)",
     "[CIE15 8.2.1]"},
    {"cie94",
     "lab",
     [](const Values& a, const Values& b, DifferenceFactors k) noexcept {
       return cie94(lab(a), lab(b), {}, k);
     },
     {},
     3,
     false,
     "graphic arts: sqrt((dL/kL)^2 + (dC/kC (1 + .045 C1))^2 + (dH/kH (1 + .015 C1))^2)",
     "[CIE116]"},
    {"cie94-textiles",
     "lab",
     [](const Values& a, const Values& b, DifferenceFactors k) noexcept {
       return cie94(lab(a), lab(b), kTextileWeights, k);
     },
     {2, 1, 1},
     3,
     false,
     "kL = 2: sqrt((dL/kL)^2 + (dC/kC (1 + .048 C1))^2 + (dH/kH (1 + .014 C1))^2)",
     "[CIE116]"},
    {"cmc",
     "lab",
     [](const Values& a, const Values& b, DifferenceFactors k) noexcept {
       return cmc(lab(a), lab(b), k);
     },
     {2, 1, 1},
     2,
     false,
     "CMC(2:1): sqrt((dL/l SL)^2 + (dC/c SC)^2 + (dH/SH)^2)",
     "[Clarke84]"},
    {"cmc-1-1",
     "lab",
     [](const Values& a, const Values& b, DifferenceFactors k) noexcept {
       return cmc(lab(a), lab(b), k);
     },
     {},
     2,
     false,
     "CMC(1:1)",
     "[Clarke84]"},
    {"ok",
     "oklab",
     [](const Values& a, const Values& b, DifferenceFactors) noexcept {
       return delta_e_ok(oklab(a), oklab(b));
     },
     {},
     0,
     true,
     "sqrt(dL^2 + da^2 + db^2) of Oklab",
     "[CSS4 delta E OK]"},
}};

DifferenceReference parse_difference(std::string_view text, std::string_view thing) {
  const std::vector<std::string_view> parts = split(text, ':');
  const DifferenceFormula* formula = find_by_name(kDifferenceFormulas, parts[0]);
  if (formula == nullptr) {
    throw Error(ErrorKind::kMisuse, thing, "unknown difference '" + std::string(parts[0]) + "'",
                name_hint(kDifferenceFormulas, parts[0]));
  }
  DifferenceReference reference{formula, formula->factors};
  double* const factors[] = {&reference.factors.lightness, &reference.factors.chroma,
                             &reference.factors.hue};
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const auto factor = parse_number(parts[i]);
    const bool fits = static_cast<int>(i) <= formula->factor_count && factor && *factor > 0 &&
                      *factor <= std::numeric_limits<double>::max();
    if (!fits) {
      throw Error(ErrorKind::kMisuse, thing, "'" + std::string(text) + "' has wrong factors",
                  range_text(*formula));
    }
    *factors[i - 1] = *factor;
  }
  return reference;
}

}  // namespace tristim
