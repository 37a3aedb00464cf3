#include "lib/color/munsell_slice.h"

#include <algorithm>
#include <cmath>

namespace tristim::detail {
namespace {

constexpr double kOnPlane = 1e-9;  // value from a plane: nearer is on it
constexpr double kInside = 1e-9;   // a place this far outside of a cell is on its edge
constexpr double kOnLine = 1e-11;  // nearer to a column or ring is on it
constexpr double kStill = 1e-7;
constexpr int kWalkSteps = 24;  // a dozen is common between far cells
constexpr int kCellSteps = 12;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) noexcept {
  return a.x() * b.y() - a.y() * b.x();
}

int wrapped(int column) noexcept {  // within a turn of [0, 40)
  return column < 0 ? column + kMunsellColumns : column % kMunsellColumns;
}

// Solves column_u * du + column_s * ds = right. Returns (du, ds), not finite where there is none.
Eigen::Vector2d solve(const Eigen::Vector2d& column_u, const Eigen::Vector2d& column_s,
                      const Eigen::Vector2d& right) noexcept {
  const double determinant = cross(column_u, column_s);
  return {cross(right, column_s) / determinant, cross(column_u, right) / determinant};
}

bool inside(double t) noexcept { return t >= -kInside && t <= 1 + kInside; }

// A last bit must not put a colour of the table's edge outside.
double snapped(double t) noexcept {
  const double nearest = std::round(t);
  return std::fabs(t - nearest) < kOnLine ? nearest : t;
}

}  // namespace

// Newton steps square the error: what is left after one this short is rounding.
bool MunsellSlice::is_still(const Cell& before, const Cell& after) noexcept {
  return std::fabs(after.u - before.u) < kStill && std::fabs(after.s - before.s) < kStill;
}

MunsellSlice::MunsellSlice(double value, double luminance) {
  const auto planes = munsell_planes();
  const auto* above =
      std::find_if(planes.data(), planes.data() + planes.size() - 1,
                   [&](const MunsellPlane& p) { return p.value > value - kOnPlane; });
  high_ = above;
  low_ = above == planes.data() || above->value < value + kOnPlane ? above : above - 1;
  if (low_ != high_) {
    weight_ = (luminance - low_->luminance) / (high_->luminance - low_->luminance);
  }
}

int MunsellSlice::rings(int column) const noexcept {
  return std::max(low_->rings(column), high_->rings(column));
}

int MunsellSlice::cell_rings(int column) const noexcept {
  return std::min(rings(column), rings(column + 1));
}

bool MunsellSlice::is_real(const ChartPlace& place) const noexcept {
  const int column = static_cast<int>(place.column);
  const int next = place.column > column ? column + 1 : column;
  const int rings = std::min({low_->real_rings(column), low_->real_rings(next),
                              high_->real_rings(column), high_->real_rings(next)});
  return place.ring <= rings;
}

CurvePoint MunsellSlice::arc(int column, int ring, double u) const noexcept {
  CurvePoint point = low_->arc(column, ring, u);
  if (low_ != high_) {
    const CurvePoint high = high_->arc(column, ring, u);
    point.position += weight_ * (high.position - point.position);
    point.slope += weight_ * (high.slope - point.slope);
  }
  return point;
}

std::optional<Eigen::Vector2d> MunsellSlice::position(const ChartPlace& place) const noexcept {
  const int column = static_cast<int>(place.column);
  const int ring = static_cast<int>(place.ring);
  const double u = place.column - column;
  const double s = place.ring - ring;
  const int last = u > 0 ? cell_rings(column) : rings(column);
  if (ring > last || (ring == last && s > 0)) return std::nullopt;
  const Eigen::Vector2d inner = ring > 0 ? arc(column, ring - 1, u).position : munsell_center();
  if (s == 0) return inner;
  return inner + s * (arc(column, ring, u).position - inner);
}

// Nearly the place of a position, by the nodes of one plane: a column near its direction, the ring
// of its distance along that column, then the columns on both sides of it at that ring.
MunsellSlice::Cell MunsellSlice::start(const Eigen::Vector2d& offset) const noexcept {
  const MunsellPlane& plane = weight_ > 0.5 ? *high_ : *low_;
  int ring = 0;
  const auto node = [&](int column) -> Eigen::Vector2d {
    return plane.node(column, std::min(ring, plane.rings(column) - 1)) - munsell_center();
  };
  int column = plane.column_towards(offset);
  while (ring + 1 < plane.rings(column) && node(column).squaredNorm() < offset.squaredNorm()) {
    ++ring;
  }
  double before = cross(node(column), offset);
  for (int i = 0; i < kMunsellColumns && before < 0; ++i) {
    column = wrapped(column - 1);
    before = cross(node(column), offset);
  }
  double after = cross(node(column + 1), offset);
  for (int i = 0; i < kMunsellColumns && after >= 0; ++i) {
    column = wrapped(column + 1);
    before = after;
    after = cross(node(column + 1), offset);
  }
  ring = std::clamp(ring, 0, std::max(cell_rings(column) - 1, 0));
  return {column, ring, before / (before - after), 0.5};
}

