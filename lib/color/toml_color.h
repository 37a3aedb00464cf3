#pragma once

#include <optional>

#include "lib/core/toml.h"
#include "tristim/color/adaptation.h"
#include "tristim/color/primaries.h"
#include "tristim/color/rgb.h"
#include "tristim/color/xyz.h"

namespace tristim::detail {

/// The white at `key` of a table: a name of kWhitePoints, or [x, y].
Chromaticity read_white_point(const TomlTable& table, std::string_view key);

/// The chromaticity at `key`, [x, y] with y other than 0.
Chromaticity read_chromaticity(const TomlTable& table, std::string_view key);

/// The encoded sRGB at the key rgb: integers 0..255 or numbers 0.0..1.0.
EncodedRgb read_rgb(const TomlTable& entry);

/// What an entry of a palette looks like under the white that it is seen under: exactly one of the
/// keys lab, xyz and rgb says so. `white`: none given, which lab needs and which else is D65.
Xyz read_appearance(const TomlTable& entry, std::optional<Chromaticity> white,
                    Adaptation adaptation);

}  // namespace tristim::detail
