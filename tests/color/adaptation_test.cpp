#include "tristim/color/adaptation.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d vector(Chromaticity white) {
  const Xyz w = white_xyz(white);
  return {w.x, w.y, w.z};
}

double largest(const Eigen::MatrixXd& m) { return m.cwiseAbs().maxCoeff(); }

struct Golden {
  Adaptation method;
  Chromaticity from, to;
  double entries[9];
};

// Solved in 50 digits from the published decimals.
constexpr Chromaticity kA{0.44758, 0.40745};
constexpr Golden kGolden[] = {
    {Adaptation::kCat02,
     kD65,
     kD50,
     {1.042573892411199, 0.030891075263705154, -0.052812565931937426,  //
      0.022193451065251966, 1.001856632807238, -0.021073749209281611,  //
      -0.0011648800532352001, -0.0034205274827750921, 0.7617890755244797}},
    {Adaptation::kCat16,
     kD65,
     kD50,
     {1.0108543289379336, 0.040708610323500833, -0.0341445825006862,      //
      0.0054281420123078743, 0.99358192619306478, 0.0011559203885934037,  //
      0.00025072246811704448, -0.011491875891322773, 0.76796494691154456}},
    {Adaptation::kVonKries,
     kD65,
     kA,
     {1.0710902307462808, 0.2441529756017983, -0.15030095636568416,       //
      0.026818472679795131, 0.98040334011984533, -0.0054112065487051381,  //
      0, 0, 0.32670283757371729}},
    {Adaptation::kBradford,
     kA,
     kD65,
     {0.8446689780364757, -0.11795009010772295, 0.39501338554204021,  //
      -0.13664965786836733, 1.1041266252750911, 0.12923543078145813,  //
      0.079893692237706045, -0.13497785972815458, 3.1935882646174834}},
    {Adaptation::kXyzScaling,
     kD65,
     kD50,
     {1.0145611689968908, 0, 0, 0, 1, 0, 0, 0, 0.7576316333406124}},
};

TEST(AdaptationMatrix, AgreesWithFiftyDigits) {
  for (const Golden& golden : kGolden) {
    SCOPED_TRACE(static_cast<int>(golden.method));
    const Matrix3d exact =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(golden.entries);
    const Matrix3d ours = adaptation_matrix(golden.from, golden.to, golden.method);
    EXPECT_LE(largest(ours - exact), 5e-16 * largest(exact));  // largest over all whites: 2.1e-16
  }
}

TEST(AdaptationMatrix, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/adaptation.csv")) {
    SCOPED_TRACE(row.text("id"));
    const std::string name =
        row.text("method") == "vonkries_hpe" ? "von-kries" : row.text("method");
    const AdaptationMethod* method = find_by_name(kAdaptations, name);
    const WhitePoint* from = find_by_name(kWhitePoints, row.text("from"));
    const WhitePoint* to = find_by_name(kWhitePoints, row.text("to"));
    ASSERT_TRUE(method != nullptr && from != nullptr && to != nullptr);
    const Vector3d in(row.number("i0"), row.number("i1"), row.number("i2"));
    const Vector3d out(row.number("o0"), row.number("o1"), row.number("o2"));
    const Vector3d ours =
        adaptation_matrix(from->chromaticity, to->chromaticity, method->method) * in;
    EXPECT_LE(largest(ours - out), row.text("kind") == "white" ? 2e-16 : 2e-15 * largest(out));
  }
}

TEST(AdaptationMatrix, CarriesWhiteToWhite) {
  for (const AdaptationMethod& method : kAdaptations) {
    if (method.method == Adaptation::kNone) continue;
    for (const WhitePoint& from : kWhitePoints) {
      for (const WhitePoint& to : kWhitePoints) {
        SCOPED_TRACE(testing::Message() << method.name << " " << from.name << " " << to.name);
        const Matrix3d m = adaptation_matrix(from.chromaticity, to.chromaticity, method.method);
        const Vector3d adapted = m * vector(from.chromaticity);
        EXPECT_LE(largest(adapted - vector(to.chromaticity)), 2e-16);  // largest measured: 1.2e-16
        if (from.name == to.name) {
          EXPECT_EQ(m, Matrix3d::Identity());
        }
      }
    }
  }
}

TEST(AdaptationMatrix, NoneLeavesXyzAlone) {
  EXPECT_EQ(adaptation_matrix(kD50, kD65, Adaptation::kNone), Matrix3d::Identity());
}

// [CSS4 sample code] D65_to_D50, the same whites.
TEST(AdaptationMatrix, AgreesWithCss) {
  Matrix3d css;
  css << 1.0479297925449969, 0.022946870601609652, -0.05019226628920524,  //
      0.02962780877005599, 0.9904344267538799, -0.017073799063418826,     //
      -0.009243040646204504, 0.015055191490298152, 0.7518742814281371;
  EXPECT_LE(largest(adaptation_matrix(kD65, kD50, Adaptation::kBradford) - css), 5e-16);
}

TEST(AdaptationMatrix, RejectsAWhiteWithoutLuminance) {
  EXPECT_THROW(adaptation_matrix({0.3, 0}, kD65, Adaptation::kBradford), std::invalid_argument);
  EXPECT_THROW(adaptation_matrix(kD65, {0.3, 0}, Adaptation::kNone), std::invalid_argument);
}

}  // namespace
}  // namespace tristim
