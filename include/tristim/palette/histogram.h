#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string_view>
#include <unordered_map>
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
/// Memory grows with the 64ths of a channel that a picture uses, not with its pixels: 3 to 10 MB
/// for most photographs, 35 MB for a picture of all 2^24 colours; translucent colours and those of
/// more than 65535 pixels take 40 bytes each.
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

  /// The same, cell by cell of 4 x 4 x 4 colours, in one order whatever was counted first.
  std::vector<Entry> neighbours() const;

  /// How many distinct colours there are.
  std::size_t size() const noexcept { return opaque_colors() + translucent_.size(); }

  bool empty() const noexcept { return blocks_ == 0 && translucent_.empty(); }

 private:
  // 4 x 4 x 4 neighbouring colours, which a picture's neighbouring pixels mostly share.
  using Block = std::array<std::uint16_t, 64>;

  std::uint32_t new_block(std::uint32_t cell);
  Block& block(std::uint32_t cell);
  const Block* block_of(std::uint32_t cell) const;
  void carry(std::uint32_t number, std::uint16_t& low, std::uint64_t sum);
  void count(std::uint32_t number, std::uint64_t pixels);
  template <int kChannels, typename T, typename Weights>
  void add_row(const T* pixels, int width, Weights&& weight);
  template <typename T, typename Weights>
  void add_rows(ImageView<const T> codes, Weights&& weight);
  std::size_t opaque_colors() const noexcept;
  template <typename Before>
  void add_carried(std::vector<Entry>& entries, Before&& before) const;

  std::vector<std::uint32_t> directory_;   // of each cell the number of its block, from 1; 0: none
  std::vector<std::vector<Block>> slabs_;  // of blocks, so that growth moves none
  std::uint32_t blocks_ = 0;
  // What the 16 bits of a colour's count in its block do not hold; that count is then not 0.
  std::unordered_map<std::uint32_t, std::uint64_t> carried_;
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
inline constexpr std::array kAlphaModes{NamedAlphaMode{"premultiplied", AlphaMode::kOver},
                                        NamedAlphaMode{"threshold", AlphaMode::kThreshold},
                                        NamedAlphaMode{"entries", AlphaMode::kEntries}};

Histogram with_alpha(const Histogram& histogram, AlphaMode mode);

}  // namespace tristim
