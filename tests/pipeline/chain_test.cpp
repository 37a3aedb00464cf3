#include "tristim/pipeline/chain.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/error_text.h"
#include "tests/pipeline/pictures.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"

namespace tristim {
namespace {

Settings settings(std::initializer_list<std::pair<std::string_view, std::string_view>> values) {
  Settings result;
  for (const auto& [name, value] : values) {
    EXPECT_FALSE(find_by_name(settings_list(), name)->set(result, value)) << name;
  }
  return result;
}

TEST(StageList, HasOnlyWhatIsAskedFor) {
  const Display display;
  const StageList plain = stage_list({}, display, {});
  ASSERT_EQ(plain.stages.size(), 2U);
  EXPECT_EQ(plain.scene_stages, 0);
  EXPECT_TRUE(std::holds_alternative<ConvertPrimaries>(plain.stages[0]));
  EXPECT_TRUE(std::holds_alternative<GamutMap>(plain.stages[1]));
  const StageList full =
      stage_list({}, display, settings({{"exposure", "1"}, {"tone-map", "reinhard"}}));
  ASSERT_EQ(full.stages.size(), 4U);
  EXPECT_EQ(full.scene_stages, 2);
  EXPECT_EQ(std::get<Exposure>(full.stages[0]).stops, 1);
  EXPECT_TRUE(std::holds_alternative<ToneMap>(full.stages[1]));
}

TEST(StageList, WeighsTheToneMapByThePicturesPrimaries) {
  PictureInfo info;
  info.primaries = find_by_name(primaries_list(), "aces-ap0")->primaries;
  const StageList list = stage_list(info, {}, settings({{"tone-map", "reinhard"}}));
  EXPECT_EQ(std::get<ToneMap>(list.stages[0]).luminance, xyz_from_rgb(info.primaries).row(1));
}

// Every setting that is absent has a default for every device.
TEST(ReduceOptions, AreCompleteForEveryDeviceAndDither) {
  for (const BuiltInDisplay& built_in : built_in_displays()) {
    SCOPED_TRACE(built_in.name);
    const Display display = load_display(std::string(built_in.name));
    EXPECT_NE(reduce_options(display, {}).metric.place, nullptr);
    for (const NamedDither& dither : dither_methods()) {
      Settings chosen;
      chosen.dither = dither;
      const ReduceOptions options = reduce_options(display, chosen);
      EXPECT_EQ(options.metric.name, dither.name == "none" ? "oklab" : "oklab-toe");
      EXPECT_EQ(options.dither.index(), dither.method.index());
    }
  }
}

TEST(ReduceOptions, TakeWhatIsSet) {
  const ReduceOptions options = reduce_options({}, settings({{"metric", "lab"},
                                                             {"mix", "encoded"},
                                                             {"black-point", "absolute"},
                                                             {"serpentine", "true"},
                                                             {"dither", "floyd-steinberg"}}));
  EXPECT_EQ(options.metric.name, "lab");
  EXPECT_EQ(options.mix, Mix::kEncoded);
  EXPECT_EQ(options.black_point, BlackPoint::kAbsolute);
  EXPECT_EQ(options.parameters.serpentine, true);
}

TEST(Prepare, TakesThePanelsSizeUnlessOneIsSet) {
  const auto size = [](const Display& display, const Settings& chosen) {
    const auto rows =
        prepare(std::make_unique<ImageSource>(Image(40, 20, 3)), display, chosen, nullptr);
    return std::to_string(rows->info().width) + "x" + std::to_string(rows->info().height);
  };
  Display panel;
  panel.panel = PanelSize{16, 8};
  EXPECT_EQ(size({}, {}), "40x20");
  EXPECT_EQ(size(panel, {}), "16x8");
  EXPECT_EQ(size(panel, settings({{"size", "10x10"}})), "10x10");
}

TEST(Prepare, PutsAlphaOverTheBackground) {
  Image image(1, 1, 4);  // transparent
  Settings white = settings({{"background", "white"}});
  const auto rows =
      prepare(std::make_unique<ImageSource>(std::move(image), PictureInfo{.channels = 4}), {},
              white, nullptr);
  Image row(1, 1, 3);
  rows->read(row.view());
  for (const float c : row.view().row(0)) EXPECT_NEAR(c, 1, 1e-6);
}

TEST(PictureHistogram, CountsTheCodesThatTheDeviceWillBeAskedFor) {
  Image image = flat_picture(5, 4, 1, 1, 1);
  image.view().pixel(2, 1)[0] = 0.21586F;  // sRGB 128
  image.view().pixel(3, 1)[0] = -7;
  ImageSource source(std::move(image));
  const Display display;
  const auto entries = histogram(source, stage_list({}, display, {}), display, {}).entries();
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(entries[0].color, (Color8{0, 255, 255}));
  EXPECT_EQ(entries[1].color, (Color8{128, 255, 255}));
  EXPECT_EQ(entries[2].color, (Color8{255, 255, 255}));
  EXPECT_EQ(entries[2].count, 18U);
}

TEST(PictureHistogram, WeighsByAMaskAndByCoverage) {
  const auto counted = [](AlphaMode alpha, bool masked) {
    Image image = flat_picture(3, 2, 1, 1, 1);
    image.view().pixel(0, 0)[0] = 0;
    Image cover = flat_picture(3, 2, 1, 1, 1);
    cover.view().pixel(0, 0)[0] = 0.4F;
    Image mask = flat_picture(3, 2, 0, 0, 0);
    mask.view().pixel(0, 0)[0] = 1;
    mask.view().pixel(1, 1)[0] = 0.2F;
    ImageSource source(std::move(image));
    ImageSource coverage(std::move(cover));
    ImageSource weights(std::move(mask));
    const CountOptions options{
        .mask = masked ? &weights : nullptr, .coverage = &coverage, .alpha = alpha};
    return histogram(source, stage_list({}, {}, {}), {}, {}, options).entries();
  };
  using Entries = std::vector<Histogram::Entry>;
  const Color8 cyan{0, 255, 255};
  const Color8 white{255, 255, 255};
  EXPECT_EQ(counted(AlphaMode::kOver, false), (Entries{{cyan, 1}, {white, 5}}));
  EXPECT_EQ(counted(AlphaMode::kOver, true), (Entries{{cyan, 255}, {white, 51}}));
  EXPECT_EQ(counted(AlphaMode::kThreshold, false), (Entries{{white, 5}}));
  EXPECT_EQ(counted(AlphaMode::kEntries, true), (Entries{{{0, 255, 255, 102}, 255}, {white, 51}}));
}

// What is counted, chosen and shown is one colour: the palette's entries come back as they were.
TEST(WithPalette, ShowsTheChosenColours) {
  Display display = load_display("vga16");
  display = with_palette(display, {{10, 20, 30}, {255, 255, 255}, {128, 0, 64}});
  EXPECT_FALSE(display.palette_has_white);
  const FrameInfo info = frame_info(display, 1, 1);
  ASSERT_EQ(info.palette.size(), 3U);
  EXPECT_EQ(info.palette[0].srgb, (std::array<std::uint8_t, 3>{10, 20, 30}));
  EXPECT_EQ(info.palette[2].srgb, (std::array<std::uint8_t, 3>{128, 0, 64}));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(info.palette[i].code, i);
}

TEST(WithPalette, OfAPictureWithFewColoursShowsItUnchanged) {
  Image image = flat_picture(6, 1, 0, 0, 0);
  for (int x = 0; x < 6; ++x) image.view().pixel(x, 0)[x % 3] = 0.1F * static_cast<float>(x);
  const auto copy = [&] {
    Image same(6, 1, 3);
    std::ranges::copy(image.view().row(0), same.view().row(0).begin());
    return same;
  };
  Display display = load_display("vga16");
  const StageList stages = stage_list({}, display, {});
  ImageSource counted(copy());
  const Histogram colors = histogram(counted, stages, display, {});
  for (const PaletteMethod& method : kPaletteMethods) {
    if (!method.needs_histogram) continue;
    SCOPED_TRACE(method.name);
    const Display chosen = with_palette(display, build_palette(colors, method, {.colors = 16}));
    ImageSource source(copy());
    Reducer reducer(chosen, reduce_options(chosen, settings({{"dither", "none"}})), 6);
    CodeCollector codes;
    run(source, stages.stages, reducer, codes);
    Reducer srgb(Display{}, {}, 6);
    CodeCollector expected;
    ImageSource again(copy());
    run(again, stages.stages, srgb, expected);
    const FrameInfo info = frame_info(chosen, 6, 1);
    for (std::size_t x = 0; x < 6; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(info.palette[codes.codes[x]].srgb[c], expected.codes[3 * x + c]);
      }
    }
  }
}

TEST(PaletteColors, FitThePacking) {
  const Display vga = load_display("vga16");
  const PaletteMethod* median = find_by_name(kPaletteMethods, "median-cut");
  const PaletteMethod* fixed = find_by_name(kPaletteMethods, "fixed-332");
  EXPECT_EQ(palette_colors(vga, {median, 0}), 16);
  EXPECT_EQ(palette_colors(vga, {median, 5}), 5);
  EXPECT_EQ(error_text([&] {
              palette_colors(vga, {median, 17});
            }),
            "2 --palette: 17 colours do not fit packing index4; ask for 16 or less");
  EXPECT_EQ(error_text([&] {
              palette_colors(vga, {fixed, 0});
            }),
            "2 --palette: 256 colours do not fit packing index4; ask for 16 or less");
  EXPECT_EQ(error_text([&] {
              palette_colors(Display{}, {median, 0});
            }),
            "2 --palette: packing rgb888 has no palette; choose a device with an indexed packing, "
            "or leave --palette out");
}

}  // namespace
}  // namespace tristim
