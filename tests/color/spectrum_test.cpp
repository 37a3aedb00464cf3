#include "tristim/color/spectrum.h"

#include <gtest/gtest.h>

#include <limits>

namespace tristim {
namespace {

TEST(SpectrumFault, NamesWhatIsWrong) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(spectrum_fault({{400, 500}, {1, 2}}), "");
  EXPECT_EQ(spectrum_fault({{}, {}}), "has no sample of at least two");
  EXPECT_EQ(spectrum_fault({{400}, {1}}), "has one sample of at least two");
  EXPECT_EQ(spectrum_fault({{400, 500}, {1}}), "has not as many values as wavelengths");
  EXPECT_EQ(spectrum_fault({{500, 400}, {1, 2}}),
            "has 400 nm behind 500 nm: wavelengths must rise");
  EXPECT_EQ(spectrum_fault({{400, 500, 500}, {1, 2, 3}}), "has 500 nm twice");
  EXPECT_EQ(spectrum_fault({{-400, 500}, {1, 2}}),
            "has the wavelength -400 nm, which is not above 0");
  EXPECT_EQ(spectrum_fault({{0, 500}, {1, 2}}), "has the wavelength 0 nm, which is not above 0");
  EXPECT_EQ(spectrum_fault({{400, kInfinity}, {1, 2}}), "has a wavelength that is inf");
  EXPECT_NE(spectrum_fault({{400, std::numeric_limits<double>::quiet_NaN()}, {1, 2}}), "");
}

TEST(ValueAt, IsLinearBetweenSamplesAndZeroOutside) {
  const Spectrum spectrum{{400, 410, 450}, {1, 3, -1}};
  EXPECT_EQ(value_at(spectrum, 400), 1);
  EXPECT_EQ(value_at(spectrum, 450), -1);
  EXPECT_EQ(value_at(spectrum, 405), 2);
  EXPECT_EQ(value_at(spectrum, 430), 1);
  EXPECT_EQ(value_at(spectrum, 399.999), 0);
  EXPECT_EQ(value_at(spectrum, 450.001), 0);
}

TEST(Sampled, TakesTheRulesWavelengths) {
  const Spectrum ramp{{300, 900}, {300, 900}};
  for (const SumRule& rule : kSumRules) {
    SCOPED_TRACE(rule.name);
    const std::vector<double> values = sampled(ramp, rule);
    ASSERT_EQ(values.size(), rule.count());
    EXPECT_NEAR(values.front(), rule.first_nm, 1e-12);
    EXPECT_NEAR(values.back(), rule.last_nm, 1e-12);
    EXPECT_EQ(rule.lambda_nm(rule.count() - 1), rule.last_nm);
  }
}

}  // namespace
}  // namespace tristim
