#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/pipeline/pictures.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"
#include "tristim/pipeline/reduce.h"

namespace tristim {
namespace {

std::vector<Display> displays() {
  std::vector<Display> all;
  for (const BuiltInDisplay& built_in : built_in_displays()) {
    all.push_back(load_display(std::string(built_in.name)));
  }
  Display grey{.name = "index store", .response = GammaResponse{}, .levels = LevelTable{.n = 100}};
  grey.frame.packing = *find_by_name(kPackings, "gray8");
  grey.frame.store = Store::kIndex;
  all.push_back(grey);
  return all;
}

int code_count(const Display& display) {
  if (!display.palette.empty()) return static_cast<int>(display.palette.size());
  const bool indexed_levels = display.levels && display.frame.store == Store::kIndex;
  return indexed_levels ? display.levels->n + 1 : 1 << display.frame.packing.bits[0];
}

// What the device shows of each code, asked for, gives that light again.
TEST(Decoder, UndoesTheReducer) {
  for (const Display& display : displays()) {
    if (display.press) continue;  // several mixtures of inks look alike
    SCOPED_TRACE(display.name);
    const Packing& packing = display.frame.packing;
    const int count = code_count(display);
    Raster<std::uint16_t> codes(count, 1, packing.samples);
    for (int i = 0; i < count; ++i) {
      for (int c = 0; c < packing.samples; ++c) {
        const int most = (1 << packing.bits[static_cast<std::size_t>(c)]) - 1;
        codes.view().pixel(i, 0)[c] = static_cast<std::uint16_t>(std::min(i, most));
      }
    }
    const Decoder decoder(display);
    Image light(count, 1, 3);
    decoder.decode(codes.view(), light.view());
    const auto row = light.view().row(0);
    const std::vector<float> shown(row.begin(), row.end());
    Reducer reducer(display, {.black_point = BlackPoint::kAbsolute}, count);
    reducer.reduce({light.view(), 0}, codes.view());
    decoder.decode(codes.view(), light.view());
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const bool below_levels = display.levels && shown[i] < display.levels->i0;
      if (below_levels) continue;
      // Codes between the V_j are no levels: the nearest is half a ratio away at the most, 2 %.
      ASSERT_NEAR(row[i], shown[i], display.levels ? 0.02F * shown[i] : 0) << i / 3;
    }
  }
}

TEST(Decoder, GivesGreysToAllChannels) {
  const Decoder decoder(load_display("laser-300"));
  const std::uint16_t paper = 0;
  const std::uint16_t toner = 1;
  EXPECT_NEAR(decoder.light(&paper).b, 1, 1e-15);
  EXPECT_EQ(decoder.light(&toner), (Rgb{0, 0, 0}));
}

TEST(FrameInfo, TagsWhatTheCodesAre) {
  const FrameInfo srgb = frame_info(load_display("srgb"), 7, 5);
  EXPECT_EQ(srgb.width, 7);
  EXPECT_EQ(srgb.height, 5);
  EXPECT_TRUE(srgb.srgb);
  EXPECT_FALSE(srgb.gamma);
  EXPECT_EQ(srgb.device, load_display("srgb").name);
  EXPECT_TRUE(srgb.palette.empty());

  const Display crt = load_display("crt-p22");
  const FrameInfo info = frame_info(crt, 1, 1);
  EXPECT_FALSE(info.srgb);
  EXPECT_EQ(info.gamma, 2.3);
  EXPECT_EQ(info.primaries, crt.primaries);

  EXPECT_EQ(frame_info(load_display("laser-300"), 1, 1).dpi, 300);
  EXPECT_EQ(frame_info({.response = LinearResponse{}}, 1, 1).gamma, 1);
  EXPECT_EQ(frame_info({.response = Bt1886Response{}}, 1, 1).gamma, 2.4);
  EXPECT_FALSE(frame_info({.response = TableResponse{{0, 255}, {1, 2}}}, 1, 1).gamma);
  // The sRGB curve over other primaries is no sRGB.
  EXPECT_FALSE(frame_info({.primaries = {.white = kD50}}, 1, 1).srgb);
}

TEST(FrameInfo, TagsNoCurveWhereTheCodesAreIndicesOfLevels) {
  for (const Response& response : {Response{SrgbResponse{}}, Response{GammaResponse{}}}) {
    Display display{.response = response, .levels = LevelTable{}};
    display.frame.store = Store::kIndex;
    EXPECT_FALSE(frame_info(display, 1, 1).srgb);
    EXPECT_FALSE(frame_info(display, 1, 1).gamma);
  }
}

TEST(FrameInfo, KeepsThePaletteInItsOrderWithItsCodes) {
  const Display vga = load_display("vga16");
  const FrameInfo info = frame_info(vga, 1, 1);
  ASSERT_EQ(info.palette.size(), 16U);
  EXPECT_EQ(info.palette[0].srgb, (std::array<std::uint8_t, 3>{0, 0, 0}));
  EXPECT_EQ(info.palette[6].srgb, (std::array<std::uint8_t, 3>{170, 85, 0}));  // brown, as stated
  EXPECT_EQ(info.palette[15].srgb, (std::array<std::uint8_t, 3>{255, 255, 255}));
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(info.palette[i].code, vga.palette[i].code);
    EXPECT_EQ(info.palette[i].name, vga.palette[i].name);
  }
}

TEST(FrameInfo, GivesTheColourTableOfIndexedLevels) {
  Display display{.response = GammaResponse{}, .levels = LevelTable{.n = 15, .i0 = 0.02}};
  display.frame.packing = *find_by_name(kPackings, "gray4");
  display.frame.store = Store::kIndex;
  const FrameInfo info = frame_info(display, 1, 1);
  const std::vector<int> values = display_level_codes(display, 4);
  ASSERT_EQ(info.palette.size(), 16U);
  for (std::size_t j = 0; j < 16; ++j) {
    EXPECT_EQ(info.palette[j].code, j);
    EXPECT_EQ(info.palette[j].srgb[0], values[j] * 17);  // 255/15
    EXPECT_EQ(info.palette[j].srgb[0], info.palette[j].srgb[2]);
  }
}

}  // namespace
}  // namespace tristim
