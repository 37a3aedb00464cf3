#include "tools/commands.h"
#include "tools/palette_source.h"
#include "tools/report.h"
#include "tools/scene_facts.h"
#include "tools/spool.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/image/io/indexed.h"
#include "tristim/image/io/read.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim render spheres -o spheres.exr\n"
    "  tristim info spheres.exr\n"
    "  tristim info spheres.exr --json\n"
    "  printf 'v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf 1 2 3\\n' > model.obj && tristim info model.obj\n";

// Positions as runs: "0-7 9 12-15".
std::string runs_text(const std::vector<std::size_t>& positions) {
  std::string text;
  for (std::size_t i = 0; i < positions.size();) {
    std::size_t end = i + 1;
    while (end < positions.size() && positions[end] == positions[end - 1] + 1) ++end;
    if (!text.empty()) text += " ";
    text += std::to_string(positions[i]);
    if (end - i > 1) text += (end - i > 2 ? "-" : " ") + std::to_string(positions[end - 1]);
    i = end;
  }
  return text;
}

std::vector<std::size_t> used_positions(const PaletteSource& source) {
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < source.pixels.size(); ++i) {
    if (source.pixels[i] > 0) used.push_back(i);
  }
  return used;
}

// What a file of positions in a palette has of one.
struct IndexFacts {
  PaletteSource source;
  int pictures = 1;
};

std::optional<IndexFacts> index_facts(const std::string& path) {
  const auto picture = read_indexed_picture(path);
  if (!picture) return std::nullopt;
  return IndexFacts{palette_source(path, *picture), picture->pictures};
}

void add_palette(Json& json, const IndexFacts& facts) {
  const auto& colors = facts.source.palette.colors;
  Json palette = Json::array();
  for (std::size_t i = 0; i < colors.size(); ++i) {
    Json one{{"index", i}, {"hex", hex_text(colors[i].color)}};
    if (colors[i].alpha < 1) one["alpha"] = colors[i].alpha;
    one["pixels"] = facts.source.pixels[i];
    palette.push_back(one);
  }
  json["pictures"] = facts.pictures;
  json["palette"] = palette;
  json["used"] = used_positions(facts.source);
}

// The colours with their positions and pixels, a few in a line.
std::string palette_text(const PaletteSource& source) {
  constexpr std::size_t kInLine = 4;
  const auto& colors = source.palette.colors;
  std::string text;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    std::string cell = std::to_string(i);
    cell.insert(0, 4 - std::min<std::size_t>(cell.size(), 4), ' ');
    cell += " " + hex_text(colors[i].color);
    if (colors[i].alpha < 1) cell += "/" + rounded(colors[i].alpha, 3);
    cell += " " + std::to_string(source.pixels[i]);
    const bool last = i + 1 == colors.size() || i % kInLine == kInLine - 1;
    if (!last) cell.resize(std::max<std::size_t>(cell.size(), 22), ' ');
    text += cell + (last ? "\n" : "");
  }
  return text;
}

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

std::string indices_text(const IndexFacts& facts) {
  const std::vector<std::size_t> used = used_positions(facts.source);
  std::string text;
  if (facts.pictures > 1) text += "  pictures      " + std::to_string(facts.pictures) + "\n";
  return text + "  palette       " + std::to_string(facts.source.palette.colors.size()) +
         " colours, " + std::to_string(used.size()) + " used: " + runs_text(used) + "\n" +
         palette_text(facts.source);
}

}  // namespace

void run_info(Arguments arguments) {
  std::vector<std::string> files;
  bool json = false;
  CommandLine line(*find_by_name(kCommands, "info"), kExamples);
  line.positional("FILE", "pictures, scenes (TOML), meshes (OBJ, glTF); - is standard input", files,
                  1, 1 << 20);
  line.flag("--json", "print the facts as JSON, a line a file", json);
  if (!line.parse(arguments)) return;
  for (const std::string& file : files) {
    if (is_scene_file(file)) {
      const SceneFile scene = load_scene(file);
      print(json ? json_line(scene_json(file, scene)) : scene_text(file, scene));
      continue;
    }
    if (file == "-") make_rereadable(file);
    const PictureFacts facts = picture_facts(file);
    const auto indices = index_facts(file);
    if (json) {
      Json all = facts_json(file, facts);
      if (indices) add_palette(all, *indices);
      print(json_line(all));
      continue;
    }
    print(facts_text(file, facts));
    if (indices) print(indices_text(*indices));
  }
}

}  // namespace tristim::tools
