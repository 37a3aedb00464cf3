#include "tristim/color/rows.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "lib/color/row_steps.h"
#include "tristim/core/error.h"

namespace tristim {

struct RowConversion::Program {
  detail::RowKernels kernels;
  std::vector<detail::RowStep> steps;
  std::size_t from_components, to_components;
  RowOptions options;

  /// The step that can do without a block.
  const detail::RowStep* only_step() const {
    const bool fits = steps.size() == 1 && steps[0].kernel.pixels != nullptr &&
                      from_components == 3 && to_components == 3;
    return fits ? &steps[0] : nullptr;
  }
};

namespace {

using detail::RowBlock;
using detail::RowStep;

const ColorModel& with_numbers(const ColorModel& model) {
  if (model.to_text == nullptr) return model;
  throw Error(ErrorKind::kMisuse, model.name, "its colours are words",
              "rows of pixels take models of numbers");
}

void apply_edge(const RowStep& step, RowBlock& block, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    Components c{};
    for (std::size_t k = 0; k < c.size(); ++k) c[k] = block.plane[k][i];
    c = step.edge(c, step.context);
    for (std::size_t k = 0; k < c.size(); ++k) block.plane[k][i] = c[k];
  }
}

void apply(const RowStep& step, RowBlock& block, std::size_t count) {
  if (step.edge != nullptr) return apply_edge(step, block, count);
  step.kernel.block(block, count, step.parameters);
}

// Pixels of three channels, or of others by way of three: a colour is the same beside any alpha.
void apply_to_pixels(const RowStep& step, const float* in, std::size_t in_channels, float* out,
                     std::size_t out_channels, std::size_t pixels, bool keep_undefined) {
  if (in_channels == 3 && out_channels == 3) {
    return step.kernel.pixels(in, out, pixels, step.parameters, keep_undefined);
  }
  float colors[3 * RowBlock::kSize];
  for (std::size_t begin = 0; begin < pixels; begin += RowBlock::kSize) {
    const std::size_t end = std::min(begin + RowBlock::kSize, pixels);
    for (std::size_t i = begin; i < end; ++i) {
      std::copy_n(in + i * in_channels, 3, colors + 3 * (i - begin));
    }
    step.kernel.pixels(colors, colors, end - begin, step.parameters, keep_undefined);
    for (std::size_t i = begin; i < end; ++i) {
      std::copy_n(colors + 3 * (i - begin), 3, out + i * out_channels);
      if (out_channels > 3)
        out[i * out_channels + 3] = in_channels > 3 ? in[i * in_channels + 3] : 1;
    }
  }
}

void check_channels(std::size_t channels, std::size_t components, std::string_view side) {
  if (channels >= components) return;
  throw std::invalid_argument(std::string(side) + ": " + std::to_string(channels) +
                              " channels, the model has " + std::to_string(components) +
                              " components");
}

}  // namespace

RowConversion::RowConversion(const ModelReference& from, const ModelReference& to,
                             Adaptation adaptation, RowOptions options)
    : conversion_(from, to, adaptation) {
  const detail::RowKernels& kernels = detail::row_kernels();
  program_ = std::make_shared<const Program>(
      Program{kernels, row_steps(conversion_, kernels), component_count(with_numbers(*from.model)),
              component_count(with_numbers(*to.model)), options});
}

void RowConversion::operator()(std::span<const float> in, std::size_t in_channels,
                               std::span<float> out, std::size_t out_channels) const {
  const Program& program = *program_;
  check_channels(in_channels, program.from_components, "in");
  check_channels(out_channels, program.to_components, "out");
  const std::size_t pixels = in.size() / in_channels;
  if (pixels * in_channels != in.size() || pixels * out_channels != out.size()) {
    throw std::invalid_argument("rows: " + std::to_string(in.size()) + " numbers of " +
                                std::to_string(in_channels) + " channels do not become " +
                                std::to_string(out.size()) + " of " + std::to_string(out_channels));
  }
  if (const RowStep* only = program.only_step()) {
    return apply_to_pixels(*only, in.data(), in_channels, out.data(), out_channels, pixels,
                           program.options.keep_undefined);
  }
  RowBlock block{};
  for (std::size_t i = 0; i < pixels; i += RowBlock::kSize) {
    const std::size_t count = std::min(RowBlock::kSize, pixels - i);
    program.kernels.load(in.data() + i * in_channels, {program.from_components, in_channels}, count,
                         block);
    if (program.options.keep_undefined) {
      std::fill_n(block.undefined, count, std::numeric_limits<double>::quiet_NaN());
    }
    for (const RowStep& step : program.steps) apply(step, block, count);
    program.kernels.store(block, {program.to_components, out_channels}, count,
                          out.data() + i * out_channels);
  }
}

}  // namespace tristim
