#include "tristim/color/models.h"

#include <limits>

#include "tristim/color/lab.h"
#include "tristim/color/oklab.h"
#include "tristim/color/transfer.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

Components list(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Vector3d vector(const Components& c) { return {c[0], c[1], c[2]}; }
Eigen::Vector3d vector(const Xyz& c) { return {c.x, c.y, c.z}; }
Xyz xyz(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Xyz linear_to_xyz(const Components& c, const ModelContext& context) {
  return xyz(xyz_from_rgb(context.primaries) * vector(c));
}
Components xyz_to_linear(Xyz c, const ModelContext& context) {
  return list(rgb_from_xyz(context.primaries) * vector(c));
}

// The curve that encodes an RGB model: that of the set where it is a pure exponent, else the sRGB
// curve.
double set_gamma(const Primaries& primaries) {
  for (const NamedPrimaries& set : primaries_list()) {
    if (set.primaries == primaries && set.transfer == "gamma 563/256") return 563.0 / 256;
    if (set.primaries == primaries && set.transfer.starts_with("gamma ")) {
      return parse_number(set.transfer.substr(6)).value_or(0);
    }
  }
  return 0;
}

double decode(double e, double gamma) {
  return gamma > 0 ? gamma_decode(e, gamma) : srgb_decode(e);
}
double encode(double x, double gamma) {
  return gamma > 0 ? gamma_encode(x, gamma) : srgb_encode(x);
}

Xyz rgb_to_xyz(const Components& c, const ModelContext& context) {
  const double gamma = set_gamma(context.primaries);
  return linear_to_xyz({decode(c[0], gamma), decode(c[1], gamma), decode(c[2], gamma)}, context);
}
Components xyz_to_rgb(Xyz c, const ModelContext& context) {
  const double gamma = set_gamma(context.primaries);
  const Components light = xyz_to_linear(c, context);
  return {encode(light[0], gamma), encode(light[1], gamma), encode(light[2], gamma)};
}

Xyz lab_model_to_xyz(const Components& c, const ModelContext& context) {
  return lab_to_xyz({c[0], c[1], c[2]}, white_xyz(context.white));
}
Components xyz_to_lab_model(Xyz c, const ModelContext& context) {
  const Lab lab = xyz_to_lab(c, white_xyz(context.white));
  return {lab.l, lab.a, lab.b};
}

Xyz xyy_model_to_xyz(const Components& c, const ModelContext&) {
  return xyy_to_xyz({c[0], c[1], c[2]});
}
Components xyz_to_xyy_model(Xyz c, const ModelContext&) {
  const Xyy xyy = xyz_to_xyy(c);
  return {xyy.x, xyy.y, xyy.luminance};
}

Xyz oklab_model_to_xyz(const Components& c, const ModelContext&) {
  const Rgb rgb = oklab_to_linear_srgb({c[0], c[1], c[2]});
  return linear_to_xyz({rgb.r, rgb.g, rgb.b}, {});
}
Components xyz_to_oklab_model(Xyz c, const ModelContext&) {
  const Components rgb = xyz_to_linear(c, {});
  const Oklab lab = linear_srgb_to_oklab({rgb[0], rgb[1], rgb[2]});
  return {lab.l, lab.a, lab.b};
}

constexpr ColorModel kModels[] = {
    {"rgb", "R G B", "0..1, encoded by the set's curve", true, false, rgb_to_xyz, xyz_to_rgb,
     "the curve of the set (a pure exponent where it names one, else sRGB), then as linear",
     "[IEC61966]"},
    {"linear", "R G B", "0..1, light", true, false, linear_to_xyz, xyz_to_linear,
     "M = columns (x, y, 1-x-y) C, C from the white", "[Shoaff 2.2.4]"},
    {"xyz", "X Y Z", "Y of the white is 1", false, false,
     [](const Components& c, const ModelContext&) {
       return Xyz{c[0], c[1], c[2]};
     },
     [](Xyz c, const ModelContext&) {
       return Components{c.x, c.y, c.z};
     },
     "the hub", "[CIE15]"},
    {"xyy", "x y Y", "Y of the white is 1; black has no x and y", false, false, xyy_model_to_xyz,
     xyz_to_xyy_model, "x = X/(X+Y+Z), y = Y/(X+Y+Z)", "[CIE15]"},
    {"lab", "L* a* b*", "L* 0..100", false, false, lab_model_to_xyz, xyz_to_lab_model,
     "L* = 116 f(Y/Yn) - 16, a* = 500 (f(X/Xn) - f(Y/Yn)), b* = 200 (f(Y/Yn) - f(Z/Zn))",
     "[CIE15 8.2.1]"},
    {"oklab", "L a b", "L 0..1", false, true, oklab_model_to_xyz, xyz_to_oklab_model,
     "cube roots of cone responses between two matrices", "[Ottosson20]"},
};

bool is_rgb(const ModelReference& reference) { return reference.model->has_primaries; }

// RGB to Lab of one white: greys come out exactly neutral, which the way through XYZ cannot
// promise.
bool has_direct_edge(const ModelReference& from, const ModelReference& to, bool one_white) {
  return one_white && is_rgb(from) && to.model->name == "lab";
}

std::string white_text(Chromaticity white) {
  for (const WhitePoint& known : kWhitePoints) {
    if (known.chromaticity == white) return std::string(known.name);
  }
  return shortest(white.x) + " " + shortest(white.y);
}

std::string matrix_text(const Eigen::Matrix3d& m) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) text += (j > 0 ? " " : i > 0 ? " / " : "") + shortest(m(i, j));
  }
  return text;
}

}  // namespace

