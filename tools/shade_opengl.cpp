#include <array>

#include "tools/shade_model.h"
#include "tristim/light/opengl.h"

namespace tristim::tools {
namespace {

constexpr Column kIn[] = {{"pos", kVector},
                          {"N", kVector},
                          {"mat_amb", kColor},
                          {"mat_dif", kColor},
                          {"mat_spec", kColor},
                          {"shininess", kNotNegative},
                          {"lightpos", kVector},
                          {"lightpos_w", kNumber},
                          {"l_amb", kColor},
                          {"l_dif", kColor},
                          {"l_spec", kColor},
                          {"spotdir", kVector},
                          {"spot_exp", kNotNegative},
                          {"spot_cutoff", kCutoff},
                          {"kc", kNumber},
                          {"kl", kNumber},
                          {"kq", kNumber},
                          {"local_viewer", kFlag},
                          {"global_amb", kColor}};
constexpr Column kOut[] = {{"I", kColor}};

void fixed_function(const ShadeRow& in, ShadeRow& out) {
  const GlMaterial material{.ambient = in.color("mat_amb"),
                            .diffuse = in.color("mat_dif"),
                            .specular = in.color("mat_spec"),
                            .shininess = in.number("shininess")};
  const GlLight light{.position = in.vector("lightpos"),
                      .w = in.number("lightpos_w"),
                      .ambient = in.color("l_amb"),
                      .diffuse = in.color("l_dif"),
                      .specular = in.color("l_spec"),
                      .spot_direction = in.vector("spotdir"),
                      .spot_exponent = in.number("spot_exp"),
                      .spot_cutoff_deg = in.number("spot_cutoff"),
                      .constant = in.number("kc"),
                      .linear = in.number("kl"),
                      .quadratic = in.number("kq")};
  const GlLightModel model{in.color("global_amb"), in.flag("local_viewer")};
  out.set("I",
          gl_lighting(material, model, std::span(&light, 1), in.vector("pos"), in.vector("N")));
}

constexpr std::array kModels{
    ShadeModel{"gl_fixed_function",
               "global ambient + f_att spot (ambient + diffuse N.L + specular (N.H)^shininess)",
               "[OpenGL 2.13.1]", kIn, kOut, fixed_function},
};

}  // namespace

std::span<const ShadeModel> opengl_models() { return kModels; }

}  // namespace tristim::tools
