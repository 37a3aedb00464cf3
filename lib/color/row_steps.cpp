#include "lib/color/row_steps.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/color/oklab_matrices.h"
#include "lib/color/row_curves.h"
#include "tristim/color/yiq.h"
#include "tristim/core/find.h"

namespace tristim::detail {
namespace {

// The steps so far.
class Builder {
 public:
  explicit Builder(const RowKernels& kernels) : kernels_(kernels) {}

  const RowKernels& kernels() const noexcept { return kernels_; }
  bool ends_with_edge() const noexcept { return !steps_.empty() && steps_.back().edge != nullptr; }

  void add(RowKernel kernel, const RowParameters& parameters = {}) {
    steps_.push_back({kernel, parameters});
  }

  void add_edge(const ConversionStep& step) {
    steps_.push_back({{}, {}, step.apply, step.context});
  }

  /// Times `m`, in one with a matrix before it.
  void add_matrix(Eigen::Matrix3d m) {
    if (!steps_.empty() && steps_.back().kernel == kernels_.matrix) {
      m = m * Eigen::Map<const RowMajor>(steps_.back().parameters.data());
      steps_.pop_back();
    }
    RowParameters p{};
    Eigen::Map<RowMajor>(p.data()) = m;
    add(kernels_.matrix, p);
  }

  void add_oklab(const RowKernel& kernel, const Eigen::Matrix3d& before,
                 const Eigen::Matrix3d& after) {
    add_matrix(before);
    steps_.back().kernel = kernel;
    RowParameters& p = steps_.back().parameters;
    Eigen::Map<RowMajor>(p.data() + 9) = after;
    std::transform(p.begin() + 9, p.begin() + 18, p.begin() + 18,
                   [](double x) { return std::round(x * 4096) / 4096; });
  }

  /// w G + a (R - G) + b (B - G) with a row of `m`'s outer columns each, times `red` and `blue`.
  void add_grey_matrix(const Eigen::Matrix3d& m, const Eigen::Vector3d& grey, double red = 1,
                       double blue = 1) {
    RowParameters p{};
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(3 * i);
      p[at] = grey[i];
      p[at + 1] = m(i, 0) * red;
      p[at + 2] = m(i, 2) * blue;
    }
    add(kernels_.grey_matrix, p);
  }

  /// The steps, those that have one kernel together in one.
  std::vector<RowStep> take();

 private:
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

