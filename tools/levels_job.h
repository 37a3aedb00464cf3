#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tristim/device/drive_tables.h"
#include "tristim/device/level_report.h"
#include "tristim/device/levels.h"
#include "tristim/device/response.h"

namespace tristim::tools {

/// A channel of the device.
struct DriveChannel {
  Response response;
  int vmax = 255;  // its highest code
};

/// What `tristim levels` computes.
struct LevelsJob {
  LevelTable table;
  std::vector<DriveChannel> drives;  // the one channel, or red, green and blue
  Store store = Store::kValue;
  bool dead_reckoned = false;
  int temporal_bits = 0;  // 0: no frames
  std::optional<Bt1886Constants> bt1886;
};

/// The table of one channel.
struct ChannelLevels {
  int vmax = 255;
  std::vector<int> codes;
  LevelReport report;
  std::vector<FrameCodes> frames;  // of each level; empty without temporal bits
};

/// The highest code of all channels.
int most_code(const LevelsJob& job);

/// All of it. Throws std::invalid_argument as the library does.
std::vector<ChannelLevels> channel_levels(const LevelsJob& job);

/// Every fact of the tables, with the keys I0 n gamma Vmax I V; what differs between channels is an
/// array of three.
nlohmann::ordered_json levels_json(const LevelsJob& job,
                                   const std::vector<ChannelLevels>& channels);

/// The tables for people, with a summary above.
std::string levels_text(const LevelsJob& job, const std::vector<ChannelLevels>& channels);

/// How the tables are called in C, and where they lie.
struct CTableOptions {
  std::string name;      // empty: level_codes, color_table or level_frames
  bool progmem = false;  // in the program memory of AVR processors
};

/// The tables as a C header.
std::string levels_c(const LevelsJob& job, const std::vector<ChannelLevels>& channels,
                     const CTableOptions& options);

/// A drawing (SVG): light of the codes with the levels on it, and L* of the levels.
std::string levels_plot(const LevelsJob& job, const std::vector<ChannelLevels>& channels);

}  // namespace tristim::tools
