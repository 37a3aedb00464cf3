#include <array>

#include "tools/shade_model.h"
#include "tristim/light/fisher_woo.h"
#include "tristim/light/highlight_match.h"
#include "tristim/light/vector.h"

namespace tristim::tools {
namespace {

constexpr ColumnKind kAngle180{"", "0 to 180", [](double x) { return x >= 0 && x <= 180; }};

constexpr ColumnKind kCosine{"", "0 to 1", [](double x) { return x >= 0 && x <= 1; }};

constexpr Column kFactorIn[] = {{"rho_deg", kAngle180}};
constexpr Column kFactorOut[] = {{"cos_rho", kNumber}, {"cos_nu", kNumber}, {"f", kNumber}};
void factor(const ShadeRow& in, ShadeRow& out) {
  const double rho_deg = in.number("rho_deg");
  out.set("cos_rho", cosine_deg(rho_deg));
  out.set("cos_nu", cosine_deg(rho_deg / 2));
  out.set("f", exponent_factor(rho_deg));
}

constexpr Column kConversionIn[] = {{"phong_r", kNotNegative}, {"LE_deg", kAngle180}};
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

constexpr Column kCoplanarIn[] = {{"rho_deg", kAngle180}, {"r", kNotNegative}};
constexpr Column kCoplanarOut[] = {{"error", kNumber}};
void coplanar(const ShadeRow& in, ShadeRow& out) {
  out.set("error", coplanar_pixel_error(in.number("rho_deg"), in.number("r")));
}

constexpr Column kAsideIn[] = {
    {"nu_deg", kAngle180}, {"beta_deg", kAngle180}, {"theta_deg", kAngle180}};
constexpr Column kAsideOut[] = {{"RdotE", kNumber}};
void aside(const ShadeRow& in, ShadeRow& out) {
  out.set("RdotE", r_dot_e(in.number("nu_deg"), in.number("beta_deg"), in.number("theta_deg")));
}

constexpr Column kZeroIn[] = {{"NdotH", kCosine}, {"f", kNotNegative}, {"LE_deg", kAngle180}};
constexpr Column kZeroOut[] = {{"exists", kFlag}, {"cos_theta", kNumber}};
void zero(const ShadeRow& in, ShadeRow& out) {
  const double cos_theta =
      zero_error_cos_theta(in.number("NdotH"), in.number("f"), in.number("LE_deg"));
  const bool exists = cos_theta >= 0;  // it is NaN where no normal has the error 0
  out.set("exists", exists);
  out.set("cos_theta", exists ? cos_theta : 0);
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

constexpr Column kBlinnIn[] = {{"blinn_n", kAboveZero}, {"f", kAboveZero}};
constexpr Column kBlinnOut[] = {{"phong_r", kNumber},
                                {"beckmann_m", kNumber},
                                {"least_error", kNumber},
                                {"greatest_error", kNumber}};
void blinn_match(const ShadeRow& in, ShadeRow& out) {
  const double n = in.number("blinn_n");
  const ErrorRange errors = beckmann_match_errors(n);
  out.set("phong_r", phong_exponent(n, in.number("f")));
  out.set("beckmann_m", beckmann_roughness(n));
  out.set("least_error", errors.least);
  out.set("greatest_error", errors.greatest);
}

constexpr Column kExtremesIn[] = {{"r", kAboveZero}, {"f", kAboveZero}, {"LE_deg", kAngle180}};
constexpr Column kExtremesOut[] = {{"least", kNumber},
                                   {"greatest", kNumber},
                                   {"extreme", kNumber},
                                   {"mean", kNumber},
                                   {"standard_deviation", kNumber}};
void extremes(const ShadeRow& in, ShadeRow& out) {
  const ErrorRange range = highlight_errors(in.number("r"), in.number("f"), in.number("LE_deg"));
  const ErrorStatistics spread =
      highlight_error_statistics(in.number("r"), in.number("f"), in.number("LE_deg"));
  out.set("least", range.least);
  out.set("greatest", range.greatest);
  out.set("extreme", range.extreme());
  out.set("mean", spread.mean);
  out.set("standard_deviation", spread.standard_deviation);
}

constexpr Column kMinimaxIn[] = {{"r", kAboveZero}, {"LE_deg", kAngle180}};
constexpr Column kMinimaxOut[] = {{"f", kNumber}};
void minimax(const ShadeRow& in, ShadeRow& out) {
  out.set("f", minimax_factor(in.number("r"), in.number("LE_deg")));
}

constexpr ColumnKind kEyeDistance{"", "above 1", [](double x) { return x > 1; }};
constexpr Column kNearEyeIn[] = {
    {"r", kNotNegative}, {"f", kAboveZero}, {"LE_deg", kAngle180}, {"eye_distance", kEyeDistance}};
constexpr Column kNearEyeOut[] = {{"extreme", kNumber}};
void near_eye(const ShadeRow& in, ShadeRow& out) {
  out.set("extreme", near_eye_extreme(in.number("r"), in.number("f"), in.number("LE_deg"),
                                      in.number("eye_distance")));
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
    ShadeModel{"coplanar_error", "255 (cos^(4 r) nu - cos^r rho), rho = 2 nu", "[FisherWoo, eq. 6]",
               kCoplanarIn, kCoplanarOut, coplanar},
    ShadeModel{"highlight_aside", "R.E = cos(2 nu) + 2 sin^2 beta cos^2 theta",
               "[FisherWoo, eq. 7]", kAsideIn, kAsideOut, aside},
    ShadeModel{"highlight_zero",
               "where R.E = (N.H)^f: 2 sin^2 beta cos^2 theta = (N.H)^f - 2 (N.H)^2 + 1",
               "[FisherWoo], continued", kZeroIn, kZeroOut, zero},
    ShadeModel{"highlight_limits", "255 (1 - a) a^(a/(1 - a)), a = cos^2 beta; f* = 4 cos beta",
               "[FisherWoo], continued", kLimitIn, kLimitOut, limits},
    ShadeModel{"blinn_match", "r = n/f, m = sqrt(2/(n + 2)); 255 (D(b)/D(0) - cos^n b) over b",
               "[FisherWoo, Walter07]", kBlinnIn, kBlinnOut, blinn_match},
    ShadeModel{"highlight_extremes",
               "ends, mean and deviation of 255 ((R.E)^r - (N.H)^(f r)) over the normals",
               "[FisherWoo, table 3]", kExtremesIn, kExtremesOut, extremes},
    ShadeModel{"highlight_minimax", "the f for which the greatest error is smallest",
               "[FisherWoo], continued", kMinimaxIn, kMinimaxOut, minimax},
    ShadeModel{"highlight_near_eye",
               "the extreme on a unit sphere, the eye eye_distance from its centre", "[FisherWoo]",
               kNearEyeIn, kNearEyeOut, near_eye},
};

}  // namespace

std::span<const ShadeModel> highlight_models() { return kModels; }

}  // namespace tristim::tools
