#include "tools/convert_gamut.h"

#include <string>

#include "tristim/core/error.h"
#include "tristim/core/find.h"

namespace tristim::tools {
namespace {

// Linear RGB of the primaries that the conversion ends in.
ModelReference light_of(const ColorConversion& conversion) {
  ModelReference light = conversion.to_reference();
  if (!takes_primaries(*light.model)) {
    throw Error(ErrorKind::kMisuse, "--gamut-map",
                "'" + std::string(light.model->name) + "' has no gamut",
                "give --to a model of RGB, such as rgb:srgb, linear:bt2020 or hsv:display-p3");
  }
  light.model = find_by_name(color_models(), "linear");
  light.parameters = {};
  return light;
}

}  // namespace

GamutMapping::GamutMapping(const ModelReference& from, const ColorConversion& conversion,
                           Adaptation adaptation, const GamutMethod& method)
    : to_light_(from, light_of(conversion), adaptation),
      from_light_(light_of(conversion), conversion.to_reference(), Adaptation::kNone),
      method_(method),
      space_(gamut_space(light_of(conversion).primaries.value_or(Primaries{}))) {}

std::optional<Components> GamutMapping::operator()(const Components& light) const {
  const Rgb rgb{light[0], light[1], light[2]};
  if (method_.keeps_inside && in_gamut(rgb)) return std::nullopt;
  const Rgb mapped = method_.map(rgb, space_);
  if (mapped == rgb || !in_gamut(mapped)) return std::nullopt;
  return Components{mapped.r, mapped.g, mapped.b};
}

}  // namespace tristim::tools
