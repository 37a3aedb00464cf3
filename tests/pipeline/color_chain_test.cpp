#include "tristim/pipeline/color_chain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"

namespace tristim {
namespace {

// What process does with floats of the same colours, before it rounds to a code.
TEST(ColorChain, IsTheStagesAndTheResponse) {
  const Display crt = load_display("crt-p22");
  Settings settings;
  settings.exposure_stops = 0.5;
  settings.tone = &kToneOperators[0];
  settings.tone_white = 3;
  const ColorChain chain(Primaries{}, crt, settings);
  for (const Rgb in : {Rgb{0.1, 0.2, 0.3}, Rgb{1, 0, 0}, Rgb{0, 0, 0}, Rgb{2, 1.5, 0.01}}) {
    float pixel[] = {static_cast<float>(in.r), static_cast<float>(in.g), static_cast<float>(in.b)};
    StageCounts counts;
    for (const Stage& stage : chain.stages()) apply(stage, {{pixel, 1, 1, 3, 3}, 0}, counts);
    const DisplayDrive drive(crt, BlackPoint::kRelative);
    const EncodedRgb expected = drive.drive({pixel[0], pixel[1], pixel[2]});
    const EncodedRgb found = chain(in);
    EXPECT_NEAR(found.r, expected.r, 2e-7);
    EXPECT_NEAR(found.g, expected.g, 2e-7);
    EXPECT_NEAR(found.b, expected.b, 2e-7);
  }
}

TEST(DisplayDrive, LeadsThereAndBack) {
  for (const char* name : {"srgb", "crt-p22", "lcd-rgb565"}) {
    SCOPED_TRACE(name);
    const DisplayDrive drive(load_display(name), BlackPoint::kRelative);
    const EncodedRgb codes = drive.drive({0.25, 0.5, 0.75});
    const Rgb back = drive.picture(codes);
    EXPECT_NEAR(back.r, 0.25, 1e-14);
    EXPECT_NEAR(back.g, 0.5, 1e-14);
    EXPECT_NEAR(back.b, 0.75, 1e-14);
    EXPECT_EQ(drive.drive({1, 1, 1}), (EncodedRgb{1, 1, 1}));
  }
}

TEST(DisplayDrive, RefusesPalettes) {
  for (const char* name : {"vga16", "epaper-7color", "offset-cmyk"}) {
    EXPECT_THROW(DisplayDrive(load_display(name), BlackPoint::kRelative), Error) << name;
  }
}

TEST(ColorChain, ShowsWhatTheDisplayShows) {
  const ColorChain chain(Primaries{}, load_display("srgb"), {});
  const Lab white = chain.appearance({1, 1, 1});
  EXPECT_NEAR(white.l, 100, 1e-12);
  EXPECT_NEAR(white.a, 0, 1e-12);
  EXPECT_NEAR(white.b, 0, 1e-12);
  EXPECT_NEAR(chain.appearance(chain({0.18, 0.18, 0.18})).l, 49.496, 0.001);
}

}  // namespace
}  // namespace tristim
