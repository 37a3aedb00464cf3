#include "tools/commands.h"
#include "tools/report.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/image/io/read.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim render spheres -o spheres.exr\n"
    "  tristim info spheres.exr\n"
    "  tristim info spheres.exr --json\n";

Json xy_json(Chromaticity c) { return Json::array({c.x, c.y}); }

Json facts_json(const std::string& path, const PictureFacts& facts) {
  const PictureInfo& info = facts.info;
  return Json{{"file", path},
              {"format", facts.format},
              {"width", info.width},
              {"height", info.height},
              {"channels", facts.channels},
              {"compression", facts.compression},
              {"colour", facts.colour},
              {"primaries",
               {{"red", xy_json(info.primaries.red)},
                {"green", xy_json(info.primaries.green)},
                {"blue", xy_json(info.primaries.blue)},
                {"white", xy_json(info.primaries.white)}}},
              {"pixel_aspect", info.pixel_aspect},
              {"orientation", info.orientation},
              {"data_window",
               {{"x", facts.data_x},
                {"y", facts.data_y},
                {"width", facts.data_width},
                {"height", facts.data_height}}}};
}

std::string xy_text(Chromaticity c) { return rounded(c.x, 6) + " " + rounded(c.y, 6); }

std::string facts_text(const std::string& path, const PictureFacts& facts) {
  const PictureInfo& info = facts.info;
  std::string channels;
  for (const std::string& channel : facts.channels)
    channels += (channels.empty() ? "" : " ") + channel;
  std::string text = one_line(path) + "\n";
  const auto line = [&text](std::string label, const std::string& value) {
    label.resize(14, ' ');
    if (!value.empty()) text += "  " + label + value + "\n";
  };
  line("format", facts.format);
  line("size", std::to_string(info.width) + "x" + std::to_string(info.height));
  line("channels", channels);
  line("compression", facts.compression);
  line("colour", facts.colour);
  line("primaries", "red " + xy_text(info.primaries.red) + ", green " +
                        xy_text(info.primaries.green) + ", blue " + xy_text(info.primaries.blue) +
                        ", white " + xy_text(info.primaries.white));
  if (info.pixel_aspect != 1) line("pixel aspect", shortest(info.pixel_aspect));
  if (info.orientation != 1) line("orientation", std::to_string(info.orientation));
  const bool whole = facts.data_x == 0 && facts.data_y == 0 && facts.data_width == info.width &&
                     facts.data_height == info.height;
  if (!whole) {
    line("data window", std::to_string(facts.data_width) + "x" + std::to_string(facts.data_height) +
                            " at " + std::to_string(facts.data_x) + "," +
                            std::to_string(facts.data_y));
  }
  return text;
}

}  // namespace

void run_info(Arguments arguments) {
  std::vector<std::string> files;
  bool json = false;
  CommandLine line(*find_by_name(kCommands, "info"), kExamples);
  line.positional("FILE", "pictures; - is standard input", files, 1, 1 << 20);
  line.flag("--json", "print the facts as JSON, a line a file", json);
  if (!line.parse(arguments)) return;
  for (const std::string& file : files) {
    const PictureFacts facts = picture_facts(file);
    print(json ? json_line(facts_json(file, facts)) : facts_text(file, facts));
  }
}

}  // namespace tristim::tools
