#include <array>

#include "lib/render/io/read_scene.h"
#include "tristim/light/metals.h"

namespace tristim::detail {
namespace {

// Wavelengths that stand for the three primaries where a spectrum has to be one number for each.
constexpr std::array<double, 3> kPrimaries_nm{610, 550, 465};

struct TransparencyKind {
  std::string_view name;
  Transparency kind;
};
constexpr std::array kTransparencies{TransparencyKind{"none", Transparency::kNone},
                                     TransparencyKind{"interpolated", Transparency::kInterpolated},
                                     TransparencyKind{"filtered", Transparency::kFiltered}};

double part(const TomlTable& table, std::string_view key, double fallback) {
  return number_in(table, key, fallback, 0, 1e6, "of 0 or more");
}

// One number for all, or one for each of red, green and blue.
std::array<double, 3> three(const TomlTable& table, std::string_view key, double fallback,
                            double least) {
  std::array<double, 3> values{fallback, fallback, fallback};
  if (table.is_array(key)) {
    const Eigen::Vector3d v = read_vector(table, key, {});
    values = {v.x(), v.y(), v.z()};
  } else if (const auto value = table.number(key)) {
    values = {*value, *value, *value};
  }
  for (const double value : values) {
    if (value < least || value > 100) {
      table.fail(key, std::string(key) + " is out of range",
                 least > 0 ? "give an index from 0.1 to 100" : "give a number from 0 to 100");
    }
  }
  return values;
}

// Where one of the two colours is a spectrum the other has to be one as well; that of a grey is
// even.
SpectralColor spectrum_of(const TomlTable& table, std::string_view key, const SceneColor& color) {
  if (color.spectrum) return *color.spectrum;
  if (color.rgb.r == color.rgb.g && color.rgb.g == color.rgb.b) return flat_spectrum(color.rgb.r);
  table.fail(key, "one of od and os is a spectrum, the other is not",
             "give both as spectra, or one as a grey");
}

void read_metal(const TomlTable& table, RoughSurface& rough) {
  for (const std::string_view other : {"eta", "k"}) {
    if (table.has(other)) {
      table.fail(other, "both metal and " + std::string(other) + " are given", "give one of them");
    }
  }
  const Metal metal = choice(table, "metal", metals(), metals()[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    rough.reflectors[i] = conductor_at(metal, kPrimaries_nm[i]);
  }
  std::array<Reflector, kSpectralSamples>& spectral = rough.spectral.emplace();
  for (std::size_t i = 0; i < kSpectralSamples; ++i) {
    spectral[i] = conductor_at(metal, sample_nm(i));
  }
}

RoughSurface read_rough(const TomlTable& table) {
  RoughSurface rough;
  rough.facets.m = number_in(table, "m", rough.facets.m, 0.001, 10, "from 0.001 to 10");
  rough.facets.distribution =
      choice(table, "distribution", kMicrofacetDistributions, rough.facets.distribution);
  rough.facets.normalization =
      choice(table, "normalization", kMicrofacetNormalizations, rough.facets.normalization);
  if (table.has("metal")) {
    read_metal(table, rough);
    return rough;
  }
  const bool conductor = table.has("k");
  const std::array<double, 3> eta = three(table, "eta", conductor ? 1 : 1.5, conductor ? 0 : 0.1);
  const std::array<double, 3> k = three(table, "k", 0, 0);
  for (std::size_t i = 0; i < 3; ++i) {
    rough.reflectors[i] =
        conductor ? Reflector(Conductor{eta[i], k[i]}) : Reflector(Dielectric{1, eta[i]});
  }
  return rough;
}

void read_transparency(const TomlTable& table, const SceneContext& context,
                       SceneMaterial& material) {
  const TransparencyKind preset = kTransparencies[table.has("kt") ? 1 : 0];
  material.transparency = choice(table, "transparency", kTransparencies, preset).kind;
  material.transparent.kt = number_in(table, "kt", 0, 0, 1, "from 0 to 1");
  material.transparent.tint = read_color(table, "ot", context, {1, 1, 1}).rgb;
}

SceneMaterial read_material(const TomlTable& table, const SceneContext& context) {
  SceneMaterial material;
  material.name = table.string("name").value_or("");
  material.model = choice(table, "model", kReflectionModels, kReflectionModels[0]);
  material.surface.kd = part(table, "kd", 0.8);
  material.surface.ka = part(table, "ka", material.surface.kd);
  material.surface.ks = part(table, "ks", 0);
  material.surface.n = number_in(table, "n", 20, 0, 1e6, "of 0 or more");
  const SceneColor od = read_color(table, "od", context, {1, 1, 1});
  const SceneColor os = read_color(table, "os", context, {1, 1, 1});
  material.surface.od = od.rgb;
  material.surface.os = os.rgb;
  if (od.spectrum || os.spectrum) {
    material.spectral = SpectralSurface{spectrum_of(table, "od", od), spectrum_of(table, "os", os)};
  }
  material.rough = read_rough(table);
  material.gooch.warm = read_color(table, "warm", context, material.gooch.warm).rgb;
  material.gooch.cool = read_color(table, "cool", context, material.gooch.cool).rgb;
  read_transparency(table, context, material);
  material.two_sided = table.boolean("two_sided").value_or(false);
  table.finish();
  return material;
}

}  // namespace

std::vector<SceneMaterial> read_materials(const TomlTable& root, const SceneContext& context) {
  std::vector<SceneMaterial> materials;
  for (const TomlTable& table : root.tables("material")) {
    SceneMaterial material = read_material(table, context);
    if (material.name.empty()) {
      table.fail("name", "the name of the material is missing", "objects name their material");
    }
    if (find_by_name(materials, material.name) != nullptr) {
      table.fail("name", "there is a material '" + material.name + "' already",
                 "give each its own name");
    }
    materials.push_back(std::move(material));
  }
  return materials;
}

}  // namespace tristim::detail
