#include "tristim/core/version.h"

#include <gtest/gtest.h>

namespace tristim {
namespace {

TEST(Version, IsTheOneThatCmakeRead) { EXPECT_EQ(kVersion, TRISTIM_CMAKE_VERSION); }

}  // namespace
}  // namespace tristim
