#include "tristim/device/display_file.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/error_text.h"
#include "tests/support.h"
#include "tristim/color/lab.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

Display parsed(const std::string& text) { return parse_display("name = \"x\"\n" + text, "a.toml"); }

TEST(BuiltInDisplays, AllParseAndNameTheirSource) {
  ASSERT_FALSE(built_in_displays().empty());
  for (const BuiltInDisplay& built_in : built_in_displays()) {
    SCOPED_TRACE(built_in.name);
    const Display display = load_display(std::string(built_in.name));
    EXPECT_FALSE(display.name.empty());
    EXPECT_FALSE(display.source.empty());
  }
}

TEST(LoadDisplay, FindsBuiltInDisplaysByTheirFoldedName) {
  EXPECT_EQ(load_display("CRT_P22").name, load_display("crt-p22").name);
}

TEST(LoadDisplay, ReadsFilesAndTheTablesBesideThem) {
  const TemporaryDirectory folder;
  write_bytes(folder.path() / "measured.csv", "# cd/m2\ncode,Y\n0, 0.5\r\n128,20\n\n255,100\n");
  write_bytes(folder.path() / "panel.toml",
              "name = \"mine\"\n[response]\nkind = \"table\"\nfile = \"measured.csv\"\n");
  const Display display = load_display(folder.file("panel.toml"));
  EXPECT_EQ(display.name, "mine");
  const auto& table = std::get<TableResponse>(display.response);
  EXPECT_EQ(table.code, (std::vector<double>{0, 128, 255}));
  EXPECT_EQ(table.luminance, (std::vector<double>{0.5, 20, 100}));
}

TEST(LoadDisplay, RefusesRowsOfAMeasuredFileThatAreNoPairs) {
  const TemporaryDirectory folder;
  write_bytes(folder.path() / "panel.toml",
              "name = \"mine\"\n[response]\nkind = \"table\"\nfile = \"m.csv\"\n");
  write_bytes(folder.path() / "m.csv", "0,0\n1,x\n255,1\n");
  EXPECT_EQ(error_text([&] { load_display(folder.file("panel.toml")); }),
            "3 " + folder.file("m.csv") +
                ":2: 'x' is no finite number; give numbers with decimal points: 64,12.5");
}

TEST(LoadDisplay, NamesWhatItDoesNotFind) {
  EXPECT_EQ(error_text([] { load_display("vga61"); }),
            "2 vga61: unknown device; did you mean vga16? (a file of your own: "
            "./panel.toml; the list: tristim device list)");
  EXPECT_TRUE(error_text([] { load_display("./absent.toml"); }).starts_with("1 ./absent.toml: "));
  EXPECT_TRUE(error_text([] { load_display("absent.toml"); }).starts_with("1 absent.toml: "));
}

TEST(ParseDisplay, TakesDefaultsForWhatIsAbsent) {
  const Display display = parsed("");
  EXPECT_EQ(display.kind, DisplayKind::kEmissive);
  EXPECT_EQ(display.frame.packing.name, "rgb888");
  EXPECT_EQ(display.frame.bit_order, BitOrder::kMsb);
  EXPECT_EQ(display.frame.byte_order, ByteOrder::kBig);
  EXPECT_EQ(display.primaries, Primaries{});
  EXPECT_TRUE(std::holds_alternative<SrgbResponse>(display.response));
  EXPECT_FALSE(display.panel || display.levels || display.dots);
  EXPECT_TRUE(display.palette.empty());
}

TEST(ParseDisplay, TakesEveryKey) {
  const Display display = parsed(R"(source = "sheet"
kind = "print"
[frame_buffer]
packing = "GRAY_4"
bit_order = "lsb"
byte_order = "little"
store = "index"
[panel]
size = [800, 480]
[primaries]
red = [0.6, 0.3]
green = [0.3, 0.6]
blue = [0.15, 0.1]
white = "D50"
[response]
kind = "gamma"
gamma = 2.3
i0 = 0.01
k = 0.002
[levels]
i0 = 0.03
n = 12
spacing = "gamma"
gamma = 1.9
[dots]
dpi = 300
isolated = false
gain = 0.2
)");
  EXPECT_EQ(display.source, "sheet");
  EXPECT_EQ(display.kind, DisplayKind::kPrint);
  EXPECT_EQ(display.frame.packing.name, "gray4");
  EXPECT_EQ(display.frame.bit_order, BitOrder::kLsb);
  EXPECT_EQ(display.frame.byte_order, ByteOrder::kLittle);
  EXPECT_EQ(display.frame.store, Store::kIndex);
  EXPECT_EQ(display.panel->width, 800);
  EXPECT_EQ(display.panel->height, 480);
  EXPECT_EQ(display.primaries, (Primaries{{0.6, 0.3}, {0.3, 0.6}, {0.15, 0.1}, kD50}));
  const auto& gamma = std::get<GammaResponse>(display.response);
  EXPECT_EQ(gamma.gamma, 2.3);
  EXPECT_EQ(gamma.i0, 0.01);
  EXPECT_EQ(gamma.k, 0.002);
  EXPECT_EQ(display.levels->i0, 0.03);
  EXPECT_EQ(display.levels->n, 12);
  EXPECT_EQ(display.levels->gamma, 1.9);
  EXPECT_EQ(display.levels->spacing->name, "gamma");
  EXPECT_EQ(display.dots->dpi, 300);
  EXPECT_FALSE(display.dots->isolated);
  EXPECT_EQ(std::get<MurrayDaviesGain>(display.dots->gain).at_half, 0.2);
}

