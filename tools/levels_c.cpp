#include "tools/levels_job.h"

#include <algorithm>

#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

constexpr const char* kProgmem =
    "#if defined(__AVR__)\n"
    "#include <avr/pgmspace.h>\n"
    "#elif !defined(PROGMEM)\n"
    "#define PROGMEM\n"
    "#endif\n";

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  return text;
}

std::string default_name(const LevelsJob& job) {
  if (job.temporal_bits > 0) return "level_frames";
  return job.store == Store::kIndex ? "color_table" : "level_codes";
}

std::string list(const std::vector<int>& codes, const std::string& indent) {
  std::string text;
  for (std::size_t j = 0; j < codes.size(); ++j) {
    text += (j % 16 == 0 ? "\n" + indent : " ") + std::to_string(codes[j]) + ",";
  }
  return text;
}

// The lists of one channel: its codes, or those of each frame.
std::vector<std::vector<int>> lists_of(const ChannelLevels& channel) {
  if (channel.frames.empty()) return {channel.codes};
  std::vector<std::vector<int>> frames(channel.frames[0].size());
  for (const FrameCodes& level : channel.frames) {
    for (std::size_t f = 0; f < frames.size(); ++f) frames[f].push_back(level[f]);
  }
  return frames;
}

std::string nested(const ChannelLevels& channel, const std::string& indent) {
  const std::vector<std::vector<int>> lists = lists_of(channel);
  if (channel.frames.empty()) return list(lists[0], indent);
  std::string text;
  for (const std::vector<int>& frame : lists) {
    text += "\n" + indent + "{" + list(frame, indent + "    ") + "\n" + indent + "},";
  }
  return text;
}

std::string comment(const LevelsJob& job) {
  const LevelTable& table = job.table;
  std::string text = "/* Code of each intensity level";
  text += job.temporal_bits > 0 ? " in each frame" : "";
  text += ": I0 " + shortest(lowest_intensity(table)) + ", " + std::string(spacing_of(table).name) +
          " spacing";
  if (job.dead_reckoned) text += ", dead-reckoned";
  for (const DriveChannel& drive : job.drives) text += ".\n   " + describe(drive.response);
  text += job.store == Store::kIndex
              ? ".\n   The frame buffer holds the level j, entry j of the colour table its code."
              : ".\n   The frame buffer holds the code.";
  return text + " */\n";
}

}  // namespace

std::string levels_c(const LevelsJob& job, const std::vector<ChannelLevels>& channels,
                     const CTableOptions& options) {
  const std::string name = options.name.empty() ? default_name(job) : options.name;
  const std::string count = options.name.empty() ? "LEVEL_COUNT" : upper(name) + "_LEVELS";
  const std::string frames = options.name.empty() ? "FRAME_COUNT" : upper(name) + "_FRAMES";
  const bool three = channels.size() == 3;
  std::string text = "#pragma once\n\n#include <stdint.h>\n";
  if (options.progmem) text += kProgmem;
  text += "\n" + comment(job) + "#define " + count + " " + std::to_string(job.table.n + 1) + "\n";
  std::string size = three ? "[3]" : "";
  if (job.temporal_bits > 0) {
    text += "#define " + frames + " " + std::to_string(1 << job.temporal_bits) + "\n";
    size += "[" + frames + "]";
  }
  text += "static const " + std::string(most_code(job) < 256 ? "uint8_t " : "uint16_t ") + name +
          size + "[" + count + "]" + (options.progmem ? " PROGMEM" : "") + " = {";
  for (const ChannelLevels& channel : channels) {
    text += three ? "\n    {" + nested(channel, "        ") + "\n    }," : nested(channel, "    ");
  }
  return text + "\n};\n";
}

}  // namespace tristim::tools
