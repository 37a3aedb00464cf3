#pragma once

#include <Eigen/Core>

namespace tristim {

// How the highlights (R.E)^r [Phong75] and (N.H)^n [Blinn77] differ, as Fisher and Woo derive it
// [FisherWoo]. In their letters: L to the light, E to the eye (V elsewhere), R the reflected light,
// H half way between L and E; beta = [L,H], so that [L,E] is 2 beta; rho = [R,E], nu = [N,H];
// n = f r. Vectors are unit vectors, used as given. Nothing here throws; NaN passes.

/// The paper's frame: one light, one eye, one normal of a sphere that is lit from far away and seen
/// from far away [FisherWoo, fig. 4].
struct HighlightFrame {
  Eigen::Vector3d to_light;  // L, in the half plane of x <= 0 and z
  Eigen::Vector3d to_eye;    // E = +z
  Eigen::Vector3d normal;    // N, in the half space of z >= 0
};

/// The normal stands `theta_deg` from +y and `phi_deg` from -x about y, both 0..180; the light
/// stands `le_deg` = [L,E] from the eye, 0..180. theta 90 is the plane of L and E.
HighlightFrame highlight_frame(double theta_deg, double phi_deg, double le_deg) noexcept;

/// R.E from N.H where L, N and E lie in one plane: 2 (N.H)^2 - 1 [FisherWoo, eq. 2, 3].
double coplanar_r_dot_e(double n_dot_h) noexcept;

/// R.E from nu, beta and theta, the angle of N to the normal of the plane of L and E, in degrees:
/// cos 2 nu + 2 sin^2 beta cos^2 theta [FisherWoo, eq. 7].
double r_dot_e(double nu_deg, double beta_deg, double theta_deg) noexcept;

/// R.E from N.H exactly, for any three directions: 2 (N.H)^2 - 1 + 2 (L x H . N)^2 [FisherWoo, eq.
/// 9]. With it a model that has H at hand makes Phong's highlight. Where L = -E there is no H, and
/// the result is -1, which is R.E only for N along L.
double r_dot_e_from_half(const Eigen::Vector3d& normal, const Eigen::Vector3d& to_light,
                         const Eigen::Vector3d& to_eye) noexcept;

/// The same without H in the last term: 2 (N.H)^2 - 1 + (L x E . N)^2 / (1 + L.E)
/// [FisherWoo, eq. 8, 12]. Loses digits as L comes near -E; -1 at L = -E.
double r_dot_e_from_eye(const Eigen::Vector3d& normal, const Eigen::Vector3d& to_light,
                        const Eigen::Vector3d& to_eye) noexcept;

/// a x b . c, the determinant of the matrix [a|b|c].
double triple_product(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                      const Eigen::Vector3d& c) noexcept;

/// |M^T M| of M = [a|b|c], from the six dot products alone [FisherWoo, eq. 11, left side]. Equals
/// the square of triple_product for vectors of any length.
double gram_determinant(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                        const Eigen::Vector3d& c) noexcept;

/// The left side of (L.E)^2 + (E.N)^2 + (N.L)^2 - 2 (L.E)(E.N)(N.L) - 1 + (L x E . N)^2 = 0
/// [FisherWoo, eq. 10, 13]: 0 but for rounding for any three unit vectors.
double unit_gram_identity(const Eigen::Vector3d& to_light, const Eigen::Vector3d& to_eye,
                          const Eigen::Vector3d& normal) noexcept;

/// The factor f that makes (N.H)^(f r) equal to (R.E)^r in the coplanar case, whatever r:
/// log cos rho / log cos nu with rho = 2 nu [FisherWoo, eq. 4, 5]. 4 at rho = 0, rising to infinity
/// at 90 degrees and beyond, where R.E is not above 0.
double exponent_factor(double rho_deg) noexcept;

/// 255 (cos^(4r) nu - cos^r rho) with rho = 2 nu [FisherWoo, eq. 6], the error of a pixel in the
/// coplanar case. Cosines count where they are positive.
double coplanar_pixel_error(double rho_deg, double r) noexcept;

/// 255 ((R.E)^r - (N.H)^(f r)), the error of a pixel with the sign of [FisherWoo, table 3, fig. 5],
/// opposite to equation 6. Dot products count where they are positive; N.L is not looked at, as in
/// the paper.
double pixel_error(const HighlightFrame& frame, double r, double f) noexcept;

/// Where pixel_error is 0 off the plane of L and E: cos theta of the normals on the circle N.H =
/// `n_dot_h` for which R.E is (N.H)^f. NaN where the circle has no such normal.
double zero_error_cos_theta(double n_dot_h, double f, double le_deg) noexcept;

}  // namespace tristim
