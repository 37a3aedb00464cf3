#include <array>

#include "tools/report.h"
#include "tools/shade_model.h"
#include "tristim/core/error.h"
#include "tristim/light/normals.h"

namespace tristim::tools {
namespace {

constexpr Column kExpect[] = {{"expect", kJson}};

constexpr Column kPolygonIn[] = {{"vertices", kJson}};
Json polygon(const JsonRow& in) {
  const std::vector<Eigen::Vector3d> vertices = in.vectors("vertices");
  return {{"expect",
           {{"newell", vector_json(newell_normal(vertices))},
            {"area", number_json(polygon_area(vertices))},
            {"unit", vector_json(unit_newell_normal(vertices))}}}};
}

constexpr Column kMeshIn[] = {{"vertices", kJson}, {"faces", kJson}, {"planes", kJson}};
Json mesh_normals(const JsonRow& in) {
  PolygonMesh mesh = polygon_mesh_of(in);
  const bool planes = in.has("planes") && !in.value("planes").is_null();
  if (planes) {
    mesh.planes = in.vectors("planes");
    if (mesh.planes.size() != mesh.faces.size()) {
      in.refuse("planes", "are not one for each face", "give as many as faces, or none");
    }
  }
  Json expect = Json::object();
  for (const NormalWeighting& weighting : kNormalWeightings) {
    if (weighting.name == kPlaneNormals.name && !planes) continue;
    Json& list = expect[std::string(weighting.name)] = Json::array();
    for (const Eigen::Vector3d& n : vertex_normals(mesh, weighting)) list.push_back(vector_json(n));
  }
  return {{"expect", expect}};
}

constexpr std::array kModels{
    ShadeModel{"polygon_normals", "the sums (yk - yk+1)(zk + zk+1), ... and half their length",
               "[Shoaff 3.5]", kPolygonIn, kExpect, nullptr, polygon},
    ShadeModel{"vertex_normals",
               "sums of unit normals, of Newell normals/2, of angles times unit normals, of planes",
               "[Shoaff 4.1, Gouraud71, Thuermer98]", kMeshIn, kExpect, nullptr, mesh_normals},
};

}  // namespace

std::span<const ShadeModel> polygon_models() { return kModels; }

}  // namespace tristim::tools
