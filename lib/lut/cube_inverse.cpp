#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tristim/lut/invert.h"

namespace tristim {
namespace {

constexpr double kFar = 1e30;  // infinity has no nearest colour

struct Vector {
  double x, y, z;
};
Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator*(double k, Vector a) { return {k * a.x, k * a.y, k * a.z}; }
double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// The nearest place found so far.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();  // squared
  Vector place{};                                             // in steps of the cube
};

// A corner of a cell: what the cube makes of it, and where it is.
struct Corner {
  Vector color, place;
};

void offer(Nearest& nearest, Vector target, Vector color, Vector place) {
  const Vector off = color - target;
  const double distance = dot(off, off);
  if (distance < nearest.distance) nearest = {distance, place};
}

void offer_edge(Nearest& nearest, Vector target, const Corner& a, const Corner& b) {
  const Vector edge = b.color - a.color;
  const double length = dot(edge, edge);
  const double along = length > 0 ? dot(target - a.color, edge) / length : 0;
  const double t = std::clamp(along, 0.0, 1.0);
  offer(nearest, target, a.color + t * edge, a.place + t * (b.place - a.place));
}

// The point of the triangle's plane below the target, where that is inside; else its edges.
void offer_face(Nearest& nearest, Vector target, const Corner& a, const Corner& b,
                const Corner& c) {
  const Vector ab = b.color - a.color;
  const Vector ac = c.color - a.color;
  const Vector normal = cross(ab, ac);
  const double area = dot(normal, normal);
  const Vector at = target - a.color;
  const double u = area > 0 ? dot(cross(at, ac), normal) / area : -1;
  const double v = area > 0 ? dot(cross(ab, at), normal) / area : -1;
  if (u >= 0 && v >= 0 && u + v <= 1) {
    const Vector place = a.place + u * (b.place - a.place) + v * (c.place - a.place);
    return offer(nearest, target, a.color + u * ab + v * ac, place);
  }
  offer_edge(nearest, target, a, b);
  offer_edge(nearest, target, b, c);
  offer_edge(nearest, target, c, a);
}

void offer_tetrahedron(Nearest& nearest, Vector target, const std::array<Corner, 4>& p) {
  const Vector e1 = p[1].color - p[0].color;
  const Vector e2 = p[2].color - p[0].color;
  const Vector e3 = p[3].color - p[0].color;
  const Vector at = target - p[0].color;
  const double volume = dot(e1, cross(e2, e3));
  if (volume != 0) {
    const double u = dot(at, cross(e2, e3)) / volume;
    const double v = dot(e1, cross(at, e3)) / volume;
    const double w = dot(e1, cross(e2, at)) / volume;
    if (u >= 0 && v >= 0 && w >= 0 && u + v + w <= 1) {
      const Vector place = p[0].place + u * (p[1].place - p[0].place) +
                           v * (p[2].place - p[0].place) + w * (p[3].place - p[0].place);
      return offer(nearest, target, p[0].color + u * e1 + v * e2 + w * e3, place);
    }
  }
  offer_face(nearest, target, p[0], p[1], p[2]);
  offer_face(nearest, target, p[0], p[1], p[3]);
  offer_face(nearest, target, p[0], p[2], p[3]);
  offer_face(nearest, target, p[1], p[2], p[3]);
}

// What a block of cells makes, from low to high in each channel.
struct Box {
  std::array<float, 3> low, high;

  double distance(Vector target) const {  // squared
    const double t[] = {target.x, target.y, target.z};
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double off = std::max({low[c] - t[c], t[c] - high[c], 0.0});
      sum += off * off;
    }
    return sum;
  }
};

struct Layer {
  int edge;  // blocks along an axis; of the lowest layer cells
  std::vector<Box> boxes;

  std::size_t index(int x, int y, int z) const {
    const auto n = static_cast<std::size_t>(edge);
    return (static_cast<std::size_t>(z) * n + static_cast<std::size_t>(y)) * n +
           static_cast<std::size_t>(x);
  }
};

// The three axes in each order: one tetrahedron of a cell for each.
constexpr int kOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

}  // namespace

// Boxes about boxes about cells; each layer has half the blocks of the one below along an axis.
struct CubeInverse::Boxes {
  Lut3D cube;
  std::vector<Layer> layers;

  explicit Boxes(const Lut3D& lut) : cube(lut) {
    layers.push_back(cells());
    while (layers.back().edge > 1) layers.push_back(halved(layers.back()));
  }

  const float* color(int x, int y, int z) const {
    const auto n = static_cast<std::size_t>(cube.size);
    return cube.rgb.data() +
           3 * ((static_cast<std::size_t>(z) * n + static_cast<std::size_t>(y)) * n +
                static_cast<std::size_t>(x));
  }

