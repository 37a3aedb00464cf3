#include "tools/levels_job.h"

#include <algorithm>

#include "tools/report.h"
#include "tristim/core/text.h"
#include "tristim/device/channels.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

// A fact of the one channel, or of all three.
template <typename Fact>
Json per_channel(const std::vector<ChannelLevels>& channels, Fact&& fact) {
  if (channels.size() == 1) return fact(channels[0]);
  Json all = Json::array();
  for (const ChannelLevels& channel : channels) all.push_back(fact(channel));
  return all;
}

template <typename Fact>
Json per_drive(const LevelsJob& job, Fact&& fact) {
  if (job.drives.size() == 1) return fact(job.drives[0]);
  Json all = Json::array();
  for (const DriveChannel& drive : job.drives) all.push_back(fact(drive));
  return all;
}

// One number where all channels have the same.
Json vmax_json(const LevelsJob& job) {
  const Json all = per_drive(job, [](const DriveChannel& d) { return Json(d.vmax); });
  const bool one = all.is_array() && all[0] == all[1] && all[0] == all[2];
  return one ? all[0] : all;
}

Json gamma_json(const DriveChannel& drive) {
  const auto* gamma = std::get_if<GammaResponse>(&drive.response);
  return gamma != nullptr ? Json(gamma->gamma) : Json(nullptr);
}

Json runs_json(const std::vector<SharedRun>& runs, const char* shared) {
  Json list = Json::array();
  for (const SharedRun& run : runs) {
    list.push_back({{"from", run.first}, {"to", run.last}, {shared, run.shared}});
  }
  return list;
}

// The codes that give level 0, where there are several: what lies below the levels.
Json dead_zone_json(const LevelReport& report) {
  if (report.dead_zones.empty() || report.dead_zones[0].shared != 0) return nullptr;
  const SharedRun& dark = report.dead_zones[0];
  return {{"from", dark.first}, {"to", dark.last}, {"codes", dark.count()}};
}

Json frames_json(const ChannelLevels& channel) {
  Json levels = Json::array();
  for (const FrameCodes& frames : channel.frames) levels.push_back(frames);
  return levels;
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size() + 1), ' ');
  return text;
}

std::string right(const std::string& text, std::size_t width) {
  return std::string(width > text.size() ? width - text.size() : 0, ' ') + text;
}

std::string range_text(int first, int last) {
  return first == last ? std::to_string(first)
                       : std::to_string(first) + ".." + std::to_string(last);
}

int sharing(const std::vector<SharedRun>& runs) {
  int count = 0;
  for (const SharedRun& run : runs) count += run.count();
  return count;
}

// The longest runs, as many as fit a line.
std::string runs_text(const std::vector<SharedRun>& runs, const std::string& shared) {
  constexpr std::size_t kMost = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, runs.size()); ++i) {
    text += (i > 0 ? ", " : "") + range_text(runs[i].first, runs[i].last) + " " + shared + " " +
            std::to_string(runs[i].shared);
  }
  return runs.size() > kMost ? text + ", ..." : text;
}

std::string dead_zone_text(const LevelReport& report, int vmax) {
  const Json dark = dead_zone_json(report);
  std::string text = "dead zone: ";
  text +=
      dark.is_null() ? "none" : "codes " + range_text(dark["from"], dark["to"]) + " give level 0";
  return text + "; " + std::to_string(sharing(report.dead_zones)) + " of " +
         std::to_string(vmax + 1) + " codes share their level with others\n";
}

std::string shared_text(const LevelsJob& job, const LevelReport& report) {
  if (report.shared_codes.empty()) return {};
  const std::string why =
      job.dead_reckoned ? ", more levels than codes: they cannot all differ" : "";
  return "levels with one code" + why + ": " + runs_text(report.shared_codes, "have") + "\n";
}

std::string summary(const LevelsJob& job, const ChannelLevels& channel) {
  const LevelReport& report = channel.report;
  return "distinct codes " + std::to_string(report.distinct) + " of " +
         std::to_string(job.table.n + 1) + ", largest step " +
         rounded(report.largest_lstar_step, 4) + " L* to level " +
         std::to_string(report.largest_step_at) + ", as shown " +
         rounded(report.largest_shown_lstar_step, 4) + " L*\n" +
         dead_zone_text(report, channel.vmax) + shared_text(job, report);
}

std::string frames_text(const FrameCodes& frames) {
  std::string text = "  ";
  for (const int code : frames) text += " " + std::to_string(code);
  return text;
}

