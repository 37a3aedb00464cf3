#pragma once

namespace tristim {

// Which exponent makes one model's highlight look like another's, and how far off it stays. Letters
// as in fisher_woo.h; `r` is the exponent of (R.E)^r, n that of (N.H)^n, m Beckmann's roughness.
// Errors are on a scale of 255. What takes exponents throws std::invalid_argument where they are
// not above 0 and finite; angles are degrees, [L,E] in 0..180.

/// n = f r, and back. The factor is 4 in [FisherWoo]; see minimax_factor for better ones.
double blinn_exponent(double phong_r, double f = 4);
double phong_exponent(double blinn_n, double f = 4);

/// m = sqrt(2 / (n + 2)): the Beckmann distribution of the same curvature at its peak [Walter07],
/// and back, n = max(2 / m^2 - 2, 0). The first takes n = 0 too.
double beckmann_roughness(double blinn_n);
double blinn_exponent_of_roughness(double beckmann_m);

/// (n + 2) / (2 pi): what makes (N.H)^n a distribution of microfacets [Blinn77]. And (r + 1) / (2
/// pi): what makes (R.E)^r around R integrate to 1 over the hemisphere. Take 0 too.
double blinn_normalisation(double blinn_n);
double phong_normalisation(double phong_r);

/// The ends of an error over all directions, on a scale of 255, and N.H where each is reached.
struct ErrorRange {
  double least = 0;     // 0 or below
  double greatest = 0;  // 0 or above
  double least_n_dot_h = 1;
  double greatest_n_dot_h = 1;

  /// The end of the larger size, with its sign, as [FisherWoo, table 3] lists it.
  double extreme() const noexcept { return -least > greatest ? least : greatest; }
};

/// The range of 255 ((R.E)^r - (N.H)^(f r)) over all normals of the half space N.E >= 0.
///
/// At one N.H, R.E is least in the plane of L and E and greatest on the great circle across it
/// through H, by equation 7: the two ends lie on these two circles, and each is the extreme of a
/// function of one variable. At [L,E] = 180 the circle across is a limit.
ErrorRange highlight_errors(double phong_r, double f, double le_deg);

/// What the greatest error with f = 4 tends to as r grows: 255 (1 - a) a^(a/(1-a)), a = cos^2 beta.
double limit_error(double le_deg) noexcept;

/// The factor for which the larger end of highlight_errors is smallest: where both ends are equal.
/// 0 at [L,E] = 180, where no factor helps.
double minimax_factor(double phong_r, double le_deg);

/// What minimax_factor tends to as r grows: 4 cos beta.
double minimax_factor_limit(double le_deg) noexcept;

/// What the greatest error with minimax_factor tends to: limit_error with cos beta for a. At [L,E]
/// = 90 it is half of what f = 4 gives, 32.35 for 63.75.
double minimax_limit_error(double le_deg) noexcept;

/// The error left by beckmann_roughness: the range of 255 (D(b) / D(0) - cos^n b) over the angles b
/// of N to H, D the Beckmann distribution exp(-(tan b / m)^2) / (m^2 cos^4 b).
ErrorRange beckmann_match_errors(double blinn_n);

/// Mean and standard deviation of pixel_error over the normals of [FisherWoo, fig. 5], theta and
/// phi from 0 to 180 in steps of 1 degree.
struct ErrorStatistics {
  double mean = 0;
  double standard_deviation = 0;
};
ErrorStatistics highlight_error_statistics(double phong_r, double f, double le_deg);

/// The extreme of the error on a unit sphere that an eye sees from `eye_distance` (in radii from
/// the sphere's centre, above 1): the light is directional, `le_deg` from the direction of the eye,
/// and E turns with the place. Found to 1e-3.
double near_eye_extreme(double phong_r, double f, double le_deg, double eye_distance);

}  // namespace tristim
