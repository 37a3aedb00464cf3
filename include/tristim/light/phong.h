#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string_view>

#include "tristim/color/rgb.h"
#include "tristim/light/samples.h"
#include "tristim/light/source.h"

namespace tristim {

/// How a surface reflects, in the letters of the illumination equation [Shoaff 3.4]. Coefficients
/// and colours are unitless, 0..1 for surfaces that exist; nothing is clamped.
template <typename Color>
struct MaterialOf {
  double ka = 0;  // ambient
  double kd = 0;  // diffuse
  double ks = 0;  // specular
  double n = 1;   // specular exponent, 0 or more; 1 is broad, several hundred a pinpoint
  Color od = kWhiteOf<Color>;  // colour of the diffuse (and ambient) reflection
  Color os = kWhiteOf<Color>;  // colour of the highlight
};
using Material = MaterialOf<Rgb>;
using SpectralMaterial = MaterialOf<SpectralColor>;

/// (N.L), 0 where the light is behind the surface [Shoaff 3.2]. Rounded once, as the lobes are.
double lambert(const Eigen::Vector3d& normal, const Eigen::Vector3d& to_light) noexcept;

/// (R.V)^n with R = 2 (N.L) N - L [Phong75]. 0 where N.L or R.V is not above 0, so that n = 0 gives
/// 1 inside the lobe and 0 outside. N.V does not count: a surface seen from behind keeps its
/// highlight.
double phong_lobe(const Eigen::Vector3d& normal, const Eigen::Vector3d& to_light,
                  const Eigen::Vector3d& to_eye, double n) noexcept;

/// (N.H)^n with H half way between L and V [Blinn77]. 0 where N.L or N.H is not above 0; else as
/// phong_lobe.
double blinn_phong_lobe(const Eigen::Vector3d& normal, const Eigen::Vector3d& to_light,
                        const Eigen::Vector3d& to_eye, double n) noexcept;

/// A shape of the highlight.
struct SpecularModel {
  std::string_view name;
  std::string_view formula;
  std::string_view source;
  double (*lobe)(const Eigen::Vector3d& normal, const Eigen::Vector3d& to_light,
                 const Eigen::Vector3d& to_eye, double n) noexcept;
};

inline constexpr SpecularModel kPhong{"phong", "(R.V)^n", "[Phong75]", phong_lobe};
inline constexpr SpecularModel kBlinnPhong{"blinn-phong", "(N.H)^n", "[Blinn77]", blinn_phong_lobe};

/// Every model. The command line, the docs and the tests read this list.
inline constexpr std::array kSpecularModels{kPhong, kBlinnPhong};

/// ka Ia Od [Shoaff 3.1].
Rgb ambient_reflection(const Material& material, const Rgb& ambient) noexcept;
SpectralColor ambient_reflection(const SpectralMaterial& material,
                                 const SpectralColor& ambient) noexcept;

/// f_att Ip [kd Od (N.L) + ks Os lobe], the light of one source [Shoaff 3.4]; 0 where N.L is not
/// above 0.
Rgb direct_reflection(const Material& material, const SpecularModel& model,
                      const Eigen::Vector3d& normal, const Eigen::Vector3d& to_eye,
                      const Incident& incident) noexcept;
SpectralColor direct_reflection(const SpectralMaterial& material, const SpecularModel& model,
                                const Eigen::Vector3d& normal, const Eigen::Vector3d& to_eye,
                                const SpectralIncident& incident) noexcept;

/// The complete illumination equation at `point`, one source after the other [Shoaff 3.4, 3.7]:
/// ka Ia Od + sum f_att Ip [kd Od (N.L) + ks Os lobe]. `normal` (N) and `to_eye` (V) are unit
/// vectors. No finite input gives NaN; a light of infinite attenuation gives infinity where the
/// surface reflects it.
Rgb shade(const Material& material, const SpecularModel& model, const Eigen::Vector3d& normal,
          const Eigen::Vector3d& to_eye, const Eigen::Vector3d& point, const Rgb& ambient,
          std::span<const Light> lights) noexcept;
SpectralColor shade(const SpectralMaterial& material, const SpecularModel& model,
                    const Eigen::Vector3d& normal, const Eigen::Vector3d& to_eye,
                    const Eigen::Vector3d& point, const SpectralColor& ambient,
                    std::span<const SpectralLight> lights) noexcept;

}  // namespace tristim
