#include <csignal>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "tools/commands.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/instruction_sets.h"
#include "tristim/core/version.h"

namespace tristim::tools {
namespace {

extern "C" void end_by_signal(int signal_number) {
  tristim::remove_temporary_files();
  std::signal(signal_number, SIG_DFL);
  std::raise(signal_number);
}

void set_up_signals() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    // What the parent has it ignore, as nohup does, stays ignored.
    if (std::signal(number, SIG_IGN) != SIG_IGN) std::signal(number, end_by_signal);
  }
  std::signal(SIGPIPE, SIG_IGN);  // a lost reader is an error of write()
  std::signal(SIGXFSZ, SIG_IGN);  // as is a file size limit
}

std::string help() {
  std::string text = "tristim " + std::string(kVersion) +
                     ": from rendered light to the codes a display takes\n\n"
                     "Usage: tristim <command> [options]\n\nCommands:\n";
  for (const Command& command : kCommands) {
    std::string line = "  " + std::string(command.name);
    line.resize(12, ' ');
    text += line + std::string(command.summary) + "\n";
  }
  text +=
      "\ntristim <command> --help tells the options of a command.\n\n"
      "The environment variable TRISTIM_SIMD chooses the instructions that pixels are\n"
      "worked on with, of those here: " +
      list_names(instruction_sets()) +
      ".\nAll of them give the same bytes; process --explain tells which ran.\n\nExamples:\n"
      "  tristim render spheres -o spheres.exr\n"
      "  tristim process spheres.exr --device epaper-7color --tone-map reinhard:6 -o epaper.png\n"
      "  tristim convert --from rgb --to lab '#ff8000'\n"
      "  tristim device list\n";
  return text;
}

const Command& command_named(const std::string& name) {
  if (name.starts_with('-')) {
    throw Error(ErrorKind::kMisuse, name, "unknown option",
                "options follow the command: tristim <command> [options]");
  }
  if (const Command* command = find_by_name(kCommands, name)) return *command;
  throw Error(ErrorKind::kMisuse, name, "unknown command", name_hint(kCommands, name));
}

void run(Arguments arguments) {
  if (arguments.empty() || arguments[0] == "--help" || arguments[0] == "-h") return print(help());
  if (arguments[0] == "--version") return print("tristim " + std::string(kVersion) + "\n");
  if (arguments[0] == "help") {
    const std::vector<std::string> asked{"--help"};
    return arguments.size() == 1 ? print(help()) : command_named(arguments[1]).run(asked);
  }
  command_named(arguments[0]).run(arguments.subspan(1));
}

int fail(const std::string& text, ErrorKind kind) {
  const std::string line = "tristim: " + one_line(text) + "\n";
  std::fputs(line.c_str(), stderr);
  return static_cast<int>(kind);
}

}  // namespace
}  // namespace tristim::tools

int main(int argc, char** argv) {
  using tristim::ErrorKind;
  using tristim::tools::fail;
  tristim::tools::set_up_signals();
  const std::vector<std::string> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
  try {
    tristim::check_instruction_set();
    tristim::limit_to_instruction_set();
    tristim::tools::run(arguments);
    return 0;
  } catch (const tristim::Error& error) {
    return fail(error.what(), error.kind());
  } catch (const std::invalid_argument& error) {
    return fail(error.what(), ErrorKind::kMisuse);
  } catch (const std::bad_alloc&) {
    return fail("memory: not enough; process a smaller picture", ErrorKind::kSystem);
  } catch (const std::exception& error) {
    return fail(std::string("internal: ") + error.what(), ErrorKind::kSystem);
  }
}
