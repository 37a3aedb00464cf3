#include "tristim/color/wavelength.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/example_rows.h"
#include "tests/support.h"

namespace tristim {
namespace {

constexpr Chromaticity kC{0.31006, 0.31616};
constexpr Chromaticity kE{1.0 / 3, 1.0 / 3};

void expect_number(double value, const std::string& text, double tolerance) {
  if (text == "undef") {
    EXPECT_TRUE(std::isnan(value)) << value;
  } else {
    EXPECT_NEAR(value, std::stod(text), tolerance);
  }
}

// Wavelengths within the file's tolerance (.01 nm but at the ends); purities 1e-12 as the same
// locus makes them.
TEST(DominantWavelength, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  const auto path = *shared / "spec/colour-examples/dominant_wavelength.csv";
  for (const ExampleRow& row : example_rows(path)) {
    SCOPED_TRACE(row.text("id"));
    const DominantWavelength d = dominant_wavelength({row.number("x"), row.number("y")},
                                                     {row.number("xw"), row.number("yw")});
    expect_number(d.dominant_nm, row.text("lambda_nm"), 1e-9);
    expect_number(d.complementary_nm, row.text("complementary_nm"), 1e-9);
    expect_number(d.excitation_purity, row.text("p_e"), 1e-12);
    expect_number(d.colorimetric_purity, row.text("p_c"), 1e-12);
  }
}

TEST(DominantWavelength, HasGoldenValues) {
  const DominantWavelength a = dominant_wavelength({0.3562559261602548, 0.3163369651148506}, kC);
  EXPECT_NEAR(a.dominant_nm, 615.8651043255413, 1e-9);
  EXPECT_NEAR(a.complementary_nm, 490.91587323213395, 1e-9);
  EXPECT_NEAR(a.excitation_purity, 0.1241212147657984, 1e-14);
  EXPECT_NEAR(a.colorimetric_purity, 0.12461119857078276, 1e-14);
  const DominantWavelength green = dominant_wavelength({0.265, 0.69}, kD65);  // of Display P3
  EXPECT_NEAR(green.dominant_nm, 544.1677314488744, 1e-9);
  EXPECT_TRUE(std::isnan(green.complementary_nm));
  EXPECT_NEAR(green.colorimetric_purity, 0.9530062928706644, 1e-14);
}

TEST(DominantWavelength, OfSpectralLightIsItsOwn) {
  for (int lambda = kLocusFirstNm; lambda <= 698; ++lambda) {
    const DominantWavelength d = dominant_wavelength(spectral_locus(lambda), kE);
    EXPECT_NEAR(d.dominant_nm, lambda, 1e-6);
    EXPECT_NEAR(d.excitation_purity, 1, 1e-14);
    EXPECT_NEAR(d.colorimetric_purity, 1, 1e-12);
  }
}

TEST(DominantWavelength, OfAPurpleIsMinusTheComplementary) {
  const Chromaticity red = spectral_locus(700);
  const Chromaticity violet = spectral_locus(380);
  const Chromaticity on_line{(red.x + violet.x) / 2, (red.y + violet.y) / 2};
  const DominantWavelength d = dominant_wavelength(on_line, kE);
  EXPECT_LT(d.dominant_nm, -490);
  EXPECT_GT(d.dominant_nm, -570);
  EXPECT_NEAR(d.excitation_purity, 1, 1e-14);
  EXPECT_TRUE(std::isnan(d.complementary_nm));
  EXPECT_TRUE(std::isnan(d.colorimetric_purity));
}

TEST(DominantWavelength, OfTheWhiteIsNone) {
  for (const Chromaticity c : {kE, Chromaticity{kE.x + 1e-16, kE.y - 2e-16}}) {
    const DominantWavelength d = dominant_wavelength(c, kE);
    EXPECT_TRUE(std::isnan(d.dominant_nm) && std::isnan(d.complementary_nm));
    EXPECT_EQ(d.excitation_purity, 0);
    EXPECT_EQ(d.colorimetric_purity, 0);
  }
}

TEST(DominantWavelength, IsNotClampedOutside) {
  const DominantWavelength d = dominant_wavelength({0.05, 0.9}, kE);
  EXPECT_GT(d.excitation_purity, 1);
  EXPECT_GT(d.dominant_nm, 500);
}

TEST(DominantWavelength, PassesNanAndLeavesStrangeWhites) {
  const double nan = std::nan("");
  EXPECT_TRUE(std::isnan(dominant_wavelength({nan, 0.3}, kE).excitation_purity));
  EXPECT_TRUE(std::isnan(dominant_wavelength({0.3, 0.3}, {0.3, nan}).dominant_nm));
  EXPECT_TRUE(std::isnan(dominant_wavelength({3, 3}, {2, 2}).excitation_purity));
}

TEST(ChromaticityOfWavelength, InvertsEveryColor) {
  for (double x = 0.05; x < 0.7; x += 0.031) {
    for (double y = 0.02; y < 0.8; y += 0.029) {
      const DominantWavelength d = dominant_wavelength({x, y}, kD65);
      const Chromaticity back =
          chromaticity_of_wavelength(d.dominant_nm, d.excitation_purity, kD65);
      EXPECT_NEAR(back.x, x, 1e-13);
      EXPECT_NEAR(back.y, y, 1e-13);
    }
  }
  EXPECT_EQ(chromaticity_of_wavelength(std::nan(""), 0, kD65), kD65);
  EXPECT_TRUE(std::isnan(chromaticity_of_wavelength(379, 0.5, kD65).x));
  EXPECT_TRUE(std::isnan(chromaticity_of_wavelength(-600, 0.5, kD65).x));  // its opposite is green
}

TEST(SpectralLocus, IsTheTable) {
  const Chromaticity c = spectral_locus(520);
  EXPECT_NEAR(c.x, 0.0743, 5e-5);  // [CIE15] as printed to four decimals
  EXPECT_NEAR(c.y, 0.8338, 5e-5);
  EXPECT_NEAR(spectral_locus(520.5).x, (c.x + spectral_locus(521).x) / 2, 1e-16);
  EXPECT_TRUE(std::isnan(spectral_locus(379.9).x));
  EXPECT_TRUE(std::isnan(spectral_locus(700.1).x));
}

}  // namespace
}  // namespace tristim
