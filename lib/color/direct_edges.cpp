#include "lib/color/direct_edges.h"

#include "lib/color/edges.h"
#include "lib/color/matrix_text.h"
#include "tristim/color/lab.h"
#include "tristim/core/find.h"

namespace tristim::detail {
namespace {

// The rows of a matrix that takes white to white add up to 1, so that a grey leaves G alone.
Components rgb_to_rgb(const Components& c, const ModelContext& context) {
  const double red = c[0] - c[1];
  const double blue = c[2] - c[1];
  const Eigen::Matrix3d& m = context.matrix;
  return {c[1] + (m(0, 0) * red + m(0, 2) * blue), c[1] + (m(1, 0) * red + m(1, 2) * blue),
          c[1] + (m(2, 0) * red + m(2, 2) * blue), 0};
}

template <auto function>
Components from_rgb(const Components& c, const ModelContext& context) {
  return components_of(function(color_of<Rgb>(c), context.matrix));
}

template <auto function>
Components to_rgb(const Components& c, const ModelContext& context) {
  return components_of(function(color_of<decltype(first_of(function))>(c), white_xyz(context.white),
                                context.matrix));
}

struct DirectEdge {
  std::string_view from, to;
  Edge apply;
  std::string_view formula, source;
};

constexpr DirectEdge kDirectEdges[] = {
    {"linear", "linear", rgb_to_rgb, "RGB = G + M (R-G, 0, B-G), M = M2^-1 A M1 with adaptation A",
     "[Shoaff 2.2.4]"},
    {"linear", "lab", from_rgb<rgb_to_lab>,
     "X/Xn = G + (M (R-G, 0, B-G))/Xn and likewise Y and Z, then as lab: greys are neutral exactly",
     "[CIE15 8.2.1]"},
    {"linear", "luv", from_rgb<rgb_to_luv>,
     "XYZ = G XYZn + M (R-G, 0, B-G), then as luv: greys are neutral exactly", "[CIE15 8.2.2]"},
    {"lab", "linear", to_rgb<lab_to_rgb>,
     "RGB = Y + M (X - Y Xn, 0, Z - Y Zn) with XYZ as lab: neutral colours are greys exactly",
     "[CIE15 8.2.1]"},
    {"luv", "linear", to_rgb<luv_to_rgb>,
     "RGB = Y + M (X - Y Xn, 0, Z - Y Zn) with XYZ as luv: neutral colours are greys exactly",
     "[CIE15 8.2.2]"},
};

const DirectEdge* find_edge(const ColorModel& from, const ColorModel& to) {
  for (const DirectEdge& edge : kDirectEdges) {
    if (edge.from == from.name && edge.to == to.name) return &edge;
  }
  return nullptr;
}

}  // namespace

ConversionStep adaptation_step(const ModelContext& from, Chromaticity to, Adaptation method) {
  ConversionStep step{
      &color_models().front(), &color_models().front(), matrix_edge, from, true, {}, {}};
  step.context.matrix = adaptation_matrix(from.white, to, method);
  for (const AdaptationMethod& known : kAdaptations) {
    if (known.method != method) continue;
    step.formula = known.name;
    step.source = known.source;
  }
  return step;
}

void use_direct_edges(std::vector<ConversionStep>& steps, Adaptation adaptation) {
  const auto up_to_root = [](const ConversionStep& s) { return s.to->base.empty(); };
  const auto first = std::find_if(steps.begin(), steps.end(), up_to_root);
  if (first == steps.end() || first->from->base.empty()) return;
  auto last = first + 1;
  while (last != steps.end() && last->to->base.empty()) ++last;
  if (last == steps.end()) return;
  const DirectEdge* edge = find_edge(*first->from, *last->to);
  const bool one_white = first->context.white == last->context.white;
  if (edge == nullptr || !(one_white || adaptation != Adaptation::kNone)) return;

  ConversionStep direct{first->from, last->to,      edge->apply, first->context,
                        true,        edge->formula, edge->source};
  // The matrices of the steps in one; that of an edge of Lab or Luv is the identity.
  Eigen::Matrix3d matrix = first->context.matrix;
  for (auto step = first + 1; step <= last; ++step) {
    const bool is_identity = step->context.matrix == Eigen::Matrix3d::Identity();
    if (!is_identity) matrix = step->context.matrix * matrix;
  }
  const bool between_rgb = first->from->reads_primaries && last->to->reads_primaries;
  direct.context.matrix =
      between_rgb ? rgb_from_rgb(last->context.primaries, first->context.primaries, adaptation)
                  : matrix;
  *first = direct;
  steps.erase(first + 1, last + 1);
}

}  // namespace tristim::detail
