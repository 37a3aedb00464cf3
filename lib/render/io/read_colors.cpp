#include <algorithm>

#include "lib/light/product.h"
#include "lib/render/io/read_scene.h"
#include "tristim/color/adaptation.h"
#include "tristim/color/illuminant.h"
#include "tristim/color/parse.h"
#include "tristim/color/primaries.h"
#include "tristim/color/spectrum_text.h"
#include "tristim/color/transfer.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/text.h"
#include "tristim/light/spectral.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

// Of the display's primaries, its white being the scene's.
Rgb rgb_of(const SpectralColor& light, const SpectralColor& white) {
  const Xyz xyz = xyz_of_samples(light, white);
  const Xyz of_white = xyz_of_samples(white, white);
  const double sum = of_white.x + of_white.y + of_white.z;
  const Chromaticity from{of_white.x / sum, of_white.y / sum};
  const Vector3d rgb =
      rgb_from_xyz(Primaries{}) *
      (adaptation_matrix(from, kD65, Adaptation::kBradford) * Vector3d(xyz.x, xyz.y, xyz.z));
  return {rgb.x(), rgb.y(), rgb.z()};
}

SceneColor light_of(const SpectralColor& power, double scale, const SceneContext& context) {
  const double luminance = xyz_of_samples(power, context.white).y;
  const SpectralColor spectrum = product(luminance > 0 ? scale / luminance : 0, power);
  return {rgb_of(spectrum, context.white), spectrum};
}

SceneColor reflectance_of(const SpectralColor& reflectance, const SceneContext& context) {
  return {rgb_of(product(reflectance, context.white), context.white), reflectance};
}

SpectralColor samples_of(const Spectrum& spectrum) {
  const std::vector<double> values = sampled(spectrum, kSum5nm);
  SpectralColor samples;
  std::copy(values.begin(), values.end(), samples.at.begin());
  return samples;
}

bool names_light(std::string_view text) {
  return names_thermal_light(text) || find_by_name(illuminants(), text) != nullptr;
}

SpectralColor illuminant_at(const TomlTable& table, std::string_view key) {
  const std::string name = *table.string(key);
  try {
    return samples_of(parse_illuminant(name, key).spectrum);
  } catch (const Error&) {
    table.fail(key, "unknown illuminant '" + name + "'", name_hint(illuminants(), name));
  }
}

Rgb named_color(const TomlTable& table, std::string_view key) {
  const std::string text = *table.string(key);
  const auto color = parse_color(text);
  if (!color) table.fail(key, "'" + text + "' is no colour", color_hint(text));
  return {srgb_decode(color->r), srgb_decode(color->g), srgb_decode(color->b)};
}

SpectralColor shaped_reflectance(const TomlTable& table) {
  const ReflectanceShape shape =
      choice(table, "reflectance", kReflectanceShapes, kReflectanceShapes[0]);
  const double lo = number_in(table, "lo", 0, 0, 1, "from 0 to 1");
  const double hi = number_in(table, "hi", 1, 0, 1, "from 0 to 1");
  const double mu = number_in(table, "mu", 560, 1, 1e4, "in nm");
  const double mu2 = shape.two_peaks ? number_in(table, "mu2", mu, 1, 1e4, "in nm") : mu;
  const double sd = number_in(table, "sd", 40, kTiny, 1e4, "of nm above 0");
  SpectralColor reflectance;
  for (std::size_t i = 0; i < kSpectralSamples; ++i) {
    reflectance.at[i] = shape.at(sample_nm(i), lo, hi, mu, mu2, sd);
  }
  return reflectance;
}

SpectralColor spectrum_file(const TomlTable& table, const SceneContext& context) {
  const std::string path = path_beside(context.directory, *table.string("file"));
  const std::vector<NamedSpectrum> spectra = parse_spectra(read_text_file(path), path);
  const auto column = table.integer("column").value_or(1);
  if (column < 1 || column > static_cast<std::int64_t>(spectra.size())) {
    table.fail("column", "column " + std::to_string(column) + " is not there",
               "the file has 1 to " + std::to_string(spectra.size()));
  }
  return samples_of(spectra[static_cast<std::size_t>(column - 1)].spectrum);
}

SceneColor described_color(const TomlTable& table, const SceneContext& context) {
  SceneColor color;
  const bool scaled = table.has("scale");
  const double scale = number_in(table, "scale", 1, 0, 1e12, "of 0 or more");
  if (table.has("illuminant")) {
    if (!table.is_string("illuminant")) table.fail("illuminant", "'illuminant' must be a string");
    color = light_of(illuminant_at(table, "illuminant"), scale, context);
  } else if (table.has("reflectance")) {
    color = reflectance_of(product(scale, shaped_reflectance(table)), context);
  } else if (table.has("file")) {
    const bool light = table.string("kind").value_or("reflectance") == "light";
    if (!light && table.string("kind").value_or("reflectance") != "reflectance") {
      table.fail("kind", "unknown kind", "use one of: light, reflectance");
    }
    const SpectralColor samples = spectrum_file(table, context);
    color = light ? light_of(samples, scale, context)
                  : reflectance_of(product(scale, samples), context);
  } else if (table.has("color")) {
    color = read_color(table, "color", context, {});
    color.rgb = product(scale, color.rgb);
    if (color.spectrum) color.spectrum = product(scale, *color.spectrum);
  } else {
    table.fail(scaled ? "scale" : "", "the colour is missing",
               "give one of color, illuminant, reflectance, file");
  }
  table.finish();
  return color;
}

}  // namespace

SceneColor read_color(const TomlTable& table, std::string_view key, const SceneContext& context,
                      const Rgb& fallback) {
  if (!table.has(key)) return {fallback, {}};
  if (table.is_number(key)) {
    const double grey = *table.number(key);
    return {{grey, grey, grey}, {}};
  }
  if (table.is_string(key)) {
    if (names_light(*table.string(key))) return light_of(illuminant_at(table, key), 1, context);
    return {named_color(table, key), {}};
  }
  if (table.is_array(key)) {
    const Vector3d rgb = read_vector(table, key, {0, 0, 0});
    return {{rgb.x(), rgb.y(), rgb.z()}, {}};
  }
  return described_color(*table.table(key), context);
}

Vector3d read_vector(const TomlTable& table, std::string_view key, const Vector3d& fallback) {
  const auto numbers = table.numbers(key);
  if (!numbers) return fallback;
  if (numbers->size() != 3) {
    table.fail(key, std::string(key) + " has " + std::to_string(numbers->size()) + " numbers",
               "give 3");
  }
  return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

Vector3d read_direction(const TomlTable& table, std::string_view key, const Vector3d& fallback) {
  const Vector3d direction = read_vector(table, key, fallback);
  if (direction == Vector3d(0, 0, 0)) {
    table.fail(key, std::string(key) + " has no direction", "give numbers that are not all 0");
  }
  return direction;
}

}  // namespace tristim::detail
