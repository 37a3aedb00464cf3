#include "lib/color/envelope.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace tristim::detail {
namespace {

constexpr std::size_t kFew = 16;           // functions of a leaf that needs no further division
constexpr double kSmallest = 1.0 / 128;    // side of the smallest leaf
constexpr std::size_t kMost = UINT16_MAX;  // functions of a leaf

PlanePoint centre_of(const Polygon& cell) {
  PlanePoint sum;
  for (const PlanePoint& p : cell) sum = {sum.x + p.x, sum.y + p.y};
  const auto count = static_cast<double>(cell.size());
  return {sum.x / count, sum.y / count};
}

using Heights = std::vector<double>;  // of a function at several places

void measure(const LinearFunction& function, const Polygon& places, Heights& heights) {
  heights.clear();
  for (const PlanePoint& p : places) heights.push_back(function.at(p.x, p.y));
}

// The heights of the function that is the greatest at `place`.
Heights greatest_at(PlanePoint place, const Polygon& places,
                    std::span<const LinearFunction> functions) {
  Heights heights;
  measure(*std::max_element(functions.begin(), functions.end(),
                            [&](const LinearFunction& f, const LinearFunction& g) {
                              return f.at(place.x, place.y) < g.at(place.x, place.y);
                            }),
          places, heights);
  return heights;
}

// Whether a function rises above all of the greatest of a triangle's corners somewhere in one of
// the triangles from the centre, the last place, to an edge of the cell.
bool rises(const Heights& heights, const std::vector<Heights>& greatest) {
  const std::size_t centre = heights.size() - 1;
  for (std::size_t i = 0; i < centre; ++i) {
    const std::size_t next = i + 1 < centre ? i + 1 : 0;
    const auto below = [&](const Heights& top) {
      return heights[centre] <= top[centre] && heights[i] <= top[i] && heights[next] <= top[next];
    };
    if (!below(greatest[centre]) && !below(greatest[i]) && !below(greatest[next])) return true;
  }
  return false;
}

// The functions that may be the greatest somewhere in a convex cell, and maybe a few more.
std::vector<LinearFunction> greatest_in(const Polygon& cell,
                                        std::span<const LinearFunction> functions) {
  if (cell.empty() || functions.empty()) return {};
  Polygon places = cell;
  places.push_back(centre_of(cell));
  std::vector<Heights> greatest;
  for (const PlanePoint& place : places) {
    greatest.push_back(greatest_at(place, places, functions));
  }
  std::vector<LinearFunction> kept;
  Heights heights;
  for (const LinearFunction& f : functions) {
    measure(f, places, heights);
    if (rises(heights, greatest) ||
        std::find(greatest.begin(), greatest.end(), heights) != greatest.end()) {
      kept.push_back(f);
    }
  }
  return kept;
}

}  // namespace

Envelope::Envelope(std::span<const LinearFunction> functions, Polygon domain)
    : domain_(std::move(domain)), nodes_(1) {
  divide(0, {0, 0}, 1, functions);
  functions_.shrink_to_fit();
}

void Envelope::divide(std::size_t node, PlanePoint corner, double size,
                      std::span<const LinearFunction> functions) {
  const auto [x, y] = corner;
  const Polygon square{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  const Polygon cell = convex_intersection(square, domain_);
  const std::vector<LinearFunction> kept = greatest_in(cell, functions);
  if (kept.size() <= kFew || (size <= kSmallest && kept.size() <= kMost)) {
    nodes_[node] = {.first = static_cast<std::uint32_t>(functions_.size()),
                    .count = static_cast<std::uint16_t>(kept.size()),
                    .side = cell.empty()     ? Side::kOutside
                            : cell == square ? Side::kInside
                                             : Side::kCut};
    functions_.insert(functions_.end(), kept.begin(), kept.end());
    return;
  }
  const std::size_t first = nodes_.size();
  nodes_[node] = {.first = static_cast<std::uint32_t>(first), .branch = true};
  nodes_.resize(first + 4);
  const double half = size / 2;
  divide(first, corner, half, kept);
  divide(first + 1, {x + half, y}, half, kept);
  divide(first + 2, {x, y + half}, half, kept);
  divide(first + 3, {x + half, y + half}, half, kept);
}

const Envelope::Node& Envelope::leaf(double x, double y) const noexcept {
  const Node* node = nodes_.data();
  PlanePoint middle{0.5, 0.5};
  for (double quarter = 0.25; node->branch; quarter /= 2) {
    const bool right = x >= middle.x;
    const bool upper = y >= middle.y;
    middle.x += right ? quarter : -quarter;
    middle.y += upper ? quarter : -quarter;
    node = &nodes_[node->first + (right ? 1U : 0U) + (upper ? 2U : 0U)];
  }
  return *node;
}

double Envelope::at(double x, double y) const noexcept {
  const Node& node = leaf(x, y);
  if (node.side == Side::kOutside ||
      (node.side == Side::kCut && !convex_contains(domain_, {x, y}))) {
    return std::numeric_limits<double>::infinity();
  }
  const LinearFunction* f = functions_.data() + node.first;
  double greatest[4] = {};  // four at a time: one waits for the one before
  std::uint32_t i = 0;
  for (; i + 4 <= node.count; i += 4) {
    for (std::uint32_t k = 0; k < 4; ++k) greatest[k] = std::max(greatest[k], f[i + k].at(x, y));
  }
  for (; i < node.count; ++i) greatest[0] = std::max(greatest[0], f[i].at(x, y));
  return std::max({greatest[0], greatest[1], greatest[2], greatest[3]});
}

}  // namespace tristim::detail