TEST(ParseDisplay, TakesEveryResponse) {
  const auto response = [](const std::string& keys) {
    return parsed("[response]\nkind = " + keys).response;
  };
  EXPECT_TRUE(std::holds_alternative<SrgbResponse>(response("\"srgb\"")));
  EXPECT_TRUE(std::holds_alternative<LinearResponse>(response("\"linear\"")));
  EXPECT_EQ(std::get<GammaResponse>(response("\"gamma\"")).gamma, 2.2);
  EXPECT_EQ(std::get<Bt1886Response>(response("\"bt1886\"\nblack = 0.001")).black, 0.001);
  const auto table = std::get<TableResponse>(response("\"table\"\ntable = [[0, 1], [255, 80]]"));
  EXPECT_EQ(table.luminance, (std::vector<double>{1, 80}));
}

TEST(ParseDisplay, TakesResponsesOfChannels) {
  const Display display = parsed(R"([response]
kind = "gog"
gamma = 2.3
offset = -0.02
black = 0.001
[response.green]
kind = "gamma"
gamma = 1.9
)");
  EXPECT_EQ(std::get<GogResponse>(display.response).offset, -0.02);
  EXPECT_EQ(std::get<GogResponse>(response_of(display, 2)).black, 0.001);
  EXPECT_EQ(std::get<GammaResponse>(response_of(display, 1)).gamma, 1.9);
}

TEST(LoadDisplay, TakesATableOfThreeChannels) {
  const TemporaryDirectory folder;
  write_bytes(folder.path() / "m.csv", "code,red,green,blue\n0,0,0,1\n255,10,20,31\n");
  write_bytes(folder.path() / "panel.toml",
              "name = \"mine\"\n[response]\nkind = \"table\"\nfile = \"m.csv\"\n");
  const Display display = load_display(folder.file("panel.toml"));
  EXPECT_EQ(std::get<TableResponse>(response_of(display, 1)).luminance.back(), 20);
  EXPECT_EQ(std::get<TableResponse>(response_of(display, 2)).luminance.front(), 1);
}

TEST(ParseDisplay, TakesEverySpacingOfLevels) {
  const auto levels = [](const std::string& keys) { return *parsed("[levels]\n" + keys).levels; };
  EXPECT_EQ(levels("spacing = \"pq\"\npeak = 300").peak_cd_m2, 300);
  EXPECT_TRUE(levels("spacing = \"lstar\"\nfrom_zero = true").from_zero);
  const Display measured = parsed(
      "[response]\nkind = \"table\"\ntable = [[0, 1], [255, 80]]\n[levels]\nspacing = "
      "\"measured\"");
  EXPECT_EQ(measured.levels->measured->luminance.back(), 80);
}

TEST(ParseDisplay, SolvesTheWhiteFromLuminances) {
  const Eigen::RowVector3d y = xyz_from_rgb(Primaries{}).row(1);
  const Display display =
      parsed("[primaries]\nset = \"srgb\"\nluminance = [" + std::to_string(100 * y[0]) + ", " +
             std::to_string(100 * y[1]) + ", " + std::to_string(100 * y[2]) + "]\n");
  EXPECT_NEAR(display.primaries.white.x, kD65.x, 1e-7);  // six decimals of cd/m2 in the text
  EXPECT_NEAR(display.primaries.white.y, kD65.y, 1e-7);
}

TEST(ParseDisplay, TakesAppearancesInThreeForms) {
  const Display display = parsed(R"([frame_buffer]
packing = "index4"
[viewing]
white = "D50"
[[palette]]
lab = [50, 10, -20]
name = "by Lab"
[[palette]]
code = 7
xyz = [0.1, 0.2, 0.3]
[[palette]]
code = 9
rgb = [255, 255, 255]
[[palette]]
rgb = [1.0, 1.0, 1.0]
)");
  ASSERT_EQ(display.palette.size(), 4U);
  EXPECT_EQ(display.viewing_white, kD50);
  EXPECT_EQ(display.palette[0].appearance, lab_to_xyz({50, 10, -20}, white_xyz(kD50)));
  EXPECT_EQ(display.palette[0].name, "by Lab");
  EXPECT_EQ(display.palette[1].appearance, (Xyz{0.1, 0.2, 0.3}));
  // sRGB white is adapted to the viewing white.
  EXPECT_NEAR(display.palette[2].appearance.z, white_xyz(kD50).z, 1e-14);
  EXPECT_EQ(display.palette[3].appearance, display.palette[2].appearance);
  EXPECT_EQ(display.palette[0].code, 0);  // its position, where it has none
  EXPECT_EQ(display.palette[1].code, 7);
  EXPECT_EQ(display.palette[3].code, 3);
}

TEST(ParseDisplay, AdaptsThePaletteAsTheFileSays) {
  for (const AdaptationMethod& method : kAdaptations) {
    const Display display =
        parsed("[frame_buffer]\npacking = \"index4\"\n[viewing]\nwhite = \"A\"\nadapt = \"" +
               std::string(method.name) +
               "\"\n[[palette]]\nrgb = [1.0, 0.0, 0.0]\n[[palette]]\nrgb = [255, 255, 255]\n");
    EXPECT_EQ(display.adaptation, method.method);
    const Eigen::Vector3d red =
        adaptation_matrix(kD65, display.viewing_white, method.method) * xyz_from_rgb({}).col(0);
    EXPECT_NEAR(display.palette[0].appearance.x, red.x(), 1e-15) << method.name;
  }
  EXPECT_EQ(parsed("").adaptation, Adaptation::kBradford);
}

}  // namespace
}  // namespace tristim
