#include "tristim/palette/histogram.h"

#include <algorithm>

namespace tristim {
namespace {

std::uint32_t key_of(Color8 c) {
  return std::uint32_t{c.r} << 16 | std::uint32_t{c.g} << 8 | std::uint32_t{c.b};
}

Color8 color_of(std::uint32_t key) {
  return {static_cast<std::uint8_t>(key >> 16), static_cast<std::uint8_t>(key >> 8 & 0xff),
          static_cast<std::uint8_t>(key & 0xff)};
}

}  // namespace

void Histogram::add(Color8 color, std::uint64_t count) { counts_[key_of(color)] += count; }

void Histogram::add(ImageView<const std::uint16_t> codes) {
  for (int y = 0; y < codes.height; ++y) {
    const std::uint16_t* pixel = codes.row(y).data();
    std::uint32_t run_key = 0;
    std::uint64_t run = 0;  // runs of one colour are looked up once
    for (int x = 0; x < codes.width; ++x, pixel += 3) {
      const std::uint32_t key =
          std::uint32_t{pixel[0]} << 16 | std::uint32_t{pixel[1]} << 8 | std::uint32_t{pixel[2]};
      if (key != run_key && run > 0) {
        counts_[run_key] += run;
        run = 0;
      }
      run_key = key;
      ++run;
    }
    if (run > 0) counts_[run_key] += run;
  }
}

void Histogram::merge(const Histogram& other) {
  for (const auto& [key, count] : other.counts_) counts_[key] += count;
}

std::vector<Histogram::Entry> Histogram::entries() const {
  std::vector<Entry> all;
  all.reserve(counts_.size());
  for (const auto& [key, count] : counts_) all.push_back({color_of(key), count});
  std::sort(all.begin(), all.end(),
            [](const Entry& a, const Entry& b) { return a.color < b.color; });
  return all;
}

}  // namespace tristim
