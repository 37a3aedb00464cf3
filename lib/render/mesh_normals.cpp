#include "tristim/render/mesh_normals.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "lib/light/corner.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using detail::PreciseVector;
using Eigen::Vector3d;

// A corner among those of its vertex.
struct Spoke {
  std::size_t face;
  std::size_t at;  // which corner of the face
};

// The corners at each vertex: those of vertex v are spokes first[v]..first[v + 1] - 1.
struct Spokes {
  std::vector<std::size_t> first;
  std::vector<Spoke> all;
};

Spokes spokes_of(const PolygonModel& model) {
  Spokes spokes{std::vector<std::size_t>(model.positions.size() + 1), {}};
  for (const MeshCorner& corner : model.corners) ++spokes.first[corner.position + 1];
  for (std::size_t v = 0; v < model.positions.size(); ++v) {
    spokes.first[v + 1] += spokes.first[v];
  }
  std::vector<std::size_t> next(spokes.first.begin(), spokes.first.end() - 1);
  spokes.all.resize(model.corners.size());
  for (std::size_t face = 0; face < model.faces.size(); ++face) {
    for (std::size_t at = 0; at < model.faces[face].count; ++at) {
      const MeshCorner& corner = model.corners[model.faces[face].first + at];
      spokes.all[next[corner.position]++] = {face, at};
    }
  }
  return spokes;
}

class Averager {
 public:
  Averager(PolygonModel& model, const NormalWeighting& weighting, double smoothing_deg)
      : model_(model),
        weighting_(weighting),
        all_smooth_(smoothing_deg >= 180),
        least_cosine_(cosine_deg(smoothing_deg)) {
    for (const PolygonFace& face : model.faces) {
      face_normals_.push_back(unit_newell_normal(polygon_of(face)));
    }
  }

  void average() {
    model_.normals.clear();
    const Spokes spokes = spokes_of(model_);
    for (std::size_t v = 0; v < model_.positions.size(); ++v) {
      average_vertex(
          std::span(spokes.all).subspan(spokes.first[v], spokes.first[v + 1] - spokes.first[v]));
    }
  }

 private:
  std::span<const Vector3d> polygon_of(const PolygonFace& face) {
    polygon_.clear();
    for (const MeshCorner& corner : model_.corners_of(face)) {
      polygon_.push_back(model_.positions[corner.position]);
    }
    return polygon_;
  }

  // The neighbour of a corner's vertex so many steps round its face.
  std::uint32_t beside(const Spoke& spoke, std::size_t steps) const {
    const PolygonFace& face = model_.faces[spoke.face];
    return model_.corners[face.first + (spoke.at + steps) % face.count].position;
  }

  bool smooth(const Spoke& a, const Spoke& b) const {
    return dot(face_normals_[a.face], face_normals_[b.face]) >= least_cosine_;
  }

  // Which corners of a vertex hang together, as a number for each.
  std::vector<std::size_t> groups_of(std::span<const Spoke> spokes) const {
    if (all_smooth_) return std::vector<std::size_t>(spokes.size(), 0);
    struct Edge {
      std::uint32_t to;
      std::size_t spoke;
    };
    std::vector<Edge> edges;
    std::vector<std::size_t> parent(spokes.size());
    for (std::size_t i = 0; i < spokes.size(); ++i) {
      parent[i] = i;
      edges.push_back({beside(spokes[i], 1), i});
      edges.push_back({beside(spokes[i], model_.faces[spokes[i].face].count - 1), i});
    }
    const auto root = [&](std::size_t i) {
      while (parent[i] != i) i = parent[i] = parent[parent[i]];
      return i;
    };
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge& a, const Edge& b) { return a.to < b.to; });
    for (std::size_t e = 1; e < edges.size(); ++e) {
      const Edge& a = edges[e - 1];
      const Edge& b = edges[e];
      if (a.to != b.to || !smooth(spokes[a.spoke], spokes[b.spoke])) continue;
      const std::size_t first = root(a.spoke);
      const std::size_t second = root(b.spoke);
      parent[std::max(first, second)] = std::min(first, second);
    }
    for (std::size_t i = 0; i < spokes.size(); ++i) parent[i] = root(i);
    return parent;
  }

  void average_vertex(std::span<const Spoke> spokes) {
    const std::vector<std::size_t> groups = groups_of(spokes);
    std::vector<std::size_t> order(spokes.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return groups[a] < groups[b]; });
    for (std::size_t first = 0; first < order.size();) {
      std::size_t last = first;
      while (last < order.size() && groups[order[last]] == groups[order[first]]) ++last;
      average_group(spokes, std::span(order).subspan(first, last - first));
      first = last;
    }
  }

  void average_group(std::span<const Spoke> spokes, std::span<const std::size_t> group) {
    PreciseVector sum;
    for (const std::size_t i : group) {
      const Spoke& spoke = spokes[i];
      const Vector3d* plane = model_.planes.empty() ? nullptr : &model_.planes[spoke.face];
      sum = sum + weighting_.share({polygon_of(model_.faces[spoke.face]), spoke.at, plane});
    }
    const Vector3d normal = rounded(normalize(sum));
    std::uint32_t number = kNoIndex;
    if (normal != Vector3d(0, 0, 0)) {
      number = static_cast<std::uint32_t>(model_.normals.size());
      model_.normals.push_back(normal);
    }
    for (const std::size_t i : group) {
      model_.corners[model_.faces[spokes[i].face].first + spokes[i].at].normal = number;
    }
  }

  PolygonModel& model_;
  const NormalWeighting& weighting_;
  bool all_smooth_;
  double least_cosine_;
  std::vector<Vector3d> face_normals_;
  std::vector<Vector3d> polygon_;
};

}  // namespace

void average_normals(PolygonModel& model, const NormalWeighting& weighting, double smoothing_deg) {
  const bool by_planes = weighting.share == kPlaneNormals.share;
  if (by_planes && model.planes.size() != model.faces.size()) {
    throw std::invalid_argument(std::to_string(model.planes.size()) + " planes for " +
                                std::to_string(model.faces.size()) + " faces");
  }
  Averager(model, weighting, smoothing_deg).average();
}

void drop_normals(PolygonModel& model) noexcept {
  model.normals.clear();
  for (MeshCorner& corner : model.corners) corner.normal = kNoIndex;
}

bool has_normals(const PolygonModel& model) noexcept {
  return std::all_of(model.corners.begin(), model.corners.end(),
                     [](const MeshCorner& corner) { return corner.normal != kNoIndex; });
}

}  // namespace tristim
