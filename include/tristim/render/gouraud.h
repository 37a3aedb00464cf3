#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "tristim/render/raster.h"

namespace tristim {

// Gouraud's interpolation of vertex intensities [Gouraud71, Shoaff 4.1], one value of it at a time.

/// A vertex in the picture plane.
struct GouraudVertex {
  Eigen::Vector2d at{0, 0};
  double intensity = 0;
  double w = 1;  // in clip space, above 0; for interpolation that is right in perspective
};

/// What a horizontal line meets on a convex polygon: Q on the left, R on the right, with the
/// intensities between the ends of their edges, I_Q = (1 - u) I_A + u I_B, u = AQ/AB. All 0 where
/// the line misses it.
struct GouraudSpan {
  double x_q = 0, x_r = 0;
  double i_q = 0, i_r = 0;
  double u = 0, w = 0;  // where Q and R lie on their edges: 0 at the first vertex, 1 at the second
  double t = 0;         // QP/QR, 0 where Q is R
  double i_p = 0;       // (1 - t) I_Q + t I_R
};

/// The span on the height of `p`, and the intensity there. Rounded once.
GouraudSpan gouraud_span(std::span<const GouraudVertex> polygon, const Eigen::Vector2d& p);

/// The intensities of the pixels of a row of a convex polygon: I_P of the first centre, then one
/// addition of (I_R - I_Q)/(x_R - x_Q) for each pixel [Shoaff 4.1]. The sum carries 106 bits: each
/// is gouraud_span's to 2 units of its last place. 0 where the row misses the polygon.
std::vector<double> gouraud_row(std::span<const GouraudVertex> polygon, const PixelRun& run);

/// The parts that the corners of a triangle have in a point, which add up to 1; all 0 where the
/// triangle has no area. Negative outside. Rounded once.
struct Barycentric {
  double alpha = 0, beta = 0, gamma = 0;  // of corners 0, 1 and 2
};
Barycentric barycentric(std::span<const GouraudVertex, 3> triangle,
                        const Eigen::Vector2d& p) noexcept;

/// The same by the triangle's own axes, P = A + beta (B - A) + gamma (C - A), which stand at any
/// angle [UBC]: two equations instead of three areas. Rounded once.
Barycentric barycentric_by_axes(std::span<const GouraudVertex, 3> triangle,
                                const Eigen::Vector2d& p) noexcept;

/// Whether a point is a convex combination of the corners: no part is below 0, and there is one.
bool is_convex(const Barycentric& parts) noexcept;

/// alpha A + beta B + gamma C. Rounded once.
Eigen::Vector2d combination(std::span<const GouraudVertex, 3> triangle,
                            const Barycentric& parts) noexcept;

/// sum(part I/w) / sum(part/w), the intensity that a plane in space has there [UBC]; 0 where the
/// divisor is.
double perspective_intensity(std::span<const GouraudVertex, 3> triangle,
                             const Eigen::Vector2d& p) noexcept;

/// The intensities of the pixels xQ..xR, both included, each from the one before by one addition
/// [Shoaff 4.1]. The sum carries 106 bits, so that the last one is I_R. One value, I_Q, where the
/// ends are one pixel; nothing where they are in the wrong order.
std::vector<double> gouraud_incremental(long long x_q, long long x_r, double i_q, double i_r);

/// How far float additions run away from the intensities: the largest difference seen, and what it
/// cannot exceed, n 2^-24 (|step| + largest intensity) for n additions and the rounded step.
struct IncrementalDrift {
  double largest = 0;
  double bound = 0;
};
IncrementalDrift incremental_drift(long long x_q, long long x_r, double i_q, double i_r);

/// The normals of the pixels xQ..xR of Phong's interpolation [Phong75, Shoaff 4.2]: the sum grows
/// by (N_R - N_Q)/(x_R - x_Q), and each is made a unit vector; 0 where the sum is. One, of N_Q,
/// where the ends are one pixel.
std::vector<Eigen::Vector3d> normals_incremental(long long x_q, long long x_r,
                                                 const Eigen::Vector3d& n_q,
                                                 const Eigen::Vector3d& n_r);

/// The intensity at `p` when polygon and point are turned together about the origin, counter-
/// clockwise: for more than three vertices it depends on the angle [Shoaff 4.3].
double gouraud_turned(std::span<const GouraudVertex> polygon, const Eigen::Vector2d& p,
                      double angle_deg);

}  // namespace tristim
