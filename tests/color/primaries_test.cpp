#include "tristim/color/primaries.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tests/error_text.h"
#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d white_of(const Primaries& primaries) {
  const Xyz w = white_xyz(primaries.white);
  return {w.x, w.y, w.z};
}

const Primaries& named(std::string_view name) {
  const NamedPrimaries* set = find_by_name(primaries_list(), name);
  if (set == nullptr) throw std::runtime_error("no primaries " + std::string(name));
  return set->primaries;
}

Matrix3d rows(std::initializer_list<double> values) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.begin());
}

double largest(const Eigen::MatrixXd& m) { return m.cwiseAbs().maxCoeff(); }

TEST(XyzFromRgb, MakesTheWhiteOfEverySet) {
  for (const NamedPrimaries& set : primaries_list()) {
    SCOPED_TRACE(set.name);
    const Matrix3d xyz_from = xyz_from_rgb(set.primaries);
    const Matrix3d rgb_from = rgb_from_xyz(set.primaries);
    EXPECT_EQ(xyz_from * Vector3d::Ones(), white_of(set.primaries));
    EXPECT_LE(largest(rgb_from * white_of(set.primaries) - Vector3d::Ones()), 2e-16);
    EXPECT_LE(largest(rgb_from * xyz_from - Matrix3d::Identity()), 4e-15 * largest(rgb_from));
  }
}

TEST(XyzFromRgb, HasTheChromaticitiesInItsColumns) {
  for (const NamedPrimaries& set : primaries_list()) {
    SCOPED_TRACE(set.name);
    const Matrix3d m = xyz_from_rgb(set.primaries);
    const Chromaticity phosphors[] = {set.primaries.red, set.primaries.green, set.primaries.blue};
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(m(0, i) / m.col(i).sum(), phosphors[i].x, 1e-15);
      EXPECT_NEAR(m(1, i) / m.col(i).sum(), phosphors[i].y, 1e-15);
    }
  }
}

// Solved in exact fractions from the published decimals, then rounded once; ours may be moved by
// a last bit or two for the sake of the white.
TEST(XyzFromRgb, AgreesWithExactFractions) {
  const Matrix3d srgb = rows({0.4123907992659595, 0.35758433938387796, 0.1804807884018343,   //
                              0.21263900587151036, 0.7151686787677559, 0.07219231536073371,  //
                              0.01933081871559185, 0.11919477979462599, 0.9505321522496606});
  EXPECT_LE(largest(xyz_from_rgb(Primaries{}) - srgb), 4.5e-16);
  EXPECT_EQ(xyz_from_rgb(named("srgb")), xyz_from_rgb(Primaries{}));
  const Matrix3d ntsc = rows({0.60699283073821, 0.17344852694074156, 0.2005713005488966,  //
                              0.29896661812479, 0.5864212101329834, 0.11461217174222663,  //
                              0.0, 0.0660756293107587, 1.1174686744867097});
  EXPECT_LE(largest(xyz_from_rgb(named("ntsc-1953")) - ntsc), 4.5e-16);
}

TEST(XyzFromRgb, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row :
       example_rows(*shared / "spec/colour-examples/rgb_xyz_matrices.csv")) {
    SCOPED_TRACE(row.text("primaries"));
    const Primaries& set = named(row.text("primaries"));
    const Matrix3d ours = row.text("op") == "rgb_to_xyz" ? xyz_from_rgb(set) : rgb_from_xyz(set);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const std::string column = "m" + std::to_string(i) + std::to_string(j);
        EXPECT_NEAR(ours(i, j), row.number(column), 4e-15 * largest(ours));  // the file's tolerance
      }
    }
  }
}

TEST(XyzFromRgb, RejectsCollinearPhosphors) {
  const Primaries line{{0.2, 0.3}, {0.3, 0.4}, {0.4, 0.5}, kD65};
  const char* text = "invalid: primaries: the three chromaticities lie on a line";
  EXPECT_EQ(error_text([&] { xyz_from_rgb(line); }), text);
  EXPECT_EQ(error_text([&] { rgb_from_xyz(line); }), text);
  EXPECT_EQ(error_text([&] { rgb_from_rgb({}, line, Adaptation::kNone); }), text);
  EXPECT_THROW(xyz_from_rgb({{0.3, 0.3}, {0.3, 0.3}, {0.1, 0.1}, kD65}), std::invalid_argument);
}

TEST(XyzFromRgb, RejectsAWhiteWithoutLuminance) {
  Primaries primaries;
  primaries.white.y = 0;
  EXPECT_EQ(error_text([&] { xyz_from_rgb(primaries); }),
            "invalid: white: y must be finite and not 0");
}

TEST(WhiteFromLuminances, UndoesTheMatrix) {
  for (const NamedPrimaries& set : primaries_list()) {
    SCOPED_TRACE(set.name);
    const Eigen::RowVector3d y = xyz_from_rgb(set.primaries).row(1) * 80;  // cd/m2, any unit
    const Chromaticity white = white_from_luminances(set.primaries, y[0], y[1], y[2]);
    // 1e-15 over the smallest y of a phosphor, 1e-4, by which luminances are divided.
    EXPECT_NEAR(white.x, set.primaries.white.x, 1e-12);
    EXPECT_NEAR(white.y, set.primaries.white.y, 1e-12);
  }
}

TEST(WhiteFromLuminances, RejectsDarkness) {
  EXPECT_EQ(error_text([] { white_from_luminances({}, 0, 0, 0); }),
            "invalid: luminances: their sum must be above 0");
  EXPECT_THROW(white_from_luminances({}, -1, 0.5, 0.2), std::invalid_argument);
}

TEST(RgbFromRgb, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/rgb_rgb.csv")) {
    SCOPED_TRACE(row.text("id"));
    const AdaptationMethod* method = find_by_name(kAdaptations, row.text("adapt"));
    ASSERT_NE(method, nullptr) << row.text("adapt");
    const Vector3d in(row.number("i0"), row.number("i1"), row.number("i2"));
    const Vector3d out =
        rgb_from_rgb(named(row.text("to")), named(row.text("from")), method->method) * in;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(out[i], row.number("o" + std::to_string(i)), 1.1e-14);  // the file's tolerance
    }
  }
}

TEST(RgbFromRgb, KeepsWhiteWhereItAdapts) {
  for (const NamedPrimaries& from : primaries_list()) {
    for (const NamedPrimaries& to : primaries_list()) {
      const Matrix3d m = rgb_from_rgb(to.primaries, from.primaries, Adaptation::kBradford);
      SCOPED_TRACE(testing::Message() << from.name << " " << to.name);
      EXPECT_EQ(m * Vector3d::Ones(), Vector3d::Ones());
      if (from.primaries == to.primaries) {
        EXPECT_EQ(m, Matrix3d::Identity());
      }
    }
  }
}

// Monitor to monitor as the document has it: M2^-1 M1, and the white moves.
TEST(RgbFromRgb, MovesTheWhiteWithoutAdaptation) {
  const Primaries& ntsc = named("ntsc-1953");
  const Matrix3d m = rgb_from_rgb(ntsc, Primaries{}, Adaptation::kNone);
  EXPECT_LE(largest(m - rgb_from_xyz(ntsc) * xyz_from_rgb(Primaries{})), 1e-15);
  // In 50 digits.
  const Vector3d white(0.9688738766248713, 1.0327728624209664, 0.9135080537351388);
  EXPECT_LE(largest(m * Vector3d::Ones() - white), 2.3e-16);
}

}  // namespace
}  // namespace tristim
