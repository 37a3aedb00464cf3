#include <array>

#include "tools/shade_model.h"
#include "tristim/light/phong.h"

namespace tristim::tools {
namespace {

constexpr Column kLocalIn[] = {{"L", kVector},      {"N", kVector},  {"V", kVector},
                               {"n", kNotNegative}, {"ka", kNumber}, {"kd", kNumber},
                               {"ks", kNumber},     {"Ia", kColor},  {"Ip", kColor},
                               {"Od", kColor},      {"Os", kColor},  {"fatt", kNumber}};
constexpr Column kLocalOut[] = {{"lambert", kNumber},
                                {"spec_phong", kNumber},
                                {"spec_blinn", kNumber},
                                {"I_phong", kColor},
                                {"I_blinn", kColor}};

double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

Rgb sum(const Rgb& a, const Rgb& b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }

void local_illumination(const ShadeRow& in, ShadeRow& out) {
  const Eigen::Vector3d l = in.vector("L");
  const Eigen::Vector3d n = in.vector("N");
  const Eigen::Vector3d v = in.vector("V");
  const Material material{.ka = in.number("ka"),
                          .kd = in.number("kd"),
                          .ks = in.number("ks"),
                          .n = in.number("n"),
                          .od = in.color("Od"),
                          .os = in.color("Os")};
  const double f_att = in.number("fatt");
  const Rgb ip = in.color("Ip");
  const Incident arriving{l, {product(f_att, ip.r), product(f_att, ip.g), product(f_att, ip.b)}};
  const Rgb ambient = ambient_reflection(material, in.color("Ia"));
  out.set("lambert", lambert(n, l));
  out.set("spec_phong", phong_lobe(n, l, v, material.n));
  out.set("spec_blinn", blinn_phong_lobe(n, l, v, material.n));
  out.set("I_phong", sum(ambient, direct_reflection(material, kPhong, n, v, arriving)));
  out.set("I_blinn", sum(ambient, direct_reflection(material, kBlinnPhong, n, v, arriving)));
}

constexpr std::array kModels{
    ShadeModel{"local_illumination", "ka Ia Od + fatt Ip [kd Od N.L + ks Os (R.V)^n or (N.H)^n]",
               "[Shoaff 3.4, Phong75, Blinn77]", kLocalIn, kLocalOut, local_illumination},
};

}  // namespace

std::span<const ShadeModel> reflection_models() { return kModels; }

}  // namespace tristim::tools
