#include "tools/cli.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "tools/help.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

bool quiet_flag = false;  // NOLINT(readability-identifier-naming): the process's one verbosity

// CLI11 would take a negative number for an option: a blank in front makes it a value, and is taken
// off again.
std::string guarded(const std::string& argument) {
  const bool number = argument.starts_with("-.") ||
                      (argument.starts_with('-') && parse_number(argument).has_value());
  return number ? " " + argument : argument;
}

std::string unguarded(std::string value) {
  if (value.starts_with(" -")) value.erase(0, 1);
  return value;
}

struct OptionName {
  std::string name;
};

struct Positional {
  std::string name;
  const std::vector<std::string>* values;
  std::size_t least;
};

[[noreturn]] void misuse(std::string_view thing, std::string_view wrong, std::string_view remedy) {
  throw Error(ErrorKind::kMisuse, thing, wrong, remedy);
}

// "-o,--output" as help shows it; long names alone stand below long names.
std::string shown_names(const std::string& names) {
  const std::size_t comma = names.find(',');
  if (comma == std::string::npos) return "    " + names;
  return names.substr(0, comma) + ", " + names.substr(comma + 1);
}

}  // namespace

struct CommandLine::State {
  const Command command;
  CLI::App app;
  std::vector<Positional> positionals;
  std::vector<HelpSection> sections{{"", {}}, {"Options", {}}};
  std::string examples;

  explicit State(const Command& c) : command(c) {}

  std::string see_help() const { return "see tristim " + std::string(command.name) + " --help"; }

  std::string usage() const {
    return "tristim " + std::string(command.name) + " " + std::string(command.usage);
  }

  std::string help() const {
    std::string summary(command.summary);
    summary[0] = static_cast<char>(summary[0] - 'a' + 'A');
    return "Usage: " + usage() + "\n\n" + summary + ".\n\n" + help_text(sections) +
           "\nExamples:\n" + examples;
  }

  [[noreturn]] void refuse_argument(const std::string& argument) const {
    if (!argument.starts_with('-')) misuse(argument, "is one argument too many", see_help());
    std::vector<OptionName> names;
    for (const CLI::Option* option : app.get_options()) {
      for (const std::string& known : option->get_lnames()) names.push_back({"--" + known});
    }
    const std::string name = argument.substr(0, argument.find('='));
    const std::string hint = name_hint(names, name);
    const bool useful = name.size() > 2 && !hint.starts_with("use one of");
    misuse(name, "unknown option", useful ? hint : see_help());
  }

  // What CLI11 says of an option, in our words.
  [[noreturn]] void refuse(const std::string& what) const {
    const std::size_t override = what.find(" was given a disallowed flag override");
    if (override != std::string::npos) {
      misuse("--" + what.substr(0, override), "takes no value", "give it alone");
    }
    const std::size_t colon = what.find(": ");
    const bool named = what.starts_with('-') && colon != std::string::npos;
    if (!named) misuse(command.name, what, see_help());
    const std::string option = what.substr(0, colon);
    const std::string wrong = what.substr(colon + 2);
    if (wrong.find("At Most") != std::string::npos) {
      misuse(option, "is given more than once", "give it once");
    }
    if (wrong.find("missing") != std::string::npos) misuse(option, "has no value", see_help());
    misuse(option, wrong, see_help());
  }

  void check_positionals() const {
    for (const Positional& positional : positionals) {
      if (positional.values->size() >= positional.least) continue;
      misuse(command.name, positional.name.substr(0, positional.name.find("...")) + " is missing",
             "use: " + usage());
    }
  }
};

CommandLine::CommandLine(const Command& command, std::string_view examples)
    : state_(std::make_unique<State>(command)) {
  state_->examples = examples;
  state_->app.set_help_flag("-h,--help");
  state_->app.add_flag("-q,--quiet", quiet_flag);
}

CommandLine::~CommandLine() = default;

