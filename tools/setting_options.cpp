#include "tools/setting_options.h"

#include <algorithm>

#include "tristim/core/error.h"

namespace tristim::tools {
namespace {

void apply_setting(Settings& settings, const Setting& setting, const std::string& value) {
  if (const auto refusal = setting.set(settings, value)) {
    throw Error(ErrorKind::kMisuse, "--" + std::string(setting.name), refusal->wrong,
                refusal->remedy);
  }
}

}  // namespace

void declare_settings(CommandLine& line, std::vector<GivenSetting>& given,
                      std::span<const std::string_view> names) {
  for (const Setting& setting : settings_list()) {
    const bool wanted = names.empty() || std::ranges::find(names, setting.name) != names.end();
    if (!wanted) continue;
    const auto keep = [&given, &setting](const std::string& value) {
      given.push_back({&setting, value});
    };
    if (setting.argument.empty()) {
      line.toggle(std::string(setting.name), setting.help, keep);
    } else {
      line.option("--" + std::string(setting.name), setting.argument, setting.help, keep);
    }
  }
}

void apply_settings(Settings& settings, const std::vector<GivenSetting>& given) {
  for (const GivenSetting& one : given) apply_setting(settings, *one.setting, one.value);
}

}  // namespace tristim::tools
