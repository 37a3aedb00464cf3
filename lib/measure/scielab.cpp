#include <Eigen/LU>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>

#include "lib/core/fast_exp.h"
#include "lib/measure/fourier.h"
#include "lib/measure/statistics.h"
#include "tristim/color/primaries.h"
#include "tristim/color/rows.h"
#include "tristim/measure/vision.h"

namespace tristim {
namespace {

// Of a kernel k exp(-r^2 / s^2), made to a sum of 1.
struct Gaussian {
  double weight;
  double spread_deg;
};

// Blur of an opponent channel: a weighted mean of Gaussians [ZhangWandell96 table 1].
struct Blur {
  std::array<Gaussian, 3> terms;  // the last of weight 0 where there are two
};

constexpr std::array<Blur, 3> kBlurs{{
    {{{{0.921, 0.0283}, {0.105, 0.133}, {-0.108, 4.336}}}},  // light
    {{{{0.531, 0.0392}, {0.330, 0.494}, {0, 0}}}},           // red-green
    {{{{0.488, 0.0536}, {0.371, 0.386}, {0, 0}}}},           // blue-yellow
}};

// Opponent channels of XYZ [ZhangWandell96 eq 1].
Eigen::Matrix3d opponent_from_xyz() {
  return (Eigen::Matrix3d() << 0.279, 0.72, -0.107, -0.449, 0.29, -0.077, 0.086, -0.59, 0.501)
      .finished();
}

// exp(-(pi s f)^2), the transform of a Gaussian, for each frequency of a line.
std::vector<double> responses(double spread_samples, int size) {
  std::vector<double> all(static_cast<std::size_t>(size / 2 + 1));
  for (int i = 0; i <= size / 2; ++i) {
    const double t = 3.14159265358979323846 * spread_samples * detail::frequency_of(i, size);
    all[static_cast<std::size_t>(i)] = detail::fast_exp(-t * t);
  }
  return all;
}

void blur(detail::ComplexPlane& plane, const Blur& blur, double samples_per_degree) {
  double sum = 0;
  for (const Gaussian& term : blur.terms) sum += term.weight;
  std::array<std::vector<double>, 3> across;
  std::array<std::vector<double>, 3> down;
  for (std::size_t i = 0; i < blur.terms.size(); ++i) {
    const double spread = blur.terms[i].spread_deg * samples_per_degree;
    across[i] = responses(spread, plane.width);
    down[i] = responses(spread, plane.height);
    for (double& v : across[i]) v *= blur.terms[i].weight / sum;
  }
  detail::forward_transform(plane);
  detail::multiply(plane, [&](int x, int y) {
    const auto i = static_cast<std::size_t>(x);
    const auto j = static_cast<std::size_t>(y);
    return across[0][i] * down[0][j] + across[1][i] * down[1][j] + across[2][i] * down[2][j];
  });
  detail::inverse_transform(plane);
}

// One opponent channel of both pictures, blurred: the reference in the real part.
detail::ComplexPlane blurred_channel(const PicturePair& pictures, std::size_t channel, int border,
                                     double samples_per_degree) {
  const Eigen::Matrix3d opponent = opponent_from_xyz() * xyz_from_rgb(Primaries{});
  const Eigen::Vector3d weights = opponent.row(static_cast<Eigen::Index>(channel));
  const auto value = [&](const float* p) {
    return weights[0] * double{p[0]} + weights[1] * double{p[1]} + weights[2] * double{p[2]};
  };
  detail::ComplexPlane plane =
      detail::mirrored_plane(pictures.reference.width, pictures.reference.height, border,
                             detail::PlaneSize::kExact, [&](int x, int y) {
                               return std::complex<double>(value(pictures.reference.pixel(x, y)),
                                                           value(pictures.result.pixel(x, y)));
                             });
  blur(plane, kBlurs[channel], samples_per_degree);
  return plane;
}

// Blurred opponent colours of a row to L*a*b*. XYZ below 0, which no light has, is 0.
void lab_row(std::span<float> opponent) {
  static const RowConversion to_lab(parse_model("xyz", "measure"), parse_model("lab", "measure"),
                                    Adaptation::kNone);
  static const Eigen::Matrix3d xyz_from_opponent = opponent_from_xyz().inverse();
  for (std::size_t i = 0; i < opponent.size(); i += 3) {
    const Eigen::Vector3d o(opponent[i], opponent[i + 1], opponent[i + 2]);
    const Eigen::Vector3f xyz = (xyz_from_opponent * o).cwiseMax(0).cast<float>();
    for (std::size_t c = 0; c < 3; ++c) opponent[i + c] = xyz[static_cast<Eigen::Index>(c)];
  }
  to_lab(opponent, 3, opponent, 3);
}

}  // namespace

VisibleDifference scielab(const PicturePair& pictures, double samples_per_degree) {
  detail::check_pair(pictures);
  if (!(samples_per_degree > 0)) {
    throw std::invalid_argument("samples per degree are not above 0");
  }
  const int width = pictures.reference.width;
  const int height = pictures.reference.height;
  const int border = static_cast<int>(std::min(samples_per_degree, std::min(width, height) / 2.0));
  // Both pictures interleaved: the reference's pixels of a row, then the result's.
  Image opponent(2 * width, height, 3);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const detail::ComplexPlane plane =
        blurred_channel(pictures, channel, border, samples_per_degree);
    for (int y = 0; y < height; ++y) {
      const std::complex<double>* from = plane.row(y + border) + border;
      float* reference = opponent.view().pixel(0, y) + channel;
      float* result = opponent.view().pixel(width, y) + channel;
      for (std::ptrdiff_t x = 0; x < width; ++x) {
        reference[3 * x] = static_cast<float>(from[x].real());
        result[3 * x] = static_cast<float>(from[x].imag());
      }
    }
  }

  std::vector<float> difference(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  detail::parallel_for_rows(height, 0, [&](int y) {
    lab_row(opponent.view().row(y));
    const float* a = opponent.view().pixel(0, y);
    const float* b = opponent.view().pixel(width, y);
    float* d = difference.data() + static_cast<std::ptrdiff_t>(y) * width;
    for (int x = 0; x < width; ++x, a += 3, b += 3) {
      d[x] = Eigen::Vector3f(b[0] - a[0], b[1] - a[1], b[2] - a[2]).norm();
    }
  });
  VisibleDifference figures;
  for (const float d : difference) figures.mean += double{d};
  figures.mean /= static_cast<double>(difference.size());
  figures.p95 = detail::percentile(difference, 0.95);
  return figures;
}

}  // namespace tristim
