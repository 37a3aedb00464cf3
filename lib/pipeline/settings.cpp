#include "tristim/pipeline/settings.h"

#include <array>
#include <cmath>
#include <vector>

#include "lib/core/toml.h"
#include "lib/pipeline/screen_settings.h"
#include "lib/pipeline/setting_values.h"
#include "tristim/color/parse.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

using detail::not_a;
using detail::Result;
using detail::set_switch;

template <typename List>
Refusal unknown(std::string_view what, const List& list, std::string_view value) {
  return {"unknown " + std::string(what) + " '" + std::string(value) + "'", name_hint(list, value)};
}

constexpr double kMostStops = 64;

Result set_exposure(Settings& settings, std::string_view value) {
  const auto stops = parse_number(value);
  if (!stops || !(std::fabs(*stops) <= kMostStops)) {
    return not_a("exposure", value, "give stops from -64 to 64, such as 1.5 or -2");
  }
  settings.exposure_stops = *stops;
  return {};
}

Result set_tone_map(Settings& settings, std::string_view value) {
  if (same_name(value, "none")) {
    settings.tone = nullptr;
    return {};
  }
  const std::vector<std::string_view> parts = split(value, ':');
  const ToneOperator* tone = find_by_name(kToneOperators, parts[0]);
  if (tone == nullptr) {
    Refusal refusal = unknown("tone map", kToneOperators, parts[0]);
    if (refusal.remedy.starts_with("use one of")) refusal.remedy += ", none";
    return refusal;
  }
  double white = 0;
  if (parts.size() > 1) {
    const auto number = parse_number(parts[1]);
    if (parts.size() > 2 || !number || !(*number > 0) || !std::isfinite(*number)) {
      return not_a("tone map", value, "give the luminance that becomes white, as in reinhard:8");
    }
    white = *number;
  }
  settings.tone = tone;
  settings.tone_white = white;
  return {};
}

Result set_size(Settings& settings, std::string_view value) {
  const std::size_t x = value.find_first_of("xX");
  const auto side = [](std::string_view text) -> std::optional<int> {
    if (text.empty()) return 0;
    const auto number = parse_integer(text);
    if (!number || *number < 1 || *number > kMaxFitSide) return std::nullopt;
    return static_cast<int>(*number);
  };
  const bool both = x != std::string_view::npos;
  const auto width = side(value.substr(0, x));
  const auto height = both ? side(value.substr(x + 1)) : std::optional<int>(0);
  if (!width || !height || (*width == 0 && *height == 0)) {
    return not_a("size", value, "give WIDTHxHEIGHT in pixels, or one of them: 800x480, 800x, x480");
  }
  settings.width = *width;
  settings.height = *height;
  return {};
}

Result set_rotate(Settings& settings, std::string_view value) {
  const auto angle = parse_integer(value);
  if (!angle || *angle < 0 || *angle > 270 || *angle % 90 != 0) {
    return not_a("rotation", value, "give 0, 90, 180 or 270 degrees clockwise");
  }
  settings.rotate_deg = static_cast<int>(*angle);
  return {};
}

Result set_background(Settings& settings, std::string_view value) {
  const auto color = parse_color(value);
  if (!color) return not_a("colour", value, color_hint(value));
  settings.background = *color;
  return {};
}

Result set_jitter(Settings& settings, std::string_view value) {
  const auto jitter = parse_number(value);
  if (!jitter || !(*jitter >= 0 && *jitter <= 1)) {
    return not_a("jitter", value, "give 0 for a fixed threshold to 1 for the step between levels");
  }
  settings.dither_parameters.jitter = static_cast<float>(*jitter);
  return {};
}

// A name of no method is a file's where it has a folder or an extension.
Result set_dither(Settings& settings, std::string_view value) {
  settings.dither_file.clear();
  settings.dither = find_dither(value);
  if (settings.dither) return {};
  if (value.find_first_of("./") == std::string_view::npos) {
    return unknown("dither", dither_methods(), value);
  }
  settings.dither_file = std::string(value);
  return {};
}

