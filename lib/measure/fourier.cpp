#include "lib/measure/fourier.h"

#include <algorithm>
#include <unsupported/Eigen/FFT>

#include "lib/core/trigonometry.h"

namespace tristim::detail {
namespace {

using Complex = std::complex<double>;

constexpr int kBlock = 16;  // lines that share a plan and, as columns, cache lines

bool has_small_factors(int size) {
  for (const int factor : {2, 3, 5}) {
    while (size % factor == 0) size /= factor;
  }
  return size == 1;
}

int next_with_small_factors(int size) {
  while (!has_small_factors(size)) ++size;
  return size;
}

// Forward transforms of one length; a thread has a copy of its own. Eigen's take a time that grows
// with the square of the largest prime factor, so lengths with a factor above 5 become a
// convolution of a length without [Bluestein70].
class LineTransform {
 public:
  explicit LineTransform(int size) : size_(size), fast_(has_small_factors(size)) {
    fft_.SetFlag(Eigen::FFT<double>::Unscaled);
    if (!fast_) prepare_convolution();
    std::vector<Complex> line(static_cast<std::size_t>(size));
    (*this)(line.data());  // makes the tables, so that copies have them
  }

  void operator()(Complex* line) {
    if (size_ == 1) return;  // Eigen's does not know that
    if (fast_) {
      result_.resize(static_cast<std::size_t>(size_));
      fft_.fwd(result_.data(), line, size_);
      std::copy(result_.begin(), result_.end(), line);
    } else {
      convolve(line);
    }
  }

 private:
  // chirp k is exp(-i pi k^2 / n), so that x k = (x^2 + k^2 - (k - x)^2) / 2.
  void prepare_convolution() {
    const auto n = static_cast<std::size_t>(size_);
    const int length = next_with_small_factors(2 * size_ - 1);
    chirp_.resize(n);
    padded_.resize(static_cast<std::size_t>(length));
    kernel_.resize(padded_.size());
    result_.resize(padded_.size());
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t turns = k * k % (2 * n);
      const SineCosine angle =
          sine_cosine_deg(180 * static_cast<double>(turns) / static_cast<double>(n));
      chirp_[k] = {angle.cosine, -angle.sine};
      padded_[k] = std::conj(chirp_[k]);
      if (k > 0) padded_[padded_.size() - k] = padded_[k];
    }
    fft_.fwd(kernel_.data(), padded_.data(), length);
    for (Complex& k : kernel_) k /= length;
  }

  void convolve(Complex* line) {
    const auto length = static_cast<int>(padded_.size());
    std::fill(padded_.begin(), padded_.end(), Complex{});
    for (std::size_t k = 0; k < chirp_.size(); ++k) padded_[k] = product(line[k], chirp_[k]);
    fft_.fwd(result_.data(), padded_.data(), length);
    for (std::size_t k = 0; k < kernel_.size(); ++k) result_[k] = product(result_[k], kernel_[k]);
    fft_.inv(padded_.data(), result_.data(), length);
    for (std::size_t k = 0; k < chirp_.size(); ++k) line[k] = product(padded_[k], chirp_[k]);
  }

  // std::complex also minds infinities, which do not come here.
  static Complex product(Complex a, Complex b) noexcept {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
  }

  int size_;
  bool fast_;
  Eigen::FFT<double> fft_;
  std::vector<Complex> chirp_, kernel_, padded_, result_;
};

template <typename Body>
void for_blocks(int lines, Body&& body) {
  parallel_for_rows((lines + kBlock - 1) / kBlock, 0, [&](int block) {
    body(block * kBlock, std::min(kBlock, lines - block * kBlock));
  });
}

void transform_rows(ComplexPlane& plane) {
  const LineTransform prepared(plane.width);
  for_blocks(plane.height, [&](int first, int count) {
    LineTransform transform = prepared;
    for (int i = 0; i < count; ++i) transform(plane.row(first + i));
  });
}

void transform_columns(ComplexPlane& plane) {
  const LineTransform prepared(plane.height);
  for_blocks(plane.width, [&](int first, int count) {
    LineTransform transform = prepared;
    std::vector<Complex> columns(static_cast<std::size_t>(plane.height) * kBlock);
    const auto column = [&](int i) {
      return columns.data() + static_cast<std::ptrdiff_t>(i) * plane.height;
    };
    for (int y = 0; y < plane.height; ++y) {
      for (int i = 0; i < count; ++i) column(i)[y] = plane.row(y)[first + i];
    }
    for (int i = 0; i < count; ++i) transform(column(i));
    for (int y = 0; y < plane.height; ++y) {
      for (int i = 0; i < count; ++i) plane.row(y)[first + i] = column(i)[y];
    }
  });
}

}  // namespace

int fast_size(int size) noexcept { return next_with_small_factors(size); }

void forward_transform(ComplexPlane& plane) {
  transform_rows(plane);
  transform_columns(plane);
}

void inverse_transform(ComplexPlane& plane) {
  // The inverse is the transform of the conjugate, conjugated.
  for (Complex& v : plane.value) v = std::conj(v);
  forward_transform(plane);
  const auto count = static_cast<double>(plane.value.size());
  for (Complex& v : plane.value) v = std::conj(v) / count;
}

}  // namespace tristim::detail
