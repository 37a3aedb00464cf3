#include <filesystem>

#include "tools/lut.h"
#include "tools/outputs.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/device/display_file.h"
#include "tristim/lut/io/ocio_config.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim lut ocio-config -o config.ocio\n"
    "  tristim lut ocio-config srgb crt-p22 -o displays.ocio --json\n"
    "  ociocheck --iconfig config.ocio\n";

// A display's name in the config: as a built-in one is called, or the stem of a file.
std::string name_of(const std::string& device) {
  return std::filesystem::path(device).stem().string();
}

std::vector<OcioDisplay> load_displays(std::vector<std::string> devices) {
  if (devices.empty()) {
    for (const BuiltInDisplay& device : built_in_displays()) devices.emplace_back(device.name);
  }
  std::vector<OcioDisplay> displays;
  for (const std::string& device : devices) {
    const std::string name = name_of(device);
    for (const OcioDisplay& other : displays) {
      if (other.name != name) continue;
      throw Error(ErrorKind::kMisuse, device, "a display called " + name + " is there already",
                  "give the file another name");
    }
    displays.push_back({name, load_display(device)});
  }
  return displays;
}

// All files first, so that a name that is taken stops all of them.
void write_files(const std::vector<OcioConfigFile>& files, const std::string& folder, bool force) {
  std::vector<std::string> paths;
  for (const OcioConfigFile& file : files) {
    paths.push_back((std::filesystem::path(folder) / file.name).string());
  }
  refuse_taken_outputs(paths, force);
  for (std::size_t i = 0; i < files.size(); ++i) {
    OutputFile to(paths[i], force);
    to.write(files[i].bytes);
    to.commit();
  }
}

}  // namespace

void run_lut_ocio_config(Arguments arguments) {
  std::vector<std::string> devices;
  std::string output;
  bool json = false;
  bool force = false;
  CommandLine line(*lut_job("ocio-config"), kExamples);
  line.positional("D", "devices, built in or files; default: every built-in one", devices, 0, 1000);
  line.option("-o,--output", "OUT", "the config; the tables that it needs are written beside it",
              output);
  line.flag("--json", "print the facts as JSON", json);
  line.flag("-f,--force", "replace existing files", force);
  if (!line.parse(arguments)) return;
  if (output.empty() || output == "-") {
    throw Error(ErrorKind::kMisuse, "--output",
                output.empty() ? "is missing" : "a config has files beside it",
                "give -o config.ocio, or another name");
  }
  refuse_inputs_as_outputs(devices, {output});
  refuse_taken_outputs({output}, force);
  const std::vector<OcioDisplay> displays = load_displays(devices);
  OcioConfig config = ocio_config(displays);
  const std::filesystem::path path(output);
  config.files.push_back({path.filename().string(), config.text});  // last: it needs the others
  write_files(config.files, path.parent_path().string(), force);
  if (!json) return;
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const OcioDisplay& display : displays) names.push_back(display.name);
  for (const OcioConfigFile& file : config.files) files.push_back(file.name);
  print(json_line({{"output", output}, {"displays", names}, {"files", files}}));
}

}  // namespace tristim::tools
