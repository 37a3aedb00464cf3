#include "lib/color/light_edges.h"

#include "tristim/color/cct.h"
#include "tristim/color/illuminant.h"
#include "tristim/color/wavelength.h"

namespace tristim::detail {

Components xyy_to_cct_edge(const Components& c, const ModelContext& context) {
  const ColorTemperature t = color_temperature({c[0], c[1]}, context.parameters[0]);
  return {t.temperature_k, t.duv, c[2]};
}

Components cct_to_xyy_edge(const Components& c, const ModelContext& context) {
  const Chromaticity xy = chromaticity_of({c[0], c[1]}, context.parameters[0]);
  return {xy.x, xy.y, c[2]};
}

Components planckian_to_xyy_edge(const Components& c, const ModelContext& context) {
  const Chromaticity xy = planckian_chromaticity(c[0], context.parameters[0]);
  return {xy.x, xy.y, 1};
}

Components daylight_to_xyy_edge(const Components& c, const ModelContext& /*context*/) {
  const Chromaticity xy = daylight_chromaticity(c[0]);
  return {xy.x, xy.y, 1};
}

Components xyy_to_wavelength_edge(const Components& c, const ModelContext& context) {
  const DominantWavelength d = dominant_wavelength({c[0], c[1]}, context.white);
  return {d.dominant_nm, d.complementary_nm, d.excitation_purity, d.colorimetric_purity};
}

Components xyy_to_helmholtz_edge(const Components& c, const ModelContext& context) {
  const DominantWavelength d = dominant_wavelength({c[0], c[1]}, context.white);
  return {d.dominant_nm, d.excitation_purity, c[2]};
}

Components helmholtz_to_xyy_edge(const Components& c, const ModelContext& context) {
  const Chromaticity xy = chromaticity_of_wavelength(c[0], c[1], context.white);
  return {xy.x, xy.y, c[2]};
}

}  // namespace tristim::detail
