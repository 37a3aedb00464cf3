#pragma once

#include "tristim/color/models.h"

namespace tristim::detail {

// Edges between xyY and the models of light: temperatures and wavelengths.

/// "T Duv Y" and "T", with c2 the first parameter.
Components xyy_to_cct_edge(const Components& c, const ModelContext& context);
Components cct_to_xyy_edge(const Components& c, const ModelContext& context);
Components planckian_to_xyy_edge(const Components& c, const ModelContext& context);

/// "T" of CIE daylight.
Components daylight_to_xyy_edge(const Components& c, const ModelContext& context);

/// "lambda_d lambda_c p_e p_c" and "lambda_d p_e Y", seen from the context's white.
Components xyy_to_wavelength_edge(const Components& c, const ModelContext& context);
Components xyy_to_helmholtz_edge(const Components& c, const ModelContext& context);
Components helmholtz_to_xyy_edge(const Components& c, const ModelContext& context);

}  // namespace tristim::detail
