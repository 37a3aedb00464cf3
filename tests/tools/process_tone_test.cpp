#include "tests/image/picture_support.h"
#include "tests/tools/command_test.h"

namespace tristim {
namespace {

constexpr int kSide = 128;  // whole periods of every matrix

class ProcessTone : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    std::string flat = "PF\n128 128\n-1.0\n";
    const float light = 0.2159F;
    const std::string bytes(reinterpret_cast<const char*>(&light), sizeof light);
    for (int i = 0; i < 3 * kSide * kSide; ++i) flat += bytes;
    write("flat.pfm", flat);
    fixture("linear.toml", "kind = \"linear\"\n");
    fixture("gamma.toml", "kind = \"gamma\"\ngamma = 2.2\n");
  }

  void fixture(const std::string& name, const std::string& response) const {
    write(name, "name = \"one bit\"\n[frame_buffer]\npacking = \"mono1\"\n[response]\n" + response);
  }

  /// The part of the pixels of the written PNG that are lit, in percent.
  double lit(const std::string& device, const std::string& options) const {
    good("process flat.pfm --quiet --force -o o.png -d " + device + " " + options);
    const WholePicture picture = read_whole(file("o.png"));
    EXPECT_EQ(picture.info.width, kSide);
    int count = 0;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) count += picture.at(x, y, 0) > 0.5F ? 1 : 0;
    }
    return 100.0 * count / (kSide * kSide);
  }
};

constexpr const char* kOneBitDevices[] = {"laser-300", "./linear.toml", "./gamma.toml"};
constexpr const char* kFineDithers[] = {"floyd-steinberg", "bayer8", "bayer16", "clustered8"};

TEST_F(ProcessTone, OneBitMixesInLight) {
  for (const std::string device : kOneBitDevices) {
    for (const std::string dither : kFineDithers) {
      SCOPED_TRACE(device + " " + dither);
      EXPECT_NEAR(lit(device, "--dither " + dither), 21.59, 0.5);
    }
  }
}

TEST_F(ProcessTone, SmallMatricesGiveTheirNearestLevel) {
  EXPECT_EQ(lit("laser-300", "--dither bayer2"), 25);     // of 0, 1/4, 1/2 ...
  EXPECT_EQ(lit("laser-300", "--dither bayer4"), 18.75);  // 3/16
}

TEST_F(ProcessTone, EncodedMixingIsThereForThoseWhoWantIt) {
  for (const std::string device : kOneBitDevices) {
    for (const std::string dither : kFineDithers) {
      SCOPED_TRACE(device + " " + dither);
      // .2159 is .502 on the sRGB curve.
      EXPECT_NEAR(lit(device, "--mix encoded --dither " + dither), 50.2, 1);
    }
  }
}

TEST_F(ProcessTone, WithoutDitherTheNearestCode) {
  EXPECT_EQ(lit("laser-300", "--dither none"), 100);  // light .2159 is past the middle of Oklab
  EXPECT_EQ(lit("laser-300", "--dither none --exposure -2"), 0);
}

}  // namespace
}  // namespace tristim
