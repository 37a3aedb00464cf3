#include "tristim/light/spectral.h"

#include <gtest/gtest.h>

#include "tristim/core/find.h"
#include "tristim/light/phong.h"

namespace tristim {
namespace {

TEST(Spectral, SamplesAreThoseOfTheRule) {
  EXPECT_EQ(sample_nm(0), 380);
  EXPECT_EQ(sample_nm(kSpectralSamples - 1), 780);
}

TEST(Spectral, WhiteHasALuminanceOfOne) {
  for (const Illuminant& illuminant : illuminants()) {
    SCOPED_TRACE(illuminant.name);
    const SpectralColor white = sampled_illuminant(illuminant);
    EXPECT_EQ(xyz_of_samples(white, white).y, 1);
  }
  const SpectralColor equal = sampled_illuminant(*find_by_name(illuminants(), "e"));
  // The sums of the CIE 1931 functions at 5 nm, over that of ybar.
  EXPECT_NEAR(xyz_of_samples(equal, equal).x, 1.0000092375463026, 1e-15);
  EXPECT_NEAR(xyz_of_samples(equal, equal).z, 1.0000099394381148, 1e-15);
}

TEST(ReflectanceShape, FollowsItsFormula) {
  const auto at = [](std::string_view name, double lambda) {
    return find_by_name(kReflectanceShapes, name)->at(lambda, 0.1, 0.9, 500, 600, 20);
  };
  EXPECT_EQ(at("gauss", 500), 0.9);
  EXPECT_NEAR(at("gauss", 520), 0.1 + 0.8 * 0.60653065971263342, 1e-16);  // e^-1/2
  EXPECT_EQ(at("sigmoid", 500), 0.5);
  EXPECT_NEAR(at("sigmoid", 780), 0.9, 1e-6);
  EXPECT_NEAR(at("double", 600), 0.9 + 0.8 * 3.726653172078671e-6, 1e-15);  // e^-12.5
  EXPECT_EQ(find_by_name(kReflectanceShapes, "double")->at(500, 0.5, 2, 500, 600, 20), 1);
}

TEST(Spectral, ModelsAreThoseOfEachSample) {
  const Eigen::Vector3d up(0, 0, 1);
  const Eigen::Vector3d light(0.6, 0, 0.8);
  const SpectralMaterial material{
      .ka = 0.5, .kd = 0.25, .ks = 0.5, .n = 8, .od = flat_spectrum(0.5)};
  const Material grey{.ka = 0.5, .kd = 0.25, .ks = 0.5, .n = 8, .od = {0.5, 0.5, 0.5}};
  const std::vector<SpectralLight> spectral{
      DirectionalLightOf<SpectralColor>{light, flat_spectrum(3)}};
  const std::vector<Light> rgb{DirectionalLight{light, {3, 3, 3}}};
  for (const SpecularModel& model : kSpecularModels) {
    const SpectralColor color =
        shade(material, model, up, up, Eigen::Vector3d(0, 0, 0), flat_spectrum(2), spectral);
    const Rgb same = shade(grey, model, up, up, Eigen::Vector3d(0, 0, 0), {2, 2, 2}, rgb);
    EXPECT_EQ(color, flat_spectrum(same.g));
  }
}

}  // namespace
}  // namespace tristim
