#include "tests/tools/command_test.h"

namespace tristim {
namespace {

class Device : public CommandTest {};

TEST_F(Device, ListsAll) {
  const std::string text = good("device list");
  const auto json = parsed(good("device list --json"));
  ASSERT_EQ(json.size(), std::size(kDevices));
  for (std::size_t i = 0; i < std::size(kDevices); ++i) {
    EXPECT_EQ(json[i]["device"], kDevices[i]);
    EXPECT_NE(text.find(kDevices[i]), std::string::npos);
  }
}

TEST_F(Device, ShowsWhatThereIsToKnow) {
  for (const std::string device : kDevices) {
    SCOPED_TRACE(device);
    const auto json = parsed(good("device show --json " + device));
    for (const char* key :
         {"device", "name", "source", "kind", "packing", "bits_per_pixel", "levels", "dither",
          "response", "primaries", "xyz_from_rgb", "rgb_from_xyz"}) {
      EXPECT_TRUE(json.contains(key)) << key;
    }
    EXPECT_FALSE(json["source"].get<std::string>().empty());
  }
  EXPECT_EQ(parsed(good("device show epaper-7color --json"))["palette"].size(), 7U);
  const std::string two = good("device show srgb vga16 --json");
  EXPECT_EQ(std::count(two.begin(), two.end(), '\n'), 2);
  EXPECT_NE(good("device show laser-300").find("isolated dots       false"), std::string::npos);
}

TEST_F(Device, PrintsFilesThatCheckGood) {
  for (const std::string device : kDevices) {
    SCOPED_TRACE(device);
    write("my.toml", good("device show --toml " + device));
    const std::string checked = good("device check ./my.toml");
    EXPECT_EQ(checked.rfind("./my.toml: good: ", 0), 0U) << checked;
    EXPECT_EQ(parsed(good("device check my.toml --json"))["valid"], true);
    good("process s.exr --size 64x36 -f --quiet -d my.toml -o mine.png");
    good("process s.exr --size 64x36 -f --quiet -o theirs.png -d " + device);
    EXPECT_EQ(read("mine.png"), read("theirs.png"));
  }
}

TEST_F(Device, TakesAMeasuredTableBesideTheFile) {
  std::filesystem::create_directory(file("lab"));
  write("lab/panel.toml",
        "name = \"panel\"\n[frame_buffer]\npacking = \"gray8\"\n[response]\nkind = \"table\"\n"
        "file = \"measured.csv\"\n");
  write("lab/measured.csv", "# cd/m2\ncode, luminance\n0, 0.5\n128, 20\n255, 100\n");
  EXPECT_EQ(good("device check lab/panel.toml").rfind("lab/panel.toml: good: panel", 0), 0U);
  good("process s.exr -d ./lab/panel.toml -o o.png --quiet");
  write("lab/measured.csv", "0, 0.5\n128, 0.25\n255, 100\n");
  refuses(
      "device check lab/panel.toml", 3,
      "lab/measured.csv:2: luminance falls from 0.5 at code 0 to 0.25 at code 128; measure again, "
      "or level it out with --monotone");
  std::filesystem::remove(file("lab/measured.csv"));
  refuses("device check lab/panel.toml", 1,
          "lab/measured.csv: there is no such file; check the name");
}

TEST_F(Device, TellsThePlaceOfAMistake) {
  const auto refuses_file = [&](const std::string& text, const std::string& line) {
    write("p.toml", text);
    refuses("device check p.toml", 3, line);
    refuses("process s.exr -d ./p.toml -o o.png", 3, "./" + line);
  };
  refuses_file("name = \"p\"\n[frame_buffer]\npaking = \"mono1\"\n",
               "p.toml:3:1: unknown key 'paking'; did you mean packing?");
  refuses_file("name = \"p\"\n[frame_buffer]\npacking = \"mono2\"\n",
               "p.toml:3:11: unknown packing 'mono2'; did you mean mono1?");
  refuses_file("kind = \"emissive\"\n", "p.toml:1:1: the device has no name; add name = \"...\"");
}

TEST_F(Device, TellsWhatDoesNotGoTogether) {
  refuses("device", 2,
          "device: list|show|check|new|fit is missing; use: tristim device list|show|check|new|fit "
          "... [options]");
  refuses("device lst", 2, "device: unknown action 'lst'; did you mean list?");
  refuses("device show", 2,
          "device show: no device is named; give one of crt-p22, epaper-4grey, epaper-7color, "
          "laser-300, lcd-rgb565, offset-cmyk, srgb, vga16, or a file");
  refuses("device list srgb", 2,
          "srgb: is one argument too many; use: tristim device list, or tristim device show srgb");
  refuses("device list --toml", 2,
          "--toml: does not go with list; use: tristim device show D --toml");
  refuses("device show srgb --toml --json", 2,
          "--toml: does not go with --json; use: tristim device show D --toml");
}

}  // namespace
}  // namespace tristim
