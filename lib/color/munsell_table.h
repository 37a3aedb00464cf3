#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "tristim/color/munsell.h"

namespace tristim::detail {

// Column i of the renotation is hue 2.5 (i + 1), ring j is chroma 2 (j + 1).
constexpr int kMunsellColumns = 40;
constexpr int kMunsellRings = 25;
constexpr double kMunsellHueStep = 2.5;
constexpr double kMunsellChromaStep = 2;

/// x and y of illuminant C, the centre of every ovoid.
inline Eigen::Vector2d munsell_center() noexcept { return {kMunsellWhite.x, kMunsellWhite.y}; }

/// A point of a curve in the chromaticity diagram and its derivative by the parameter.
struct CurvePoint {
  Eigen::Vector2d position, slope;
};

/// The renotation at one value: ovoids of equal chroma around illuminant C. Columns are 0 to 40,
/// which is column 0 again.
class MunsellPlane {
 public:
  double value = 0, luminance = 0;

  /// How many rings of the table column `column` has. Some more may follow as a support, where the
  /// planes beside this one have them.
  int rings(int column) const noexcept { return rings_[static_cast<std::size_t>(column)]; }

  /// How many of them are real colours, inside of the MacAdam limits.
  int real_rings(int column) const noexcept { return real_[static_cast<std::size_t>(column)]; }

  /// x and y of a cell that exists.
  const Eigen::Vector2d& node(int column, int ring) const noexcept {
    return at(column, ring).position;
  }

  /// Ring `ring` at `u` of the way, [0, 1], from a column below 40 to the next; both have it, or u
  /// is 0. Goes on outside, [-1, 2].
  CurvePoint arc(int column, int ring, double u) const noexcept;

  /// A column in whose direction `offset` from the centre lies, as the first ring has it, or one
  /// near it.
  int column_towards(const Eigen::Vector2d& offset) const noexcept;

  /// Builds the plane: cells ring by ring, then supports of columns up to `count` rings, then what
  /// lies between them.
  void set_node(int column, int ring, const Eigen::Vector2d& position, bool real);
  void support(int column, int count);
  void connect();

 private:
  struct Node {
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    Eigen::Vector2d direction = Eigen::Vector2d::Zero();  // from illuminant C, of length 1
    double radius = 0, turn = 0;  // about illuminant C; the turn to the next column, in radians
    bool radial = false;          // whether the arc to the next column is drawn radially
  };

  const Node& at(int column, int ring) const noexcept {
    return nodes_[static_cast<std::size_t>(column)][static_cast<std::size_t>(ring)];
  }
  Node& at(int column, int ring) noexcept {
    return nodes_[static_cast<std::size_t>(column)][static_cast<std::size_t>(ring)];
  }

  std::array<std::array<Node, kMunsellRings>, kMunsellColumns + 1> nodes_;
  std::array<int, kMunsellColumns + 1> rings_{};
  std::array<int, kMunsellColumns + 1> supported_{};
  std::array<int, kMunsellColumns + 1> real_{};
  static constexpr int kSpokes = 8;
  std::array<Eigen::Vector2d, kSpokes> spokes_;  // directions of every fifth column
};

/// Every plane by rising value, from luts/munsell_renotation.csv; made at the first call.
std::span<const MunsellPlane> munsell_planes();

}  // namespace tristim::detail