void CommandLine::positional(const std::string& name, const std::string& help,
                             std::vector<std::string>& values, int least, int most) {
  state_->app
      .add_option_function<std::vector<std::string>>(
          name,
          [&values](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) values.push_back(unguarded(text));
          })
      ->expected(0, most);
  state_->positionals.push_back({name, &values, static_cast<std::size_t>(least)});
  state_->sections.front().entries.push_back({name, help});
}

void CommandLine::option(const std::string& names, const std::string& argument,
                         const std::string& help, std::string& value) {
  option(names, argument, help, [&value](const std::string& text) { value = text; });
}

void CommandLine::option(const std::string& names, const std::string& argument,
                         const std::string& help, std::function<void(const std::string&)> set) {
  state_->app.add_option_function<std::string>(
      names, [set = std::move(set)](const std::string& text) { set(unguarded(text)); });
  state_->sections.back().entries.push_back({shown_names(names) + " " + argument, help});
}

void CommandLine::flag(const std::string& names, const std::string& help, bool& value) {
  state_->app.add_flag(names, value)->disable_flag_override();
  state_->sections.back().entries.push_back({shown_names(names), help});
}

void CommandLine::toggle(const std::string& name, const std::string& help,
                         std::function<void(const std::string&)> set) {
  for (const bool on : {true, false}) {
    state_->app
        .add_flag_callback((on ? "--" : "--no-") + name, [set, on] { set(on ? "true" : "false"); })
        ->disable_flag_override();
  }
  state_->sections.back().entries.push_back({"--" + name + ", --no-" + name, help});
}

void CommandLine::section(const std::string& title) { state_->sections.push_back({title, {}}); }

bool CommandLine::parse(Arguments arguments) {
  std::vector<HelpEntry>& options = state_->sections[1].entries;
  options.push_back({"-q, --quiet", "no notes and no progress"});
  options.push_back({"-h, --help", "print this help"});
  std::vector<std::string> reversed;  // as CLI11 wants them
  for (const std::string& argument : arguments) reversed.push_back(guarded(argument));
  std::reverse(reversed.begin(), reversed.end());
  try {
    state_->app.parse(std::move(reversed));
  } catch (const CLI::CallForHelp&) {
    print(state_->help());
    return false;
  } catch (const CLI::ExtrasError&) {
    const std::vector<std::string> extras = state_->app.remaining();
    state_->refuse_argument(extras.empty() ? "arguments" : unguarded(extras.front()));
  } catch (const CLI::ParseError& error) {
    state_->refuse(error.what());
  }
  state_->check_positionals();
  return true;
}

double number_option(std::string_view option, std::string_view text, double least, double most,
                     std::string_view range) {
  const auto value = parse_number(text);
  if (value && *value >= least && *value <= most) return *value;
  misuse(option, "'" + std::string(text) + "' is " + (value ? "out of range" : "no number"),
         "give a number " + (range.empty() ? "from " + shortest(least) + " to " + shortest(most)
                                           : std::string(range)));
}

int integer_option(std::string_view option, std::string_view text, int least, int most) {
  const auto value = parse_integer(text);
  if (value && *value >= least && *value <= most) return static_cast<int>(*value);
  misuse(option, "'" + std::string(text) + "' is " + (value ? "out of range" : "no whole number"),
         "give a whole number from " + std::to_string(least) + " to " + std::to_string(most));
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return text;
}

void note(const std::string& text) {
  if (quiet_flag) return;
  const std::string line = "tristim: " + one_line(text) + "\n";
  std::fputs(line.c_str(), stderr);
}

bool quiet() { return quiet_flag; }

void print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return;
  const int error = errno;
  throw Error(ErrorKind::kSystem, "standard output", "cannot write: " + system_message(error),
              error == EPIPE    ? "the program that reads it has ended"
              : error == ENOSPC ? "free some space or write elsewhere"
                                : "");
}

}  // namespace tristim::tools