std::string rows_text(const LevelsJob& job, const std::vector<ChannelLevels>& channels) {
  const std::vector<double> levels = intensity_levels(job.table);
  const bool index = job.store == Store::kIndex;
  std::string text = "   j  I_j                     V_j" +
                     std::string(channels.size() == 3 ? ": red, green, blue" : "") +
                     (index ? "  (entry j of the colour table; j in the frame buffer)" : "") +
                     (job.temporal_bits > 0 ? "  codes of the frames" : "") + "\n";
  for (std::size_t j = 0; j < levels.size(); ++j) {
    text += right(std::to_string(j), 4) + "  " + padded(shortest(levels[j]), 24);
    std::string codes;
    for (const ChannelLevels& channel : channels) {
      codes += (codes.empty() ? "" : "  ") +
               right(std::to_string(channel.codes[j]), channels.size() == 1 ? 0 : 5);
    }
    text += codes;
    for (const ChannelLevels& channel : channels) {
      if (!channel.frames.empty()) text += frames_text(channel.frames[j]);
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::vector<ChannelLevels> channel_levels(const LevelsJob& job) {
  std::vector<ChannelLevels> channels;
  for (const auto& [response, vmax] : job.drives) {
    ChannelLevels channel{.vmax = vmax};
    channel.codes = level_codes(job.table, response, vmax);
    if (job.dead_reckoned) channel.codes = dead_reckoned(channel.codes, vmax);
    channel.report = level_report(job.table, response, channel.codes, vmax);
    if (job.temporal_bits > 0) {
      channel.frames = temporal_codes(job.table, response, vmax, job.temporal_bits);
    }
    channels.push_back(std::move(channel));
  }
  return channels;
}

int most_code(const LevelsJob& job) {
  int most = 0;
  for (const DriveChannel& drive : job.drives) most = std::max(most, drive.vmax);
  return most;
}

Json levels_json(const LevelsJob& job, const std::vector<ChannelLevels>& channels) {
  const LevelReport& first = channels[0].report;
  Json json{{"I0", lowest_intensity(job.table)},
            {"n", job.table.n},
            {"gamma", per_drive(job, gamma_json)},
            {"Vmax", vmax_json(job)},
            {"spacing", spacing_of(job.table).name},
            {"formula", spacing_of(job.table).formula},
            {"response",
             per_drive(job, [](const DriveChannel& d) { return Json(describe(d.response)); })},
            {"dynamic_range", number_json(first.dynamic_range)},
            {"ratio", number_json(first.ratio)},
            {"largest_lstar_step", first.largest_lstar_step}};
  if (channels.size() == 3) json["channels"] = kChannelNames;
  const auto add = [&](const char* key, auto&& fact) { json[key] = per_channel(channels, fact); };
  add("distinct", [](const ChannelLevels& c) { return Json(c.report.distinct); });
  add("largest_shown_lstar_step",
      [](const ChannelLevels& c) { return Json(c.report.largest_shown_lstar_step); });
  add("dead_zone", [](const ChannelLevels& c) { return dead_zone_json(c.report); });
  add("same_level", [](const ChannelLevels& c) { return runs_json(c.report.dead_zones, "level"); });
  add("same_code", [](const ChannelLevels& c) { return runs_json(c.report.shared_codes, "code"); });
  if (job.bt1886) json["bt1886"] = {{"a", job.bt1886->a}, {"b", job.bt1886->b}};
  json["I"] = intensity_levels(job.table);
  add("V", [](const ChannelLevels& c) { return Json(c.codes); });
  json["store"] = job.store == Store::kIndex ? "index" : "value";
  add("frame_buffer", [&](const ChannelLevels& c) {
    return Json(look_up_tables(c.codes, job.store, c.vmax).frame_buffer);
  });
  add("color_table", [&](const ChannelLevels& c) {
    return Json(look_up_tables(c.codes, job.store, c.vmax).color_table);
  });
  if (job.temporal_bits > 0) add("frames", frames_json);
  return json;
}

std::string levels_text(const LevelsJob& job, const std::vector<ChannelLevels>& channels) {
  const LevelReport& report = channels[0].report;
  std::string text = "dynamic range " + rounded(report.dynamic_range, 9) + ", ratio " +
                     rounded(report.ratio, 9) + ", " + std::string(spacing_of(job.table).formula) +
                     "\n";
  if (job.bt1886) {
    text +=
        "BT.1886 a = " + rounded(job.bt1886->a, 9) + ", b = " + rounded(job.bt1886->b, 9) + "\n";
  }
  for (std::size_t c = 0; c < channels.size(); ++c) {
    if (channels.size() == 3) text += std::string(kChannelNames[c]) + ": ";
    text += summary(job, channels[c]);
  }
  return text + rows_text(job, channels);
}

}  // namespace tristim::tools
