#include "tristim/lut/rows.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lib/core/parallel.h"
#include "lib/lut/cube_kernels.h"
#include "lib/lut/curve_rows.h"

namespace tristim {
namespace {

constexpr std::size_t kChunk = 512;  // pixels whose floats, before and after a step, stay in L1

struct CubeRows {
  detail::CubeTable table;
  detail::CubeRow row;
  void operator()(const float* in, float* out, std::size_t count) const {
    row(table, in, out, count);
  }
};

struct MatrixRow {
  std::array<double, 9> m;
  std::array<double, 3> offset;
  void operator()(const float* in, float* out, std::size_t count) const noexcept {
    for (std::size_t i = 0; i < 3 * count; i += 3) {
      const double r = in[i];
      const double g = in[i + 1];
      const double b = in[i + 2];
      for (std::size_t c = 0; c < 3; ++c) {
        out[i + c] =
            static_cast<float>(m[3 * c] * r + m[3 * c + 1] * g + m[3 * c + 2] * b + offset[c]);
      }
    }
  }
};

using RowStep = std::variant<CubeRows, detail::CurveRow, detail::PointsRow, MatrixRow>;

detail::CubeRow row_of(const LutInterpolation& interpolation) {
  const detail::CubeKernels& kernels = detail::cube_kernels();
  return interpolation.evaluate == trilinear ? kernels.trilinear : kernels.tetrahedral;
}

RowStep row_step(const Lut1D& step, const LutInterpolation&) { return detail::CurveRow(step); }
RowStep row_step(const LutPoints& step, const LutInterpolation&) { return detail::PointsRow(step); }
RowStep row_step(const Lut3D& step, const LutInterpolation& interpolation) {
  return CubeRows{detail::CubeTable(step), row_of(interpolation)};
}
RowStep row_step(const LutMatrix& step, const LutInterpolation&) {
  MatrixRow row{};
  for (int i = 0; i < 9; ++i) row.m[static_cast<std::size_t>(i)] = step.matrix(i / 3, i % 3);
  for (int i = 0; i < 3; ++i) row.offset[static_cast<std::size_t>(i)] = step.offset[i];
  return row;
}

// `count` pixels from the first three of `from_channels` floats to those of `to_channels`.
void copy_colors(const float* from, std::size_t from_channels, float* to, std::size_t to_channels,
                 std::size_t count) {
  for (std::size_t i = 0; i < count; ++i, from += from_channels, to += to_channels) {
    std::copy(from, from + 3, to);
  }
}

}  // namespace

struct LutRows::Program {
  std::vector<RowStep> steps;

  // Pixels of three channels.
  void run(const float* in, float* out, std::size_t count) const {
    std::array<float, 3 * kChunk> buffers[2];
    const float* from = in;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      float* to = i + 1 == steps.size() ? out : buffers[i % 2].data();
      std::visit([&](const auto& step) { step(from, to, count); }, steps[i]);
      from = to;
    }
  }
};

LutRows::LutRows(const Lut& lut, const LutInterpolation& interpolation) {
  check(lut);
  auto program = std::make_shared<Program>();
  for (const LutStep& step : lut.steps) {
    program->steps.push_back(
        std::visit([&](const auto& s) { return row_step(s, interpolation); }, step));
  }
  program_ = std::move(program);
}

void LutRows::operator()(std::span<const float> in, std::span<float> out,
                         std::size_t channels) const {
  if (channels < 3 || in.size() % channels != 0 || in.size() != out.size()) {
    throw std::invalid_argument("LutRows: rows of " + std::to_string(in.size()) + " and " +
                                std::to_string(out.size()) + " floats in " +
                                std::to_string(channels) + " channels");
  }
  const bool apart = in.data() != out.data();
  const bool colors_alone = channels == 3 && apart && !program_->steps.empty();
  if (apart && !colors_alone) std::copy(in.begin(), in.end(), out.begin());
  if (program_->steps.empty()) return;
  std::array<float, 3 * kChunk> before;
  std::array<float, 3 * kChunk> after;
  const std::size_t pixels = in.size() / channels;
  for (std::size_t i = 0; i < pixels; i += kChunk) {
    const std::size_t count = std::min(kChunk, pixels - i);
    const float* from = in.data() + i * channels;
    float* to = out.data() + i * channels;
    if (colors_alone) {
      program_->run(from, to, count);
      continue;
    }
    copy_colors(from, channels, before.data(), 3, count);
    program_->run(before.data(), after.data(), count);
    copy_colors(after.data(), 3, to, channels, count);
  }
}

void apply(const LutRows& lut, ImageView<const float> in, ImageView<float> out, int threads) {
  if (in.width != out.width || in.height != out.height || in.channels != out.channels) {
    throw std::invalid_argument("apply: pictures of different size or channels");
  }
  detail::parallel_for_rows(in.height, threads, [&](int y) {
    lut(in.row(y), out.row(y), static_cast<std::size_t>(in.channels));
  });
}

}  // namespace tristim
