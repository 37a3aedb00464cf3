#include <array>

#include "lib/render/io/read_scene.h"
#include "tristim/light/vector.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

constexpr double kLongest = 1e12;

struct Fixture {
  std::string_view name;
  bool with_camera;
};
constexpr std::array kFixtures{Fixture{"world", false}, Fixture{"camera", true}};

Attenuation read_attenuation(const TomlTable& table, std::string_view preset) {
  Attenuation attenuation;
  attenuation.kind =
      choice(table, "attenuation", kAttenuations, *find_by_name(kAttenuations, preset));
  const auto coefficient = [&](std::string_view key, double fallback) {
    return number_in(table, key, fallback, 0, kLongest, "of 0 or more");
  };
  attenuation.c1 = coefficient("c1", 1);
  attenuation.c2 = coefficient("c2", 0);
  attenuation.c3 = coefficient("c3", 0);
  return attenuation;
}

using Source = decltype(SceneLight::source);

Source directional(const TomlTable& table, const Rgb& intensity) {
  return DirectionalLight{read_direction(table, "to_light", {0, 0, 1}), intensity};
}

Source point(const TomlTable& table, const Rgb& intensity) {
  return PointLight{read_vector(table, "position", {0, 0, 0}), intensity,
                    read_attenuation(table, "none")};
}

Source spot(const TomlTable& table, const Rgb& intensity) {
  SpotLight light{.position = read_vector(table, "position", {0, 0, 0}), .intensity = intensity};
  if (table.has("target")) {
    light.direction = read_vector(table, "target", {0, 0, 0}) - light.position;
    if (light.direction == Vector3d(0, 0, 0)) {
      table.fail("target", "target is the position", "give another place, or direction");
    }
    if (table.has("direction")) table.fail("target", "both target and direction are given");
  } else {
    light.direction = read_direction(table, "direction", {0, 0, -1});
  }
  light.cutoff_deg = number_in(table, "cutoff_deg", 30, 0, 180, "from 0 to 180");
  light.exponent = number_in(table, "exponent", 0, 0, 1e6, "of 0 or more");
  light.attenuation = read_attenuation(table, "none");
  return light;
}

Source area(const TomlTable& table, const Rgb& intensity) {
  PolygonLight light{.polygon = {}, .intensity = intensity};
  const auto rows = table.rows("polygon");
  if (!rows) table.fail("polygon", "polygon is missing", "give [[x, y, z], ...]");
  for (const std::vector<double>& row : *rows) {
    if (row.size() != 3) table.fail("polygon", "a corner has not 3 numbers", "give [x, y, z]");
    light.polygon.emplace_back(row[0], row[1], row[2]);
  }
  if (unit_newell_normal(light.polygon) == Vector3d(0, 0, 0)) {
    table.fail("polygon", "the polygon has no area", "give 3 corners or more, not on a line");
  }
  (void)table.integer("samples");  // a fraction is no number of samples
  light.samples = static_cast<int>(number_in(table, "samples", 8, 1, 64, "from 1 to 64"));
  return light;
}

struct LightKind {
  std::string_view name;
  Source (*read)(const TomlTable& table, const Rgb& intensity);
};
constexpr std::array kLightKinds{LightKind{"directional", directional}, LightKind{"point", point},
                                 LightKind{"spot", spot}, LightKind{"area", area}};

SceneLight read_light(const TomlTable& table, const SceneContext& context) {
  const auto kind_name = table.string("kind");
  if (!kind_name) {
    table.fail("kind", "the kind of the light is missing",
               "give one of: " + list_names(kLightKinds));
  }
  const LightKind kind = choice(table, "kind", kLightKinds, kLightKinds[0]);
  const SceneColor color = read_color(table, "intensity", context, {1, 1, 1});
  SceneLight light;
  light.name = table.string("name").value_or("");
  light.source = kind.read(table, color.rgb);
  light.spectrum = color.spectrum;
  light.with_camera = choice(table, "fixed_to", kFixtures, kFixtures[0]).with_camera;
  table.finish();
  return light;
}

}  // namespace

std::vector<SceneLight> read_lights(const TomlTable& root, const SceneContext& context) {
  std::vector<SceneLight> lights;
  for (const TomlTable& table : root.tables("light")) {
    SceneLight light = read_light(table, context);
    if (light.name.empty()) light.name = "light" + std::to_string(lights.size() + 1);
    if (find_by_name(lights, light.name) != nullptr) {
      table.fail("name", "there is a light '" + light.name + "' already", "give each its own name");
    }
    lights.push_back(std::move(light));
  }
  return lights;
}

}  // namespace tristim::detail
