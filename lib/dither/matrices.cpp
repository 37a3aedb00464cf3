#include "tristim/dither/matrices.h"

#include <stdexcept>
#include <string>

#include "lib/dither/cells.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

constexpr std::string_view kDigits = "0123456789";
constexpr long long kMostSize = 1 << 20;  // so that it fits; what can be made each maker knows

// The top level of the recursion is the lowest digit: bits of x and y from the most significant on.
std::uint16_t bayer_rank(int x, int y, int size) {
  constexpr int kD2[2][2] = {{0, 2}, {3, 1}};
  int rank = 0;
  int weight = 1;
  for (int half = size / 2; half >= 1; half /= 2) {
    rank += weight * kD2[(y / half) % 2][(x / half) % 2];
    weight *= 4;
  }
  return static_cast<std::uint16_t>(rank);
}

void check_parameters(const MatrixRecipe& recipe, const MatrixParameters& parameters) {
  const std::string name(recipe.name);
  if (parameters.size != recipe.size && !recipe.sizes) {
    throw std::invalid_argument("size of " + name + ": " + std::to_string(parameters.size) +
                                "; it comes in " + std::to_string(recipe.size) + " alone");
  }
  if (parameters.frame && !recipe.by_frame) refuse_frame(name);
}

}  // namespace

void refuse_frame(const std::string& dither) {
  std::string others;
  for (const MatrixRecipe& recipe : kMatrixRecipes) {
    if (recipe.by_frame) others += (others.empty() ? "" : ", ") + std::string(recipe.name);
  }
  throw std::invalid_argument("frame: dither " + dither +
                              " does not change with time; leave it out, or use " + others);
}

ThresholdMatrix bayer_matrix(const MatrixParameters& parameters) {
  const int size = detail::cell_size("Bayer matrix", parameters);
  if ((size & (size - 1)) != 0) {
    throw std::invalid_argument("size of a Bayer matrix: " + std::to_string(size) +
                                "; expected a power of 2");
  }
  ThresholdMatrix matrix = detail::square_matrix(size);
  auto rank = matrix.rank.begin();
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) *rank++ = bayer_rank(x, y, size);
  }
  return matrix;
}

ThresholdMatrix d3_matrix(const MatrixParameters& /*parameters*/) {
  return {{}, {}, 3, 3, 9, {6, 8, 4, 1, 0, 3, 5, 2, 7}};
}

std::optional<MatrixRecipe> find_matrix_recipe(std::string_view name) {
  if (const MatrixRecipe* found = find_by_name(kMatrixRecipes, name)) return *found;
  const std::size_t letters = name.find_last_not_of(kDigits) + 1;
  const auto size = parse_integer(name.substr(letters));
  const MatrixRecipe* found = find_by_name(kMatrixRecipes, name.substr(0, letters));
  if (found == nullptr || !found->sizes || !size || *size > kMostSize) return std::nullopt;
  MatrixRecipe recipe = *found;
  recipe.size = static_cast<int>(*size);
  return recipe;
}

ThresholdMatrix make_matrix(const MatrixRecipe& recipe, MatrixParameters parameters) {
  if (parameters.size == 0) parameters.size = recipe.size;
  check_parameters(recipe, parameters);
  ThresholdMatrix matrix = recipe.make(parameters);
  matrix.name = recipe.name;
  if (recipe.sizes) matrix.name += std::to_string(matrix.width);
  matrix.source = recipe.source;
  return matrix;
}

}  // namespace tristim
