#include <gtest/gtest.h>
#include <lcms2.h>

#include "tests/lut/io/ocio_peer.h"
#include "tests/lut/io/tables.h"
#include "tests/support.h"
#include "tristim/color/adaptation.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"

namespace tristim {
namespace {

const LutFormat& format(std::string_view name) { return *find_by_name(lut_formats(), name); }

/// The most by which OpenColorIO differs from us over a file, within [low, high].
double difference(const Lut& lut, const std::string& path, double low, double high) {
  const OcioPeer peer(path);
  std::mt19937 generator(11);
  std::uniform_real_distribution<float> any(static_cast<float>(low), static_cast<float>(high));
  double most = 0;
  for (int i = 0; i < 3000; ++i) {
    const Rgb in{any(generator), any(generator), any(generator)};
    const Rgb a = peer(in);
    const Rgb b = evaluate(lut, in);
    for (const double d : {a.r - b.r, a.g - b.g, a.b - b.b}) most = std::max(most, std::fabs(d));
  }
  return most;
}

// OpenColorIO computes in floats: places in a table of 256 entries that rises and falls by 1
// between neighbours are known to 256 half bits. Largest difference measured: 3.5e-5.
constexpr double kFloats = 6e-5;

class LutPeers : public testing::TestWithParam<const char*> {};

TEST_P(LutPeers, OpenColorIoReadsEveryTableThatWeWrite) {
  const TemporaryDirectory scratch;
  const std::string name = GetParam();
  int count = 0;
  for (const Lut& lut : test_luts(format(name))) {
    if (lut.steps.empty()) continue;
    const bool bent = name == "csp" && lut.steps.size() == 2;
    if (bent || std::holds_alternative<LutPoints>(lut.steps[0])) continue;  // see the next test
    const std::string extension(format(name).extensions);
    const std::string path = scratch.file(std::to_string(count++) + "." + extension);
    write_bytes(path, lut_bytes(lut, format(name), path));
    SCOPED_TRACE(path + " with " + std::to_string(lut.steps.size()));
    EXPECT_LE(difference(lut, path, -0.25, 2), kFloats * (lut.steps.size() == 3 ? 1e5 : 1));
  }
  EXPECT_GT(count, 2);
}

INSTANTIATE_TEST_SUITE_P(AllThatItReads, LutPeers,
                         testing::Values("cube", "resolve", "spi1d", "spi3d", "3dl", "csp", "clf",
                                         "ctf"));

// OpenColorIO bends a spline through the curve in front of a Cinespace table, where we and
// Cinespace join its points by straight lines: the same to the square of their distance.
TEST(LutPeers, CspShapersAreTheSameWhereTheyAreSmooth) {
  const TemporaryDirectory scratch;
  Lut1D shaper{{{-1, 0, 0.5}, {3, 1, 2}}, 1024, {}};
  for (int i = 0; i < shaper.size; ++i) {
    const float x = static_cast<float>(i) / static_cast<float>(shaper.size - 1);
    shaper.rgb.insert(shaper.rgb.end(), {x * x, x * (2 - x), (x + x * x * x) / 2});
  }
  LutPoints points;
  for (LutCurve& curve : points.curves) {
    for (int i = 0; i <= 1000; ++i) {
      const float x = static_cast<float>(i * i) * 1e-6F;
      curve.in.push_back(2 * x);
      curve.out.push_back(x * x);
    }
  }
  Lut3D identity{{}, 2, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1}};
  for (const LutStep& first : {LutStep(shaper), LutStep(points)}) {
    const Lut lut{"", {first, identity}};
    const std::string path = scratch.file(std::to_string(first.index()) + ".csp");
    write_bytes(path, lut_bytes(lut, format("csp"), path));
    EXPECT_LE(difference(lut, path, -1.5, 3.5), 2e-5);  // it samples the spline 65536 times
  }
}

TEST(LutPeers, LittleCmsReadsTheCurvesOfAProfile) {
  const TemporaryDirectory scratch;
  const Lut lut{"A display", {test_curves(256, 16)}};
  const std::string bytes = lut_bytes(lut, format("icc"), "x.icc");
  cmsHPROFILE profile =
      cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size()));
  ASSERT_NE(profile, nullptr);
  EXPECT_EQ(cmsGetDeviceClass(profile), cmsSigDisplayClass);
  EXPECT_EQ(cmsGetColorSpace(profile), cmsSigRgbData);
  const auto* curves = static_cast<cmsToneCurve**>(cmsReadTag(profile, cmsSigVcgtTag));
  ASSERT_NE(curves, nullptr);
  for (cmsUInt32Number i = 0; i < 256; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = std::get<Lut1D>(lut.steps[0]).rgb[3 * i + c];
      EXPECT_EQ(cmsGetToneCurveEstimatedTable(curves[c])[i], std::lround(value * 65535));
    }
  }
  cmsCloseProfile(profile);
}

// White of a profile is D50 by definition, in X, Y, Z of four digits.
TEST(LutPeers, ProfilesHaveThePrimariesOfTheDisplay) {
  const Display display = load_display("crt-p22");
  const Lut lut{"", {test_curves(16, 16)}};
  const std::string bytes = lut_bytes(lut, format("icc"), "x.icc", {.display = &display});
  EXPECT_EQ(bytes, lut_bytes(lut, format("icc"), "x.icc", {.display = &display}));
  cmsHPROFILE profile =
      cmsOpenProfileFromMem(bytes.data(), static_cast<cmsUInt32Number>(bytes.size()));
  ASSERT_NE(profile, nullptr);
  cmsHPROFILE xyz = cmsCreateXYZProfile();
  cmsHTRANSFORM transform = cmsCreateTransform(profile, TYPE_RGB_DBL, xyz, TYPE_XYZ_DBL,
                                               INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOOPTIMIZE);
  ASSERT_NE(transform, nullptr);
  for (const Rgb& rgb : {Rgb{1, 1, 1}, Rgb{1, 0, 0}, Rgb{0, 0.5, 0}}) {
    const double in[] = {rgb.r, rgb.g, rgb.b};
    double out[3];
    cmsDoTransform(transform, in, out, 1);
    const auto light = [&](double code) {
      const double black = light_of_code(display.response, 0, 1);
      return (light_of_code(display.response, code, 1) - black) / (1 - black);
    };
    const Eigen::Vector3d expected =
        adaptation_matrix(display.primaries.white, kD50, Adaptation::kBradford) *
        xyz_from_rgb(display.primaries) * Eigen::Vector3d(light(rgb.r), light(rgb.g), light(rgb.b));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(out[i], expected(i), 3e-4);
  }
  cmsDeleteTransform(transform);
  cmsCloseProfile(xyz);
  cmsCloseProfile(profile);
}

}  // namespace
}  // namespace tristim
