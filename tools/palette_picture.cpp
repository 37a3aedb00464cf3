#include "tools/palette_picture.h"

#include <algorithm>
#include <array>
#include <map>

#include "tristim/color/primaries.h"
#include "tristim/color/transfer.h"
#include "tristim/core/find.h"
#include "tristim/image/flatten.h"
#include "tristim/image/io/read.h"
#include "tristim/palette/nearest.h"
#include "tristim/palette/palette.h"
#include "tristim/palette/quantize.h"

namespace tristim::tools {
namespace {

constexpr std::size_t kMostColors = 64;
constexpr int kMedianCutColors = 16;

std::uint8_t code_of(double light) {
  static const auto decisions = [] {
    std::array<double, 255> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = srgb_decode((static_cast<double>(i) + 0.5) / 255);
    }
    return all;
  }();
  const auto* found = std::upper_bound(decisions.begin(), decisions.end(), light);
  return static_cast<std::uint8_t>(found - decisions.begin());
}

Rgb light_of(Color8 c) {
  return {srgb_decode(c.r / 255.0), srgb_decode(c.g / 255.0), srgb_decode(c.b / 255.0)};
}

std::string hex_name(Color8 c) { return hex_text({c.r / 255.0, c.g / 255.0, c.b / 255.0}); }

struct Pixels {
  int width = 0, height = 0;
  std::vector<Color8> colors;
};

Pixels read_pixels(const std::string& path) {
  const auto source = flatten(open_picture(path), {}, nullptr);
  const PictureInfo& info = source->info();
  const Eigen::Matrix3d to_srgb = rgb_from_rgb({}, info.primaries, Adaptation::kBradford);
  Pixels pixels{info.width, info.height, {}};
  pixels.colors.reserve(static_cast<std::size_t>(info.width) *
                        static_cast<std::size_t>(info.height));
  Image row(info.width, 1, 3);
  for (int y = 0; y < info.height; ++y) {
    source->read(row.view());
    const float* p = row.view().row(0).data();
    for (int x = 0; x < info.width; ++x, p += 3) {
      const Eigen::Vector3d c = to_srgb * Eigen::Vector3d(p[0], p[1], p[2]);
      pixels.colors.push_back({code_of(c[0]), code_of(c[1]), code_of(c[2])});
    }
  }
  return pixels;
}

// For each colour of the picture its place in the palette.
std::map<Color8, std::size_t> places_of(const std::vector<Histogram::Entry>& entries,
                                        const std::vector<Color8>& palette) {
  std::vector<Rgb> light;
  for (const Color8 c : palette) light.push_back(light_of(c));
  const NearestColor nearest(light, kMetrics[0]);
  std::map<Color8, std::size_t> places;
  for (const Histogram::Entry& entry : entries) {
    places[entry.color] = static_cast<std::size_t>(nearest.find(light_of(entry.color)));
  }
  return places;
}

std::vector<Color8> palette_of(const Histogram& histogram,
                               const std::vector<Histogram::Entry>& entries) {
  if (entries.size() > kMostColors)
    return build_palette(histogram, *find_by_name(kPaletteMethods, "median-cut"),
                         {.colors = kMedianCutColors});
  std::vector<Color8> palette;
  for (const Histogram::Entry& entry : entries) palette.push_back(entry.color);
  return palette;
}

}  // namespace

ChartColor chart_color(EncodedRgb color) {
  const Rgb light{srgb_decode(color.r), srgb_decode(color.g), srgb_decode(color.b)};
  return {hex_name({code_of(light.r), code_of(light.g), code_of(light.b)}), light};
}

Histogram picture_histogram(const std::string& path) {
  Histogram histogram;
  for (const Color8 c : read_pixels(path).colors) histogram.add(c);
  return histogram;
}

Chart picture_chart(const std::string& path) {
  const Pixels pixels = read_pixels(path);
  Histogram histogram;
  for (const Color8 c : pixels.colors) histogram.add(c);
  const std::vector<Histogram::Entry> entries = histogram.entries();
  const std::vector<Color8> palette = palette_of(histogram, entries);
  const std::map<Color8, std::size_t> places = places_of(entries, palette);

  Chart chart;
  chart.has_places = true;
  for (const Color8 c : palette) chart.colors.push_back({hex_name(c), light_of(c)});
  std::map<std::pair<std::size_t, std::size_t>, std::uint64_t> touching;
  std::vector<std::size_t> above(static_cast<std::size_t>(pixels.width));
  const int rim_x = (pixels.width + 9) / 10;
  const int rim_y = (pixels.height + 9) / 10;
  std::size_t i = 0;
  for (int y = 0; y < pixels.height; ++y) {
    std::size_t left = 0;
    for (int x = 0; x < pixels.width; ++x, ++i) {
      const std::size_t place = places.at(pixels.colors[i]);
      ChartColor& color = chart.colors[place];
      ++color.count;
      const bool inner =
          x >= rim_x && x < pixels.width - rim_x && y >= rim_y && y < pixels.height - rim_y;
      if (!inner) ++color.rim;
      std::size_t& up = above[static_cast<std::size_t>(x)];
      if (x > 0 && left != place) ++touching[std::minmax(left, place)];
      if (y > 0 && up != place) ++touching[std::minmax(up, place)];
      left = place;
      up = place;
    }
  }
  for (const auto& [pair, count] : touching) chart.neighbours.push_back(pair);
  return chart;
}

}  // namespace tristim::tools
