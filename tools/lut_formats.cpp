#include "tools/lut.h"
#include "tools/report.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kExamples =
    "  tristim lut formats\n"
    "  tristim lut formats --json\n";

nlohmann::ordered_json format_json(const LutFormat& format) {
  nlohmann::ordered_json extensions = nlohmann::ordered_json::array();
  for (const std::string_view extension : split(format.extensions, ' ')) {
    extensions.push_back(extension);
  }
  return {{"name", format.name},       {"extensions", extensions},
          {"what", format.what},       {"holds", describe(format.holds)},
          {"bits", format.holds.bits}, {"told_by_bytes", format.begins != nullptr}};
}

}  // namespace

void run_lut_formats(Arguments arguments) {
  bool json = false;
  CommandLine line(*lut_job("formats"), kExamples);
  line.flag("--json", "print the facts as JSON", json);
  if (!line.parse(arguments)) return;
  if (json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const LutFormat& format : lut_formats()) all.push_back(format_json(format));
    return print(json_line(all));
  }
  std::string text;
  for (const LutFormat& format : lut_formats()) {
    std::string head = std::string(format.name) + " (";
    for (const std::string_view extension : split(format.extensions, ' ')) {
      head += (head.back() == '(' ? "." : " .") + std::string(extension);
    }
    text +=
        head + "): " + std::string(format.what) + "\n    holds " + describe(format.holds) + "\n";
  }
  print(text);
}

}  // namespace tristim::tools
