#include "lib/render/lathe.h"

#include <map>
#include <utility>

#include "lib/core/trigonometry.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

class Lathe {
 public:
  explicit Lathe(int columns) : columns_(columns) {}

  void add(const ProfileStrip& strip) {
    const std::size_t first_normal = model_.normals.size();
    for (std::size_t i = 0; i < strip.size(); ++i) add_ring(strip, i);
    for (std::size_t i = 0; i + 1 < strip.size(); ++i) {
      for (int column = 0; column < columns_; ++column) {
        add_quad(strip[i], strip[i + 1], first_normal + i * ring_size(), column);
      }
    }
  }

  PolygonModel take() { return std::move(model_); }

 private:
  std::size_t ring_size() const { return static_cast<std::size_t>(columns_) + 1; }

  // From the front to the right: seen from above against the clock.
  Vector3d turned(double r, double y, double columns) const {
    const SineCosine angle = sine_cosine_deg(360 * columns / columns_);
    return {r * angle.sine, y, r * angle.cosine};
  }

  // The positions of a point of the profile, new or those of an earlier strip.
  std::uint32_t ring_of(const ProfilePoint& point) {
    const auto [found, is_new] = rings_.try_emplace(
        std::pair(point.r, point.y), static_cast<std::uint32_t>(model_.positions.size()));
    if (is_new) {
      const int count = point.r == 0 ? 1 : columns_;
      for (int i = 0; i < count; ++i) model_.positions.push_back(turned(point.r, point.y, i));
    }
    return found->second;
  }

  // Normals and texture coordinates of a point; on the axis those of the middles of the columns.
  void add_ring(const ProfileStrip& strip, std::size_t i) {
    const ProfilePoint& point = strip[i];
    (void)ring_of(point);
    const double shift = point.r == 0 ? 0.5 : 0;
    const auto v =
        static_cast<float>(1 - static_cast<double>(i) / static_cast<double>(strip.size() - 1));
    for (int column = 0; column <= columns_; ++column) {
      model_.normals.push_back(turned(point.normal_r, point.normal_y, column + shift));
      model_.uvs.push_back({static_cast<float>((column + shift) / columns_), v});
    }
  }

  MeshCorner corner(const ProfilePoint& point, std::size_t normal, int column) {
    const int place = point.r == 0 ? 0 : column % columns_;
    return {ring_of(point) + static_cast<std::uint32_t>(place), static_cast<std::uint32_t>(normal),
            static_cast<std::uint32_t>(normal)};
  }

  void add_quad(const ProfilePoint& upper, const ProfilePoint& lower, std::size_t ring,
                int column) {
    const std::size_t here = ring + static_cast<std::size_t>(column);
    std::vector<MeshCorner> corners{corner(upper, here, column),
                                    corner(lower, here + ring_size(), column)};
    if (lower.r != 0) corners.push_back(corner(lower, here + ring_size() + 1, column + 1));
    if (upper.r != 0) corners.push_back(corner(upper, here + 1, column + 1));
    if (corners.size() > 2) add_face(model_, corners);
  }

  int columns_;
  PolygonModel model_;
  std::map<std::pair<double, double>, std::uint32_t> rings_;
};

}  // namespace

PolygonModel lathe(std::span<const ProfileStrip> strips, int columns) {
  Lathe work(columns);
  for (const ProfileStrip& strip : strips) work.add(strip);
  return work.take();
}

}  // namespace tristim::detail
