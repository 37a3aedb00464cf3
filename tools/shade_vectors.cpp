#include <array>

#include "tools/shade_model.h"
#include "tristim/light/normals.h"
#include "tristim/light/refraction.h"
#include "tristim/light/vector.h"

namespace tristim::tools {
namespace {

using Eigen::Vector3d;

constexpr Column kDirections[] = {{"L", kVector}, {"N", kVector}, {"V", kVector}};

constexpr Column kVectorOut[] = {{"R", kVector},     {"M", kVector},
                                 {"H", kVector},     {"RdotV", kNumber},
                                 {"LdotM", kNumber}, {"RdotV_expanded", kNumber},
                                 {"NdotH", kNumber}};
void vectors(const ShadeRow& in, ShadeRow& out) {
  const Vector3d l = in.vector("L");
  const Vector3d n = in.vector("N");
  const Vector3d v = in.vector("V");
  out.set("R", reflect(l, n));
  out.set("M", reflect(v, n));
  out.set("H", half_vector(l, v));
  out.set("RdotV", r_dot_v(n, l, v));
  out.set("LdotM", r_dot_v(n, v, l));
  out.set("RdotV_expanded", r_dot_v(n, l, v));
  out.set("NdotH", n_dot_h(n, l, v));
}

constexpr Column kAnglesOut[] = {
    {"alpha_deg", kNumber}, {"beta_deg", kNumber}, {"rho_deg", kNumber}, {"nu_deg", kNumber}};
void angles(const ShadeRow& in, ShadeRow& out) {
  const HighlightAngles a = highlight_angles(in.vector("N"), in.vector("L"), in.vector("V"));
  out.set("alpha_deg", a.alpha_deg);
  out.set("beta_deg", a.beta_deg);
  out.set("rho_deg", a.rho_deg);
  out.set("nu_deg", a.nu_deg);
}

constexpr Column kReflectIn[] = {{"L", kVector}, {"N", kVector}};
constexpr Column kReflectOut[] = {{"R", kVector}, {"R_turned", kVector}, {"R_of_z", kVector}};
void reflection(const ShadeRow& in, ShadeRow& out) {
  out.set("R", reflect(in.vector("L"), in.vector("N")));
  out.set("R_turned", reflect_by_turning(in.vector("L"), in.vector("N")));
  out.set("R_of_z", reflect_z(in.vector("N")));
}

constexpr Column kNormalizeIn[] = {{"v", kVector}};
constexpr Column kUnitOut[] = {{"u", kVector}, {"length", kNumber}};
void unit_vector(const ShadeRow& in, ShadeRow& out) {
  out.set("u", normalize(in.vector("v")));
  out.set("length", length(in.vector("v")));
}

constexpr Column kViewIn[] = {{"P", kVector}, {"eye", kVector}};
constexpr Column kViewOut[] = {{"V", kVector}};
void view(const ShadeRow& in, ShadeRow& out) {
  out.set("V", view_vector(in.vector("P"), in.vector("eye")));
}

constexpr Column kPlaneIn[] = {{"a", kNumber}, {"b", kNumber}, {"c", kNumber}};
constexpr Column kNormalOut[] = {{"N", kVector}};
void plane(const ShadeRow& in, ShadeRow& out) {
  out.set("N", plane_normal(in.number("a"), in.number("b"), in.number("c")));
}

constexpr Column kThreeIn[] = {{"v0", kVector}, {"v1", kVector}, {"v2", kVector}};
void three_points(const ShadeRow& in, ShadeRow& out) {
  out.set("N", three_point_normal(in.vector("v0"), in.vector("v1"), in.vector("v2")));
}

constexpr Column kFacingIn[] = {{"N", kVector}, {"V", kVector}};
void facing(const ShadeRow& in, ShadeRow& out) {
  out.set("N", facing_normal(in.vector("N"), in.vector("V")));
}

constexpr Column kRefractionIn[] = {
    {"L", kVector}, {"N", kVector}, {"eta_i", kAboveZero}, {"eta_t", kAboveZero}};
constexpr Column kRefractionOut[] = {{"T", kVector}, {"cos_t", kNumber}, {"tir", kFlag}};
void refraction(const ShadeRow& in, ShadeRow& out) {
  const Refraction r =
      refract(in.vector("L"), in.vector("N"), in.number("eta_i"), in.number("eta_t"));
  out.set("T", r.transmitted);
  out.set("cos_t", r.cos_t);
  out.set("tir", r.total_internal);
}

constexpr Column kFormsOut[] = {{"T_plane", kVector}, {"T_sines", kVector}, {"T_dots", kVector}};
void refraction_forms(const ShadeRow& in, ShadeRow& out) {
  for (const RefractionForm& form : kRefractionForms) {
    out.set("T_" + std::string(form.name),
            form.refract(in.vector("L"), in.vector("N"), in.number("eta_i"), in.number("eta_t"))
                .transmitted);
  }
}

constexpr Column kSnellIn[] = {{"sin_i", kNumber}, {"eta_i", kAboveZero}, {"eta_t", kAboveZero}};
constexpr Column kSnellOut[] = {{"sin_t", kNumber}};
void snell(const ShadeRow& in, ShadeRow& out) {
  out.set("sin_t", snell_sine(in.number("sin_i"), in.number("eta_i"), in.number("eta_t")));
}

constexpr std::array kModels{
    ShadeModel{"vectors", "R = 2 (N.L) N - L, M = 2 (N.V) N - V, H = (L + V)/|L + V|",
               "[Shoaff 3.6, FisherWoo]", kDirections, kVectorOut, vectors},
    ShadeModel{"angles", "alpha = [L,N], beta = [L,H], rho = [R,E], nu = [N,H]", "[FisherWoo]",
               kDirections, kAnglesOut, angles},
    ShadeModel{"reflection", "R = 2 (N.L) N - L; L turned to +z and back; L = +z",
               "[Shoaff 3.6, Phong75, Owen]", kReflectIn, kReflectOut, reflection},
    ShadeModel{"normalize", "u = v/|v|, 0 of 0", "[UBC]", kNormalizeIn, kUnitOut, unit_vector},
    ShadeModel{"view_vector", "V = (eye - P)/|eye - P|", "[Owen]", kViewIn, kViewOut, view},
    ShadeModel{"plane_normal", "(a, b, c)/sqrt(a^2 + b^2 + c^2)", "[Shoaff 3.5]", kPlaneIn,
               kNormalOut, plane},
    ShadeModel{"three_point_normal", "(v1 - v0) x (v2 - v0), made unit", "[Shoaff 3.5]", kThreeIn,
               kNormalOut, three_points},
    ShadeModel{"facing_normal", "-N where N.V < 0, else N", "[Shoaff 3.5]", kFacingIn, kNormalOut,
               facing},
    ShadeModel{"refraction", kRefractionForms[2].formula, kRefractionForms[2].source, kRefractionIn,
               kRefractionOut, refraction},
    ShadeModel{"refraction_forms", "T by the plane of L and N, by sines, by dot products",
               "[Shoaff 4.4]", kRefractionIn, kFormsOut, refraction_forms},
    ShadeModel{"snell", "sin_t = eta_i sin_i/eta_t", "[Shoaff 4.4]", kSnellIn, kSnellOut, snell},
};

}  // namespace

std::span<const ShadeModel> vector_models() { return kModels; }

}  // namespace tristim::tools