// One Newton step inside a cell of four corners. False where it is singular.
bool MunsellSlice::step(Cell& cell, const Eigen::Vector2d& position) const noexcept {
  if (cell.ring == 0) return step_at_center(cell, position);
  const CurvePoint inner = arc(cell.column, cell.ring - 1, cell.u);
  const CurvePoint outer = arc(cell.column, cell.ring, cell.u);
  const Eigen::Vector2d across = outer.position - inner.position;
  const Eigen::Vector2d along = inner.slope + cell.s * (outer.slope - inner.slope);
  const Eigen::Vector2d change = solve(along, across, position - inner.position - cell.s * across);
  cell.u += change.x();
  cell.s += change.y();
  return std::isfinite(change.x()) && std::isfinite(change.y());
}

// The same in a triangle at the centre, where u is ill defined: solves for u and 1/s the ray
// through the position that meets the first ring, outer(u) = center + offset/s.
bool MunsellSlice::step_at_center(Cell& cell, const Eigen::Vector2d& position) const noexcept {
  const CurvePoint outer = arc(cell.column, 0, cell.u);
  const Eigen::Vector2d offset = position - munsell_center();
  const double length = offset.norm();
  const Eigen::Vector2d change =
      solve(outer.slope, -offset / length, munsell_center() - outer.position);
  cell.u += change.x();
  cell.s = length / change.y();
  return std::isfinite(change.x()) && change.y() > 0;
}

// Moves to the cell that the place has come to, by one ring and one column at the most.
void MunsellSlice::settle(Cell& cell) const noexcept {
  if (cell.u < -kInside) {
    cell.column = wrapped(cell.column - 1);
    cell.u = std::max(cell.u + 1, 0.0);
  } else if (cell.u > 1 + kInside) {
    cell.column = wrapped(cell.column + 1);
    cell.u = std::min(cell.u - 1, 1.0);
  }
  if (cell.s > 1 + kInside && cell.ring + 1 < cell_rings(cell.column)) {
    ++cell.ring;
    cell.s = std::min(cell.s - 1, 1.0);
  } else if (cell.s < -kInside && cell.ring > 0) {
    --cell.ring;
    cell.s = std::max(cell.s + 1, 0.0);
  }
  const int outermost = std::max(cell_rings(cell.column) - 1, 0);
  cell.ring = std::min(cell.ring, outermost);
}

std::optional<MunsellSlice::Cell> MunsellSlice::walk(
    const Eigen::Vector2d& position) const noexcept {
  Cell cell = start(position - munsell_center());
  for (int i = 0; i < kWalkSteps; ++i) {
    if (cell_rings(cell.column) == 0) return std::nullopt;
    const Cell before = cell;
    if (!step(cell, position)) return std::nullopt;
    if (is_still(before, cell) && inside(cell.u) && inside(cell.s)) return cell;
    settle(cell);
  }
  return std::nullopt;
}

// Every cell, where walking did not get there: at folds of the extrapolated table.
std::optional<MunsellSlice::Cell> MunsellSlice::search(
    const Eigen::Vector2d& position) const noexcept {
  for (int column = 0; column < kMunsellColumns; ++column) {
    for (int ring = 0; ring < cell_rings(column); ++ring) {
      Cell cell{column, ring, 0.5, 0.5};
      for (int i = 0; i < kCellSteps; ++i) {
        const Cell before = cell;
        if (!step(cell, position)) break;
        if (is_still(before, cell) && inside(cell.u) && inside(cell.s)) return cell;
        cell.u = std::clamp(cell.u, -0.5, 1.5);
        cell.s = std::clamp(cell.s, -0.5, 1.5);
      }
    }
  }
  return std::nullopt;
}

std::optional<ChartPlace> MunsellSlice::locate(const Eigen::Vector2d& position) const noexcept {
  auto cell = walk(position);
  if (!cell) cell = search(position);
  if (!cell) return std::nullopt;
  return ChartPlace{snapped(cell->column + cell->u), snapped(cell->ring + cell->s)};
}

}  // namespace tristim::detail
