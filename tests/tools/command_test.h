#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support.h"
#include "tristim/core/text.h"
#include "tristim/image/io/exr.h"
#include "tristim/render/spheres.h"

namespace tristim {

inline constexpr const char* kDevices[] = {"crt-p22",   "epaper-4grey", "epaper-7color",
                                           "laser-300", "lcd-rgb565",   "offset-cmyk",
                                           "srgb",      "vga16"};

/// Arguments of a command: a text is words separated by single blanks, a list is as it stands.
struct Words : std::vector<std::string> {
  // NOLINTBEGIN(google-explicit-constructor): so that tests read as command lines
  Words(const char* text) : Words(std::string(text)) {}
  Words(const std::string& text) {
    for (const std::string_view word : split(text, ' ')) emplace_back(word);
  }
  Words(std::initializer_list<std::string> list) : std::vector<std::string>(list) {}
  Words(std::vector<std::string> list) : std::vector<std::string>(std::move(list)) {}
  // NOLINTEND(google-explicit-constructor)
};

/// Runs the command in a scratch directory that holds s.exr, the spheres at 64x36.
class CommandTest : public testing::Test {
 protected:
  void SetUp() override {
    const SpheresOptions options{.width = 64, .height = 36, .samples = 1};
    const auto sink = open_exr_sink(file("s.exr"), spheres_info(options));
    render_spheres(default_scene(), options, *sink);
    sink->finish();
  }

  std::string file(const std::string& name) const { return scratch_.file(name); }
  void write(const std::string& name, const std::string& bytes) const {
    write_bytes(file(name), bytes);
  }
  std::string read(const std::string& name) const { return read_bytes(file(name)); }
  bool exists(const std::string& name) const {
    return std::filesystem::exists(std::filesystem::symlink_status(file(name)));
  }

  CommandResult run(const Words& arguments, CommandOptions options = {}) const {
    options.directory = scratch_.path();
    return run_tristim(arguments, options);
  }

  /// Runs the command, which must end with 0; what it wrote to standard output.
  std::string good(const Words& arguments, const CommandOptions& options = {}) const {
    const CommandResult result = run(arguments, options);
    EXPECT_EQ(result.exit_code, 0) << testing::PrintToString(arguments) << result.err;
    return result.out;
  }

  /// A shell that finds the command as `tristim`.
  CommandResult shell(const std::string& script, CommandOptions options = {}) const {
    options.directory = scratch_.path();
    options.variables.push_back("TRISTIM=" + tristim_path());
    return run_command({"bash", "-c", "tristim() { \"$TRISTIM\" \"$@\"; }\n" + script}, options);
  }

  /// Every file of the scratch directory, sorted.
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(scratch_.path())) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  /// The command must refuse with this code and exactly this line, and leave no new file behind.
  void refuses(const Words& arguments, int code, const std::string& line,
               const CommandOptions& options = {}) const {
    SCOPED_TRACE(testing::PrintToString(arguments));
    const std::vector<std::string> before = files();
    const CommandResult result = run(arguments, options);
    EXPECT_EQ(result.err, "tristim: " + line + "\n");
    EXPECT_EQ(result.exit_code, code);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(files(), before);
  }

  static nlohmann::json parsed(const std::string& text) {
    return nlohmann::json::parse(text, nullptr, /*allow_exceptions=*/false);
  }

 private:
  TemporaryDirectory scratch_;
};

}  // namespace tristim
