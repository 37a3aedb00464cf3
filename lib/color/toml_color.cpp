#include "lib/color/toml_color.h"

#include <algorithm>
#include <vector>

#include "tristim/color/lab.h"
#include "tristim/color/transfer.h"
#include "tristim/core/find.h"

namespace tristim::detail {
Chromaticity read_chromaticity(const TomlTable& table, std::string_view key) {
  const auto xy = table.numbers(key);
  if (!xy) table.fail(key, std::string(key) + " is missing", "give it as [x, y]");
  if (xy->size() != 2 || !((*xy)[1] != 0)) {
    table.fail(key, std::string(key) + " is no chromaticity", "give [x, y] with y other than 0");
  }
  return {(*xy)[0], (*xy)[1]};
}

Chromaticity read_white_point(const TomlTable& table, std::string_view key) {
  if (table.is_array(key)) return read_chromaticity(table, key);
  const auto name = table.string(key);
  if (!name) return kWhitePoints[0].chromaticity;
  if (const auto* white = find_by_name(kWhitePoints, *name)) return white->chromaticity;
  table.fail(key, "unknown " + std::string(key) + " '" + *name + "'",
             name_hint(kWhitePoints, *name));
}

EncodedRgb read_rgb(const TomlTable& table) {
  const auto rgb = table.numbers("rgb");
  if (!rgb || rgb->size() != 3) table.fail("rgb", "rgb must have three numbers");
  const double scale = table.all_integers("rgb") ? 255 : 1;
  for (const double c : *rgb) {
    if (c < 0 || c > scale) {
      table.fail("rgb", "rgb is out of range",
                 "give encoded sRGB as integers 0..255 or as numbers 0.0..1.0");
    }
  }
  return {(*rgb)[0] / scale, (*rgb)[1] / scale, (*rgb)[2] / scale};
}

Xyz read_appearance(const TomlTable& table, std::optional<Chromaticity> white,
                    Adaptation adaptation) {
  const auto lab = table.numbers("lab");
  const auto xyz = table.numbers("xyz");
  const auto rgb = table.numbers("rgb");
  if (int(lab.has_value()) + int(xyz.has_value()) + int(rgb.has_value()) != 1) {
    table.fail("", "a palette entry must say once what it looks like",
               "give one of lab, xyz and rgb");
  }
  const auto& values = lab ? *lab : xyz ? *xyz : *rgb;
  const std::string_view key = lab ? "lab" : xyz ? "xyz" : "rgb";
  if (values.size() != 3) table.fail(key, std::string(key) + " must have three numbers");
  if (rgb) {
    const EncodedRgb c = read_rgb(table);
    const Eigen::Vector3d light(srgb_decode(c.r), srgb_decode(c.g), srgb_decode(c.b));
    const Eigen::Vector3d d65 = xyz_from_rgb(Primaries{}) * light;
    const Eigen::Vector3d seen = adaptation_matrix(kD65, white.value_or(kD65), adaptation) * d65;
    return {seen.x(), seen.y(), seen.z()};
  }
  if (xyz) {
    if (*std::min_element(xyz->begin(), xyz->end()) < 0) table.fail("xyz", "xyz is negative");
    return {values[0], values[1], values[2]};
  }
  if (!white) {
    table.fail("lab", "lab needs the white that it was measured under",
               "add [viewing] white = \"D50\"");
  }
  return lab_to_xyz({values[0], values[1], values[2]}, white_xyz(*white));
}

}  // namespace tristim::detail
