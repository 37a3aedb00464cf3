#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>

#include "lib/palette/clusters.h"
#include "tristim/color/oklab.h"
#include "tristim/color/transfer.h"
#include "tristim/core/find.h"
#include "tristim/palette/quantize.h"

namespace tristim {
namespace {

using Entry = Histogram::Entry;

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("palette: " + what);
}

void check(const PaletteOptions& options) {
  const auto fixed = std::ssize(options.fixed);
  if (options.colors < 1 || options.colors > kMostColors) {
    refuse(std::to_string(options.colors) + " colours, expected 1 to " +
           std::to_string(kMostColors));
  }
  if (fixed > options.colors) {
    refuse(std::to_string(fixed) + " fixed colours, more than the " +
           std::to_string(options.colors) + " of the palette");
  }
  if (options.inks.empty() || options.inks.size() > 3) {
    refuse(std::to_string(options.inks.size()) + " inks, expected 1 to 3");
  }
  if (!options.transparent) return;
  if (*options.transparent < fixed || *options.transparent >= options.colors) {
    refuse("transparent index " + std::to_string(*options.transparent) + ", expected " +
           std::to_string(fixed) + " to " + std::to_string(options.colors - 1) +
           ", behind the fixed colours");
  }
}

const Metric& metric_of(const PaletteOptions& options) {
  return options.metric != nullptr ? *options.metric : *find_by_name(kMetrics, "balanced");
}

// The colours that are not there already, in the order that the method takes.
std::vector<Entry> open_entries(const Histogram& histogram, const PaletteMethod& method,
                                const PaletteOptions& options) {
  std::vector<Entry> entries = method.neighbours ? histogram.neighbours() : histogram.entries();
  if (options.fixed.empty() && !options.transparent) return entries;
  const std::set<Color8> there(options.fixed.begin(), options.fixed.end());
  std::erase_if(entries, [&](const Entry& entry) {
    return there.contains(entry.color) || (options.transparent && entry.color.a == 0);
  });
  return entries;
}

std::vector<Color8> chosen(const PaletteMethod& method, const PaletteTask& task) {
  if (task.colors == 0) return {};
  if (method.needs_histogram) {
    if (std::ssize(task.entries) > task.colors) return method.choose(task);
    std::vector<Color8> all;
    for (const Entry& entry : task.entries) all.push_back(entry.color);
    std::sort(all.begin(), all.end());
    return all;
  }
  std::vector<Color8> palette = method.choose(task);
  if (std::ssize(palette) > task.colors) {
    refuse(std::string(method.name) + " has " + std::to_string(palette.size()) +
           " colours, more than the " + std::to_string(task.colors) + " there is room for");
  }
  return palette;
}

Oklab oklab(Color8 c) {
  const auto light = [](std::uint8_t code) { return srgb_decode(code / 255.0); };
  return linear_srgb_to_oklab({light(c.r), light(c.g), light(c.b)});
}

// Greys first, then by hue.
std::array<double, 2> hue_key(Color8 c) {
  constexpr double kRedHue = 29.2;  // of the red primary
  const Oklch ok = oklab_to_oklch(oklab(c));
  if (c.r == c.g && c.g == c.b) return {-1, ok.l};
  return {ok.h < kRedHue ? ok.h - kRedHue + 360 : ok.h - kRedHue, ok.l};
}

// Twelve bits of luminance and more: equal light is equal in it.
double luminance(Color8 c) {
  const auto light = [](std::uint8_t code) { return srgb_decode(code / 255.0); };
  return 0.2126 * light(c.r) + 0.7152 * light(c.g) + 0.0722 * light(c.b);
}

// How many pixels are nearest to each colour.
std::vector<std::uint64_t> popularity_of(std::span<const Entry> entries,
                                         const std::vector<Color8>& palette, const Metric& metric) {
  std::vector<std::uint64_t> pixels(palette.size());
  if (entries.empty()) return pixels;
  const detail::ColorCells cells({entries.begin(), entries.end()}, metric);
  detail::Places places;
  const detail::Placer placer(metric);
  for (const Color8 c : palette) places.push_back(placer(c), 0);
  const detail::Nearest nearest = detail::nearest_entries(cells.colors, places);
  for (std::size_t i = 0; i < cells.entries.size(); ++i) {
    pixels[nearest.index[i]] += cells.entries[i].count;
  }
  return pixels;
}

// Sorted by ascending keys; of equal ones by luminance, then by codes.
template <typename Key>
void sort_by(std::vector<Color8>& palette, const std::vector<Key>& keys) {
  std::vector<std::size_t> order(palette.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> light;
  for (const Color8 c : palette) light.push_back(luminance(c));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (keys[a] != keys[b]) return keys[a] < keys[b];
    return light[a] != light[b] ? light[a] < light[b] : palette[a] < palette[b];
  });
  std::vector<Color8> sorted;
  for (const std::size_t i : order) sorted.push_back(palette[i]);
  palette = std::move(sorted);
}

void put_in_order(std::vector<Color8>& palette, PaletteOrder order, std::span<const Entry> entries,
                  const Metric& metric) {
  if (order == PaletteOrder::kFound || palette.empty()) return;
  if (order == PaletteOrder::kLuminance) return sort_by(palette, std::vector<int>(palette.size()));
  if (order == PaletteOrder::kHue) {
    std::vector<std::array<double, 2>> keys;
    for (const Color8 c : palette) keys.push_back(hue_key(c));
    return sort_by(palette, keys);
  }
  std::vector<std::uint64_t> keys = popularity_of(entries, palette, metric);
  for (std::uint64_t& key : keys) key = ~key;  // most pixels first
  sort_by(palette, keys);
}

std::vector<Color8> palette_of(std::span<const Entry> entries, const detail::ColorCells* cells,
                               const PaletteMethod& method, const PaletteOptions& options) {
  const int room =
      options.colors - static_cast<int>(options.fixed.size()) - (options.transparent ? 1 : 0);
  const Metric& metric = metric_of(options);
  std::vector<Color8> colors =
      chosen(method, {entries, room, &metric, options.fixed, options.bits, options.inks, cells});
  put_in_order(colors, options.order, entries, metric);

  std::vector<Color8> palette = options.fixed;
  palette.insert(palette.end(), colors.begin(), colors.end());
  if (!options.transparent) return palette;
  const auto index = static_cast<std::size_t>(*options.transparent);
  if (palette.size() < index) palette.resize(index, palette.empty() ? Color8{} : palette.back());
  palette.insert(palette.begin() + *options.transparent, Color8{0, 0, 0, 0});
  return palette;
}

}  // namespace

std::vector<Color8> build_palette(const Histogram& histogram, const PaletteMethod& method,
                                  const PaletteOptions& options) {
  check(options);
  return palette_of(open_entries(histogram, method, options), nullptr, method, options);
}

Quantized quantize(const Histogram& histogram, const PaletteMethod& method,
                   const PaletteOptions& options) {
  check(options);
  const Metric& metric = metric_of(options);
  const detail::ColorCells cells(histogram.neighbours(), metric);
  const bool shares = method.neighbours && options.fixed.empty() && !options.transparent;
  std::vector<Color8> palette = shares ? palette_of(cells.entries, &cells, method, options)
                                       : build_palette(histogram, method, options);
  PaletteMap map(palette, metric, cells);
  return {std::move(palette), std::move(map)};
}

}  // namespace tristim
