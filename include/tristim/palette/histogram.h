#pragma once

#include <compare>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "tristim/image/view.h"

namespace tristim {

/// A colour as it is counted: codes of 8 bits a channel.
struct Color8 {
  std::uint8_t r = 0, g = 0, b = 0;
  friend constexpr auto operator<=>(const Color8&, const Color8&) = default;
};

/// How often each colour of a picture occurs, at 8 bits a channel.
class Histogram {
 public:
  struct Entry {
    Color8 color;
    std::uint64_t count = 0;
  };

  void add(Color8 color, std::uint64_t count = 1);

  /// Every pixel of rows of 3-channel codes below 256.
  void add(ImageView<const std::uint16_t> codes);

  void merge(const Histogram& other);

  /// The distinct colours in ascending order (r, then g, then b).
  std::vector<Entry> entries() const;

 private:
  std::unordered_map<std::uint32_t, std::uint64_t> counts_;
};

}  // namespace tristim
