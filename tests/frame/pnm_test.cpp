#include <gtest/gtest.h>

#include <array>
#include <sstream>

#include "tests/frame/frames.h"
#include "tests/support.h"

namespace tristim {
namespace {

/// A file of the PNM family as [PNM] describes it.
struct Pnm {
  std::string type;
  int width = 0, height = 0, highest = 1;
  std::vector<int> samples;  // PBM: 1 is black
};

Pnm read_pnm(const std::string& path) {
  std::istringstream in(read_bytes(path));
  Pnm pnm;
  in >> pnm.type >> pnm.width >> pnm.height;
  if (pnm.type != "P4") in >> pnm.highest;
  in.get();
  const int channels = pnm.type == "P6" ? 3 : 1;
  for (int y = 0; y < pnm.height; ++y) {
    int byte = 0;
    for (int x = 0; x < pnm.width * channels; ++x) {
      if (pnm.type == "P4") {
        if (x % 8 == 0) byte = in.get();
        pnm.samples.push_back(byte >> (7 - x % 8) & 1);
      } else if (pnm.highest > 255) {
        const int high = in.get();
        pnm.samples.push_back(high * 256 + in.get());
      } else {
        pnm.samples.push_back(in.get());
      }
    }
  }
  EXPECT_TRUE(in.good()) << "too short";
  EXPECT_EQ(in.get(), std::istringstream::traits_type::eof()) << "too long";
  return pnm;
}

Pnm written(const TestFrame& frame, const std::string& name) {
  const TemporaryDirectory directory;
  write_frame(frame, directory.file(name));
  const Pnm pnm = read_pnm(directory.file(name));
  EXPECT_EQ(pnm.width, frame.info.width);
  EXPECT_EQ(pnm.height, frame.info.height);
  return pnm;
}

TEST(PnmWriter, KeepsTheCodesOfEveryPacking) {
  for (const Packing& packing : kPackings) {
    SCOPED_TRACE(packing.name);
    const TestFrame frame = random_frame(frame_info(packing.name, 13, 5));
    const Pnm pnm = written(frame, "out.pnm");
    const int bits = packing.bits[0];
    const std::string type = packing.samples == 3 ? "P6" : bits == 1 ? "P4" : "P5";
    EXPECT_EQ(pnm.type, type);
    ASSERT_EQ(pnm.samples.size(), frame.codes.size());
    const bool unequal = packing.samples == 3 && packing.bits != std::array{bits, bits, bits};
    EXPECT_EQ(pnm.highest, unequal ? 255 : (1 << bits) - 1);
    for (std::size_t i = 0; i < frame.codes.size(); ++i) {
      const int highest = (1 << packing.bits[i % static_cast<unsigned>(packing.samples)]) - 1;
      const long long code = frame.codes[i];
      const long long expected =
          type == "P4" ? 1 - code : (code * pnm.highest * 2 + highest) / (2 * highest);
      ASSERT_EQ(pnm.samples[i], expected) << "sample " << i;
    }
  }
}

TEST(PnmWriter, WidensUnequalChannelsToEightBits) {
  const TestFrame frame{frame_info("rgb565", 2, 1), {31, 63, 0, 16, 32, 1}};
  const Pnm pnm = written(frame, "out.ppm");
  EXPECT_EQ(pnm.highest, 255);
  EXPECT_EQ(pnm.samples, (std::vector<int>{255, 255, 0, 132, 130, 8}));
}

TEST(PnmWriter, ShowsTheDarkerOfTwoColoursBlack) {
  FrameInfo info = frame_info("index1", 2, 1);
  info.palette = {{{0, 0, 0}, 0, ""}, {{255, 255, 255}, 1, ""}};
  EXPECT_EQ(written({info, {0, 1}}, "out.pbm").samples, (std::vector<int>{1, 0}));
  info.palette = {{{255, 255, 0}, 0, ""}, {{0, 0, 255}, 1, ""}};
  EXPECT_EQ(written({info, {0, 1}}, "out.pnm").samples, (std::vector<int>{0, 1}));
  info.palette = {{{255, 255, 255}, 0, ""}};
  EXPECT_EQ(written({info, {0, 0}}, "out.pnm").samples, (std::vector<int>{0, 0}));
  info.palette = {{{0, 0, 0}, 0, ""}};
  EXPECT_EQ(written({info, {0, 0}}, "out.pnm").samples, (std::vector<int>{1, 1}));
}

TEST(PnmWriter, ShowsTheColoursOfAPalette) {
  FrameInfo info = frame_info("index4", 3, 1);
  info.palette = {{{1, 2, 3}, 9, ""}, {{4, 5, 6}, 8, ""}, {{7, 7, 7}, 7, ""}};
  const Pnm colours = written({info, {2, 0, 1}}, "out.pnm");
  EXPECT_EQ(colours.type, "P6");
  EXPECT_EQ(colours.highest, 255);
  EXPECT_EQ(colours.samples, (std::vector<int>{7, 7, 7, 1, 2, 3, 4, 5, 6}));

  info.palette = {{{10, 10, 10}, 9, ""}, {{20, 20, 20}, 8, ""}, {{7, 7, 7}, 7, ""}};
  const Pnm greys = written({info, {2, 0, 1}}, "out.pnm");
  EXPECT_EQ(greys.type, "P5");
  EXPECT_EQ(greys.highest, 255);
  EXPECT_EQ(greys.samples, (std::vector<int>{7, 10, 20}));
}

TEST(PnmWriter, MakesTheTypeThatTheExtensionAsksFor) {
  const TestFrame mono{frame_info("mono1", 3, 1), {1, 0, 1}};
  const Pnm pgm = written(mono, "out.pgm");
  EXPECT_EQ(pgm.type, "P5");
  EXPECT_EQ(pgm.highest, 1);
  EXPECT_EQ(pgm.samples, (std::vector<int>{1, 0, 1}));
  const Pnm ppm = written(mono, "out.ppm");
  EXPECT_EQ(ppm.type, "P6");
  EXPECT_EQ(ppm.samples, (std::vector<int>{1, 1, 1, 0, 0, 0, 1, 1, 1}));

  FrameInfo info = frame_info("index1", 2, 1);
  info.palette = {{{255, 255, 0}, 0, ""}, {{0, 0, 255}, 1, ""}};
  EXPECT_EQ(written({info, {0, 1}}, "out.ppm").samples, (std::vector<int>{255, 255, 0, 0, 0, 255}));
  EXPECT_EQ(open_error(info, "out.pgm"),
            "2 out.pgm: PGM holds greys only, these codes are colours; use .ppm or .pnm");
}

TEST(PnmWriter, TellsWhichTypeHoldsTheCodes) {
  EXPECT_EQ(open_error(frame_info("gray2", 2, 1), "out.pbm"),
            "2 out.pbm: PBM holds one bit a pixel, these codes have more; use .pgm or .pnm");
  EXPECT_EQ(open_error(frame_info("rgb888", 2, 1), "out.pbm"),
            "2 out.pbm: PBM holds one bit a pixel, these codes have more; use .ppm or .pnm");
  EXPECT_EQ(open_error(frame_info("rgb888", 2, 1), "out.pgm"),
            "2 out.pgm: PGM holds greys only, these codes are colours; use .ppm or .pnm");
  FrameInfo info = frame_info("index4", 2, 1);
  info.palette = test_palette(7, 4);
  EXPECT_EQ(open_error(info, "out.pbm"),
            "2 out.pbm: PBM holds one bit a pixel, these codes have more; use .ppm or .pnm");
}

}  // namespace
}  // namespace tristim
