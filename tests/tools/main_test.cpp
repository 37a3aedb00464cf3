#include "tests/tools/command_test.h"
#include "tristim/core/version.h"

namespace tristim {
namespace {

class Main : public CommandTest {};

constexpr const char* kCommands[] = {"process", "convert", "spectrum", "gamut", "compare",
                                     "palette", "levels",  "halftone", "lut",   "device",
                                     "info",    "shade",   "render"};

TEST_F(Main, PrintsItsVersion) {
  EXPECT_EQ(good("--version"), "tristim " + std::string(kVersion) + "\n");
}

TEST_F(Main, HelpListsEveryCommand) {
  const std::string help = good("--help");
  for (const char* command : kCommands) {
    EXPECT_NE(help.find("\n  " + std::string(command) + " "), std::string::npos) << command;
  }
  EXPECT_EQ(good(std::vector<std::string>{}), help);
  EXPECT_EQ(good("help"), help);
  EXPECT_EQ(good("-h"), help);
}

TEST_F(Main, EveryCommandHasHelpOf80Columns) {
  for (const char* command : kCommands) {
    SCOPED_TRACE(command);
    const std::string help = good({command, "--help"});
    EXPECT_EQ(help.rfind("Usage: tristim " + std::string(command) + " ", 0), 0U);
    EXPECT_EQ(good({"help", command}), help);
    const std::size_t examples = help.find("\nExamples:\n");
    ASSERT_NE(examples, std::string::npos);
    for (const std::string_view line : split(std::string_view(help).substr(0, examples), '\n')) {
      EXPECT_LE(line.size(), 82U) << line;  // one word may be longer
    }
  }
}

std::string examples_of(const std::string& help) {
  return help.substr(help.find("\nExamples:\n") + std::string("\nExamples:\n").size());
}

// Pictures of the size of the examples would take seconds.
constexpr const char* kSmallRender =
    "tristim() {\n"
    "  case \"$*\" in\n"
    "    'render spheres -o '*) \"$TRISTIM\" \"$@\" --size 64x36 ;;\n"
    "    *) \"$TRISTIM\" \"$@\" ;;\n"
    "  esac\n"
    "}\n";

TEST_F(Main, EveryExampleWorks) {
  std::vector<std::string> pages{good("--help")};
  for (const char* command : kCommands) pages.push_back(good({command, "--help"}));
  for (const std::string& page : pages) {
    const TemporaryDirectory place;
    int count = 0;
    const std::string examples = examples_of(page);
    for (const std::string_view line : split(examples, '\n')) {
      if (line.empty()) continue;
      SCOPED_TRACE(line);
      const CommandResult result =
          shell(kSmallRender + ("set -o pipefail; cd " + place.path().string() + "\n") +
                std::string(line));
      EXPECT_EQ(result.exit_code, 0) << result.err;
      ++count;
    }
    EXPECT_GE(count, 2);
  }
}

TEST_F(Main, HintsAtTheNearestCommand) {
  refuses("proces", 2, "proces: unknown command; did you mean process?");
  refuses("xyzzyx", 2,
          "xyzzyx: unknown command; use one of: "
          "process, convert, spectrum, gamut, compare, palette, levels, halftone, lut, device, "
          "info, shade, render");
  refuses("--quiet process", 2,
          "--quiet: unknown option; options follow the command: tristim <command> [options]");
  refuses("help proces", 2, "proces: unknown command; did you mean process?");
}

TEST_F(Main, NamesIgnoreCaseUnderscoreAndHyphen) {
  EXPECT_EQ(good("DEVICE LIST"), good("device list"));
  EXPECT_EQ(good("device show EPAPER_4GREY --toml"), good("device show epaper-4grey --toml"));
}

TEST_F(Main, HintsAtTheNearestOption) {
  refuses("levels --gama 2", 2, "--gama: unknown option; did you mean --gamma?");
  refuses("process s.exr -d srgb -o o.png --dihter none", 2,
          "--dihter: unknown option; did you mean --dither?");
  refuses("process s.exr -d srgb -o o.png --tone reinhard", 2,
          "--tone: unknown option; did you mean --tone-map?");
  refuses("levels --xyzzyx", 2, "--xyzzyx: unknown option; see tristim levels --help");
  refuses("levels -x", 2, "-x: unknown option; see tristim levels --help");
  refuses("levels 5", 2, "5: is one argument too many; see tristim levels --help");
}

TEST_F(Main, TellsWhatAnOptionLacks) {
  refuses("process s.exr -d srgb -o o.png --exposure", 2,
          "--exposure: has no value; see tristim process --help");
  refuses("process s.exr -d srgb -o o.png --exposure 1 --exposure 2", 2,
          "--exposure: is given more than once; give it once");
  refuses("process s.exr -d srgb -o o.png --serpentine=no", 2,
          "--serpentine: takes no value; give it alone");
}

TEST_F(Main, ReportsAStandardOutputThatIsClosedOrFull) {
  const CommandResult closed = shell("tristim device list >&-");
  EXPECT_EQ(closed.exit_code, 1);
  EXPECT_EQ(closed.err, "tristim: standard output: cannot write: bad file descriptor\n");
  const CommandResult full = shell("tristim device list >/dev/full");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_EQ(full.err,
            "tristim: standard output: cannot write: no space left on device; free some space or "
            "write elsewhere\n");
}

TEST_F(Main, NumbersIgnoreTheLocale) {
  const std::string plain = good("convert --to lab 0.5 0.25 1.5");
  for (const char* locale : {"LC_ALL=de_DE.UTF-8", "LC_ALL=de_DE"}) {
    EXPECT_EQ(good("convert --to lab 0.5 0.25 1.5", {.variables = {locale}}), plain);
    EXPECT_EQ(good("levels --n 15 --i0 0.02 --json", {.variables = {locale}}),
              good("levels --n 15 --i0 0.02 --json"));
  }
}

TEST_F(Main, ShowsProgressToATerminalOnly) {
  const std::string command = "process s.exr -d vga16 --force -o o.png --size ";
  EXPECT_EQ(run(command + "9x9 --quiet").err, "");
  if (shell("command -v script").exit_code != 0) GTEST_SKIP() << "no script: the pipe was tested";
  const auto terminal = [&](const std::string& arguments) {
    return shell("script -qec \"$TRISTIM " + arguments + "\" /dev/null").out;
  };
  const std::string shown = terminal(command + "4000x4000 --serpentine");  // takes seconds
  EXPECT_NE(shown.find("\rs.exr: "), std::string::npos) << shown;
  EXPECT_EQ(shown.find('\033'), std::string::npos) << "not every terminal knows escape sequences";
  EXPECT_NE(shown.find(" \rtristim: s.exr: note: "), std::string::npos) << shown;
  EXPECT_EQ(terminal(command + "9x9 --quiet"), "");
  EXPECT_EQ(
      terminal("process s.exr -d srgb -o -"),
      "tristim: -: a picture is not written to a terminal; give -o a file, or pipe it on\r\n");
}

}  // namespace
}  // namespace tristim
