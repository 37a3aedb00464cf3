#include <fcntl.h>
#include <unistd.h>

#include <map>

#include "tests/tools/command_test.h"

namespace tristim {
namespace {

// Several pictures in one run.
class ProcessSequence : public CommandTest {
 protected:
  // A picture that is `stops` brighter than the spheres, as an EXR.
  std::string brighter(int stops) const {
    const std::string name = "s" + std::to_string(stops) + ".exr";
    good("process s.exr -d srgb --quiet --exposure " + std::to_string(stops) + " -o " + name);
    return name;
  }

  bool has_unnamed_files() const {
    const int unnamed = ::open(file(".").c_str(), O_TMPFILE | O_WRONLY, 0600);
    if (unnamed >= 0) ::close(unnamed);
    return unnamed >= 0;
  }
};

std::string repeated(const std::string& word, int times) {
  std::string words;
  for (int i = 0; i < times; ++i) words += " " + word;
  return words;
}

TEST_F(ProcessSequence, IsTheSameOnAnyNumberOfThreads) {
  std::string inputs;
  for (const int stops : {-2, -1, 0, 1, 2}) inputs += " " + brighter(stops);
  const std::string job = "process" + inputs + " -d srgb --dither floyd-steinberg -o ";
  good(job + "a%d.png --quiet --threads 1");
  for (const std::string threads : {"2", "3", "4", "7"}) {
    good(job + "b%d.png --force --quiet --threads " + threads);
    for (const std::string number : {"1", "2", "3", "4", "5"}) {
      EXPECT_EQ(read("a" + number + ".png"), read("b" + number + ".png")) << threads;
    }
  }
}

TEST_F(ProcessSequence, TellsOfPicturesInTheirOrder) {
  // The first one takes the longest.
  good("process s.exr -d srgb --quiet --size 800x -o large.exr");
  const std::string bright = brighter(4);
  for (const std::string threads : {"1", "2", "7"}) {
    const CommandResult result = run("process large.exr" + repeated(bright, 8) +
                                     " -d srgb --exposure 3 -o {stem}%d.png --force --json "
                                     "--threads " +
                                     threads);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    std::vector<std::string> outputs;
    for (const std::string_view line : split(result.out, '\n')) {
      if (!line.empty()) outputs.push_back(parsed(std::string(line))["output"]);
    }
    std::vector<std::string> expected{"large1.png"};
    for (int i = 2; i <= 9; ++i) expected.push_back("s4" + std::to_string(i) + ".png");
    EXPECT_EQ(outputs, expected) << threads;
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 9) << result.err;
    EXPECT_EQ(result.err.rfind("tristim: large.exr: note: ", 0), 0U) << result.err;
  }
}

TEST_F(ProcessSequence, EndsWithTheFirstFailureOfItsOrder) {
  good("process s.exr -d srgb --quiet --size 1500x -o large.exr");
  const std::string large = read("large.exr");
  write("late.exr", large.substr(0, large.size() - 100));
  write("early.exr", large.substr(0, 20000));
  for (const std::string threads : {"1", "2", "7"}) {
    SCOPED_TRACE(threads);
    const CommandResult result =
        run("process s.exr late.exr early.exr" + repeated("large.exr", 20) +
            " -d srgb -o %d.png --quiet --force --threads " + threads);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_EQ(result.err.rfind("tristim: late.exr: is damaged or cut off at row ", 0), 0U)
        << result.err;
    EXPECT_TRUE(exists("1.png"));
    for (const std::string& name : files()) {
      EXPECT_TRUE(name.ends_with(".exr") || (name.ends_with(".png") && name != "2.png" &&
                                             name != "3.png" && name != "23.png"))
          << name;
    }
  }
}

TEST_F(ProcessSequence, GoesOnAfterItWasKilled) {
  constexpr int kPictures = 300;
  const std::string job =
      "process" + repeated("s.exr", kPictures) + " -d srgb --size 200x200 --quiet -o %d.png";
  good("process s.exr -d srgb --size 200x200 --quiet -o whole.png");
  const CommandResult killed = shell("$TRISTIM " + job +
                                     " & job=$!\n"
                                     "until [ -e 3.png ]; do sleep 0.005; done\n"
                                     "kill -KILL $job; wait $job");
  EXPECT_EQ(killed.exit_code, 128 + 9);
  std::map<std::string, std::filesystem::file_time_type> done;
  for (const std::string& name : files()) {
    if (!has_unnamed_files() && name.starts_with(".tristim-")) continue;
    if (name == "s.exr" || name == "whole.png") continue;
    EXPECT_EQ(read(name), read("whole.png")) << name;
    done[name] = std::filesystem::last_write_time(file(name));
  }
  EXPECT_GE(done.size(), 1U);
  EXPECT_LT(done.size(), std::size_t{kPictures});
  good(job + " --resume");
  for (const auto& [name, time] : done) {
    EXPECT_EQ(std::filesystem::last_write_time(file(name)), time) << name;
  }
  for (int i = 1; i <= kPictures; ++i) {
    EXPECT_EQ(read(std::to_string(i) + ".png"), read("whole.png")) << i;
  }
}

}  // namespace
}  // namespace tristim
