#include <sys/stat.h>

#include <csignal>

#include "tests/tools/command_test.h"

namespace tristim {
namespace {

class ProcessOutput : public CommandTest {};

const std::string kFormats =
    "use one of: png gif bmp dib tif tiff pnm pbm pgm ppm raw bin h hpp c inc exr";

TEST_F(ProcessOutput, NeedsANameWithAKnownFormat) {
  refuses("process s.exr -d srgb", 2, "--output: is missing; give -o result.png, or another name");
  refuses("process s.exr -d srgb -o x", 2,
          "x: has no extension that tells the format; " + kFormats);
  refuses("process s.exr -d srgb -o x.jpg", 2, "x.jpg: unknown extension 'jpg'; " + kFormats);
  refuses("process s.exr -d srgb -o x.png --format jpg", 2,
          "--format: unknown format 'jpg'; use one of: png, gif, bmp, tiff, pnm, raw, c, exr");
  refuses("process s.exr -d srgb -o x.png --format ppm", 2,
          "--format: unknown format 'ppm'; did you mean pnm?");
}

TEST_F(ProcessOutput, RefusesPlacesThatCannotBeWritten) {
  std::filesystem::create_directory(file("folder"));
  refuses("process s.exr -d srgb -o folder", 1,
          "folder: is a directory; give a name in it: folder/{stem}.png");
  refuses("process s.exr -d srgb -o no/x.png", 1,
          "no/x.png: there is no directory no; create it first");
  refuses("process s.exr -d srgb -o s.exr/x.png", 1,
          "s.exr/x.png: s.exr is no directory; choose another place");
  const CommandResult kernel = run("process s.exr -d srgb -o /proc/tristim/x.png");
  EXPECT_EQ(kernel.exit_code, 1);
  EXPECT_EQ(kernel.err,
            "tristim: /proc/tristim/x.png: there is no directory /proc/tristim; create it first\n");
}

TEST_F(ProcessOutput, RefusesAReadOnlyDirectory) {
  std::filesystem::create_directory(file("locked"));
  chmod(file("locked").c_str(), 0555);
  if (access(file("locked").c_str(), W_OK) == 0) {
    const CommandResult result = run("process s.exr -d srgb -o /proc/x.png --quiet");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(result.err.rfind("tristim: /proc/x.png: cannot write in directory /proc: ", 0), 0U)
        << result.err;
    GTEST_SKIP() << "root may write in a read-only directory; /proc was tested";
  }
  refuses("process s.exr -d srgb -o locked/x.png", 1,
          "locked/x.png: cannot write in directory locked: permission denied; check the "
          "permissions");
}

TEST_F(ProcessOutput, ReplacesWithForceOnly) {
  good("process s.exr -d srgb -o o.png --proof p.png --quiet");
  const std::string first = read("o.png");
  refuses("process s.exr -d srgb --exposure -1 -o o.png", 1,
          "o.png: exists already; give --force to replace it");
  refuses("process s.exr -d srgb --exposure -1 -o new.png --proof p.png", 1,
          "p.png: exists already; give --force to replace it");
  EXPECT_EQ(read("o.png"), first);
  good("process s.exr -d srgb --exposure -1 -o o.png --force --quiet");
  EXPECT_NE(read("o.png"), first);
}

TEST_F(ProcessOutput, FindsATakenNameBeforeTheFirstOfSeveralIsWritten) {
  write("2.png", "");
  refuses("process s.exr s.exr s.exr -d srgb -o %d.png", 1,
          "2.png: exists already; give --force to replace it");
}

TEST_F(ProcessOutput, ResumesAfterThePicturesThatAreThere) {
  const std::string job = "process s.exr s.exr s.exr -d srgb -o %d.png --proof proof%d.png";
  good(job);
  const std::string whole = read("2.png");
  std::filesystem::remove(file("2.png"));  // its proof is left: the run was killed between the two
  write("1.png", "mine");
  const CommandResult result = run(job + " --resume");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err.rfind("tristim: --resume: note: 2 pictures are there already, 1 to do\n", 0),
            0U)
      << result.err;
  EXPECT_EQ(read("2.png"), whole);
  EXPECT_EQ(read("1.png"), "mine");
  EXPECT_EQ(run(job + " --resume --quiet").err, "");
  refuses(job + " --resume --force", 2,
          "--resume: keeps the files that --force replaces; give one of them");
}

TEST_F(ProcessOutput, NeverReplacesAnInput) {
  std::filesystem::create_symlink("s.exr", file("link.exr"));
  std::filesystem::create_hard_link(file("s.exr"), file("hard.exr"));
  write("panel.toml", "name = \"panel\"\n");
  write("p.toml", "exposure = -1\n");
  const std::string before = read("s.exr");
  for (const std::string name : {"s.exr", "./s.exr", "link.exr", "hard.exr"}) {
    refuses("process s.exr -d srgb --force -o " + name, 2,
            name + ": is an input too; choose another name for the output");
  }
  refuses("process link.exr -d srgb --force -o s.exr", 2,
          "s.exr: is an input too; choose another name for the output");
  refuses("process s.exr -d ./panel.toml --force --format raw -o panel.toml", 2,
          "panel.toml: is an input too; choose another name for the output");
  refuses("process s.exr -d srgb --pipeline p.toml --force --format raw -o p.toml", 2,
          "p.toml: is an input too; choose another name for the output");
  EXPECT_EQ(read("s.exr"), before);
}

TEST_F(ProcessOutput, RefusesTwoOutputsOfOneName) {
  std::filesystem::create_directory(file("folder"));
  std::filesystem::copy_file(file("s.exr"), file("folder/s.exr"));
  refuses("process s.exr folder/s.exr -d srgb -o o.png", 2,
          "--output: two inputs would be written to o.png; put {stem} or %04d into the name");
  refuses("process s.exr folder/s.exr -d srgb -o {stem}.png", 2,
          "--output: two inputs would be written to s.png; put %04d into the name, the number of "
          "the picture");
  refuses("process s.exr folder/s.exr -d srgb -o %d.png --proof p.png", 2,
          "--proof: two inputs would be written to p.png; put {stem} or %04d into the name");
  refuses("process s.exr -d srgb -o o.png --proof ./o.png", 2,
          "--proof: ./o.png is the output too; choose another name for the proof");
  refuses("process s.exr -d srgb -o - --proof -", 2,
          "--proof: - is the output too; choose another name for the proof");
}

TEST_F(ProcessOutput, NumbersAndNamesSeveral) {
  std::filesystem::create_directory(file("folder"));
  std::filesystem::copy_file(file("s.exr"), file("folder/t.exr"));
  good("process s.exr folder/t.exr -d srgb --quiet -o f%04d.png --proof {stem}-100%%.png");
  good("process s.exr folder/t.exr -d srgb --quiet -o {stem}%2d.ppm");
  EXPECT_EQ(files(), (std::vector<std::string>{"f0001.png", "f0002.png", "folder", "s 1.ppm",
                                               "s-100%.png", "s.exr", "t 2.ppm", "t-100%.png"}));
  EXPECT_EQ(read("f0001.png"), read("f0002.png"));
  refuses("process s.exr -d srgb -o n%s.png", 2,
          "--output: 'n%s.png' has a '%' without a number; write %04d for the number of the frame, "
          "%% for a percent sign");
}

TEST_F(ProcessOutput, ProofsArePng) {
  refuses("process s.exr -d srgb -o o.png --proof p.jpg", 2,
          "--proof: 'p.jpg' does not end in .png; proofs are PNG: give p.png");
  good("process s.exr -d srgb -o o.ppm --proof p.PNG --quiet");
  EXPECT_EQ(read("p.PNG").substr(1, 3), "PNG");
}

TEST_F(ProcessOutput, PipesPictures) {
  good("process s.exr -d srgb -o o.png --quiet");
  EXPECT_EQ(good("process s.exr -d srgb -o -"), read("o.png"));
  EXPECT_EQ(good("process s.exr -d srgb -o /dev/stdout"), read("o.png"));
  EXPECT_EQ(good("process s.exr -d srgb -o /dev/null --proof -"), read("o.png"));
  EXPECT_EQ(good("process s.exr -d srgb -o - --format pnm").substr(0, 2), "P6");
  EXPECT_EQ(good("process s.exr -d srgb -o - --format exr").substr(0, 4), "\x76\x2f\x31\x01");
}

TEST_F(ProcessOutput, KeepsFactsAndPicturesApart) {
  refuses("process s.exr -d srgb -o - --json", 2,
          "--json: standard output is taken by the picture; write the picture to a file");
  refuses("process s.exr -d srgb -o - --explain", 2,
          "--explain: standard output is taken by the picture; write the picture to a file");
  refuses("process s.exr -d srgb -o o.png --proof - --json", 2,
          "--json: standard output is taken by the picture; write the picture to a file");
}

TEST_F(ProcessOutput, ReportsAFullDiskAndALimit) {
  refuses("process s.exr -d srgb -o /dev/full", 1,
          "/dev/full: cannot write: no space left on device; free some space or write elsewhere");
  for (const std::string command :
       {"process s.exr -d srgb --size 400x400 --quiet -o o.png",
        "process s.exr -d srgb --size 400x400 --quiet -o o.exr",
        "process s.exr -d srgb --size 400x400 --quiet -o small.raw --proof o.png",
        "render spheres --size 200x200 -o o.exr"}) {
    SCOPED_TRACE(command);
    const CommandResult limited = shell("ulimit -f 4; exec \"$TRISTIM\" " + command);
    EXPECT_EQ(limited.exit_code, 1);
    EXPECT_NE(limited.err.find("cannot write: file too large; raise the limit (ulimit -f) or write "
                               "elsewhere\n"),
              std::string::npos)
        << limited.err;
    EXPECT_EQ(files(), (std::vector<std::string>{"s.exr"}));
  }
}

TEST_F(ProcessOutput, ReportsALostReader) {
  const CommandResult lost = shell(
      "tristim process s.exr -d srgb --size 1000x1000 --quiet -o - | head -c 9 >/dev/null\n"
      "exit ${PIPESTATUS[0]}");
  EXPECT_EQ(lost.exit_code, 1);
  EXPECT_EQ(lost.err,
            "tristim: standard output: cannot write: broken pipe; the program that reads it has "
            "ended\n");
}

TEST_F(ProcessOutput, LeavesNothingBehindWhenInterrupted) {
  for (const int number : {SIGINT, SIGTERM}) {
    for (const char* command :
         {"process s.exr -d vga16 --size 20000x20000 --quiet -o o.png --proof p.png",
          "render spheres --size 9000x9000 --samples 64 -o o.exr"}) {
      SCOPED_TRACE(command);
      const CommandResult result =
          run(command, {.timeout_s = 20, .signal = number, .signal_after_s = 0.3});
      EXPECT_EQ(result.exit_code, -number);
      EXPECT_FALSE(result.timed_out);
      EXPECT_EQ(files(), (std::vector<std::string>{"s.exr"}));
    }
  }
}

TEST_F(ProcessOutput, GoesOnUnderNohup) {
  const CommandResult result = shell(
      "trap '' HUP\n"
      "tristim process s.exr -d vga16 --size 1200x1200 --quiet -o o.png & job=$!\n"
      "sleep 0.05; kill -HUP $job; wait $job");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(exists("o.png"));
}

TEST_F(ProcessOutput, LeavesNothingBehindWhenAnInputIsCutOff) {
  write("cut.exr", read("s.exr").substr(0, 6000));
  const CommandResult result =
      run("process s.exr cut.exr -d srgb -o {stem}.png --proof {stem}-proof.png --quiet");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(files(), (std::vector<std::string>{"cut.exr", "s-proof.png", "s.exr", "s.png"}));
}

}  // namespace
}  // namespace tristim
