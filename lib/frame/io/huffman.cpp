#include "lib/frame/io/huffman.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace tristim::detail {
namespace {

constexpr std::size_t kLongest = 15;  // of any code of deflate

struct Leaf {
  std::uint32_t count;
  std::uint16_t symbol;
};

/// How many leaves of Huffman's tree lie at each depth; those below `most` count there. `leaves`
/// ascend by count; at least two.
std::array<std::uint32_t, kLongest + 1> leaves_at_depth(const std::vector<Leaf>& leaves,
                                                        std::size_t most) {
  // Two queues: the leaves, and the inner nodes, which are made in ascending order.
  const std::size_t inner = leaves.size() - 1;
  std::vector<std::uint64_t> weight(inner);
  std::vector<std::size_t> parent(leaves.size() + inner);
  std::size_t leaf = 0;
  std::size_t node = 0;
  for (std::size_t made = 0; made < inner; ++made) {
    for (int child = 0; child < 2; ++child) {
      const bool take_leaf =
          node == made || (leaf < leaves.size() && leaves[leaf].count <= weight[node]);
      weight[made] += take_leaf ? leaves[leaf].count : weight[node];
      parent[take_leaf ? leaf++ : leaves.size() + node++] = leaves.size() + made;
    }
  }
  std::vector<std::size_t> depth(leaves.size() + inner);
  std::array<std::uint32_t, kLongest + 1> number{};
  for (std::size_t i = depth.size() - 1; i-- > 0;) {
    depth[i] = depth[parent[i]] + 1;
    if (i < leaves.size()) ++number[std::min(depth[i], most)];
  }
  return number;
}

/// Leaves that were lifted to `most` took more of the code than there is: others go down until all
/// fit.
void make_room(std::array<std::uint32_t, kLongest + 1>& number, std::size_t most) {
  std::uint32_t used = 0;  // in codes of the longest length
  for (std::size_t depth = 1; depth <= most; ++depth) used += number[depth] << (most - depth);
  for (; used > std::uint32_t{1} << most; --used) {
    std::size_t depth = most - 1;
    while (number[depth] == 0) --depth;
    --number[depth];  // one leaf becomes a node over itself and one of the deepest
    number[depth + 1] += 2;
    --number[most];
  }
}

}  // namespace

void code_lengths(std::span<const std::uint32_t> count, int most, std::span<std::uint8_t> length) {
  std::vector<Leaf> leaves;
  for (std::size_t i = 0; i < count.size(); ++i) {
    length[i] = 0;
    if (count[i] > 0) leaves.push_back({count[i], static_cast<std::uint16_t>(i)});
  }
  if (leaves.size() < 2) {
    for (const Leaf& leaf : leaves) length[leaf.symbol] = 1;
    return;
  }
  std::ranges::stable_sort(leaves, {}, &Leaf::count);
  const auto deepest = static_cast<std::size_t>(most);
  auto number = leaves_at_depth(leaves, deepest);
  make_room(number, deepest);
  std::size_t depth = deepest;
  for (const Leaf& leaf : leaves) {  // the rarest are the deepest
    while (number[depth] == 0) --depth;
    --number[depth];
    length[leaf.symbol] = static_cast<std::uint8_t>(depth);
  }
}

void canonical_code(std::span<const std::uint8_t> length, std::span<std::uint16_t> code) {
  std::array<std::uint32_t, kLongest + 2> next{};
  for (const std::uint8_t bits : length) {
    if (bits > 0) ++next[bits + 1U];
  }
  for (std::size_t bits = 1; bits <= kLongest; ++bits) {
    next[bits + 1] += next[bits];
    next[bits + 1] <<= 1;
  }
  // next[bits] is now the first code of that length.
  for (std::size_t i = 0; i < length.size(); ++i) {
    std::uint32_t straight = length[i] > 0 ? next[length[i]]++ : 0;
    std::uint32_t reversed = 0;
    for (int bit = 0; bit < length[i]; ++bit, straight >>= 1) {
      reversed = reversed << 1 | (straight & 1);
    }
    code[i] = static_cast<std::uint16_t>(reversed);
  }
}

}  // namespace tristim::detail