Result set_cells(Settings& settings, std::string_view value) {
  constexpr long long kMostSide = 256;
  const std::vector<std::string_view> parts = split(value, 'x');
  const auto width = parse_integer(parts[0]);
  const auto height = parts.size() == 2 ? parse_integer(parts[1]) : width;
  const auto fits = [](const auto& side) { return side && *side >= 1 && *side <= kMostSide; };
  if (parts.size() > 2 || !fits(width) || !fits(height)) {
    return not_a("cell", value, "give a side of 1 to 256, or WIDTHxHEIGHT, in device pixels");
  }
  settings.cell_width = static_cast<int>(*width);
  settings.cell_height = static_cast<int>(*height);
  return {};
}

Result set_strength(Settings& settings, std::string_view value) {
  const auto strength = parse_number(value);
  if (!strength || !(*strength >= 0 && *strength <= 1)) {
    return not_a("strength", value, "give 0 for the nearest code to 1 for the whole dither");
  }
  settings.dither_parameters.strength = static_cast<float>(*strength);
  return {};
}

// An integer from 0 to `most` into a parameter of the dither.
template <typename Assign>
Result set_count(std::string_view what, std::string_view value, std::int64_t most,
                 Assign&& assign) {
  const auto number = parse_integer(value);
  if (!number || *number < 0 || *number > most) {
    return not_a(what, value, "give an integer from 0 to " + std::to_string(most));
  }
  assign(*number);
  return {};
}

constexpr std::int64_t kMostFrames = 1'000'000'000;
constexpr std::int64_t kMostMaskSize = 1024;
constexpr std::int64_t kMostSeed = 1'000'000'000'000'000;
constexpr std::int64_t kMostEffort = 1000;

// The method of "fixed-565" and the like, with so many bits a channel; nothing for other names.
std::optional<std::array<int, 3>> fixed_bits(std::string_view name) {
  constexpr std::string_view kFixed = "fixed-";
  if (name.size() != kFixed.size() + 3 || !name.starts_with(kFixed)) return std::nullopt;
  std::array<int, 3> bits{};
  int sum = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    bits[c] = name[kFixed.size() + c] - '0';
    if (bits[c] < 0 || bits[c] > 8) return std::nullopt;
    sum += bits[c];
  }
  return sum >= 1 && sum <= 16 ? std::optional(bits) : std::nullopt;
}

// Colours behind "inks:N:", as in "#204080+black"; nothing where one is none.
std::optional<std::vector<Color8>> parse_inks(std::string_view text) {
  std::vector<Color8> inks;
  for (const std::string_view part : split(text, '+')) {
    const auto color = parse_color(part);
    if (!color) return std::nullopt;
    const auto code = [](double v) { return static_cast<std::uint8_t>(v * 255 + 0.5); };
    inks.push_back({code(color->r), code(color->g), code(color->b)});
  }
  if (inks.size() > 3) return std::nullopt;
  return inks;
}

// Files have a folder or an extension, which no method has.
bool names_file(std::string_view value) { return value.find_first_of("/.") != value.npos; }

Result set_colors(Settings& settings, std::string_view value) {
  const auto number = parse_integer(value);
  if (!number || *number < 1 || *number > kMostColors) {
    return not_a("number of colours", value, "give 1 to 65536");
  }
  settings.colors = static_cast<int>(*number);
  return {};
}

Result set_transparent(Settings& settings, std::string_view value) {
  const auto number = same_name(value, "last") ? -1 : parse_integer(value).value_or(-2);
  if (number < -1 || number >= kMostColors) {
    return not_a("position", value, "give the position in the palette, from 0, or last");
  }
  settings.transparent = static_cast<int>(number);
  return {};
}

