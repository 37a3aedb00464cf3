#include <gtest/gtest.h>

#include <string>

#include "tests/error_text.h"
#include "tristim/device/display_file.h"

namespace tristim {
namespace {

// A device file below `name = "x"` in line 1, and what is said of it after "a.toml:".
struct BadFile {
  const char* text;
  const char* error;
};

const BadFile kBadFiles[] = {
    // Names.
    {"[respnse]\nkind = \"srgb\"", "2:2: unknown key 'respnse'; did you mean response?"},
    {"[frame_buffer]\npacking = \"rgb888\"\nbit_ordr = \"msb\"",
     "4:1: unknown key 'bit_ordr'; did you mean bit_order?"},
    {"[frame_buffer]\npacking = \"index3\"",
     "3:11: unknown packing 'index3'; did you mean index8?"},
    {"kind = \"reflectiv\"", "2:8: unknown kind 'reflectiv'; did you mean reflective?"},
    {"kind = 3", "2:8: 'kind' must be a string"},
    {"[primaries]\nset = \"ntsc1935\"",
     "3:7: unknown primaries 'ntsc1935'; did you mean ntsc-1953?"},
    {"[viewing]\nwhite = \"D56\"", "3:9: unknown white 'D56'; did you mean d50?"},
    {"[viewing]\nadapt = \"cat2\"", "3:9: unknown adapt 'cat2'; did you mean cat02?"},
    {"[response]\nkind = \"gama\"", "3:8: unknown kind 'gama'; did you mean gamma?"},
    {"[levels]\nspacing = \"rato\"", "3:11: unknown spacing 'rato'; did you mean ratio?"},
    // Ranges.
    {"[panel]\nsize = [0, 480]", "3:8: size is no panel size; give [width, height] in pixels"},
    {"[panel]\nsize = [800.5, 480]", "3:8: size is no panel size; give [width, height] in pixels"},
    {"[panel]\nsize = [800]", "3:8: size is no panel size; give [width, height] in pixels"},
    {"[response]\nkind = \"gamma\"\ngamma = 0",
     "4:9: gamma = 0 is out of range; give a number from 0.01 to 100"},
    {"[response]\nkind = \"gamma\"\ngamma = inf", "4:9: 'gamma' must be a finite number"},
    {"[response]\nkind = \"gamma\"\ni0 = 1",
     "4:6: i0 = 1 is out of range; give a number from 0 up to, not including, 1"},
    {"[response]\nkind = \"gamma\"\nk = 0", "4:5: k = 0 is out of range; give a number above 0"},
    {"[response]\nkind = \"bt1886\"\nblack = -0.1",
     "4:9: black = -0.1 is out of range; give a number from 0 up to, not including, 1"},
    {"[response]\nkind = \"linear\"\ngamma = 2.2",
     "4:1: unknown key 'gamma'; use one of: kind, red, green, blue"},
    {"[levels]\ni0 = 0", "3:6: i0 = 0 is out of range; give a number between 0 and 1"},
    {"[levels]\nn = 256",
     "3:5: n = 256 is out of range; give a number from 1 to 255, the packing's highest code"},
    {"[levels]\nn = 15.5", "3:5: 'n' must be an integer"},
    {"[dots]\ndpi = -1", "3:7: dpi = -1 is out of range; give a number from 0 to 1000000"},
    {"[dots]\ngain = 0.3",
     "3:8: gain = 0.3 is out of range; give a number from 0 to 0.25: coverage gained at 50 %"},
    {"[dots]\nisolated = 1", "3:12: 'isolated' must be true or false"},
    // Primaries.
    {"[primaries]\nred = [0.6, 0.3]", "2:1: green is missing; give it as [x, y]"},
    {"[primaries]\nred = [0.6]", "3:7: red is no chromaticity; give [x, y] with y other than 0"},
    {"[primaries]\nred = [0.6, 0]", "3:7: red is no chromaticity; give [x, y] with y other than 0"},
    {"[primaries]\nred = [0.2, 0.3]\ngreen = [0.3, 0.4]\nblue = [0.4, 0.5]",
     "2:1: primaries: the three chromaticities lie on a line; check red, green, blue and white in "
     "[primaries]"},
    {"[primaries]\nset = \"srgb\"\nwhite = \"D65\"\nluminance = [1, 1, 1]",
     "5:13: both luminance and white are given; give one of them"},
    {"[primaries]\nset = \"srgb\"\nluminance = [1, 1]", "4:13: luminance must be [Yr, Yg, Yb]"},
    {"[primaries]\nset = \"srgb\"\nluminance = [0, 0, 0]",
     "2:1: luminances: their sum must be above 0; check red, green, blue and white in "
     "[primaries]"},
    {"[primaries]\nset = \"srgb\"\nred = [0.6, 0.3]",
     "4:1: unknown key 'red'; use one of: set, luminance, white"},
    // Measured tables.
    {"[response]\nkind = \"table\"",
     "3:8: a measured response has no figures; give table = [[code, luminance], ...] or file = "
     "\"measured.csv\""},
    {"[response]\nkind = \"table\"\ntable = [[0, 1], [10, 5], [5, 6]]",
     "4:9: row 3: code 5 does not ascend from 10"},
    {"[response]\nkind = \"table\"\ntable = [[0, 1], [10, 1]]",
     "4:9: row 2: luminance does not rise"},
    {"[response]\nkind = \"table\"\ntable = [[0, 1], [10, 5], [20, 4]]",
     "4:9: row 3: luminance falls from 5 at code 10 to 4 at code 20"},
    {"[response]\nkind = \"table\"\ntable = [[0, -1], [10, 5]]",
     "4:9: row 1: luminance -1 at code 0 is below 0"},
    {"[response]\nkind = \"table\"\ntable = [[0, 1]]",
     "4:9: a measured table needs at least 2 rows"},
    {"[response]\nkind = \"table\"\ntable = [[0, 1, 2], [1, 2, 3]]",
     "4:9: a row is no pair; give [code, luminance] pairs"},
    {"[response]\nkind = \"table\"\ntable = [[0, 1], [256, 2]]",
     "4:9: the measured table leaves the codes 0..255; give code_max where its codes are others "
     "than the frame buffer's"},
    // Gain, offset, gamma, and channels.
    {"[response]\nkind = \"gog\"\noffset = 1",
     "4:10: offset = 1 is out of range; give a number between -1 and 1"},
    {"[frame_buffer]\npacking = \"gray8\"\n[response.red]\nkind = \"srgb\"",
     "4:1: the codes have one channel; give one [response]"},
    {"[response.green]\ngama = 2", "3:1: unknown key 'gama'; use one of: kind"},
    {"[levels]\nspacing = \"measured\"", "3:11: spacing: measured needs a measured response"},
    {"[levels]\nfrom_zero = true", "2:1: from zero: there is no ratio to 0"},
    {"[response]\nkind = \"table\"\nfile = \"m.csv\"",
     "4:8: no file can be named here; give the table itself"},
    // Palettes.
    {"[frame_buffer]\npacking = \"index1\"\n[[palette]]\nrgb = [0, 0, 0]\n[[palette]]\ncode = 0\n"
     "rgb = [255, 255, 255]",
     "4:1: code 0 is in the palette twice"},
    {"[frame_buffer]\npacking = \"index1\"\n[[palette]]\ncode = 2\nrgb = [0, 0, 0]",
     "5:8: code 2 does not fit the packing; give a code from 0 to 1"},
    {"[frame_buffer]\npacking = \"index1\"\n[[palette]]\nlab = [50, 0, 0]",
     "5:7: lab needs the white that it was measured under; add [viewing] white = \"D50\""},
    {"[frame_buffer]\npacking = \"index1\"\n[[palette]]\nrgb = [0, 0, 0]\nxyz = [0, 0, 0]",
     "4:1: a palette entry must say once what it looks like; give one of lab, xyz and rgb"},
    {"[frame_buffer]\npacking = \"index1\"\n[[palette]]\ncode = 0",
     "4:1: a palette entry must say once what it looks like; give one of lab, xyz and rgb"},
    {"[frame_buffer]\npacking = \"index1\"\n[[palette]]\nrgb = [0, 0]",
     "5:7: rgb must have three numbers"},
    {"[frame_buffer]\npacking = \"index1\"\n[[palette]]\nrgb = [0, 0, 255.5]",
     "5:7: rgb is out of range; give encoded sRGB as integers 0..255 or as numbers 0.0..1.0"},
    {"[frame_buffer]\npacking = \"index1\"\n[[palette]]\nxyz = [-1, 0.5, 0.5]",
     "5:7: xyz is negative"},
    {"[frame_buffer]\npacking = \"index1\"\n[[palette]]\nrgb = [9, 9, 9]\n[[palette]]\n"
     "rgb = [9, 9, 9]",
     "4:1: the palette has no lightest and darkest entry; give at least two entries of different "
     "luminance"},
    {"[[palette]]\nrgb = [0, 0, 0]",
     "2:1: packing rgb888 has no palette; give an index, gray or mono packing"},
    // Contradictions.
    {"[frame_buffer]\npacking = \"gray2\"\n[levels]\nn = 3\n[[palette]]\nrgb = [0, 0, 0]",
     "4:1: a display with a palette has no [levels]; remove one"},
    {"[frame_buffer]\npacking = \"index2\"\n[levels]\nn = 3",
     "4:1: an indexed packing has no [levels]; give a gray or RGB packing"},
    {"[frame_buffer]\npacking = \"rgb565\"\n[levels]\nn = 3",
     "4:1: [levels] needs the same bits in each channel; give another packing than rgb565"},
    {"[frame_buffer]\nstore = \"index\"",
     "2:1: store = \"index\" needs intensity levels; add [levels]"},
};

TEST(ParseDisplay, SaysWhatIsWrongWhereAndWhatToDo) {
  for (const BadFile& bad : kBadFiles) {
    const std::string text = std::string("name = \"x\"\n") + bad.text + "\n";
    EXPECT_EQ(error_text([&] { parse_display(text, "a.toml"); }),
              std::string("3 a.toml:") + bad.error)
        << text;
  }
}

TEST(ParseDisplay, NeedsAName) {
  EXPECT_EQ(error_text([] { parse_display("", "a.toml"); }),
            "3 a.toml:1:1: the device has no name; add name = \"...\"");
}

}  // namespace
}  // namespace tristim
