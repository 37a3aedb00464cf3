#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/support.h"
#include "tristim/color/hsv.h"
#include "tristim/color/transfer.h"
#include "tristim/image/io/exr.h"
#include "tristim/image/io/read.h"

namespace tristim {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// One row of pixels as an EXR file of floats.
void write_row(const std::string& path, std::vector<float> samples, int channels,
               Primaries primaries = {}) {
  PictureInfo info;
  info.width = static_cast<int>(samples.size()) / channels;
  info.height = 1;
  info.channels = channels;
  info.primaries = primaries;
  const auto sink = open_exr_sink(path, info, {.pixel = ExrPixel::kFloat});
  sink->write({samples.data(), info.width, 1, channels, std::ptrdiff_t{info.width} * channels});
  sink->finish();
}

std::vector<float> read_all(const std::string& path) {
  const auto source = open_picture(path);
  const PictureInfo& info = source->info();
  Image image(info.width, info.height, info.channels);
  source->read(image.view());
  std::vector<float> all;
  for (int y = 0; y < info.height; ++y) {
    all.insert(all.end(), image.view().row(y).begin(), image.view().row(y).end());
  }
  return all;
}

std::vector<float> converted(std::vector<std::string> options, const std::vector<float>& in,
                             int channels = 3, Primaries primaries = {}) {
  const TemporaryDirectory directory;
  write_row(directory.file("in.exr"), in, channels, primaries);
  options.insert(options.begin(), "convert");
  options.insert(options.end(), {directory.file("in.exr"), "-o", directory.file("out.exr")});
  const CommandResult result = run_tristim(options);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return read_all(directory.file("out.exr"));
}

TEST(ConvertPicture, TakesPixelsAsColorsOfTheModel) {
  const std::vector<float> in{1, 0.5F, 0.25F, 0.1F, 0.7F, -0.2F};
  const std::vector<float> out = converted({"--from", "rgb:srgb", "--to", "hsv"}, in);
  for (std::size_t i = 0; i < in.size(); i += 3) {
    const Hsv hsv = rgb_to_hsv({in[i], in[i + 1], in[i + 2]});
    EXPECT_EQ(out[i], static_cast<float>(hsv.h));
    EXPECT_EQ(out[i + 1], static_cast<float>(hsv.s));
    EXPECT_EQ(out[i + 2], static_cast<float>(hsv.v));
  }
}

TEST(ConvertPicture, HasHuesOfZeroOrNan) {
  const std::vector<float> in{0.5F, 0.5F, 0.5F, 0, 0, 0};
  EXPECT_EQ(converted({"--from", "rgb", "--to", "hsv"}, in),
            (std::vector<float>{0, 0, 0.5F, 0, 0, 0}));
  const std::vector<float> kept =
      converted({"--from", "rgb", "--to", "hsv", "--undefined", "nan"}, in);
  EXPECT_TRUE(std::isnan(kept[0]) && std::isnan(kept[3]));
  EXPECT_EQ(kept[2], 0.5F);
}

TEST(ConvertPicture, KeepsAlphaNanAndInfinity) {
  const std::vector<float> out =
      converted({"--from", "linear", "--to", "rgb"},
                {kNan, 0.5F, kInfinity, 0.25F, 1, 0, -kInfinity, kNan}, 4);
  ASSERT_EQ(out.size(), 8);
  EXPECT_TRUE(std::isnan(out[0]));
  EXPECT_EQ(out[1], static_cast<float>(srgb_encode(0.5)));
  EXPECT_EQ(out[2], kInfinity);
  EXPECT_EQ(out[3], 0.25F);
  EXPECT_EQ(out[6], -kInfinity);
  EXPECT_TRUE(std::isnan(out[7]));
}

TEST(ConvertPicture, IsLightOfTheFilesPrimariesUnlessNamed) {
  const Primaries wide{{0.708, 0.292}, {0.17, 0.797}, {0.131, 0.046}, kD65};
  const std::vector<float> in{0.2F, 0.4F, 0.6F};
  const std::vector<float> out = converted({"--to", "xyz"}, in, 3, wide);
  const Eigen::Vector3d xyz = xyz_from_rgb(wide) * Eigen::Vector3d(0.2, 0.4, 0.6);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(out[static_cast<std::size_t>(i)], xyz[i], 1e-7);
}

TEST(ConvertPicture, CountsCodesFromZeroToOne) {
  const TemporaryDirectory directory;
  write_bytes(directory.path() / "in.ppm", std::string("P6 1 1 255\n\xff\x80\x00", 14));
  const CommandResult result =
      run_tristim({"convert", "--from", "rgb:srgb", "--to", "cmy", directory.file("in.ppm"), "-o",
                   directory.file("out.exr")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::vector<float> out = read_all(directory.file("out.exr"));
  EXPECT_NEAR(out[0], 0, 1e-7);
  EXPECT_NEAR(out[1], 1 - 128 / 255.0, 1e-7);
  EXPECT_EQ(out[2], 1);
}

TEST(ConvertPicture, SaysWhatItCannotDo) {
  const TemporaryDirectory directory;
  write_row(directory.file("in.exr"), {0, 0, 0}, 3);
  const auto fails = [&](std::vector<std::string> options, int code, const std::string& text) {
    options.insert(options.begin(), "convert");
    const CommandResult result = run_tristim(options);
    EXPECT_EQ(result.exit_code, code);
    EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
  };
  const std::string in = directory.file("in.exr");
  fails({"--to", "hsv", in, "-o", directory.file("out.png")}, 2, "does not end in .exr");
  fails({"--to", "hsv", directory.file("none.exr"), "-o", directory.file("out.exr")}, 1,
        "no such file");
  fails({"--to", "hsv", in, "-o", in}, 1, "exists");
  fails({"--to", "hsw", in, "-o", directory.file("out.exr")}, 2, "hsv");
  fails({"--to", "hsv", "--undefined", "maybe", in, "-o", directory.file("out.exr")}, 2,
        "0 or nan");
  fails({"--to", "hsv", in, in, "-o", directory.file("out.exr")}, 2, "one picture");
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "out.exr"));
}

}  // namespace
}  // namespace tristim
