#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tristim::tools {

/// The arguments behind a command's name.
using Arguments = std::span<const std::string>;

/// A command of `tristim`; tools/commands.h lists them all.
struct Command {
  std::string_view name;
  std::string_view usage;  // what follows the name
  std::string_view summary;
  void (*run)(Arguments arguments);  // throws Error for whatever goes wrong
};

/// Declares and reads a command's options: GNU style, in front of the one file that knows the
/// option parser.
///
/// Numbers such as -2 and -inf are values, never options. --help and --quiet are always there.
class CommandLine {
 public:
  /// `examples`: complete commands that work, one a line, for the end of --help.
  CommandLine(const Command& command, std::string_view examples);
  ~CommandLine();

  void positional(const std::string& name, const std::string& help,
                  std::vector<std::string>& values, int least, int most);
  void option(const std::string& names, const std::string& argument, const std::string& help,
              std::string& value);
  void option(const std::string& names, const std::string& argument, const std::string& help,
              std::function<void(const std::string&)> set);
  void flag(const std::string& names, const std::string& help, bool& value);

  /// A switch with both positions, --name and --no-name; `set` gets "true" or "false" where one is
  /// given.
  void toggle(const std::string& name, const std::string& help,
              std::function<void(const std::string&)> set);

  /// Begins a section of the help page; what is declared next stands in it.
  void section(const std::string& title);

  /// False where help was asked for and printed. Throws Error (kMisuse).
  bool parse(Arguments arguments);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The value of a numeric option. Throw Error (kMisuse) for other texts and outside of the range,
/// which `range` puts into words where its bounds do not: "between 0 and 1".
double number_option(std::string_view option, std::string_view text, double least, double most,
                     std::string_view range = {});
int integer_option(std::string_view option, std::string_view text, int least, int most);

/// `text` as it is safe to show: '?' for control characters, which file names may have.
std::string one_line(std::string text);

/// A line on standard error, "tristim: <text>", unless --quiet was given.
void note(const std::string& text);

/// Whether --quiet was given.
bool quiet();

/// Standard output as text; throws Error (kSystem) where it cannot be written.
void print(std::string_view text);

}  // namespace tristim::tools
