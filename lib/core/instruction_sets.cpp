#include "tristim/core/instruction_sets.h"

// Nothing older than SSE4 is used by every kernel.
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lib/core/instruction_sets.cpp"
// clang-format off: foreach_target.h comes before highway.h
#include <hwy/foreach_target.h>
// clang-format on
#include <hwy/highway.h>

#include <cctype>
#include <cstddef>
#include <cstdint>

#include "lib/core/every_target.h"
#include "lib/core/instruction_set.h"
#include "tristim/core/error.h"

HWY_BEFORE_NAMESPACE();
namespace tristim::detail::sets::HWY_NAMESPACE {

InstructionSet this_set() { return {hwy::TargetName(HWY_TARGET)}; }

}  // namespace tristim::detail::sets::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tristim {
namespace detail::sets {
namespace {

HWY_EXPORT(this_set);

}  // namespace
}  // namespace detail::sets

const std::vector<InstructionSet>& instruction_sets() {
  static const std::vector<InstructionSet> sets = [] {
    auto all = detail::of_every_target(detail::sets::HWY_DISPATCH_TABLE(this_set));
    for (InstructionSet& set : all) {
      for (char& c : set.name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    all.push_back({"scalar"});
    return all;
  }();
  return sets;
}

const InstructionSet& chosen_instruction_set() {
  const InstructionSet* named = detail::chosen_instruction_set(std::span(instruction_sets()));
  return named != nullptr ? *named : instruction_sets().back();
}

void check_instruction_set() {
  const char* wanted = std::getenv("TRISTIM_SIMD");
  if (wanted == nullptr || find_by_name(instruction_sets(), wanted) != nullptr) return;
  throw Error(ErrorKind::kMisuse, "TRISTIM_SIMD",
              "unknown instruction set '" + std::string(wanted) + "'",
              "use one of: " + list_names(instruction_sets()));
}

void limit_to_instruction_set() {
  hwy::SetSupportedTargetsForTest(0);  // all
  const std::string& chosen = chosen_instruction_set().name;
  const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
  std::size_t i = 0;
  while (i < targets.size() && instruction_sets()[i].name != chosen) ++i;
  if (i == 0) return;
  // A target is a bit; the lower, the better, those too that nothing was compiled for. What
  // DisableTargets() switches off, Highway 1.0.3 takes again after the next SupportedTargets().
  const std::int64_t best = i < targets.size() ? targets[i] : HWY_SCALAR;
  hwy::SetSupportedTargetsForTest(hwy::SupportedTargets() & ~(best - 1));
}

}  // namespace tristim
#endif
