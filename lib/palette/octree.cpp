#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "tristim/palette/quantize.h"

namespace tristim {
namespace {

constexpr int kDepth = 8;  // bits of a channel

struct Node {
  std::array<std::uint64_t, 4> sum{};  // of the colours below, by count
  std::uint64_t count = 0;
  std::uint32_t first = 0, end = 0;  // children in the level below
};

// The bits of a colour's channels in turn, from the top: neighbours in a branch share the front.
std::uint32_t path_of(Color8 c) {
  std::uint32_t path = 0;
  for (int bit = kDepth - 1; bit >= 0; --bit) {
    for (const std::uint8_t code : {c.r, c.g, c.b, c.a}) path = path << 1 | (code >> bit & 1U);
  }
  return path;
}

void add(Node& node, const Node& other) {
  for (std::size_t c = 0; c < 4; ++c) node.sum[c] += other.sum[c];
  node.count += other.count;
}

Color8 mean(const Node& node) {
  const auto rounded = [&node](std::uint64_t sum) {
    return static_cast<std::uint8_t>((2 * sum + node.count) / (2 * node.count));
  };
  return {rounded(node.sum[0]), rounded(node.sum[1]), rounded(node.sum[2]), rounded(node.sum[3])};
}

using Level = std::vector<Node>;  // in the order of their paths

// The leaves, one for each colour.
std::vector<std::pair<std::uint32_t, Node>> leaves_of(std::span<const Histogram::Entry> entries) {
  std::vector<std::pair<std::uint32_t, Node>> leaves;
  leaves.reserve(entries.size());
  for (const auto& [c, n] : entries) {
    leaves.push_back({path_of(c), {{c.r * n, c.g * n, c.b * n, c.a * n}, n, 0, 0}});
  }
  std::sort(leaves.begin(), leaves.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  return leaves;
}

}  // namespace

std::vector<Color8> choose_octree(const PaletteTask& task) {
  auto nodes = leaves_of(task.entries);
  const auto wanted = static_cast<std::size_t>(task.colors);
  std::vector<Color8> palette;
  // Level by level from the deepest: its branches become leaves, all of them while there are too
  // many even so, and then only the rarest.
  for (int level = 0; level < kDepth && nodes.size() > wanted; ++level) {
    std::vector<std::pair<std::uint32_t, Node>> branches;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const std::uint32_t path = nodes[i].first >> 4;
      if (branches.empty() || branches.back().first != path) {
        branches.push_back({path, {{}, 0, static_cast<std::uint32_t>(i), 0}});
      }
      add(branches.back().second, nodes[i].second);
      branches.back().second.end = static_cast<std::uint32_t>(i + 1);
    }
    if (branches.size() > wanted) {
      nodes = std::move(branches);
      continue;
    }
    std::vector<std::size_t> rarest(branches.size());
    for (std::size_t i = 0; i < rarest.size(); ++i) rarest[i] = i;
    std::stable_sort(rarest.begin(), rarest.end(), [&](std::size_t a, std::size_t b) {
      return branches[a].second.count < branches[b].second.count;
    });
    std::vector<bool> merged(branches.size());
    std::size_t left = nodes.size();
    for (const std::size_t i : rarest) {
      if (left <= wanted) break;
      merged[i] = true;
      left -= branches[i].second.end - branches[i].second.first - 1;
    }
    for (std::size_t i = 0; i < branches.size(); ++i) {
      const Node& branch = branches[i].second;
      if (merged[i]) palette.push_back(mean(branch));
      for (std::uint32_t k = branch.first; k < branch.end && !merged[i]; ++k) {
        palette.push_back(mean(nodes[k].second));
      }
    }
    return palette;
  }
  for (const auto& [path, node] : nodes) palette.push_back(mean(node));
  return palette;
}

}  // namespace tristim
