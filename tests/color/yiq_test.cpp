#include "tristim/color/yiq.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "lib/core/trigonometry.h"
#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/color/primaries.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

const YiqSystem& system_of(const ExampleRow& row) {
  const YiqSystem* system = find_by_name(kYiqSystems, row.text("matrix"));
  if (system == nullptr) throw std::runtime_error("no such system");
  return *system;
}

TEST(Yiq, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/yiq.csv")) {
    SCOPED_TRACE(row.text("id"));
    const double i0 = row.number("i0");
    const double i1 = row.number("i1");
    const double i2 = row.number("i2");
    double out[3] = {};
    if (row.text("op") == "rgb_to_yiq") {
      const Yiq yiq = rgb_to_yiq({i0, i1, i2}, system_of(row));
      out[0] = yiq.y, out[1] = yiq.i, out[2] = yiq.q;
    } else {
      const EncodedRgb rgb = yiq_to_rgb({i0, i1, i2}, system_of(row));
      out[0] = rgb.r, out[1] = rgb.g, out[2] = rgb.b;
    }
    EXPECT_NEAR(out[0], row.number("o0"), 1e-15);
    EXPECT_NEAR(out[1], row.number("o1"), 1e-15);
    EXPECT_NEAR(out[2], row.number("o2"), 1e-15);
  }
}

TEST(Yiq, MatricesAgreeWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/yiq_matrices.csv")) {
    SCOPED_TRACE(row.text("id"));
    const bool forward = row.text("op") == "rgb_to_yiq";
    const Eigen::Matrix3d m = forward ? yiq_from_rgb(system_of(row)) : rgb_from_yiq(system_of(row));
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const std::string column = "m" + std::to_string(i) + std::to_string(j);
        EXPECT_NEAR(m(i, j), row.number(column), 1e-16 * (forward ? 1 : 5));
      }
    }
  }
}

// The rows of [FCC53] and [SMPTE170M] in R - G and B - G, from I and Q in R - Y and B - Y.
void expect_rows(const YiqSystem& s, double i_by, double i_ry, double q_by, double q_ry) {
  SCOPED_TRACE(s.name);
  EXPECT_NEAR(s.i_r, i_ry * (1 - s.y_r) - i_by * s.y_r, 2e-16);
  EXPECT_NEAR(s.i_b, i_by * (1 - s.y_b) - i_ry * s.y_b, 2e-16);
  EXPECT_NEAR(s.q_r, q_ry * (1 - s.y_r) - q_by * s.y_r, 2e-16);
  EXPECT_NEAR(s.q_b, q_by * (1 - s.y_b) - q_ry * s.y_b, 2e-16);
}

TEST(Yiq, NumbersFollowFromTheDefinitions) {
  const detail::SineCosine turn = detail::sine_cosine_deg(33);
  const double u = 0.492111;
  const double v = 0.877283;
  for (const char* name : {"smpte170m", "ntsc-phosphor"}) {
    expect_rows(*find_by_name(kYiqSystems, name), -u * turn.sine, v * turn.cosine, u * turn.cosine,
                v * turn.sine);
  }
  expect_rows(*find_by_name(kYiqSystems, "fcc1953"), -0.27, 0.74, 0.41, 0.48);
  const YiqSystem& phosphor = *find_by_name(kYiqSystems, "ntsc-phosphor");
  const Eigen::Matrix3d ntsc = xyz_from_rgb(find_by_name(primaries_list(), "ntsc1953")->primaries);
  EXPECT_NEAR(phosphor.y_r, ntsc(1, 0), 2e-16);
  EXPECT_NEAR(phosphor.y_b, ntsc(1, 2), 2e-16);
}

TEST(Yiq, GreysAreExactlyNeutralAndColoursComeBack) {
  for (const YiqSystem& system : kYiqSystems) {
    SCOPED_TRACE(system.name);
    for (int code = 0; code <= 255; ++code) {
      const double v = code / 255.0;
      EXPECT_EQ(rgb_to_yiq({v, v, v}, system), (Yiq{v, 0, 0}));
      EXPECT_EQ(yiq_to_rgb({v, 0, 0}, system), (EncodedRgb{v, v, v}));
    }
    const EncodedRgb rgb{0.9, -0.2, 0.4};
    const EncodedRgb back = yiq_to_rgb(rgb_to_yiq(rgb, system), system);
    EXPECT_NEAR(back.r, rgb.r, 1e-15);
    EXPECT_NEAR(back.g, rgb.g, 1e-15);
    EXPECT_NEAR(back.b, rgb.b, 1e-15);
    EXPECT_TRUE(std::isnan(rgb_to_yiq({0.5, 0.5, std::nan("")}, system).y));
    EXPECT_TRUE((rgb_from_yiq(system) * yiq_from_rgb(system)).isIdentity(1e-15));
  }
}

}  // namespace
}  // namespace tristim
