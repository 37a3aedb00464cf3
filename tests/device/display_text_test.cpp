#include "tristim/device/display_text.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/error_text.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"

namespace tristim {
namespace {

// Two displays are one where all that is written of them is.
void expect_comes_back(const Display& display) {
  const std::string text = display_text(display);
  const Display back = parse_display(text, "back.toml");
  EXPECT_EQ(display_text(back), text);
  EXPECT_EQ(back.name, display.name);
  EXPECT_EQ(back.primaries, display.primaries);
  EXPECT_EQ(back.frame.packing.name, display.frame.packing.name);
  EXPECT_EQ(kind_of(back.response), kind_of(display.response));
  ASSERT_EQ(back.palette.size(), display.palette.size());
  for (std::size_t i = 0; i < back.palette.size(); ++i) {
    EXPECT_EQ(back.palette[i].appearance, display.palette[i].appearance);
    EXPECT_EQ(back.palette[i].code, display.palette[i].code);
  }
}

TEST(DisplayText, OfEveryBuiltInDisplayReadsBackAsItself) {
  for (const BuiltInDisplay& built_in : built_in_displays()) {
    SCOPED_TRACE(built_in.name);
    const Display display = load_display(std::string(built_in.name));
    if (display.press) {
      EXPECT_EQ(error_text([&] { display_text(display); }),
                "invalid: display: a press has no device file of its own");
      continue;
    }
    expect_comes_back(display);
  }
}

TEST(DisplayText, HasEveryResponseOfEveryChannel) {
  Display display{.name = "a \"name\" \\ with\ttabs", .source = "ünïcode"};
  display.frame.packing = *find_by_name(kPackings, "rgb565");
  display.response = GogResponse{2.3, -0.04, 0.001};
  display.channel_response = {TableResponse{{0, 16, 31}, {0.5, 20, 100}, 31},
                              GammaResponse{.gamma = 1.8, .i0 = 0.01, .k = 1e-4},
                              Bt1886Response{0.002}};
  expect_comes_back(display);
  const Display back = parse_display(display_text(display), "back.toml");
  EXPECT_EQ(std::get<TableResponse>(response_of(back, 0)).luminance,
            (std::vector<double>{0.5, 20, 100}));
  EXPECT_EQ(std::get<GammaResponse>(response_of(back, 1)).k, 1e-4);
  EXPECT_EQ(std::get<Bt1886Response>(response_of(back, 2)).black, 0.002);
}

TEST(DisplayText, HasLevelsPanelAndRemarks) {
  Display display{.name = "x", .panel = PanelSize{320, 240}};
  display.levels = LevelTable{.n = 100,
                              .i0 = 0.01,
                              .spacing = find_by_name(level_spacings(), "pq"),
                              .peak_cd_m2 = 500,
                              .from_zero = true};
  const std::string text = display_text(display, "first\nsecond");
  EXPECT_EQ(text.rfind("# first\n# second\nname", 0), 0U) << text;
  const Display back = parse_display(text, "back.toml");
  EXPECT_EQ(back.levels->spacing->name, "pq");
  EXPECT_EQ(back.levels->peak_cd_m2, 500);
  EXPECT_TRUE(back.levels->from_zero);
  EXPECT_EQ(back.panel->height, 240);
}

}  // namespace
}  // namespace tristim
