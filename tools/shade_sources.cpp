#include <array>

#include "tools/report.h"
#include "tools/shade_model.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/light/area.h"
#include "tristim/light/phong.h"
#include "tristim/light/source.h"
#include "tristim/light/vector.h"

namespace tristim::tools {
namespace {

using Eigen::Vector3d;

constexpr Column kAttenuationIn[] = {
    {"kind", kWord}, {"d", kNotNegative}, {"c1", kNumber}, {"c2", kNumber}, {"c3", kNumber}};
constexpr Column kAttenuationOut[] = {{"f", kNumber}};
void attenuation(const ShadeRow& in, ShadeRow& out) {
  const AttenuationKind* kind = find_by_name(kAttenuations, in.word("kind"));
  if (kind == nullptr) {
    throw Error(ErrorKind::kContent, "column kind", "unknown kind '" + in.word("kind") + "'",
                name_hint(kAttenuations, in.word("kind")));
  }
  out.set("f", kind->factor(in.number("d"), in.number("c1"), in.number("c2"), in.number("c3")));
}

constexpr Column kSpotIn[] = {
    {"lp", kVector}, {"axis", kVector}, {"cutoff_deg", kCutoff}, {"exponent", kNotNegative}};
constexpr Column kSpotOut[] = {{"factor", kNumber}};
void spot(const ShadeRow& in, ShadeRow& out) {
  out.set("factor", spot_factor(in.vector("lp"), in.vector("axis"), in.number("cutoff_deg"),
                                in.number("exponent")));
}

constexpr Column kCameraIn[] = {{"position", kVector}, {"direction", kVector}, {"right", kVector},
                                {"up", kVector},       {"back", kVector},      {"eye", kVector}};
constexpr Column kCameraOut[] = {{"position", kVector}, {"direction", kVector}};
void camera_light(const ShadeRow& in, ShadeRow& out) {
  CameraPose camera{.world_from_camera = {}, .eye = in.vector("eye")};
  camera.world_from_camera << in.vector("right"), in.vector("up"), in.vector("back");
  const SpotLight light{.position = in.vector("position"), .direction = in.vector("direction")};
  const auto placed = std::get<SpotLight>(placed_with_camera(light, camera));
  out.set("position", placed.position);
  out.set("direction", placed.direction);
}

Attenuation attenuation_of(const JsonRow& light) {
  const JsonRow in = light.object("attenuation");
  const std::string name = in.text("kind");
  const AttenuationKind* kind = find_by_name(kAttenuations, name);
  if (kind == nullptr) in.refuse("kind", "is unknown: " + name, name_hint(kAttenuations, name));
  return {*kind, in.number("c1"), in.number("c2"), in.number("c3")};
}

Light directional_light(const JsonRow& in) {
  return DirectionalLight{in.vector("to_light"), in.color("I")};
}

Light point_light(const JsonRow& in) {
  return PointLight{in.vector("position"), in.color("I"), attenuation_of(in)};
}

Light spot_light(const JsonRow& in) {
  const double cutoff = in.number("cutoff_deg");
  if (!kCutoff.allows(cutoff)) in.refuse("cutoff_deg", "is out of range", "give 0 to 180");
  return SpotLight{in.vector("position"),       in.vector("direction"), cutoff,
                   in.not_negative("exponent"), in.color("I"),          attenuation_of(in)};
}

struct LightType {
  std::string_view name;
  Light (*read)(const JsonRow& in);
};
constexpr LightType kLightTypes[] = {
    {"directional", directional_light}, {"point", point_light}, {"spot", spot_light}};

Light light_of(const JsonRow& in) {
  const std::string type = in.text("type");
  const LightType* found = find_by_name(kLightTypes, type);
  if (found == nullptr) {
    in.refuse("type", "is unknown: " + type, name_hint(kLightTypes, type));
  }
  return found->read(in);
}

constexpr Column kMultilightIn[] = {{"point", kJson},   {"normal", kJson},   {"eye", kJson},
                                    {"ambient", kJson}, {"material", kJson}, {"lights", kJson}};
constexpr Column kExpect[] = {{"expect", kJson}};
Json multilight(const JsonRow& in) {
  const JsonRow surface = in.object("material");
  const Material material{.ka = surface.number("ka"),
                          .kd = surface.number("kd"),
                          .ks = surface.number("ks"),
                          .n = surface.not_negative("n"),
                          .od = surface.color("Od"),
                          .os = surface.color("Os")};
  std::vector<Light> lights;
  for (const JsonRow& light : in.objects("lights")) lights.push_back(light_of(light));
  const Vector3d point = in.vector("point");
  const Vector3d to_eye = view_vector(point, in.vector("eye"));
  const auto shaded = [&](const SpecularModel& model) {
    return color_json(
        shade(material, model, in.vector("normal"), to_eye, point, in.color("ambient"), lights));
  };
  return {{"expect", {{"I_phong", shaded(kPhong)}, {"I_blinn", shaded(kBlinnPhong)}}}};
}

constexpr Column kAreaIn[] = {
    {"polygon", kJson}, {"point", kJson}, {"normal", kJson}, {"Le", kJson}};
Json area_light(const JsonRow& in) {
  const std::vector<Vector3d> polygon = in.vectors("polygon");
  const Vector3d point = in.vector("point");
  const Vector3d normal = in.vector("normal");
  return {{"expect",
           {{"E", number_json(polygon_irradiance(polygon, point, normal, in.number("Le")))},
            {"form_factor", number_json(polygon_form_factor(polygon, point, normal))}}}};
}

constexpr std::array kModels{
    ShadeModel{"attenuation",
               "none 1, inverse_square 1/d^2, clamped_quadratic min(1/(c1 + c2 d + c3 d^2), 1), "
               "linear 1/(c1 + c2 d), opengl 1/(c1 + c2 d + c3 d^2), beer_lambert exp(-c1 d)",
               "[Shoaff 3.2, UBC, Lambert1760]", kAttenuationIn, kAttenuationOut, attenuation},
    ShadeModel{"spot", "cos^exponent of the angle between lp and axis, 0 beyond cutoff",
               "[OpenGL 2.13.1]", kSpotIn, kSpotOut, spot},
    ShadeModel{"camera_light", "a light fixed to the camera: eye + x right + y up + z back",
               "[UBC]", kCameraIn, kCameraOut, camera_light},
    ShadeModel{"multilight", "ka Ia Od + sum f_att Ip [kd Od N.L + ks Os (R.V)^n or (N.H)^n]",
               "[Shoaff 3.7]", kMultilightIn, kExpect, nullptr, multilight},
    ShadeModel{"area_light", "E = Le/2 sum of the edges' angles times N on their planes' normals",
               "[Lambert1760]", kAreaIn, kExpect, nullptr, area_light},
};

}  // namespace

std::span<const ShadeModel> source_models() { return kModels; }

}  // namespace tristim::tools
