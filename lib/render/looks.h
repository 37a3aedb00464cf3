#pragma once

#include <vector>

#include "lib/render/fresnel_table.h"
#include "tristim/light/rows.h"
#include "tristim/render/scene.h"

namespace tristim::detail {

/// The colours of a material under the lights of a scene, multiplied once for all samples: with
/// spectra, 81 products for each pair, so that spectral light costs what RGB does [Shoaff 3.7].
struct MaterialLook {
  Rgb ambient = {};                           // ka Ia Od
  Rgb albedo = {};                            // kd Od
  Rgb flat = {};                              // Od
  std::vector<RowLightColors> lights = {};    // of each light of the scene
  std::vector<FresnelTable> highlights = {};  // likewise, where Fresnel's term has a colour
};

/// Microfacets that the rows of rows.h have, with F: Beckmann's, normalised, of one index in every
/// colour. nullptr for others.
const Dielectric* row_dielectric(const SceneMaterial& material);

/// Where a light and a surface both have spectra their product is summed up; where only one has, it
/// counts as the RGB that it has by itself, a surface under D65.
std::vector<MaterialLook> looks_of(const Scene& scene);

}  // namespace tristim::detail
