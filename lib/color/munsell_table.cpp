#include "lib/color/munsell_table.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "lib/core/trigonometry.h"
#include "tristim/color/munsell_value.h"

namespace tristim::detail {
namespace {

struct Cell {
  double hue, value, chroma, x, y;
  int real;
};

constexpr Cell kCells[] = {
#include "luts/munsell_renotation.csv"
};

struct RadialArcs {
  double value, chroma_from, chroma_to, hue_from, hue_to;
};

constexpr RadialArcs kRadialArcs[] = {
#include "luts/munsell_radial.csv"
};

// Planes below 1 and at 10 are drawn as their neighbours, which the charts end with.
bool is_radial(double value, double chroma, double hue) {
  const double chart = std::clamp(value, 1.0, 9.0);
  return std::any_of(std::begin(kRadialArcs), std::end(kRadialArcs), [&](const RadialArcs& arcs) {
    return arcs.value == chart && arcs.chroma_from <= chroma && chroma <= arcs.chroma_to &&
           arcs.hue_from <= hue && hue + kMunsellHueStep <= arcs.hue_to;
  });
}

int column_of(double hue) { return static_cast<int>(hue / kMunsellHueStep) - 1; }
double hue_of(int column) { return kMunsellHueStep * (column + 1); }
int ring_of(double chroma) { return static_cast<int>(chroma / kMunsellChromaStep) - 1; }

// The angle from a to b in radians, (-pi, pi].
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double degrees = angle_deg(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  return (degrees > 180 ? degrees - 360 : degrees) * (std::numbers::pi / 180);
}

// The table lacks 10Y 0.2/2 alone of its first rings: half way, by angle and radius, between its
// neighbours.
void fill_gap(MunsellPlane& plane) {
  constexpr int kGap = 11;  // 10Y
  if (plane.rings(kGap) > 0) return;
  const Eigen::Vector2d before = plane.node(kGap - 1, 0) - munsell_center();
  const Eigen::Vector2d after = plane.node(kGap + 1, 0) - munsell_center();
  const Eigen::Vector2d direction = (before.normalized() + after.normalized()).normalized();
  plane.set_node(kGap, 0, munsell_center() + direction * ((before.norm() + after.norm()) / 2),
                 false);
}

void support_each_other(MunsellPlane& low, MunsellPlane& high) {
  for (int column = 0; column < kMunsellColumns; ++column) {
    low.support(column, high.rings(column));
    high.support(column, low.rings(column));
  }
}

std::vector<MunsellPlane> make_planes() {
  std::vector<MunsellPlane> planes;
  for (const Cell& cell : kCells) {  // by rising value
    if (planes.empty() || planes.back().value != cell.value) {
      planes.emplace_back();
      planes.back().value = cell.value;
      planes.back().luminance = luminance_from_munsell_value(cell.value);
    }
    planes.back().set_node(column_of(cell.hue), ring_of(cell.chroma), {cell.x, cell.y},
                           cell.real == 1);
  }
  for (MunsellPlane& plane : planes) fill_gap(plane);
  for (std::size_t i = 0; i + 1 < planes.size(); ++i) support_each_other(planes[i], planes[i + 1]);
  for (MunsellPlane& plane : planes) plane.connect();
  return planes;
}

struct Turn {
  double cosine, sine;
};

// Taylor's series, within an ulp up to .7 radians: arcs turn by less than .35, and Newton steps go
// an arc beyond at the most. Not the C library's: its last bits differ between processors.
Turn small_turn(double angle) noexcept {
  constexpr int kTerms = 7;
  constexpr auto kInverseFactorials = [] {
    std::array<double, 2 * kTerms + 2> inverse{};
    double factorial = 1;
    for (std::size_t n = 0; n < inverse.size(); ++n) {
      inverse[n] = 1 / factorial;
      factorial *= static_cast<double>(n + 1);
    }
    return inverse;
  }();
  const double q = -angle * angle;
  double cosine = 0;
  double sine = 0;
  for (std::size_t n = 2 * kTerms; n > 0; n -= 2) {
    cosine = (cosine + kInverseFactorials[n]) * q;
    sine = (sine + kInverseFactorials[n + 1]) * q;
  }
  return {1 + cosine, angle + angle * sine};
}

}  // namespace

std::span<const MunsellPlane> munsell_planes() {
  static const std::vector<MunsellPlane> planes = make_planes();
  return planes;
}

void MunsellPlane::set_node(int column, int ring, const Eigen::Vector2d& position, bool real) {
  at(column, ring).position = position;
  rings_[static_cast<std::size_t>(column)] = ring + 1;
  supported_[static_cast<std::size_t>(column)] = ring + 1;
  if (real) real_[static_cast<std::size_t>(column)] = ring + 1;
}

// Goes on as the last two rings do, the centre being the ring before the first.
void MunsellPlane::support(int column, int count) {
  int& rings = supported_[static_cast<std::size_t>(column)];
  for (; rings < count; ++rings) {
    const Eigen::Vector2d last = node(column, rings - 1);
    const Eigen::Vector2d before = rings > 1 ? node(column, rings - 2) : munsell_center();
    at(column, rings).position = last + (last - before);
  }
}

void MunsellPlane::connect() {
  for (int spoke = 0; spoke < kSpokes; ++spoke) {
    spokes_[static_cast<std::size_t>(spoke)] =
        (node(spoke * (kMunsellColumns / kSpokes), 0) - munsell_center()).normalized();
  }
  for (auto& column : nodes_) {
    for (Node& node : column) {
      const Eigen::Vector2d offset = node.position - munsell_center();
      node.radius = offset.norm();
      node.direction = offset / node.radius;
    }
  }
  nodes_[kMunsellColumns] = nodes_[0];
  rings_[kMunsellColumns] = rings_[0];
  supported_[kMunsellColumns] = supported_[0];
  real_[kMunsellColumns] = real_[0];
  for (int column = 0; column < kMunsellColumns; ++column) {
    const auto index = static_cast<std::size_t>(column);
    for (int ring = 0; ring < std::min(supported_[index], supported_[index + 1]); ++ring) {
      Node& node = at(column, ring);
      const double hue = column == kMunsellColumns - 1 ? 0 : hue_of(column);
      node.radial = is_radial(value, kMunsellChromaStep * (ring + 1), hue);
      const Eigen::Vector2d a = node.position - munsell_center();
      const Eigen::Vector2d b = this->node(column + 1, ring) - munsell_center();
      node.turn = turn(a, b);
    }
  }
}

int MunsellPlane::column_towards(const Eigen::Vector2d& offset) const noexcept {
  int nearest = 0;
  for (int spoke = 1; spoke < kSpokes; ++spoke) {
    const auto index = static_cast<std::size_t>(spoke);
    if (spokes_[index].dot(offset) > spokes_[static_cast<std::size_t>(nearest)].dot(offset)) {
      nearest = spoke;
    }
  }
  return nearest * (kMunsellColumns / kSpokes);
}

CurvePoint MunsellPlane::arc(int column, int ring, double u) const noexcept {
  const Node& from = at(column, ring);
  const Node& to = at(column + 1, ring);
  if (!from.radial) {
    const Eigen::Vector2d step = to.position - from.position;
    return {from.position + u * step, step};
  }
  const double radius_step = to.radius - from.radius;
  const double radius = from.radius + u * radius_step;
  const auto [c, s] = small_turn(u * from.turn);
  const Eigen::Vector2d& start = from.direction;
  const Eigen::Vector2d direction(c * start.x() - s * start.y(), s * start.x() + c * start.y());
  const Eigen::Vector2d across(-direction.y(), direction.x());
  return {u == 0 ? from.position : munsell_center() + radius * direction,
          radius_step * direction + radius * from.turn * across};
}

}  // namespace tristim::detail
