#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

#include "tristim/color/xyz.h"

namespace tristim {

/// How colours seen under one white are carried to another; kAdaptations says what each does.
enum class Adaptation { kBradford, kCat02, kCat16, kVonKries, kXyzScaling, kNone };

/// An adaptation: the responses in which it scales the source's white to the target's.
struct AdaptationMethod {
  std::string_view name;
  Adaptation method;
  std::array<double, 9> responses_from_xyz;  // by rows; all 0: XYZ stay as they are
  std::string_view formula;
  std::string_view source;
};

/// Every adaptation, complete and in one step: M^-1 diag(M target / M source) M. The first is the
/// default. The command line, the device files and the tests read this list.
inline constexpr std::array kAdaptations{
    AdaptationMethod{"bradford",
                     Adaptation::kBradford,
                     {0.8951, 0.2664, -0.1614,   //
                      -0.7502, 1.7135, 0.0367,   //
                      0.0389, -0.0685, 1.0296},  //
                     "sharpened responses, the linear form of ICC profiles",
                     "[Lam85]"},
    AdaptationMethod{"cat02",
                     Adaptation::kCat02,
                     {0.7328, 0.4296, -0.1624,  //
                      -0.7036, 1.6975, 0.0061,  //
                      0.0030, 0.0136, 0.9834},
                     "the responses of CIECAM02",
                     "[CIE159]"},
    AdaptationMethod{"cat16",
                     Adaptation::kCat16,
                     {0.401288, 0.650173, -0.051461,   //
                      -0.250268, 1.204414, 0.045854,   //
                      -0.002079, 0.048952, 0.953127},  //
                     "the responses of CAM16",
                     "[Li17]"},
    AdaptationMethod{"von-kries",
                     Adaptation::kVonKries,
                     {0.40024, 0.70760, -0.08081,  //
                      -0.22630, 1.16532, 0.04570,  //
                      0, 0, 0.91822},
                     "cones of Hunt, Pointer and Estevez, normalised to D65",
                     "[Hunt85]"},
    AdaptationMethod{"xyz-scaling",
                     Adaptation::kXyzScaling,
                     {1, 0, 0, 0, 1, 0, 0, 0, 1},
                     "X, Y and Z by themselves",
                     "[Fairchild13]"},
    AdaptationMethod{"none", Adaptation::kNone, {}, "XYZ stay: the white moves", "[Shoaff 2.2.4]"}};

/// XYZ seen under white `from` to XYZ that look alike under white `to`, within 5e-16 of its largest
/// entry. The matrix times `from` is `to`, rounding included, but for rare last bits.
/// Throws std::invalid_argument when a white has y = 0.
Eigen::Matrix3d adaptation_matrix(Chromaticity from, Chromaticity to, Adaptation method);

}  // namespace tristim
