#include "lib/color/adaptation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace tristim {
namespace {

using detail::DoubleDouble;
using detail::ExactMatrix;
using detail::ExactVector;

ExactMatrix responses_from_xyz(Adaptation method) noexcept {
  const auto* row = std::find_if(kAdaptations.begin(), kAdaptations.end(),
                                 [&](const AdaptationMethod& m) { return m.method == method; });
  ExactMatrix responses;
  for (std::size_t i = 0; i < 9; ++i) {
    responses[i / 3][i % 3] = detail::published(row->responses_from_xyz[i]);
  }
  return responses;
}

constexpr DoubleDouble kOne{1, 0};
constexpr ExactMatrix kIdentity{ExactVector{kOne, {}, {}}, ExactVector{DoubleDouble{}, kOne, {}},
                                ExactVector{DoubleDouble{}, {}, kOne}};

}  // namespace

ExactMatrix detail::exact_adaptation(Chromaticity from, Chromaticity to,
                                     Adaptation method) noexcept {
  if (method == Adaptation::kNone || from == to) return kIdentity;
  const ExactMatrix responses = responses_from_xyz(method);
  const ExactVector source = responses * exact_white(from);
  ExactVector gain = responses * exact_white(to);
  for (std::size_t i = 0; i < 3; ++i) gain[i] = divide(gain[i], source[i]);
  return scale_columns(inverse(responses), gain) * responses;
}

void detail::check_white(Chromaticity white) {
  if (white.y != 0 && std::isfinite(white.x) && std::isfinite(white.y)) return;
  throw std::invalid_argument("white: y must be finite and not 0");
}

Eigen::Matrix3d adaptation_matrix(Chromaticity from, Chromaticity to, Adaptation method) {
  detail::check_white(from);
  detail::check_white(to);
  const auto white = [](Chromaticity c) { return detail::rounded(detail::exact_white(c)); };
  const bool moves = method == Adaptation::kNone;  // the white; nothing to make it of
  return detail::rounded(detail::exact_adaptation(from, to, method), white(from),
                         white(moves ? from : to));
}

}  // namespace tristim