  // Calls `visit(x, y, z)` on a layer's blocks in its order.
  template <typename Visit>
  static void each_block(int edge, Visit&& visit) {
    for (int z = 0; z < edge; ++z) {
      for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) visit(x, y, z);
      }
    }
  }

  static void widen(Box& box, const float* low, const float* high) {
    for (std::size_t c = 0; c < 3; ++c) {
      box.low[c] = std::min(box.low[c], low[c]);
      box.high[c] = std::max(box.high[c], high[c]);
    }
  }

  static Box empty() {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    return {{kInf, kInf, kInf}, {-kInf, -kInf, -kInf}};
  }

  Layer cells() const {
    Layer layer{cube.size - 1, {}};
    each_block(layer.edge, [&](int x, int y, int z) {
      Box box = empty();
      for (int i = 0; i < 8; ++i) {
        const float* corner = color(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
        widen(box, corner, corner);
      }
      layer.boxes.push_back(box);
    });
    return layer;
  }

  static Layer halved(const Layer& below) {
    Layer layer{(below.edge + 1) / 2, {}};
    each_block(layer.edge, [&](int x, int y, int z) {
      Box box = empty();
      each_child(below, x, y, z, [&](int cx, int cy, int cz) {
        const Box& child = below.boxes[below.index(cx, cy, cz)];
        widen(box, child.low.data(), child.high.data());
      });
      layer.boxes.push_back(box);
    });
    return layer;
  }

  template <typename Visit>
  static void each_child(const Layer& below, int x, int y, int z, Visit&& visit) {
    for (int i = 0; i < 8; ++i) {
      const int cx = 2 * x + (i & 1);
      const int cy = 2 * y + (i >> 1 & 1);
      const int cz = 2 * z + (i >> 2);
      if (std::max({cx, cy, cz}) < below.edge) visit(cx, cy, cz);
    }
  }

  void search_cell(Nearest& nearest, Vector target, int x, int y, int z) const {
    const auto corner = [&](int dx, int dy, int dz) -> Corner {
      const float* c = color(x + dx, y + dy, z + dz);
      return {
          {c[0], c[1], c[2]},
          {static_cast<double>(x + dx), static_cast<double>(y + dy), static_cast<double>(z + dz)}};
    };
    for (const auto& order : kOrders) {
      int d[3] = {0, 0, 0};
      std::array<Corner, 4> corners;
      corners[0] = corner(0, 0, 0);
      for (std::size_t i = 0; i < 3; ++i) {
        d[order[i]] = 1;
        corners[i + 1] = corner(d[0], d[1], d[2]);
      }
      offer_tetrahedron(nearest, target, corners);
    }
  }

  // The nearer blocks first, and none that is further than what was found.
  void search(Nearest& nearest, Vector target, std::size_t level, int x, int y, int z) const {
    if (level == 0) return search_cell(nearest, target, x, y, z);
    struct Child {
      double distance;
      int x, y, z;
    };
    std::array<Child, 8> children;
    std::size_t count = 0;
    const Layer& below = layers[level - 1];
    each_child(below, x, y, z, [&](int cx, int cy, int cz) {
      children[count++] = {below.boxes[below.index(cx, cy, cz)].distance(target), cx, cy, cz};
    });
    std::stable_sort(children.begin(), children.begin() + static_cast<std::ptrdiff_t>(count),
                     [](const Child& a, const Child& b) { return a.distance < b.distance; });
    for (std::size_t i = 0; i < count; ++i) {
      const Child& child = children[i];
      if (child.distance >= nearest.distance) return;
      search(nearest, target, level - 1, child.x, child.y, child.z);
    }
  }
};

CubeInverse::CubeInverse(const Lut3D& cube) {
  check({"", {cube}});
  boxes_ = std::make_shared<Boxes>(cube);
}

Rgb CubeInverse::operator()(Rgb rgb) const noexcept {
  const auto near = [](double x) { return std::clamp(x, -kFar, kFar); };
  const LutRange& range = boxes_->cube.range;
  if (std::isnan(rgb.r) || std::isnan(rgb.g) || std::isnan(rgb.b))
    return {range.low[0], range.low[1], range.low[2]};
  Nearest nearest;
  boxes_->search(nearest, {near(rgb.r), near(rgb.g), near(rgb.b)}, boxes_->layers.size() - 1, 0, 0,
                 0);
  const double last = boxes_->cube.size - 1;
  const auto input = [&](std::size_t c, double place) {
    return range.low[c] + (range.high[c] - range.low[c]) * (place / last);
  };
  return {input(0, nearest.place.x), input(1, nearest.place.y), input(2, nearest.place.z)};
}

}  // namespace tristim
