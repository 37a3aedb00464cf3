#include "tools/halftone.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"
#include "tristim/dither/cells.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim halftone levels --n 2 --bits 1\n"
    "  tristim halftone levels --n 2 --bits 1,1,1 --colors\n"
    "  tristim halftone levels --n 4 --bits 3,3,2 --json\n";

constexpr std::int64_t kMostListed = 1'000'000;

struct Options {
  int n = 0;
  std::vector<int> bits;
  bool colors = false, json = false;
};

std::vector<int> bits_option(const std::string& text) {
  std::vector<int> bits;
  for (const std::string_view part : split(text, ',')) {
    bits.push_back(integer_option("--bits", part, 1, 16));
  }
  if (bits.size() > 4) {
    throw Error(ErrorKind::kMisuse, "--bits", "'" + text + "' has more than 4 channels",
                "give one number, or one for each channel: 3,3,2");
  }
  return bits;
}

std::string channel_name(const Options& options, std::size_t channel) {
  if (options.bits.size() == 1) return "";
  if (options.bits.size() == 3) return std::string(1, "RGB"[channel]) + " ";
  return std::to_string(channel + 1) + " ";
}

std::string count_text(const Options& options) {
  const std::string n = std::to_string(options.n);
  std::string text = n + " x " + n + " cells, ";
  std::string product;
  for (const int bits : options.bits) {
    product += (product.empty() ? "" : " x ") + std::to_string(cell_level_count(options.n, bits));
  }
  if (options.bits.size() == 1) {
    return text + std::to_string(options.bits[0]) + " bits: n^2 (2^m - 1) + 1 = " + product +
           " levels [Shoaff 2.1.2]\n";
  }
  std::string bits;
  for (const int b : options.bits) bits += (bits.empty() ? "" : ", ") + std::to_string(b);
  return text + bits + " bits: " + product + " = " +
         std::to_string(cell_color_count(options.n, options.bits)) + " colours [Shoaff 2.1.2]\n";
}

std::string levels_text(const Options& options) {
  std::string text = count_text(options);
  for (std::size_t c = 0; c < options.bits.size(); ++c) {
    text += "\n" + channel_name(options, c) +
            "level, intensity, value of all pixels, pixels with "
            "one more\n";
    const std::int64_t count = cell_level_count(options.n, options.bits[c]);
    for (std::int64_t k = 0; k < count; ++k) {
      const CellLevel level = cell_level(options.n, options.bits[c], k);
      text += std::to_string(level.level) + "  " + rounded(level.intensity, 7) + "  " +
              std::to_string(level.value) + "  " + std::to_string(level.raised) + "\n";
    }
  }
  return text;
}

// The levels of color number `index`, the last channel fastest.
std::vector<std::int64_t> color_levels(const Options& options, std::int64_t index) {
  std::vector<std::int64_t> levels(options.bits.size());
  for (std::size_t c = options.bits.size(); c-- > 0;) {
    const std::int64_t count = cell_level_count(options.n, options.bits[c]);
    levels[c] = index % count;
    index /= count;
  }
  return levels;
}

std::string colors_text(const Options& options) {
  std::string text = "\nintensities of the colours\n";
  const std::int64_t count = cell_color_count(options.n, options.bits);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::vector<std::int64_t> levels = color_levels(options, i);
    for (std::size_t c = 0; c < levels.size(); ++c) {
      text += (c == 0 ? "" : "  ") +
              rounded(cell_level(options.n, options.bits[c], levels[c]).intensity, 7);
    }
    text += "\n";
  }
  return text;
}

Json levels_json(const Options& options) {
  Json channels = Json::array();
  for (const int bits : options.bits) {
    Json levels = Json::array();
    const std::int64_t count = cell_level_count(options.n, bits);
    for (std::int64_t k = 0; k < count; ++k) {
      const CellLevel level = cell_level(options.n, bits, k);
      levels.push_back({{"level", level.level},
                        {"intensity", level.intensity},
                        {"value", level.value},
                        {"raised", level.raised}});
    }
    channels.push_back({{"bits", bits}, {"count", count}, {"levels", levels}});
  }
  Json facts{{"n", options.n},
             {"count", cell_color_count(options.n, options.bits)},
             {"channels", channels}};
  if (!options.colors) return facts;
  Json colors = Json::array();
  const std::int64_t count = cell_color_count(options.n, options.bits);
  for (std::int64_t i = 0; i < count; ++i) colors.push_back(color_levels(options, i));
  facts["colors"] = colors;
  return facts;
}

void check(const Options& options) {
  if (options.n == 0 || options.bits.empty()) {
    throw Error(ErrorKind::kMisuse, options.n == 0 ? "--n" : "--bits", "is missing",
                "give both, as in --n 2 --bits 1");
  }
  std::int64_t listed = options.colors ? cell_color_count(options.n, options.bits) : 0;
  for (const int bits : options.bits) listed += cell_level_count(options.n, bits);
  if (listed <= kMostListed) return;
  throw Error(ErrorKind::kMisuse, "halftone levels",
              std::to_string(listed) + " levels and colours are too many to list",
              "ask for " + std::to_string(kMostListed) + " at most");
}

}  // namespace

void run_halftone_levels(Arguments arguments) {
  Options options;
  CommandLine line(*halftone_job("levels"), kExamples);
  line.option("--n", "N", "side of a cell, 1 to 256",
              [&options](const std::string& v) { options.n = integer_option("--n", v, 1, 256); });
  line.option("--bits", "M|R,G,B", "bits of the device, or of each of its channels",
              [&options](const std::string& v) { options.bits = bits_option(v); });
  line.flag("--colors", "list the colours too", options.colors);
  line.flag("--json", "print as JSON", options.json);
  if (!line.parse(arguments)) return;
  check(options);
  if (options.json) return print(json_line(levels_json(options)));
  print(levels_text(options) + (options.colors ? colors_text(options) : ""));
}

}  // namespace tristim::tools
