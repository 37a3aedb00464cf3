#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/error_text.h"
#include "tristim/color/conversion.h"

namespace tristim {
namespace {

Components convert(const std::string& from, const std::string& to, const Components& c) {
  return ColorConversion(parse_model(from, "--from"), parse_model(to, "--to"),
                         Adaptation::kBradford)(c);
}

TEST(LightModels, ReadAndMakeTemperatures) {
  const Components white = convert("rgb", "cct", {1, 1, 1});
  EXPECT_NEAR(white[0], 6504.34, 0.01);
  EXPECT_NEAR(white[1], 0.0032, 5e-5);
  EXPECT_NEAR(white[2], 1, 1e-15);
  const Components back = convert("cct", "rgb", white);
  for (const std::size_t i : {0U, 1U, 2U}) EXPECT_NEAR(back[i], 1, 1e-12);
  EXPECT_NEAR(convert("planckian", "cct", {2856})[0], 2856, 1e-6);
  EXPECT_TRUE(std::isnan(convert("planckian", "xyz", {0})[0]));
  EXPECT_TRUE(std::isnan(convert("daylight", "xyz", {3999})[0]));
  EXPECT_NEAR(convert("daylight", "xyy", {6504})[0], 0.3127, 5e-5);
  EXPECT_EQ(convert("daylight", "xyz", {6504})[1], 1);
}

TEST(LightModels, TakeTheRadiationConstant) {
  const Components red = convert("planckian:c2=0.014387768775039338", "xyy", {800});
  EXPECT_NEAR(red[0], 0.6813342745175867, 1e-14);
  EXPECT_NEAR(red[1], 0.31793139694568917, 1e-14);
  // Illuminant A is 2848 K where c2 = .01435, 2856 K today.
  EXPECT_NEAR(convert("planckian:c2=0.01435", "cct", {2848})[0], 2855.54, 0.01);
}

TEST(LightModels, SeeWavelengthsFromTheWhite) {
  const Components d = convert("xyy@c", "wavelength", {0.3562559261602548, 0.3163369651148506, 1});
  EXPECT_NEAR(d[0], 615.8651043255413, 1e-9);
  EXPECT_NEAR(d[1], 490.91587323213395, 1e-9);
  EXPECT_NEAR(d[2], 0.1241212147657984, 1e-13);
  EXPECT_NEAR(d[3], 0.12461119857078276, 1e-13);
}

// Greys have no wavelength and no purity, whatever the primaries.
TEST(LightModels, GreysHaveNoWavelength) {
  for (const NamedPrimaries& set : primaries_list()) {
    SCOPED_TRACE(set.name);
    for (const double v : {0.003, 0.25, 1.0}) {
      const Components d = convert("rgb:" + std::string(set.name), "wavelength", {v, v, v});
      EXPECT_TRUE(std::isnan(d[0]) && std::isnan(d[1]));
      EXPECT_EQ(d[2], 0);
      EXPECT_EQ(d[3], 0);
    }
  }
}

TEST(LightModels, GoOneWayOnly) {
  EXPECT_NE(error_text([] { convert("wavelength", "rgb", {500, 0, 1, 1}); }), "");
  EXPECT_NE(error_text([] { convert("rgb", "planckian", {1, 1, 1}); }), "");
}

}  // namespace
}  // namespace tristim
