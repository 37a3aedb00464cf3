#include "tools/lut_source.h"

#include <functional>

#include "tools/lut.h"
#include "tristim/color/conversion.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"
#include "tristim/lut/io/ocio.h"
#include "tristim/pipeline/color_chain.h"

namespace tristim::tools {
namespace {

constexpr std::string_view kLutSettings[] = {"exposure", "tone-map", "adapt", "gamut-map",
                                             "black-point"};

using Map = std::function<Rgb(Rgb)>;

Map chained(Map first, Map second) {
  return [first = std::move(first), second = std::move(second)](Rgb c) { return second(first(c)); };
}

Map conversion_map(std::shared_ptr<const ColorConversion> conversion) {
  return [conversion = std::move(conversion)](Rgb c) {
    const Components out = (*conversion)({c.r, c.g, c.b, 0});
    return Rgb{out[0], out[1], out[2]};
  };
}

ModelReference three_components(const std::string& text, std::string_view option) {
  ModelReference model = parse_model(text, option);
  if (component_count(*model.model) == 3 && model.model->to_text == nullptr) return model;
  throw Error(ErrorKind::kMisuse, option, "'" + text + "' has not three components",
              "give a model such as rgb:srgb");
}

ModelReference linear_light(const Primaries& primaries) {
  ModelReference light = parse_model("linear", "--from");
  light.primaries = primaries;
  light.white = primaries.white;
  return light;
}

void add_steps(const ColorConversion& conversion, std::vector<StepReport>& steps) {
  for (const std::string& step : conversion.explain()) steps.push_back({step, "", "", {}});
}

// What comes in, as light of the primaries.
struct Entrance {
  Map light;
  Primaries primaries;
};

Entrance from_device(const std::string& name, const Settings& settings,
                     std::vector<StepReport>& steps) {
  const Display device = load_display(name);
  const DisplayDrive drive(device, settings.black_point);
  steps.push_back({"codes of " + device.name, describe(device.response), "", {}});
  return {[drive](Rgb c) { return drive.picture({c.r, c.g, c.b}); }, device.primaries};
}

Entrance from_model(const std::string& text, const Settings& settings,
                    std::vector<StepReport>& steps) {
  const ModelReference model = three_components(text.empty() ? "linear" : text, "--from");
  const Primaries primaries = model.primaries.value_or(Primaries{});
  const auto conversion =
      std::make_shared<const ColorConversion>(model, linear_light(primaries), settings.adaptation);
  add_steps(*conversion, steps);
  return {conversion_map(conversion), primaries};
}

LutSource to_device(const Entrance& entrance, const std::string& name, const Settings& settings,
                    std::vector<StepReport> steps) {
  const Display device = load_display(name);
  const auto chain = std::make_shared<const ColorChain>(entrance.primaries, device, settings);
  for (const Stage& stage : chain->stages()) steps.push_back(explain(stage));
  steps.push_back({"codes of " + device.name, describe(device.response), "", {}});
  const Map out = [chain](Rgb light) {
    const EncodedRgb codes = (*chain)(light);
    return Rgb{codes.r, codes.g, codes.b};
  };
  const Look look = [chain](Rgb codes) { return chain->appearance({codes.r, codes.g, codes.b}); };
  return {std::make_unique<CallableSource<Map, Look>>(chained(entrance.light, out), look),
          std::move(steps)};
}

// Exposure and tone map, which do not ask for a device.
Map scene_map(const Primaries& primaries, const Settings& settings,
              std::vector<StepReport>& steps) {
  PictureInfo info;
  info.primaries = primaries;
  StageList list = stage_list(info, Display{}, settings);
  list.stages.resize(static_cast<std::size_t>(list.scene_stages), Stage{});
  for (const Stage& stage : list.stages) steps.push_back(explain(stage));
  return [stages = std::move(list.stages)](Rgb light) {
    for (const Stage& stage : stages) light = apply(stage, light);
    return light;
  };
}

LutSource to_model(const Entrance& entrance, const std::string& text, const Settings& settings,
                   std::vector<StepReport> steps) {
  const Map scene = scene_map(entrance.primaries, settings, steps);
  const auto conversion = std::make_shared<const ColorConversion>(
      linear_light(entrance.primaries), three_components(text, "--to"), settings.adaptation);
  add_steps(*conversion, steps);
  const auto lab = std::make_shared<const ColorConversion>(
      conversion->to_reference(), parse_model("lab", "--to"), Adaptation::kBradford);
  const Look look = [lab](Rgb c) {
    const Components out = (*lab)({c.r, c.g, c.b, 0});
    return Lab{out[0], out[1], out[2]};
  };
  const Map map = chained(chained(entrance.light, scene), conversion_map(conversion));
  return {std::make_unique<CallableSource<Map, Look>>(map, look), std::move(steps)};
}

// What an OpenColorIO config makes of colours, in its floats.
class OcioSource final : public BakeSource {
 public:
  OcioSource(OcioTransform transform, Look look)
      : transform_(std::move(transform)), look_(std::move(look)) {}

