#include "tristim/pipeline/settings.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/error_text.h"
#include "tests/support.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

// For each setting a line of a pipeline file that is taken, one that is not, and why not.
struct Example {
  std::string_view name;
  const char* good;
  const char* bad;
  const char* refusal;
};

const Example kExamples[] = {
    {"layer", "\"diffuse\"", "[1]", "'layer' must be a string, number or boolean"},
    {"size", "\"800x480\"", "\"800*480\"",
     "'800*480' is no size; give WIDTHxHEIGHT in pixels, or one of them: 800x480, 800x, x480"},
    {"fit", "\"cover\"", "\"covr\"", "unknown fit 'covr'; did you mean cover?"},
    {"filter", "\"hermite\"", "\"hermit\"", "unknown filter 'hermit'; did you mean hermite?"},
    {"cells", "\"2x3\"", "\"0\"",
     "'0' is no cell; give a side of 1 to 256, or WIDTHxHEIGHT, in device pixels"},
    {"rotate", "90", "45", "'45' is no rotation; give 0, 90, 180 or 270 degrees clockwise"},
    {"background", "\"#ff8000\"", "\"redd\"", "'redd' is no colour; did you mean red?"},
    {"exposure", "-1.5", "nan",
     "'nan' is no exposure; give stops from -64 to 64, such as 1.5 or -2"},
    {"tone-map", "\"reinhard:8\"", "\"reinhard:0\"",
     "'reinhard:0' is no tone map; give the luminance that becomes white, as in reinhard:8"},
    {"colors", "16", "0", "'0' is no number of colours; give 1 to 65536"},
    {"transparent", "\"last\"", "\"first\"",
     "'first' is no position; give the position in the palette, from 0, or last"},
    {"adapt", "\"cat16\"", "\"cat61\"", "unknown adaptation 'cat61'; did you mean cat02?"},
    {"gamut-map", "\"desaturate\"", "\"clap\"", "unknown gamut map 'clap'; did you mean clip?"},
    {"black-point", "\"absolute\"", "\"absolut\"",
     "unknown black point 'absolut'; did you mean absolute?"},
    {"dither", "\"bayer8\"", "\"byer8\"", "unknown dither 'byer8'; did you mean bayer8?"},
    {"serpentine", "true", "1", "'1' is no switch; give true or false"},
    {"settled", "false", "1", "'1' is no switch; give true or false"},
    {"jitter", "0.3", "1.5",
     "'1.5' is no jitter; give 0 for a fixed threshold to 1 for the step between levels"},
    {"strength", "0.5", "2",
     "'2' is no strength; give 0 for the nearest code to 1 for the whole dither"},
    {"dither-mask", "\"mask.png\"", "[1]", "'dither-mask' must be a string, number or boolean"},
    {"mask-size", "64", "-1", "'-1' is no size; give an integer from 0 to 1024"},
    {"seed", "7", "-1", "'-1' is no seed; give an integer from 0 to 1000000000000000"},
    {"frame", "12", "1.5", "'1.5' is no frame number; give an integer from 0 to 1000000000"},
    {"effort", "3", "1001", "'1001' is no effort; give an integer from 0 to 1000"},
    {"lpi", "85", "-1", "'-1' is no ruling; give lines an inch, as in --lpi 85"},
    {"angle", "\"15,75,0,45\"", "\"15,up\"",
     "'up' is no angle; give degrees, one or one for each channel: 45 or 15,75,0,45"},
    {"spot", "\"cos(pi*x) + cos(pi*y)\"", "\"rond\"", "unknown spot 'rond'; did you mean round?"},
    {"smallest-dot", "6", "-1",
     "'-1' is no size of a dot; give the device dots of the smallest dot, 1 or more"},
    {"single-cell", "true", "1", "'1' is no switch; give true or false"},
    {"dpi", "600", "-1", "'-1' is no resolution; give dots an inch, as in --dpi 600"},
    {"palette", "\"median-cut:16\"", "\"median-cut:0\"",
     "'median-cut:0' is no palette; give the number of colours, 1 to 65536, as in best:16"},
    {"palette-weights", "\"contrast\"", "\"kount\"",
     "unknown palette-weights 'kount'; did you mean count?"},
    {"metric", "\"lab\"", "\"oklabb\"", "unknown metric 'oklabb'; did you mean oklab?"},
    {"mix", "\"encoded\"", "\"encodd\"", "unknown mix 'encodd'; did you mean encoded?"},
};