Result set_palette(Settings& settings, std::string_view value) {
  if (same_name(value, "device")) {
    settings.palette = {};
    return {};
  }
  const std::vector<std::string_view> parts = split(value, ':');
  const auto bits = fixed_bits(parts[0]);
  const PaletteMethod* method = find_by_name(kPaletteMethods, bits ? "fixed" : parts[0]);
  if (method == nullptr && names_file(value)) {
    settings.palette = {nullptr, 0, {}, {}, std::string(value)};
    return {};
  }
  if (method == nullptr) return unknown("palette", kPaletteMethods, parts[0]);
  int colors = 0;
  if (parts.size() > 1) {
    const auto number = parse_integer(parts[1]);
    const bool too_many = parts.size() > 3 || (parts.size() > 2 && method->name != "inks");
    if (too_many || !number || *number < 1 || *number > kMostColors) {
      return not_a("palette", value, "give the number of colours, 1 to 65536, as in best:16");
    }
    colors = static_cast<int>(*number);
  }
  if (bits && colors == 0) colors = 1 << ((*bits)[0] + (*bits)[1] + (*bits)[2]);
  std::vector<Color8> inks;
  if (parts.size() > 2) {
    const auto given = parse_inks(parts[2]);
    if (!given)
      return not_a("palette", value, "give one to three inks, as in inks:16:#204080+black");
    inks = *given;
  }
  settings.palette = {method, colors, bits.value_or(std::array{0, 0, 0}), inks, {}};
  return {};
}

// A setting that is a member of a list.
template <typename List, typename Assign>
Result choose(std::string_view what, const List& list, std::string_view value, Assign&& assign) {
  const auto* item = find_by_name(list, value);
  if (item == nullptr) return unknown(what, list, value);
  assign(*item);
  return {};
}

