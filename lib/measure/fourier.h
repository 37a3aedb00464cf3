#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "lib/core/parallel.h"
#include "lib/measure/pair.h"

namespace tristim::detail {

/// A picture of complex numbers, row by row: two real pictures that a real and even filter treats
/// alike take one transform.
struct ComplexPlane {
  int width = 0;
  int height = 0;
  std::vector<std::complex<double>> value;

  ComplexPlane(int columns, int rows)
      : width(columns),
        height(rows),
        value(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

  std::complex<double>* row(int y) noexcept {
    return value.data() + static_cast<std::ptrdiff_t>(y) * width;
  }
  const std::complex<double>* row(int y) const noexcept {
    return value.data() + static_cast<std::ptrdiff_t>(y) * width;
  }
};

/// Discrete Fourier transforms in place, of any size; the inverse divides by the number of pixels.
void forward_transform(ComplexPlane& plane);
void inverse_transform(ComplexPlane& plane);

/// The next size without prime factors above 5, which are slow.
int fast_size(int size) noexcept;

/// The frequency of coefficient `i` of `size`, in cycles per sample without its sign.
inline double frequency_of(int i, int size) noexcept {
  return static_cast<double>(i <= size / 2 ? i : size - i) / size;
}

/// Whether a plane may become a little larger than asked for, to be transformed fast.
enum class PlaneSize { kExact, kFast };

/// A picture of `width` x `height` with `border` pixels more on each side, mirrored; sample(x, y)
/// is a pixel.
template <typename Sample>
ComplexPlane mirrored_plane(int width, int height, int border, PlaneSize size, Sample&& sample) {
  const auto side = [&](int pixels) {
    const int exact = pixels + 2 * border;
    return size == PlaneSize::kFast ? fast_size(exact) : exact;
  };
  ComplexPlane plane(side(width), side(height));
  parallel_for_rows(plane.height, 0, [&](int y) {
    const int from = mirrored(y - border, height);
    std::complex<double>* row = plane.row(y);
    for (int x = 0; x < plane.width; ++x) row[x] = sample(mirrored(x - border, width), from);
  });
  return plane;
}

/// A transformed picture times gain(x, y), a real and even function of the coefficient's place
/// that is asked for one quarter.
template <typename Gain>
void multiply(ComplexPlane& plane, Gain&& gain) {
  parallel_for_rows(plane.height / 2 + 1, 0, [&](int y) {
    const int opposite = (plane.height - y) % plane.height;
    std::complex<double>* rows[] = {plane.row(y), plane.row(opposite)};
    const int row_count = opposite == y ? 1 : 2;
    for (int x = 0; x <= plane.width / 2; ++x) {
      const double g = gain(x, y);
      const int mirror = (plane.width - x) % plane.width;
      for (int r = 0; r < row_count; ++r) {
        rows[r][x] *= g;
        if (mirror != x) rows[r][mirror] *= g;
      }
    }
  });
}

}  // namespace tristim::detail
