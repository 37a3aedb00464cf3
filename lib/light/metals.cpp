#include "tristim/light/metals.h"

#include <array>

namespace tristim {
namespace {

constexpr MetalIndex kCopper[] = {
#include "luts/copper_hagemann.csv"
};
constexpr MetalIndex kGold[] = {
#include "luts/gold_hagemann.csv"
};

constexpr std::array kMetals{Metal{"gold", "[Hagemann74]", kGold},
                             Metal{"copper", "[Hagemann74]", kCopper}};

}  // namespace

std::span<const Metal> metals() noexcept { return kMetals; }

Conductor conductor_at(const Metal& metal, double lambda_nm) noexcept {
  const std::span<const MetalIndex> table = metal.table;
  if (!(lambda_nm > table.front().lambda_nm)) return {table.front().eta, table.front().k};
  for (std::size_t i = 1; i < table.size(); ++i) {
    const MetalIndex& a = table[i - 1];
    const MetalIndex& b = table[i];
    if (lambda_nm > b.lambda_nm) continue;
    const double t = (lambda_nm - a.lambda_nm) / (b.lambda_nm - a.lambda_nm);
    return {a.eta + t * (b.eta - a.eta), a.k + t * (b.k - a.k)};
  }
  return {table.back().eta, table.back().k};
}

}  // namespace tristim
