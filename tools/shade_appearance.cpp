#include <array>

#include "tools/shade_model.h"
#include "tristim/light/gooch.h"
#include "tristim/light/transparency.h"

namespace tristim::tools {
namespace {

constexpr Column kTransparencyIn[] = {
    {"kt1", kNumber}, {"I1", kColor}, {"I2", kColor}, {"Ot", kColor}};
constexpr Column kTransparencyOut[] = {{"interpolated", kColor}, {"filtered", kColor}};
void transparency(const ShadeRow& in, ShadeRow& out) {
  const TransparentSurface surface{in.number("kt1"), in.color("Ot")};
  out.set("interpolated", interpolated_transparency(surface, in.color("I1"), in.color("I2")));
  out.set("filtered", filtered_transparency(surface, in.color("I1"), in.color("I2")));
}

constexpr Column kTranslucencyIn[] = {{"N", kVector}, {"L", kVector}};
constexpr Column kTranslucencyOut[] = {{"transmitted", kNumber}};
void translucency(const ShadeRow& in, ShadeRow& out) {
  out.set("transmitted", diffuse_transmission(in.vector("N"), in.vector("L")));
}

constexpr Column kGoochIn[] = {{"N", kVector}, {"L", kVector}, {"warm", kColor}, {"cool", kColor}};
constexpr Column kGoochOut[] = {{"kw", kNumber}, {"c", kColor}};
void cool_to_warm(const ShadeRow& in, ShadeRow& out) {
  out.set("kw", gooch_warmth(in.vector("N"), in.vector("L")));
  out.set("c", gooch(in.vector("N"), in.vector("L"), in.color("warm"), in.color("cool")));
}

constexpr Column kEdgesIn[] = {
    {"e", kVector}, {"n0", kVector}, {"n1", kVector}, {"crease_threshold", kNumber}};
constexpr Column kEdgesOut[] = {{"silhouette", kFlag}, {"crease", kFlag}};
void edges(const ShadeRow& in, ShadeRow& out) {
  const Eigen::Vector3d n0 = in.vector("n0");
  const Eigen::Vector3d n1 = in.vector("n1");
  out.set("silhouette", is_silhouette(in.vector("e"), n0, n1));
  out.set("crease", is_crease(n0, n1, in.number("crease_threshold")));
}

constexpr std::array kModels{
    ShadeModel{"transparency", "(1 - kt1) I1 + kt1 I2; I1 + kt1 Ot I2", "[Shoaff 4.4]",
               kTransparencyIn, kTransparencyOut, transparency},
    ShadeModel{"translucency", "max(-N.L, 0), Lambert's law on the far side", "[Shoaff 4.4]",
               kTranslucencyIn, kTranslucencyOut, translucency},
    ShadeModel{"gooch", "kw = (1 + N.L)/2, c = kw warm + (1 - kw) cool", "[UBC, Gooch98]", kGoochIn,
               kGoochOut, cool_to_warm},
    ShadeModel{"edges", "silhouette (e.n0)(e.n1) <= 0, crease n0.n1 <= crease_threshold", "[UBC]",
               kEdgesIn, kEdgesOut, edges},
};

}  // namespace

std::span<const ShadeModel> appearance_models() { return kModels; }

}  // namespace tristim::tools
