#include "lib/dither/simplices.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "lib/color/oklab_matrices.h"

namespace tristim::detail {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;

// What cones see besides a colour, from the light in the eye: below it dots are not seen more.
constexpr double kGlare = 0.05;
constexpr double kConeWeight[3] = {1, 1.5, 0.04};  // of long, middle and short waves

// What a unit of light is worth that a colour gives up. So much that nothing is given up that can
// be mixed; but of palettes chosen for a picture colour is, rather than mixed by far dots.
constexpr double kKept = 1e3;
struct Direction {
  std::array<double, 3> rgb;
  double price;         // of palettes chosen for a picture
  double price_of_all;  // of others
};
// Along the opponent axes of S-CIELAB [ZhangWandell96]: each changes one of its three numbers.
constexpr Direction kGivenUp[3] = {{{-0.322, 0.788, 0.524}, 7.3, 10 * kKept},  // lightness
                                   {{-0.906, 0.401, 0.134}, 0.15, kKept},      // red to green
                                   {{-0.656, 0.289, 0.697}, 0.39, kKept}};     // yellow to blue

// Costs are told apart by this much where they are equal by symmetry: any triangulation does then.
constexpr double kApart = 1e-6;

// Nearer to a face an entry lies in it: what is left of a plane in floats.
constexpr double kThin = 1e-6;

struct Column {
  Vector4d a;
  double cost;
  int entry;
};

double cost_of(const Vector3d& color) {
  double cost = 0;
  for (std::size_t cone = 0; cone < 3; ++cone) {
    const auto& row = kLmsFromSrgb[cone];
    const double seen = row[0] * color.x() + row[1] * color.y() + row[2] * color.z();
    cost -= kConeWeight[cone] * std::sqrt(std::sqrt(std::max(seen, 0.0) + kGlare));
  }
  return cost;
}

std::vector<Column> columns_of(const MixPalette& palette) {
  std::vector<Column> columns;
  std::set<MixPalette::Color> known;
  for (int i = 0; i < palette.size(); ++i) {
    const MixPalette::Color& c = palette.entry(i);
    if (!known.insert(c).second) continue;
    const double golden = i * 0.6180339887498949;
    const double apart = kApart * (golden - std::floor(golden));
    columns.push_back({{c[0], c[1], c[2], 1}, cost_of({c[0], c[1], c[2]}) + apart, i});
  }
  const bool all_kept = palette.passed_on() == 1;  // Beyond::kMoved
  double apart = 1;
  for (const Direction& direction : kGivenUp) {
    const double price = all_kept ? direction.price_of_all : direction.price;
    const Vector4d a(direction.rgb[0], direction.rgb[1], direction.rgb[2], 0);
    for (const double sign : {1.0, -1.0}) {
      columns.push_back({sign * a, price * apart, -1});
      apart += kApart;
    }
  }
  return columns;
}

class Triangulation {
 public:
  Triangulation(std::vector<Column> columns, std::size_t most)
      : columns_(std::move(columns)), most_(most) {}

  std::vector<Simplex> made() {
    add(first());
    for (std::size_t i = 0; i < list_.size(); ++i) {
      for (std::size_t face = 0; face < 4; ++face) {
        if (list_[i].next[face] < 0) cross(i, face);
        if (list_.size() > most_) return {};
      }
    }
    return std::move(list_);
  }

 private:
  std::array<int, 4> first() const;
  void cross(std::size_t from, std::size_t face);
  int add(std::array<int, 4> column);
  int entering(const Simplex& simplex, std::size_t face) const;

  std::vector<Column> columns_;
  std::size_t most_;
  std::vector<Simplex> list_;
  std::map<std::array<int, 4>, int> known_;
};

// That of the colours that lie farthest out in three directions, for which these prices are paid:
// the entry that costs least then.
std::array<int, 4> Triangulation::first() const {
  const auto directions = static_cast<int>(columns_.size()) - 6;
  Matrix3d along;
  Vector3d price;
  for (int k = 0; k < 3; ++k) {
    const Column& direction = columns_[static_cast<std::size_t>(directions + 2 * k)];
    along.row(k) = direction.a.head<3>();
    price[k] = direction.cost;
  }
  const Vector3d worth = along.inverse() * price;
  const auto left = [&](const Column& c) { return c.cost - worth.dot(c.a.head<3>()); };
  const auto entry =
      std::min_element(columns_.begin(), columns_.begin() + directions,
                       [&left](const Column& a, const Column& b) { return left(a) < left(b); });
  return {static_cast<int>(entry - columns_.begin()), directions, directions + 2, directions + 4};
}

// Makes the simplex beyond a face known to this one, and the other way round.
void Triangulation::cross(std::size_t from, std::size_t face) {
  const int enters = entering(list_[from], face);
  if (enters < 0) return;
  std::array<int, 4> beyond = list_[from].column;
  beyond[face] = enters;
  const int to = add(beyond);
  list_[from].next[face] = to;
  Simplex& there = list_[static_cast<std::size_t>(to)];
  const auto back = std::find(there.column.begin(), there.column.end(), enters);
  there.next[static_cast<std::size_t>(back - there.column.begin())] = static_cast<int>(from);
}

int Triangulation::add(std::array<int, 4> column) {
  std::sort(column.begin(), column.end());
  const auto [at, is_new] = known_.emplace(column, static_cast<int>(list_.size()));
  if (!is_new) return at->second;
  Simplex simplex{column, {}, {-1, -1, -1, -1}, {}};
  Eigen::Matrix4d basis;
  for (std::size_t i = 0; i < 4; ++i) {
    const Column& c = columns_[static_cast<std::size_t>(column[i])];
    basis.col(static_cast<Index>(i)) = c.a;
    simplex.entry[i] = c.entry;
  }
  simplex.inverse = basis.inverse();
  list_.push_back(simplex);
  return at->second;
}

// The column beyond a face with which the cost grows least: the dual step of linear programming.
int Triangulation::entering(const Simplex& simplex, std::size_t face) const {
  Eigen::RowVector4d worth = Eigen::RowVector4d::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    const double cost = columns_[static_cast<std::size_t>(simplex.column[i])].cost;
    worth += cost * simplex.inverse.row(static_cast<Index>(i));
  }
  const Eigen::RowVector4d leaving = simplex.inverse.row(static_cast<Index>(face));
  const double on_face = -kThin * leaving.head<3>().norm();
  double least = std::numeric_limits<double>::infinity();
  int found = -1;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& c = columns_[i];
    const double share = leaving.dot(c.a);
    if (!(share < on_face)) continue;
    const double grows = (c.cost - worth.dot(c.a)) / -share;
    if (grows < least) {
      least = grows;
      found = static_cast<int>(i);
    }
  }
  return found;
}

}  // namespace

std::vector<Simplex> simplices_of(const MixPalette& palette, std::size_t most) {
  return Triangulation(columns_of(palette), most).made();
}

}  // namespace tristim::detail
