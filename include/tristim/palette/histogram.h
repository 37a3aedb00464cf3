#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tristim/image/view.h"

namespace tristim {

/// A colour as it is counted: codes of 8 bits a channel, not premultiplied.
struct Color8 {
  std::uint8_t r = 0, g = 0, b = 0;
  std::uint8_t a = 255;  // 255: opaque
  friend constexpr auto operator<=>(const Color8&, const Color8&) = default;
};

/// How often each colour of a picture occurs, at 8 bits a channel. Counts are exact and do not
/// depend on the order of counting.
///
/// Memory grows with the 64ths of a channel that a picture uses, not with its pixels: 6 MB for
/// most photographs, 66 MB for a picture of all 2^24 colours; translucent colours take 40 bytes
/// each.
class Histogram {
 public:
  struct Entry {
    Color8 color;
    std::uint64_t count = 0;
    friend constexpr bool operator==(const Entry&, const Entry&) = default;
  };

  /// A count of 0 adds nothing.
  void add(Color8 color, std::uint64_t count = 1);

  /// Every pixel of rows of codes below 256, with 3 channels or with alpha as a fourth. Throws
  /// std::invalid_argument for other numbers of channels.
  void add(ImageView<const std::uint16_t> codes);
  void add(ImageView<const std::uint8_t> codes);

  /// Every pixel as often as its weight says; `weights` has one channel and the size of `codes`.
  void add(ImageView<const std::uint16_t> codes, ImageView<const std::uint16_t> weights);

  void merge(const Histogram& other);

  /// The distinct colours in ascending order (r, then g, then b, then a).
  std::vector<Entry> entries() const;

  bool empty() const noexcept { return blocks_.empty() && translucent_.empty(); }

 private:
  // 4 x 4 x 4 neighbouring colours, which a picture's neighbouring pixels mostly share.
  using Block = std::array<std::uint32_t, 64>;

  std::uint32_t new_block(std::uint32_t cell);
  Block& block(std::uint32_t cell);
  /// The blocks of the cells that hold r and g, each with its first blue.
  std::vector<std::pair<std::uint32_t, const Block*>> row_of_blocks(std::uint32_t r,
                                                                    std::uint32_t g) const;
  template <typename T, typename Weights>
  void add_rows(ImageView<const T> codes, Weights&& weight);

  std::vector<std::uint32_t> directory_;    // of each cell the number of its block, from 1; 0: none
  std::vector<std::vector<Block>> blocks_;  // in slabs, so that growth moves none
  std::unordered_map<std::uint32_t, std::uint64_t> carry_;        // what a block's 32 bits lost
  std::unordered_map<std::uint32_t, std::uint64_t> translucent_;  // by r, g, b, a
};

/// How translucent colours are counted.
enum class AlphaMode {
  kOver,       ///< over black, premultiplied: opaque
  kThreshold,  ///< from 128 on opaque, below not at all: what a transparent index stands for
  kEntries,    ///< as they are: palette entries with alpha; all of alpha 0 are one
};

struct NamedAlphaMode {
  std::string_view name;
  AlphaMode mode;
};
inline constexpr std::array kAlphaModes{NamedAlphaMode{"over", AlphaMode::kOver},
                                        NamedAlphaMode{"threshold", AlphaMode::kThreshold},
                                        NamedAlphaMode{"entries", AlphaMode::kEntries}};

Histogram with_alpha(const Histogram& histogram, AlphaMode mode);

}  // namespace tristim
