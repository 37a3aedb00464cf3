#include "lib/image/io/exr_channels.h"

#include <algorithm>

namespace tristim::detail {
namespace {

constexpr const char* kTypeNames[] = {"uint", "half", "float"};

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

// Index of `prefix` followed by `suffix`, whose case does not count: some programs write diffuse.r.
int find_channel(const ExrPart& part, std::string_view prefix, std::string_view suffix) {
  const auto found = std::ranges::find_if(part.channels, [&](const ExrChannel& channel) {
    const std::string_view name = channel.name;
    return name.size() == prefix.size() + suffix.size() && name.starts_with(prefix) &&
           std::ranges::equal(name.substr(prefix.size()), suffix, {}, upper);
  });
  return found == part.channels.end() ? -1 : static_cast<int>(found - part.channels.begin());
}

ExrSelection select_colours(const ExrPart& part, std::string_view layer) {
  const std::string prefix = layer.empty() ? "" : std::string(layer) + ".";
  const auto find = [&](std::string_view suffix) { return find_channel(part, prefix, suffix); };
  ExrSelection selection{.part = part.index, .layer = std::string(layer)};
  const int r = find("R");
  const int g = find("G");
  const int b = find("B");
  const int x = find("X");
  const int y = find("Y");
  const int z = find("Z");
  if (r >= 0 || g >= 0 || b >= 0) {
    selection.model = ExrColourModel::kRgb;
    selection.channel = {r, g, b, find("A")};
  } else if (y >= 0 && find("RY") >= 0 && find("BY") >= 0) {
    selection.model = ExrColourModel::kChroma;
    selection.channel = {y, y, y, find("A")};
  } else if (x >= 0 && y >= 0 && z >= 0) {
    selection.model = ExrColourModel::kXyz;
    selection.channel = {x, y, z, find("A")};
  } else if (y >= 0) {
    selection.model = ExrColourModel::kGrey;
    selection.channel = {y, y, y, find("A")};
  }
  return selection;
}

ExrSelection select_layer(const ExrPart& part, std::string_view layer) {
  const auto named = std::ranges::find(part.channels, layer, &ExrChannel::name);
  if (named != part.channels.end()) {
    const int index = static_cast<int>(named - part.channels.begin());
    return {part.index, ExrColourModel::kGrey, {}, {index, index, index, -1}};
  }
  ExrSelection selection = select_colours(part, layer);
  if (selection.model != ExrColourModel::kNone || part.name != layer) return selection;
  if (part.channels.size() == 1) return {part.index, ExrColourModel::kGrey, {}, {0, 0, 0, -1}};
  return select_colours(part, "");
}

}  // namespace

ExrSelection select_channels(std::span<const ExrPart> parts, std::string_view layer) {
  for (const ExrPart& part : parts) {
    if (part.deep) continue;
    ExrSelection selection = layer.empty() ? select_colours(part, "") : select_layer(part, layer);
    if (selection.model != ExrColourModel::kNone) return selection;
  }
  return {};
}

std::vector<std::string> channel_list(std::span<const ExrPart> parts) {
  std::vector<std::string> list;
  for (const ExrPart& part : parts) {
    const std::string before = parts.size() > 1 && !part.name.empty() ? part.name + "/" : "";
    for (const ExrChannel& channel : part.channels) {
      const auto type = static_cast<std::size_t>(channel.type);
      list.push_back(before + channel.name + ":" + (type < 3 ? kTypeNames[type] : "unknown"));
    }
  }
  return list;
}

}  // namespace tristim::detail