std::string refused(std::string_view name, std::string_view value) {
  Settings settings;
  const auto refusal = find_by_name(settings_list(), name)->set(settings, value);
  return refusal ? refusal->wrong + "; " + refusal->remedy : "";
}

Settings set(std::string_view name, std::string_view value) {
  Settings settings;
  EXPECT_FALSE(find_by_name(settings_list(), name)->set(settings, value)) << name << " " << value;
  return settings;
}

TEST(Settings, EachHasAnExampleHereHelpAndAName) {
  std::set<std::string_view> names;
  for (const Setting& setting : settings_list()) {
    SCOPED_TRACE(setting.name);
    EXPECT_TRUE(names.insert(setting.name).second);
    EXPECT_FALSE(setting.help.empty());
    EXPECT_NE(find_by_name(kExamples, setting.name), nullptr);
  }
  EXPECT_EQ(names.size(), std::size(kExamples));
}

TEST(ReadPipelineFile, TakesEverySetting) {
  const TemporaryDirectory folder;
  for (const Example& example : kExamples) {
    SCOPED_TRACE(example.name);
    write_bytes(folder.path() / "p.toml", std::string(example.name) + " = " + example.good + "\n");
    Settings settings;
    EXPECT_EQ(error_text([&] { read_pipeline_file(folder.file("p.toml"), settings); }), "");
  }
}

TEST(ReadPipelineFile, RefusesBadValuesOfEverySetting) {
  const TemporaryDirectory folder;
  for (const Example& example : kExamples) {
    const std::string key(example.name);
    write_bytes(folder.path() / "p.toml", "# a comment\n" + key + " = " + example.bad + "\n");
    Settings settings;
    EXPECT_EQ(error_text([&] { read_pipeline_file(folder.file("p.toml"), settings); }),
              "3 " + folder.file("p.toml") + ":2:" + std::to_string(key.size() + 4) + ": " +
                  example.refusal);
  }
}

TEST(ReadPipelineFile, FoldsNames) {
  const TemporaryDirectory folder;
  write_bytes(folder.path() / "p.toml", "Tone_Map = \"Reinhard\"\n");
  Settings settings;
  read_pipeline_file(folder.file("p.toml"), settings);
  EXPECT_NE(settings.tone, nullptr);
}

TEST(ReadPipelineFile, RefusesUnknownKeysAndMissingFiles) {
  const TemporaryDirectory folder;
  const std::string path = folder.file("p.toml");
  write_bytes(path, "exposure = 1\nditther = \"none\"\n");
  Settings settings;
  EXPECT_EQ(error_text([&] { read_pipeline_file(path, settings); }),
            "3 " + path + ":2:1: unknown key 'ditther'; did you mean dither?");
  EXPECT_TRUE(error_text([&] {
                read_pipeline_file(folder.file("absent.toml"), settings);
              }).starts_with("1 " + folder.file("absent.toml") + ": "));
}

TEST(Settings, ChangeWhatTheyName) {
  EXPECT_EQ(set("layer", "diffuse").layer, "diffuse");
  EXPECT_EQ(set("fit", "cover").fit, FitMode::kCover);
  EXPECT_EQ(set("rotate", "270").rotate_deg, 270);
  EXPECT_EQ(set("background", "#ff0000").background, (EncodedRgb{1, 0, 0}));
  EXPECT_EQ(set("exposure", "-1.5").exposure_stops, -1.5);
  EXPECT_EQ(set("adapt", "none").adaptation, Adaptation::kNone);
  EXPECT_EQ(set("gamut-map", "desaturate").gamut.name, "desaturate");
  EXPECT_EQ(set("black-point", "absolute").black_point, BlackPoint::kAbsolute);
  EXPECT_EQ(set("dither", "Bayer_8").dither->name, "bayer8");
  EXPECT_EQ(set("serpentine", "true").dither_parameters.serpentine, true);
  EXPECT_EQ(set("serpentine", "false").dither_parameters.serpentine, false);
  EXPECT_EQ(set("metric", "luv").metric->name, "luv");
  EXPECT_EQ(set("mix", "encoded").mix, Mix::kEncoded);
}