  const RowKernels& kernels_;
  std::vector<RowStep> steps_;
};

// Kernels that do two steps.
struct Pair {
  RowKernel RowKernels::*first;
  RowKernel RowKernels::*second;
  RowKernel RowKernels::*both;
};

constexpr Pair kPairs[] = {
    {&RowKernels::matrix, &RowKernels::lab_from_ratios, &RowKernels::lab_of_matrix},
    {&RowKernels::grey_matrix, &RowKernels::lab_from_ratios, &RowKernels::lab_of_grey_matrix},
    {&RowKernels::matrix, &RowKernels::luv_from_ratios, &RowKernels::luv_of_matrix},
    {&RowKernels::grey_matrix, &RowKernels::luv_from_ratios, &RowKernels::luv_of_grey_matrix},
    {&RowKernels::ratios_from_lab, &RowKernels::matrix, &RowKernels::matrix_of_lab},
    {&RowKernels::ratios_from_lab, &RowKernels::grey_matrix, &RowKernels::grey_matrix_of_lab},
    {&RowKernels::ratios_from_luv, &RowKernels::matrix, &RowKernels::matrix_of_luv},
    {&RowKernels::ratios_from_luv, &RowKernels::grey_matrix, &RowKernels::grey_matrix_of_luv},
};

constexpr std::size_t kFirstNumbers = 9;

std::vector<RowStep> Builder::take() {
  std::vector<RowStep> steps;
  for (RowStep& step : steps_) {
    const Pair* pair = nullptr;
    for (const Pair& known : kPairs) {
      if (!steps.empty() && steps.back().kernel == kernels_.*known.first &&
          step.kernel == kernels_.*known.second) {
        pair = &known;
      }
    }
    if (pair == nullptr) {
      steps.push_back(std::move(step));
      continue;
    }
    steps.back().kernel = kernels_.*pair->both;
    std::copy_n(step.parameters.begin(), kFirstNumbers,
                steps.back().parameters.begin() + kFirstNumbers);
  }
  return steps;
}

const Eigen::Vector3d kOnes = Eigen::Vector3d::Ones();

Eigen::Vector3d white_of(const ConversionStep& step) {
  const Xyz white = white_xyz(step.context.white);
  return {white.x, white.y, white.z};
}

RowParameters white_parameters(const ConversionStep& step) {
  const Xyz white = white_xyz(step.context.white);
  return {white.x, white.z};
}

void matrix(Builder& rows, const ConversionStep& step) { rows.add_matrix(step.context.matrix); }

void rgb_to_rgb(Builder& rows, const ConversionStep& step) {
  rows.add_grey_matrix(step.context.matrix, kOnes);
}

bool is_identity(const RgbCurve& curve) {
  return curve.function.name == "linear" || (curve.is_exponent() && curve.gamma == 1);
}

void decode(Builder& rows, const ConversionStep& step) {
  if (is_identity(step.context.curve)) return;
  const auto curve = curve_kernels(step.context.curve, rows.kernels());
  if (curve) return rows.add(curve->decode, curve->parameters);
  rows.add_edge(step);
}

void encode(Builder& rows, const ConversionStep& step) {
  if (is_identity(step.context.curve)) return;
  const auto curve = curve_kernels(step.context.curve, rows.kernels());
  if (curve) return rows.add(curve->encode, curve->parameters);
  rows.add_edge(step);
}

// The XYZ of Lab and Luv are ratios to the white in rows.
void to_ratios(Builder& rows, const ConversionStep& step) {
  rows.add_matrix(white_of(step).cwiseInverse().asDiagonal());
}

void from_ratios(Builder& rows, const ConversionStep& step) {
  rows.add_matrix(white_of(step).asDiagonal());
}

// Linear RGB to X/Xw = G + (Mr (R - G) + Mb (B - G))/Xw, where Xw is the sum of the row.
void rgb_to_ratios(Builder& rows, const ConversionStep& step) {
  const Eigen::Vector3d white = step.context.matrix.rowwise().sum();
  rows.add_grey_matrix(white.cwiseInverse().asDiagonal() * step.context.matrix, kOnes);
}

void rgb_from_ratios(Builder& rows, const ConversionStep& step) {
  const Eigen::Vector3d white = white_of(step);
  rows.add_grey_matrix(step.context.matrix, kOnes, white.x(), white.z());
}

template <auto before, RowKernel RowKernels::*kernel>
void into_lightness(Builder& rows, const ConversionStep& step) {
  before(rows, step);
  rows.add(rows.kernels().*kernel, white_parameters(step));
}

template <RowKernel RowKernels::*kernel, auto after>
void out_of_lightness(Builder& rows, const ConversionStep& step) {
  rows.add(rows.kernels().*kernel, white_parameters(step));
  after(rows, step);
}

template <RowKernel RowKernels::*kernel>
void plain(Builder& rows, const ConversionStep& /*step*/) {
  rows.add(rows.kernels().*kernel);
}

template <RowKernel RowKernels::*first, RowKernel RowKernels::*second>
void two(Builder& rows, const ConversionStep& /*step*/) {
  rows.add(rows.kernels().*first);
  rows.add(rows.kernels().*second);
}

Eigen::Matrix3d matrix_of(const double (&m)[3][3]) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&m[0][0]);
}

void to_oklab(Builder& rows, const ConversionStep& /*step*/) {
  rows.add_oklab(rows.kernels().oklab, matrix_of(kLmsFromSrgb), matrix_of(kLabFromRoots));
}

void from_oklab(Builder& rows, const ConversionStep& /*step*/) {
  rows.add_oklab(rows.kernels().linear_of_oklab, matrix_of(kLabFromRoots).inverse(),
                 matrix_of(kLmsFromSrgb).inverse());
}

