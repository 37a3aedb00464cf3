#include "tristim/render/shapes.h"

#include <array>

#include "lib/render/shape_makers.h"

namespace tristim {
namespace {

constexpr double kLeast = 1e-6;
constexpr double kMost = 1e6;
constexpr double kMostSteps = 2048;

constexpr ShapeParameter length(std::string_view name, double preset) {
  return {name, preset, kLeast, kMost};
}
constexpr ShapeParameter count(std::string_view name, double preset, double least) {
  return {name, preset, least, kMostSteps, true};
}

constexpr std::array kSphere{length("radius", 1), count("columns", 64, 3), count("rows", 32, 2)};
constexpr std::array kIcosphere{length("radius", 1), ShapeParameter{"divisions", 4, 0, 8, true}};
constexpr std::array kCylinder{length("radius", 1), length("height", 2), count("columns", 64, 3),
                               count("rows", 1, 1)};
constexpr std::array kCone{length("radius", 1), length("height", 2), count("columns", 64, 3),
                           count("rows", 8, 1)};
constexpr std::array kParaboloid{length("radius", 1), length("height", 1), count("columns", 64, 3),
                                 count("rows", 16, 1)};
constexpr std::array kTorus{length("radius", 1), length("tube", 0.4), count("columns", 96, 3),
                            count("rows", 32, 3)};
constexpr std::array kCap{length("radius", 0.9), ShapeParameter{"skirt", 0.25, 0, kMost},
                          count("columns", 64, 3), count("rows", 16, 1)};
constexpr std::array kBox{length("width", 1), length("height", 1), length("depth", 1)};
constexpr std::array kPlane{length("width", 10), length("depth", 10), count("columns", 1, 1),
                            count("rows", 1, 1)};
constexpr std::array kPyramid{length("bottom", 4), length("top", 2), length("height", 1)};
constexpr std::array kCorrugation{length("width", 4), length("depth", 2), length("height", 0.25),
                                  ShapeParameter{"ridges", 8, 1, 1024, true}};
constexpr std::array kTeapot{ShapeParameter{"steps", 12, 1, 256, true}};

constexpr std::array kShapes{
    Shape{"sphere", "poles up and down, quads between", kSphere, detail::sphere},
    Shape{"icosphere", "an icosahedron, each triangle divided into four again and again",
          kIcosphere, detail::icosphere},
    Shape{"cylinder", "with its ends", kCylinder, detail::cylinder},
    Shape{"cone", "with its bottom", kCone, detail::cone},
    Shape{"paraboloid", "with its bottom", kParaboloid, detail::paraboloid},
    Shape{"torus", "lying", kTorus, detail::torus},
    Shape{"cap", "the bottle cap of [FisherWoo]'s third figure, with a skirt", kCap, detail::cap},
    Shape{"box", "flat faces", kBox, detail::box},
    Shape{"plane", "facing up", kPlane, detail::plane},
    Shape{"pyramid", "truncated, as [Shoaff 4.3] averages its normals", kPyramid, detail::pyramid},
    Shape{"corrugation", "folds along z", kCorrugation, detail::corrugation},
    Shape{"teapot", "32 Bezier patches of `steps` x `steps` quads [Newell75, Crow87]", kTeapot,
          detail::teapot},
};

}  // namespace

std::span<const Shape> shapes() noexcept { return kShapes; }

PolygonModel make_shape(const Shape& shape) {
  std::vector<double> values;
  for (const ShapeParameter& parameter : shape.parameters) values.push_back(parameter.preset);
  return shape.make(values);
}

}  // namespace tristim
