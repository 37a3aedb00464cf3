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
  const detail::RowStep* only_step(std::size_t in_channels, std::size_t out_channels) const {
    const bool fits = steps.size() == 1 && steps[0].kernel.pixels != nullptr && in_channels == 3 &&
                      out_channels == 3 && from_components == 3 && to_components == 3;
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
  if (const detail::RowStep* only = program.only_step(in_channels, out_channels)) {
    return only->kernel.pixels(in.data(), out.data(), pixels, only->parameters,
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
