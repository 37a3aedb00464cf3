#include "tools/gates.h"

#include <cmath>

#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

bool keeps(const Figure& figure, double bound) {
  return figure.more_is_better ? figure.value >= bound : std::fabs(figure.value) <= bound;
}

std::string missed(const Figure& figure, double bound) {
  return figure.name + " is " + rounded(figure.value, 6) +
         (figure.more_is_better ? ", below " : ", beyond ") + shortest(bound);
}

}  // namespace

std::vector<Gate> parse_gates(std::string_view text) {
  std::vector<Gate> gates;
  for (const std::string_view part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    const auto bound = equals == part.npos ? std::nullopt : parse_number(part.substr(equals + 1));
    if (!bound || std::isnan(*bound)) {
      throw Error(ErrorKind::kMisuse, "--gate", "'" + std::string(part) + "' is no bound",
                  "give a figure and a number: tone_max=0.5");
    }
    gates.push_back({std::string(part.substr(0, equals)), *bound});
  }
  return gates;
}

void check_gates(const std::vector<Gate>& gates, const std::vector<Figure>& figures,
                 const std::string& result) {
  std::string all_missed;
  for (const Gate& gate : gates) {
    const Figure* figure = find_by_name(figures, gate.name);
    if (figure == nullptr) {
      throw Error(ErrorKind::kMisuse, "--gate", "there is no figure '" + gate.name + "'",
                  name_hint(figures, gate.name));
    }
    // Not a number misses every bound.
    if (!keeps(*figure, gate.bound)) {
      all_missed += (all_missed.empty() ? "" : "; ") + missed(*figure, gate.bound);
    }
  }
  if (!all_missed.empty()) throw Error(ErrorKind::kGate, result, all_missed);
}

}  // namespace tristim::tools