TEST(Settings, TakeToneMapsWithAndWithoutWhite) {
  EXPECT_EQ(set("tone-map", "none").tone, nullptr);
  EXPECT_EQ(set("tone-map", "reinhard").tone->name, "reinhard");
  EXPECT_EQ(set("tone-map", "reinhard").tone_white, 0);
  EXPECT_EQ(set("tone-map", "reinhard:2.5").tone_white, 2.5);
  EXPECT_EQ(refused("tone-map", "filmic"), "unknown tone map 'filmic'; use one of: reinhard, none");
  for (const char* bad :
       {"reinhard:", "reinhard:x", "reinhard:-1", "reinhard:inf", "reinhard:1:2"}) {
    EXPECT_NE(refused("tone-map", bad), "") << bad;
  }
}

TEST(Settings, TakeSizesWithOneSideOrBoth) {
  EXPECT_EQ(set("size", "800x480").width, 800);
  EXPECT_EQ(set("size", "800X480").height, 480);
  EXPECT_EQ(set("size", "800x").height, 0);
  EXPECT_EQ(set("size", "x480").width, 0);
  EXPECT_EQ(set("size", "800").width, 800);
  for (const char* bad :
       {"", "x", "0x10", "10x0", "-1x5", "1.5x2", "8 x 4", "1x2x3", "1048577x1", "99999999999x1"}) {
    EXPECT_NE(refused("size", bad), "") << bad;
  }
}

TEST(Settings, TakePalettesWithTheirNumberOfColours) {
  EXPECT_EQ(set("palette", "device").palette.method, nullptr);
  EXPECT_EQ(set("palette", "popularity").palette.colors, 0);
  EXPECT_EQ(set("palette", "fixed-565").palette.bits, (std::array{5, 6, 5}));
  EXPECT_EQ(set("palette", "fixed-565").palette.colors, 65536);
  EXPECT_EQ(set("palette", "inks:16:#204080+black").palette.inks,
            (std::vector<Color8>{{0x20, 0x40, 0x80}, {0, 0, 0}}));
  EXPECT_EQ(set("palette", "best:1").palette.colors, 1);
  EXPECT_EQ(set("palette-weights", "contrast").palette_weights, PaletteWeights::kContrast);
  EXPECT_EQ(set("palette", "median_cut:16").palette.colors, 16);
  EXPECT_EQ(set("palette", "median_cut:16").palette.method->name, "median-cut");
  for (const char* bad :
       {"median-cut:", "median-cut:x", "median-cut:65537", "median-cut:2:3", ""}) {
    EXPECT_NE(refused("palette", bad), "") << bad;
  }
}

TEST(Settings, KeepExposureWithinReason) {
  EXPECT_EQ(set("exposure", "64").exposure_stops, 64);
  for (const char* bad : {"64.1", "-65", "nan", "inf", "1e999", "", "two"}) {
    EXPECT_NE(refused("exposure", bad), "") << bad;
  }
}

// Every member of each list is taken by its name.
TEST(Settings, TakeEveryMemberOfTheirLists) {
  const auto all = [](std::string_view setting, const auto& list) {
    for (const auto& item : list) EXPECT_EQ(refused(setting, item.name), "") << item.name;
  };
  all("fit", kFitModes);
  all("filter", kFilters);
  all("tone-map", kToneOperators);
  all("adapt", kAdaptations);
  all("gamut-map", kGamutMethods);
  all("black-point", kBlackPoints);
  all("dither", dither_methods());
  all("palette", kPaletteMethods);
  all("metric", kMetrics);
  all("mix", kMixes);
}

}  // namespace
}  // namespace tristim
