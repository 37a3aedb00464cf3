#include "tristim/dither/method.h"

#include "tristim/core/find.h"
#include "tristim/dither/matrices.h"

namespace tristim {

const std::vector<NamedDither>& dither_methods() {
  static const std::vector<NamedDither> methods = [] {
    std::vector<NamedDither> all;
    const auto add = [&all](const auto& method) {
      all.push_back({std::string(method.name), method, std::string(method.source)});
    };
    add(NoDither{});
    for (const MatrixRecipe& recipe : kMatrixRecipes) add(recipe);
    for (const ScreenRecipe& recipe : kScreenRecipes) add(recipe);
    for (const DiffusionKernel& kernel : kDiffusionKernels) add(kernel);
    for (const WholePictureDither& dither : kWholePictureDithers) add(dither);
    return all;
  }();
  return methods;
}

DiffusionOptions diffusion_options(const DiffusionKernel& kernel,
                                   const DitherParameters& parameters, int channel) {
  constexpr std::uint64_t kOtherChannel = 0x9E3779B97F4A7C15;  // what is left to chance differs
  return {.kernel = &kernel,
          .serpentine = parameters.serpentine.value_or(kernel.serpentine),
          .jitter = parameters.jitter.value_or(kernel.jitter),
          .seed = parameters.seed + static_cast<std::uint64_t>(channel) * kOtherChannel,
          .settled = parameters.settled};
}

std::optional<NamedDither> find_dither(std::string_view name) {
  if (const NamedDither* found = find_by_name(dither_methods(), name)) return *found;
  const std::optional<MatrixRecipe> recipe = find_matrix_recipe(name);
  if (!recipe) return std::nullopt;
  return NamedDither{std::string(name), *recipe, std::string(recipe->source)};
}

bool has_one_matrix(const DitherMethod& method) noexcept {
  const auto* recipe = std::get_if<MatrixRecipe>(&method);
  return std::holds_alternative<ThresholdMatrix>(method) ||
         (recipe != nullptr && !recipe->by_channel);
}

std::vector<ThresholdMatrix> dither_matrices(const DitherMethod& method,
                                             const DitherParameters& parameters, int channels) {
  const auto count = static_cast<std::size_t>(channels);
  if (parameters.frame && !std::holds_alternative<MatrixRecipe>(method)) {
    refuse_frame(std::visit([](const auto& m) { return std::string(m.name); }, method));
  }
  if (const auto* own = std::get_if<ThresholdMatrix>(&method)) return {count, *own};
  if (const auto* screen = std::get_if<ScreenRecipe>(&method)) {
    return screen_matrices(*screen, parameters.screen, channels);
  }
  const auto* recipe = std::get_if<MatrixRecipe>(&method);
  if (recipe == nullptr) return {};
  MatrixParameters of_channel{parameters.size, parameters.seed, 0, parameters.frame};
  if (has_one_matrix(method)) return {count, make_matrix(*recipe, of_channel)};
  std::vector<ThresholdMatrix> matrices;
  for (int channel = 0; channel < channels; ++channel) {
    of_channel.channel = channel;
    matrices.push_back(make_matrix(*recipe, of_channel));
  }
  return matrices;
}

}  // namespace tristim