template <std::size_t system>
void to_yiq(Builder& rows, const ConversionStep& /*step*/) {
  rows.add_grey_matrix(yiq_from_rgb(kYiqSystems[system]), {1, 0, 0});
}

template <std::size_t system>
void from_yiq(Builder& rows, const ConversionStep& /*step*/) {
  rows.add_matrix(rgb_from_yiq(kYiqSystems[system]));
}

// The edges that have kernels; to_base and from_base of models, and direct ones.
struct FastEdge {
  std::string_view from, to;
  void (*add)(Builder& rows, const ConversionStep& step);
};

using K = RowKernels;

constexpr FastEdge kFastEdges[] = {
    {"linear", "xyz", matrix},
    {"xyz", "linear", matrix},
    {"xyz", "xyz", matrix},
    {"linear", "linear", rgb_to_rgb},
    {"rgb", "linear", decode},
    {"linear", "rgb", encode},
    {"rgb", "cmy", plain<&K::complement>},
    {"cmy", "rgb", plain<&K::complement>},
    {"rgb", "hsv", plain<&K::hsv_from_rgb>},
    {"hsv", "rgb", plain<&K::rgb_from_hsv>},
    {"rgb", "hls", plain<&K::hls_from_rgb>},
    {"hls", "rgb", plain<&K::rgb_from_hls>},
    {"rgb", "hsl", two<&K::hls_from_rgb, &K::swap_last>},
    {"hsl", "rgb", two<&K::swap_last, &K::rgb_from_hls>},
    {"rgb", "yiq:smpte170m", to_yiq<0>},
    {"yiq:smpte170m", "rgb", from_yiq<0>},
    {"rgb", "yiq:fcc1953", to_yiq<1>},
    {"yiq:fcc1953", "rgb", from_yiq<1>},
    {"rgb", "yiq:notes", to_yiq<2>},
    {"yiq:notes", "rgb", from_yiq<2>},
    {"rgb", "yiq:ntsc-phosphor", to_yiq<3>},
    {"yiq:ntsc-phosphor", "rgb", from_yiq<3>},
    {"xyz", "lab", into_lightness<to_ratios, &K::lab_from_ratios>},
    {"lab", "xyz", out_of_lightness<&K::ratios_from_lab, from_ratios>},
    {"linear", "lab", into_lightness<rgb_to_ratios, &K::lab_from_ratios>},
    {"lab", "linear", out_of_lightness<&K::ratios_from_lab, rgb_from_ratios>},
    {"xyz", "luv", into_lightness<to_ratios, &K::luv_from_ratios>},
    {"luv", "xyz", out_of_lightness<&K::ratios_from_luv, from_ratios>},
    {"linear", "luv", into_lightness<rgb_to_ratios, &K::luv_from_ratios>},
    {"luv", "linear", out_of_lightness<&K::ratios_from_luv, rgb_from_ratios>},
    {"linear", "oklab", to_oklab},
    {"oklab", "linear", from_oklab},
};

const FastEdge* find_edge(const ConversionStep& step) {
  for (const FastEdge& edge : kFastEdges) {
    if (edge.from == step.from->name && edge.to == step.to->name) return &edge;
  }
  return nullptr;
}

}  // namespace

std::vector<RowStep> row_steps(const ColorConversion& conversion, const RowKernels& kernels) {
  Builder rows(kernels);
  for (const ConversionStep& step : conversion.steps()) {
    const FastEdge* edge = find_edge(step);
    if (edge != nullptr) {
      edge->add(rows, step);
    } else {
      rows.add_edge(step);
    }
  }
  // The kernels of HSV and HLS see to it themselves.
  const int hue = conversion.to().hue_turn == 360 ? conversion.to().hue : -1;
  if (hue >= 0 && rows.ends_with_edge()) rows.add(kernels.hue, {double(hue)});
  return rows.take();
}

}  // namespace tristim::detail