  void apply(std::span<Rgb> colors) const override {
    std::vector<float> floats;
    for (const Rgb& c : colors) {
      for (const double x : {c.r, c.g, c.b}) floats.push_back(static_cast<float>(x));
    }
    transform_.apply(floats);
    for (std::size_t i = 0; i < colors.size(); ++i) {
      colors[i] = {floats[3 * i], floats[3 * i + 1], floats[3 * i + 2]};
    }
  }
  Lab appearance(Rgb result) const override { return look_(result); }

 private:
  OcioTransform transform_;
  Look look_;
};

LutSource through_ocio(const LutWay& way) {
  OcioTransform transform = open_ocio_transform({.config = way.ocio,
                                                 .from = way.from_space,
                                                 .to = way.to_space,
                                                 .display = way.display,
                                                 .view = way.view});
  const std::string to =
      way.to_space.empty() ? "display " + way.display + ", view " + way.view : way.to_space;
  std::vector<StepReport> steps{
      {"OpenColorIO config " + way.ocio,
       "",
       "",
       {{"from", way.from_space.empty() ? "scene_linear" : way.from_space}, {"to", to}}}};
  return {std::make_unique<OcioSource>(std::move(transform), look_of(way.look, "--look")),
          std::move(steps)};
}

void check(const LutWay& way, const std::vector<GivenSetting>& given) {
  const int ends = int{!way.to.empty()} + int{!way.device.empty()} + int{!way.ocio.empty()};
  if (ends != 1) {
    throw Error(ErrorKind::kMisuse, "lut bake",
                ends == 0 ? "where the table leads to is missing"
                          : "--device, --to and --ocio are given together",
                "give one of --device D, --to MODEL, --ocio CONFIG");
  }
  if (!way.from.empty() && !way.from_device.empty()) {
    throw Error(ErrorKind::kMisuse, "--from-device", "does not go with --from", "give one of them");
  }
  const bool spaces = !(way.from_space + way.to_space + way.display + way.view).empty();
  if (way.ocio.empty() && spaces) {
    throw Error(ErrorKind::kMisuse, "--from-space, --to-space, --display, --view",
                "are of an OpenColorIO config", "give --ocio CONFIG with them");
  }
  if (!way.ocio.empty() && (!(way.from + way.from_device).empty() || !given.empty())) {
    throw Error(ErrorKind::kMisuse, "--ocio",
                "takes no --from and no settings: the config has them",
                "give --from-space, and --to-space or --display and --view");
  }
  for (const GivenSetting& one : given) {
    const bool of_device = one.setting->name == "gamut-map" || one.setting->name == "black-point";
    if (!of_device || !way.device.empty() ||
        (one.setting->name == "black-point" && !way.from_device.empty())) {
      continue;
    }
    throw Error(ErrorKind::kMisuse, "--" + std::string(one.setting->name), "is of devices",
                "give --device D instead of --to");
  }
}

}  // namespace

void declare_lut_way(CommandLine& line, LutWay& way) {
  line.option("-d,--device", "D",
              "to the codes of a device: one of `tristim device list`, or a file", way.device);
  line.option("--to", "MODEL", "to a colour model, as `tristim convert` takes them: rgb:bt2020/pq",
              way.to);
  line.option("--from", "MODEL", "from a colour model; default: linear, light of sRGB's primaries",
              way.from);
  line.option("--from-device", "D", "from the codes of a device", way.from_device);
  line.option("--ocio", "CONFIG", "the way through an OpenColorIO config", way.ocio);
  line.option("--from-space", "S", "a colour space of the config; default: scene_linear",
              way.from_space);
  line.option("--to-space", "S", "a colour space of the config", way.to_space);
  line.option("--display", "NAME", "a display of the config; default: its own", way.display);
  line.option("--view", "NAME", "a view of the display; default: its first", way.view);
  line.option("--look", "MODEL", "what the config's results are, for errors; default: rgb:srgb",
              way.look);
}

void declare_lut_settings(CommandLine& line, std::vector<GivenSetting>& given) {
  line.section("Settings, as those of process");
  declare_settings(line, given, kLutSettings);
}

LutSource make_lut_source(const LutWay& way, const std::vector<GivenSetting>& given) {
  check(way, given);
  if (!way.ocio.empty()) return through_ocio(way);
  Settings settings;
  apply_settings(settings, given);
  std::vector<StepReport> steps;
  const Entrance entrance = way.from_device.empty() ? from_model(way.from, settings, steps)
                                                    : from_device(way.from_device, settings, steps);
  if (way.to.empty()) return to_device(entrance, way.device, settings, std::move(steps));
  return to_model(entrance, way.to, settings, std::move(steps));
}

}  // namespace tristim::tools
