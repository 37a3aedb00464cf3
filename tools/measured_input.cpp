#include "tools/measured_input.h"

#include <algorithm>

#include "tools/cli.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"
#include "tristim/device/channels.h"
#include "tristim/device/measured.h"

namespace tristim::tools {
namespace {

// Levels out what falls, and tells the largest change in percent of the white.
void level_out(MeasuredTable& table, std::size_t channel) {
  std::vector<double>& luminance = table.luminance[channel];
  const std::vector<double> level = monotone_luminance(luminance);
  if (level == luminance) return;
  std::size_t at = 0;
  double largest = 0;
  for (std::size_t i = 0; i < level.size(); ++i) {
    const double change = std::max(level[i] - luminance[i], luminance[i] - level[i]);
    if (change > largest) {
      largest = change;
      at = i;
    }
  }
  const std::string which =
      table.luminance.size() == 3 ? std::string(kChannelNames[channel]) + ": " : "";
  note(one_line(table.file) + ": " + which + "luminances that fall were levelled out, by " +
       rounded(largest, 3) + " at the most, at code " + shortest(table.code[at]));
  luminance = level;
}

}  // namespace

std::vector<TableResponse> read_measured(const std::vector<std::string>& files, bool monotone) {
  std::vector<TableResponse> responses;
  for (const std::string& file : files) {
    MeasuredTable table = load_measured(file);
    for (std::size_t c = 0; c < table.luminance.size(); ++c) {
      if (monotone) level_out(table, c);
      responses.push_back(measured_response(table, c));
    }
  }
  if (responses.size() != 1 && responses.size() != 3) {
    throw Error(ErrorKind::kMisuse, files[0],
                "makes " + std::to_string(responses.size()) + " channels with the other files",
                "give one, or three for red, green and blue");
  }
  return responses;
}

}  // namespace tristim::tools
