#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

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
  double t = 0;    // QP/QR, 0 where Q is R
  double i_p = 0;  // (1 - t) I_Q + t I_R
};

/// The span on the height of `p`, and the intensity there. Rounded once.
GouraudSpan gouraud_span(std::span<const GouraudVertex> polygon, const Eigen::Vector2d& p);

/// The parts that the corners of a triangle have in a point, which add up to 1; all 0 where the
/// triangle has no area. Negative outside. Rounded once.
struct Barycentric {
  double alpha = 0, beta = 0, gamma = 0;  // of corners 0, 1 and 2
};
Barycentric barycentric(std::span<const GouraudVertex, 3> triangle,
                        const Eigen::Vector2d& p) noexcept;

/// sum(part I/w) / sum(part/w), the intensity that a plane in space has there [UBC]; 0 where the
/// divisor is.
double perspective_intensity(std::span<const GouraudVertex, 3> triangle,
                             const Eigen::Vector2d& p) noexcept;

/// The intensities of the pixels xQ..xR, both included, each from the one before by one addition
/// [Shoaff 4.1]. The sum carries 106 bits, so that the last one is I_R. One value, I_Q, where the
/// ends are one pixel; nothing where they are in the wrong order.
std::vector<double> gouraud_incremental(long long x_q, long long x_r, double i_q, double i_r);

/// The intensity at `p` when polygon and point are turned together about the origin, counter-
/// clockwise: for more than three vertices it depends on the angle [Shoaff 4.3].
double gouraud_turned(std::span<const GouraudVertex> polygon, const Eigen::Vector2d& p,
                      double angle_deg);

}  // namespace tristim