std::vector<Setting> make_settings() {
  return {
      {"layer", "NAME", "channels to take: diffuse for diffuse.R G B, or one channel's name",
       [](Settings& s, std::string_view v) -> Result {
         s.layer = std::string(v);
         return {};
       }},
      {"size", "WxH|Wx|xH", "size of the result; default: the panel's, else the picture's",
       set_size},
      {"fit", list_names(kFitModes, "|"), "how the picture fills that size; default: contain",
       [](Settings& s, std::string_view v) {
         return choose("fit", kFitModes, v, [&](const NamedFitMode& m) { s.fit = m.mode; });
       }},
      {"filter", list_names(kFilters, "|"), "resampling filter, in light; default: hermite",
       [](Settings& s, std::string_view v) {
         return choose("filter", kFilters, v, [&](const ResampleFilter& f) { s.filter = f; });
       }},
      {"rotate", "0|90|180|270", "turn clockwise before fitting", set_rotate},
      {"background", "COLOUR", "under transparency and beside a fitted picture; default: black",
       set_background},
      {"exposure", "STOPS", "multiply light by 2^STOPS", set_exposure},
      {"tone-map", "none|" + list_names(kToneOperators, "|") + "[:WHITE]",
       "bring highlights into range; WHITE is the luminance that becomes white; default: none",
       set_tone_map},
      {"adapt", list_names(kAdaptations, "|"),
       "from the picture's white to the device's; default: bradford",
       [](Settings& s, std::string_view v) {
         return choose("adaptation", kAdaptations, v,
                       [&](const AdaptationMethod& m) { s.adaptation = m.method; });
       }},
      {"gamut-map", list_names(kGamutMethods, "|"),
       "colours outside the device's gamut; default: clip",
       [](Settings& s, std::string_view v) {
         return choose("gamut map", kGamutMethods, v, [&](const GamutMethod& m) { s.gamut = m; });
       }},
      {"black-point", list_names(kBlackPoints, "|"),
       "picture black is the device's black (relative), or no light at all (absolute); default: "
       "relative",
       [](Settings& s, std::string_view v) {
         return choose("black point", kBlackPoints, v,
                       [&](const NamedBlackPoint& p) { s.black_point = p.point; });
       }},
      {"dither", "NAME|FILE",
       "how tones between the codes are made: " + list_names(dither_methods()) +
           "; or a matrix that comes in sizes with one behind its name (magic5); or a file with "
           "your own matrix, CSV or a grey picture; default: what suits the device",
       set_dither},
      {"cells", "N|WxH", "a cell of N x N device pixels for each of the picture's; default: 1",
       set_cells},
      {"serpentine", "",
       "error diffusion turns round at every row; default: what suits the kernel, all but "
       "floyd-steinberg do; to palettes none does; rows that go one way are faster",
       [](Settings& s, std::string_view v) {
         return set_switch(v, [&](bool on) { s.dither_parameters.serpentine = on; });
       }},
      {"settled", "",
       "error diffusion begins in flat fields at the top as if they went on above, which keeps "
       "their tone; default: yes",
       [](Settings& s, std::string_view v) {
         return set_switch(v, [&](bool on) { s.dither_parameters.settled = on; });
       }},
      {"jitter", "0..1",
       "error diffusion with a threshold by chance, within so much of the step between levels: "
       "breaks worms and costs sharpness; default: 0, blue-diffusion .15",
       set_jitter},
      {"strength", "0..1", "share of the dither: 0 takes the nearest code; default: 1",
       set_strength},
      {"dither-mask", "PICTURE", "strength by pixel: black keeps the nearest code, white dithers",
       [](Settings& s, std::string_view v) -> Result {
         s.dither_mask = std::string(v);
         return {};
       }},
      {"mask-size", "N", "side of a threshold matrix that comes in sizes; default: its own",
       [](Settings& s, std::string_view v) {
         return set_count("size", v, kMostMaskSize,
                          [&](auto n) { s.dither_parameters.size = static_cast<int>(n); });
       }},
      {"seed", "N", "of dithers that leave something to chance; default: 0",
       [](Settings& s, std::string_view v) {
         return set_count("seed", v, kMostSeed, [&](auto n) {
           s.dither_parameters.seed = static_cast<std::uint64_t>(n);
         });
       }},
      {"frame", "N", "of an animation, for dithers that change with time",
       [](Settings& s, std::string_view v) {
         return set_count("frame number", v, kMostFrames,
                          [&](auto n) { s.dither_parameters.frame = static_cast<int>(n); });
       }},
      {"effort", "N", "how long dithers search that do so; default: their own",
       [](Settings& s, std::string_view v) {
         return set_count("effort", v, kMostEffort,
                          [&](auto n) { s.dither_parameters.effort = static_cast<int>(n); });
       }},
      {"palette", "device|METHOD[:N]|FILE",
       "choose N colours for the pictures by one of " + list_names(kPaletteMethods) +
           "; fixed-565 and the like have bits a channel, inks:N:#204080+black up to three inks; "
           "or "
           "take those of a palette file; default: device",
       set_palette},
      {"colors", "N", "colours of a palette that is chosen; default: as many as fit", set_colors},
      {"transparent", "N|last",
       "keep this position of a chosen palette for pixels less than half covered", set_transparent},
      {"palette-weights", list_names(kPaletteWeights, "|"),
       "what makes a colour count for a chosen palette: its pixels, or those in flat areas more; "
       "default: count",
       [](Settings& s, std::string_view v) {
         return choose("palette-weights", kPaletteWeights, v,
                       [&](const NamedPaletteWeights& w) { s.palette_weights = w.weights; });
       }},
      {"metric", list_names(kMetrics, "|"),
       "space in which the nearest colour is chosen; default: oklab, dithered oklab-toe, of a "
       "chosen palette balanced",
       [](Settings& s, std::string_view v) {
         return choose("metric", kMetrics, v, [&](const Metric& m) { s.metric = &m; });
       }},
      {"mix", list_names(kMixes, "|"), "dither in light, or in encoded numbers; default: light",
       [](Settings& s, std::string_view v) {
         return choose("mix", kMixes, v, [&](const NamedMix& m) { s.mix = m.mix; });
       }},
  };
}

}  // namespace

std::span<const Setting> settings_list() {
  static const std::vector<Setting> list = [] {
    std::vector<Setting> all = make_settings();
    for (Setting& setting : detail::screen_settings()) all.push_back(std::move(setting));
    return all;
  }();
  return list;
}

void read_pipeline_file(const std::string& path, Settings& settings) {
  const detail::TomlTable table = detail::TomlTable::parse(read_text_file(path), path);
  for (const Setting& setting : settings_list()) (void)table.has(setting.name);
  for (const std::string& key : table.keys()) {
    const Setting* setting = find_by_name(settings_list(), key);
    if (setting == nullptr) continue;  // finish() tells its place
    if (const auto refusal = setting->set(settings, table.scalar_text(key))) {
      table.fail(key, refusal->wrong, refusal->remedy);
    }
  }
  table.finish();
}

}  // namespace tristim