std::span<const ColorModel> color_models() noexcept { return kModels; }

ModelReference parse_model(std::string_view text, std::string_view thing) {
  const std::size_t at = text.find_first_of(":@");
  const std::string_view name = text.substr(0, at);
  ModelReference reference;
  reference.model = find_by_name(kModels, name);
  if (reference.model == nullptr) {
    throw Error(ErrorKind::kMisuse, thing, "unknown model '" + std::string(name) + "'",
                name_hint(kModels, name));
  }
  const std::string_view detail = at == std::string_view::npos ? "" : text.substr(at + 1);
  const char mark = at == std::string_view::npos ? '\0' : text[at];
  const bool fits = mark == '\0' || (mark == ':' && is_rgb(reference)) ||
                    (mark == '@' && !is_rgb(reference) && !reference.model->fixed_white);
  if (!fits) {
    throw Error(
        ErrorKind::kMisuse, thing, "'" + std::string(text) + "' is no model",
        "primaries go with rgb and linear (rgb:ntsc1953), whites with the others (lab@d50)");
  }
  if (mark == ':') {
    const NamedPrimaries* set = find_by_name(primaries_list(), detail);
    if (set == nullptr) {
      throw Error(ErrorKind::kMisuse, thing, "unknown primaries '" + std::string(detail) + "'",
                  name_hint(primaries_list(), detail));
    }
    reference.primaries = set->primaries;
  }
  if (mark == '@') {
    const WhitePoint* white = find_by_name(kWhitePoints, detail);
    if (white == nullptr) {
      throw Error(ErrorKind::kMisuse, thing, "unknown white '" + std::string(detail) + "'",
                  name_hint(kWhitePoints, detail));
    }
    reference.white = white->chromaticity;
  }
  if (is_rgb(reference)) reference.white = reference.primaries.white;
  if (reference.model->fixed_white) reference.white = kD65;
  return reference;
}

ColorConversion::ColorConversion(const ModelReference& from, const ModelReference& to,
                                 Adaptation adaptation)
    : from_(from), to_(to), adaptation_(adaptation) {
  const Chromaticity from_white = from.white.value_or(to.white.value_or(kD65));
  const Chromaticity to_white = to.white.value_or(from_white);
  from_context_ = {from.primaries, from_white};
  to_context_ = {to.primaries, to_white};
  (void)xyz_from_rgb(from.primaries);
  (void)xyz_from_rgb(to.primaries);
  matrix_ = adaptation_matrix(from_white, to_white, adaptation);
  one_white_ = from_white == to_white;
  adapts_ = !one_white_ && adaptation != Adaptation::kNone;
}

Components ColorConversion::operator()(const Components& c) const {
  if (from_.model == to_.model && one_white_ && from_.primaries == to_.primaries) return c;
  if (has_direct_edge(from_, to_, one_white_)) {
    Components light = c;
    if (from_.model->name == "rgb") {
      const double gamma = set_gamma(from_.primaries);
      for (double& component : light) component = decode(component, gamma);
    }
    const Lab lab = rgb_to_lab({light[0], light[1], light[2]}, xyz_from_rgb(from_.primaries));
    return {lab.l, lab.a, lab.b};
  }
  Xyz middle = from_.model->to_xyz(c, from_context_);
  if (adapts_) middle = xyz(matrix_ * vector(middle));
  return to_.model->from_xyz(middle, to_context_);
}

std::vector<std::string> ColorConversion::explain() const {
  std::vector<std::string> lines;
  const auto edge = [&](const ModelReference& reference, bool to_hub) {
    const ColorModel& m = *reference.model;
    if (m.name == "xyz") return;
    std::string line =
        to_hub ? std::string(m.name) + " to xyz: " : "xyz to " + std::string(m.name) + ": ";
    line += std::string(m.formula) + " " + std::string(m.source);
    if (is_rgb(reference)) {
      line += "; matrix " + matrix_text(to_hub ? xyz_from_rgb(reference.primaries)
                                               : rgb_from_xyz(reference.primaries));
    }
    lines.push_back(std::move(line));
  };
  edge(from_, true);
  if (adapts_) {
    for (const AdaptationMethod& method : kAdaptations) {
      if (method.method != adaptation_) continue;
      lines.push_back("white " + white_text(from_context_.white) + " to " +
                      white_text(to_context_.white) + ": " + std::string(method.name) + " " +
                      std::string(method.source) + "; matrix " + matrix_text(matrix_));
    }
  }
  edge(to_, false);
  if (has_direct_edge(from_, to_, one_white_)) {
    lines.push_back("rgb to lab of one white in one step: greys have a* = b* = 0 exactly");
  }
  return lines;
}

}  // namespace tristim
