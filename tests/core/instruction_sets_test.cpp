#include "tristim/core/instruction_sets.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>
#include <cstdlib>

#include "tests/error_text.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

class InstructionSets : public testing::Test {
 protected:
  void TearDown() override {
    unsetenv("TRISTIM_SIMD");
    limit_to_instruction_set();
  }
};

TEST_F(InstructionSets, EndWithTheDefinition) {
  EXPECT_EQ(instruction_sets().back().name, "scalar");
  unsetenv("TRISTIM_SIMD");
  EXPECT_EQ(chosen_instruction_set().name, instruction_sets().front().name);
}

TEST_F(InstructionSets, AreChosenByName) {
  for (const InstructionSet& set : instruction_sets()) {
    setenv("TRISTIM_SIMD", set.name.c_str(), 1);
    check_instruction_set();
    EXPECT_EQ(chosen_instruction_set().name, set.name);
  }
}

// A target is a bit; the lower, the better.
TEST_F(InstructionSets, LimitTheWholeProcess) {
  const std::int64_t all = hwy::SupportedTargets();
  std::int64_t last = 0;
  for (const InstructionSet& set : instruction_sets()) {
    setenv("TRISTIM_SIMD", set.name.c_str(), 1);
    limit_to_instruction_set();
    const std::int64_t best = hwy::SupportedTargets() & -hwy::SupportedTargets();
    if (set.name == "scalar") {
      EXPECT_GE(best, last);
    } else {
      EXPECT_GT(best, last) << set.name;
    }
    last = best;
  }
  unsetenv("TRISTIM_SIMD");
  limit_to_instruction_set();
  EXPECT_EQ(hwy::SupportedTargets(), all);
}

TEST_F(InstructionSets, UnknownNamesAreRefusedWithThoseThereAre) {
  setenv("TRISTIM_SIMD", "mmx", 1);
  EXPECT_EQ(error_text(check_instruction_set),
            "2 TRISTIM_SIMD: unknown instruction set 'mmx'; use one of: " +
                list_names(instruction_sets()));
  EXPECT_EQ(chosen_instruction_set().name, instruction_sets().front().name);
}

}  // namespace
}  // namespace tristim
