#include "tests/image/exr_fixture.h"
#include "tests/tools/command_test.h"

namespace tristim {
namespace {

class Info : public CommandTest {};

TEST_F(Info, PrintsWhatAFileIs) {
  const std::string text = good("info s.exr");
  EXPECT_EQ(text.rfind("s.exr\n  format        openexr\n  size          64x36\n", 0), 0U) << text;
  const auto json = parsed(good("info s.exr --json"));
  EXPECT_EQ(json["file"], "s.exr");
  EXPECT_EQ(json["format"], "openexr");
  EXPECT_EQ(json["width"], 64);
  EXPECT_EQ(json["height"], 36);
  EXPECT_EQ(json["channels"], nlohmann::json::array({"B:half", "G:half", "R:half"}));
  EXPECT_EQ(json["data_window"]["width"], 64);
  EXPECT_NEAR(json["primaries"]["white"][0].get<double>(), 0.3127, 1e-6);
  for (const char* key : {"compression", "colour", "pixel_aspect", "orientation"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
}

TEST_F(Info, PrintsALineAFile) {
  good("process s.exr -d epaper-4grey --size 64x36 -o o.png --quiet");
  const std::string lines = good("info s.exr o.png --json");
  ASSERT_EQ(split(lines, '\n').size(), 3U);
  EXPECT_EQ(parsed(std::string(split(lines, '\n')[1]))["format"], "png");
  EXPECT_EQ(parsed(good("info - --json", {.input = read("s.exr")}))["width"], 64);
}

TEST_F(Info, KnowsFilesWithoutColour) {
  fixture::write_exr(file("depth.exr"), fixture::header(4, 4, {"Z"}, Imf::FLOAT));
  EXPECT_EQ(parsed(good("info depth.exr --json"))["channels"], nlohmann::json::array({"Z:float"}));
}

TEST_F(Info, TakesNamesThatAreNotUtf8) {
  std::filesystem::copy_file(file("s.exr"), file("\xff\n.exr"));
  EXPECT_TRUE(parsed(good({"info", "\xff\n.exr", "--json"})).is_object());
  EXPECT_EQ(good({"info", "\xff\n.exr"}).substr(0, 7), "\xff?.exr\n");
}

TEST_F(Info, RefusesWhatIsNoPicture) {
  write("text.exr", "text");
  refuses("info", 2, "info: FILE is missing; use: tristim info FILE... [options]");
  refuses("info no.exr", 1, "no.exr: cannot be opened: no such file or directory; check the path");
  refuses("info text.exr", 3,
          "text.exr: is no picture: its first bytes are of no known format; give EXR, HDR, PFM, "
          "TIFF, PNG, PNM, BMP or JPEG");
}

}  // namespace
}  // namespace tristim
