#include "lib/core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace tristim::detail {
namespace {

TEST(ParallelForRows, CallsEveryRowOnce) {
  for (int threads : {0, 1, 2, 7}) {
    for (int rows : {0, 1, 2, 63, 1000}) {
      SCOPED_TRACE(testing::Message() << rows << " rows, " << threads << " threads");
      std::vector<std::atomic<int>> calls(static_cast<std::size_t>(rows));
      parallel_for_rows(rows, threads, [&](int row) { ++calls.at(static_cast<std::size_t>(row)); });
      for (const auto& count : calls) EXPECT_EQ(count, 1);
    }
  }
}

TEST(ParallelForRows, OneThreadGoesInOrder) {
  std::vector<int> order;
  parallel_for_rows(50, 1, [&](int row) { order.push_back(row); });
  std::vector<int> expected(50);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(order, expected);
}

TEST(ParallelForRows, HandsOnExceptions) {
  for (int threads : {1, 2, 7}) {
    SCOPED_TRACE(threads);
    const auto fail_at_17 = [](int row) {
      if (row == 17) throw std::runtime_error("row 17");
    };
    try {
      parallel_for_rows(100, threads, fail_at_17);
      FAIL() << "no exception";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "row 17");
    }
  }
}

TEST(ThreadCount, IsAtLeastOne) {
  EXPECT_GE(thread_count(0), 1);
  EXPECT_EQ(thread_count(5), 5);
}

}  // namespace
}  // namespace tristim::detail
