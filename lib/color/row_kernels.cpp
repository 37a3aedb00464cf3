#include "lib/color/row_kernels.h"

#include "lib/color/row_formulas-inl.h"
#include "lib/core/instruction_set.h"

namespace tristim::detail {
namespace {

using Colors = HWY_NAMESPACE::Three<float>;

// Numbers one at a time: the definition of the rows.
struct ScalarLanes {
  using W = double;
  static constexpr std::size_t count() noexcept { return 1; }
  static double load(const double* from) noexcept { return *from; }
  static void store(double x, double* to) noexcept { *to = x; }

  static constexpr std::size_t pixels() noexcept { return 1; }
  static Colors load_pixels(const float* in) noexcept { return {in[0], in[1], in[2]}; }
  static void store_pixels(const Colors& c, float* out) noexcept {
    out[0] = c.a;
    out[1] = c.b;
    out[2] = c.c;
  }

  static void load_block(const float* in, RowChannels channels, std::size_t count,
                         RowBlock& block) {
    load_pixels_of(in, channels, 0, count, block);
  }
  static void store_block(const RowBlock& block, RowChannels channels, std::size_t count,
                          float* out) {
    store_pixels_of(block, channels, 0, count, out);
  }
};

}  // namespace

const RowKernels& scalar_row_kernels() noexcept {
  static const RowKernels kernels = HWY_NAMESPACE::all_kernels<ScalarLanes>("scalar");
  return kernels;
}

const RowKernels& row_kernels() {
  const RowKernels* simd = chosen_instruction_set(simd_row_kernels());
  return simd == nullptr ? scalar_row_kernels() : *simd;
}

}  // namespace tristim::detail
