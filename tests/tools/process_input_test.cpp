#include "tests/image/exr_fixture.h"
#include "tests/tools/command_test.h"

namespace tristim {
namespace {

class ProcessInput : public CommandTest {
 protected:
  void process_refuses(const std::string& input, int code, const std::string& line) const {
    refuses({"process", input, "-d", "srgb", "-o", "o.png"}, code, line);
  }
};

TEST_F(ProcessInput, RefusesWhatIsNoPicture) {
  write("empty.exr", "");
  write("text.exr", "This is no picture.\n");
  write("cut.exr", read("s.exr").substr(0, 1500));
  write("none.pgm", "P5 0 0 255\n");
  std::filesystem::create_directory(file("folder"));
  process_refuses("no.exr", 1,
                  "no.exr: cannot be opened: no such file or directory; check the path");
  process_refuses("", 1, ": cannot be opened: no such file or directory; check the path");
  process_refuses("folder", 1, "folder: is a directory; name a picture inside it");
  process_refuses("empty.exr", 3, "empty.exr: is empty; write or copy it again");
  process_refuses("text.exr", 3,
                  "text.exr: is no picture: its first bytes are of no known format; give EXR, HDR, "
                  "PFM, TIFF, PNG, PNM, BMP or JPEG");
  process_refuses("cut.exr", 3, "cut.exr: is damaged or cut off at row 0; write or copy it again");
  process_refuses("none.pgm", 3, "none.pgm: has no pixels: its size is 0x0");
}

TEST_F(ProcessInput, RefusesAPictureWithoutColourAndListsItsChannels) {
  fixture::write_exr(file("depth.exr"), fixture::header(4, 4, {"Z", "id"}, Imf::FLOAT));
  const CommandResult result = run("process depth.exr -d srgb -o o.png");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err.rfind("tristim: depth.exr: has no colour channels", 0), 0U) << result.err;
  EXPECT_NE(result.err.find("Z, id"), std::string::npos) << result.err;
  EXPECT_FALSE(exists("o.png"));
}

TEST_F(ProcessInput, FindsAMissingInputBeforeAnyWorkIsDone) {
  refuses("process s.exr no.exr -d srgb -o {stem}.png", 1,
          "no.exr: cannot be opened: no such file or directory; check the path");
}

TEST_F(ProcessInput, TakesNamesWithBlanksLettersAndLineEnds) {
  for (const std::string stem : {"a b", "\u00fc \u2603", "[1]", "%%", "++", "-d", "x\ny", "\xff"}) {
    SCOPED_TRACE(stem);
    std::filesystem::copy_file(file("s.exr"), file(stem + ".exr"));
    const CommandResult result =
        run({"process", "--json", "-d", "srgb", "-o", "{stem}.png", "--", stem + ".exr"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(exists(stem + ".png"));
    EXPECT_TRUE(parsed(result.out).is_object()) << result.out;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

TEST_F(ProcessInput, ReadsStandardInput) {
  good("process s.exr -d vga16 --size 64x36 -o file.png --quiet");
  const CommandOptions piped{.input = read("s.exr")};
  good("process - -d vga16 --size 64x36 -o stdin.png --quiet", piped);
  EXPECT_EQ(read("stdin.png"), read("file.png"));
  const CommandResult pipe =
      shell("cat s.exr | tristim process /dev/stdin -d vga16 --size 64x36 -o - --quiet > pipe.png");
  EXPECT_EQ(pipe.exit_code, 0) << pipe.err;
  EXPECT_EQ(read("pipe.png"), read("file.png"));
}

TEST_F(ProcessInput, ReadsStandardInputTwiceForAPalette) {
  const std::string rest = " -d vga16 --palette median-cut:16 --size 64x36 --quiet -o ";
  good("process s.exr" + rest + "file.png");
  good("process -" + rest + "stdin.png", {.input = read("s.exr")});
  EXPECT_EQ(read("stdin.png"), read("file.png"));
  const CommandResult pipe = shell("cat s.exr | tristim process -" + rest + "pipe.png");
  EXPECT_EQ(pipe.exit_code, 0) << pipe.err;
  EXPECT_EQ(read("pipe.png"), read("file.png"));
}

TEST_F(ProcessInput, RefusesStandardInputTwice) {
  refuses("process - - -d srgb -o %d.png", 2,
          "-: standard input is asked for more than once; give the names of files");
  refuses("process - -d - -o o.png", 2,
          "-: standard input is asked for more than once; give the names of files");
  const CommandResult closed = shell("tristim process - -d srgb -o o.png <&-");
  EXPECT_EQ(closed.exit_code, 1);
  EXPECT_EQ(closed.err, "tristim: standard input: cannot be opened: bad file descriptor\n");
}

TEST_F(ProcessInput, SaysOnceHowManyOddValuesThereWere) {
  fixture::write_exr(file("odd.exr"), fixture::header(8, 1, {"R", "G", "B"}, Imf::FLOAT),
                     [](const std::string&, int x, int) {
                       return x == 0   ? std::numeric_limits<float>::quiet_NaN()
                              : x == 1 ? std::numeric_limits<float>::infinity()
                                       : 0.25F;
                     });
  const CommandResult result = run("process odd.exr -d srgb -o o.png --json --exposure -20");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "tristim: odd.exr: note: 3 NaN read as 0, 3 infinities as +-65504\n");
  const nlohmann::json facts = parsed(result.out);
  EXPECT_EQ(facts["nan"], 3);
  EXPECT_EQ(facts["infinite"], 3);
}

TEST_F(ProcessInput, SurvivesEveryDamagedFile) {
  if (!shared_dir()) GTEST_SKIP() << kNoShared;
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*shared_dir() / "images/damaged")) {
    SCOPED_TRACE(entry.path().filename());
    const CommandResult result =
        run({"process", entry.path().string(), "-d", "srgb", "-o", "o.png", "--quiet", "--force"},
            {.timeout_s = 5});
    EXPECT_FALSE(result.timed_out);
    EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 3) << result.exit_code;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), result.exit_code == 0 ? 0 : 1)
        << result.err;
    EXPECT_EQ(exists("o.png"), result.exit_code == 0);
    EXPECT_LT(result.peak_bytes, std::size_t{512} << 20);
    std::filesystem::remove(file("o.png"));
    ++count;
  }
  EXPECT_GT(count, 80);
}

}  // namespace
}  // namespace tristim
