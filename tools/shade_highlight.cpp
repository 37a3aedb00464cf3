#include <array>

#include "tools/shade_model.h"
#include "tristim/light/fisher_woo.h"
#include "tristim/light/highlight_match.h"
#include "tristim/light/vector.h"

namespace tristim::tools {
namespace {

constexpr ColumnKind kAngle180{"", "0 to 180", [](double x) { return x >= 0 && x <= 180; }};

constexpr Column kFactorIn[] = {{"rho_deg", kAngle180}};
constexpr Column kFactorOut[] = {{"cos_rho", kNumber}, {"cos_nu", kNumber}, {"f", kNumber}};
void factor(const ShadeRow& in, ShadeRow& out) {
  const double rho_deg = in.number("rho_deg");
  out.set("cos_rho", cosine_deg(rho_deg));
  out.set("cos_nu", cosine_deg(rho_deg / 2));
  out.set("f", exponent_factor(rho_deg));
}

constexpr Column kConversionIn[] = {{"phong_r", kAboveZero}, {"LE_deg", kAngle180}};
constexpr Column kConversionOut[] = {
    {"blinn_n_f4", kNumber},         {"blinn_n_minimax_4cosbeta", kNumber},
    {"beckmann_m_of_n_f4", kNumber}, {"beckmann_m_of_n_minimax", kNumber},
    {"blinn_D_norm", kNumber},       {"phong_lobe_norm", kNumber}};
void conversion(const ShadeRow& in, ShadeRow& out) {
  const double r = in.number("phong_r");
  const double n = blinn_exponent(r);
  const double f = minimax_factor_limit(in.number("LE_deg"));
  const double minimax = f > 0 ? blinn_exponent(r, f) : 0;  // L = -E
  out.set("blinn_n_f4", n);
  out.set("blinn_n_minimax_4cosbeta", minimax);
  out.set("beckmann_m_of_n_f4", beckmann_roughness(n));
  out.set("beckmann_m_of_n_minimax", beckmann_roughness(minimax));
  out.set("blinn_D_norm", blinn_normalisation(n));
  out.set("phong_lobe_norm", phong_normalisation(r));
}

constexpr Column kIdentityIn[] = {{"L", kVector}, {"N", kVector}, {"E", kVector}};
constexpr Column kIdentityOut[] = {
    {"RdotE", kNumber}, {"from_half", kNumber}, {"from_eye", kNumber}, {"coplanar", kNumber},
    {"det", kNumber},   {"gram", kNumber},      {"identity", kNumber}};
void identities(const ShadeRow& in, ShadeRow& out) {
  const Eigen::Vector3d l = in.vector("L");
  const Eigen::Vector3d n = in.vector("N");
  const Eigen::Vector3d e = in.vector("E");
  out.set("RdotE", r_dot_v(n, l, e));
  out.set("from_half", r_dot_e_from_half(n, l, e));
  out.set("from_eye", r_dot_e_from_eye(n, l, e));
  out.set("coplanar", coplanar_r_dot_e(n_dot_h(n, l, e)));
  out.set("det", triple_product(l, e, n));
  out.set("gram", gram_determinant(l, e, n));
  out.set("identity", unit_gram_identity(l, e, n));
}

constexpr Column kErrorIn[] = {{"theta_deg", kAngle180},
                               {"phi_deg", kAngle180},
                               {"LE_deg", kAngle180},
                               {"r", kNotNegative},
                               {"f", kNotNegative}};
constexpr Column kErrorOut[] = {{"L", kVector}, {"E", kVector}, {"N", kVector}, {"error", kNumber}};
void pixel(const ShadeRow& in, ShadeRow& out) {
  const HighlightFrame frame =
      highlight_frame(in.number("theta_deg"), in.number("phi_deg"), in.number("LE_deg"));
  out.set("L", frame.to_light);
  out.set("E", frame.to_eye);
  out.set("N", frame.normal);
  out.set("error", pixel_error(frame, in.number("r"), in.number("f")));
}

constexpr Column kLimitIn[] = {{"LE_deg", kAngle180}};
constexpr Column kLimitOut[] = {
    {"limit_error", kNumber}, {"minimax_f", kNumber}, {"minimax_error", kNumber}};
void limits(const ShadeRow& in, ShadeRow& out) {
  const double le_deg = in.number("LE_deg");
  out.set("limit_error", limit_error(le_deg));
  out.set("minimax_f", minimax_factor_limit(le_deg));
  out.set("minimax_error", minimax_limit_error(le_deg));
}

constexpr std::array kModels{
    ShadeModel{"exponent_factor", "f = log(2 cos^2 nu - 1)/log cos nu, rho = 2 nu; 4 at 0",
               "[FisherWoo, eq. 5]", kFactorIn, kFactorOut, factor},
    ShadeModel{"exponent_conversion", "n = 4 r, 4 cos(beta) r; m = sqrt(2/(n + 2))",
               "[FisherWoo, Walter07]", kConversionIn, kConversionOut, conversion},
    ShadeModel{"highlight_identities",
               "R.E = 2 (N.H)^2 - 1 + 2 (L x H . N)^2 = 2 (N.H)^2 - 1 + (L x E . N)^2/(1 + L.E)",
               "[FisherWoo, eq. 7-13]", kIdentityIn, kIdentityOut, identities},
    ShadeModel{"highlight_error", "255 ((R.E)^r - (N.H)^(f r)) in the frame of figure 4",
               "[FisherWoo, eq. 6]", kErrorIn, kErrorOut, pixel},
    ShadeModel{"highlight_limits", "255 (1 - a) a^(a/(1 - a)), a = cos^2 beta; f* = 4 cos beta",
               "[FisherWoo], continued", kLimitIn, kLimitOut, limits},
};

}  // namespace

std::span<const ShadeModel> highlight_models() { return kModels; }

}  // namespace tristim::tools
