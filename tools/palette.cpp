#include "tools/commands.h"
#include "tools/palette_actions.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"

namespace tristim::tools {
namespace {

std::string help() {
  std::string text = "Usage: tristim palette <action> [options]\n\nActions:\n";
  for (const Command& action : kPaletteActions) {
    std::string line = "  " + std::string(action.name);
    line.resize(12, ' ');
    text += line + std::string(action.summary) + "\n";
  }
  return text + "\ntristim palette <action> --help tells the options of an action.\n\nExamples:\n" +
         "  tristim render spheres -o a.exr && tristim palette build a.exr -n 16 -o a.gpl\n"
         "  tristim palette show vga16\n"
         "  tristim palette convert vga16 vga.gpl\n"
         "  tristim palette check navy crimson '#228b22'\n";
}

}  // namespace

Command palette_action(std::string_view name) {
  Command action = *find_by_name(kPaletteActions, name);
  static const std::vector<std::string> titles = [] {
    std::vector<std::string> all;
    for (const Command& one : kPaletteActions) all.push_back("palette " + std::string(one.name));
    return all;
  }();
  for (const std::string& title : titles) {
    if (title.ends_with(" " + std::string(action.name))) action.name = title;
  }
  return action;
}

void run_palette(Arguments arguments) {
  if (arguments.empty()) {
    throw Error(ErrorKind::kMisuse, "palette", "an action is missing",
                "use one of: " + list_names(kPaletteActions));
  }
  if (arguments[0] == "--help" || arguments[0] == "-h") return print(help());
  const Command* action = find_by_name(kPaletteActions, arguments[0]);
  if (action == nullptr) {
    throw Error(ErrorKind::kMisuse, "palette", "unknown action '" + arguments[0] + "'",
                name_hint(kPaletteActions, arguments[0]));
  }
  action->run(arguments.subspan(1));
}

}  // namespace tristim::tools
