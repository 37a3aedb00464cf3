#include "lib/core/ordered_pipeline.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace tristim::detail {
namespace {

// Items that are their own number; what becomes of them is noted.
struct Line {
  explicit Line(int items) : count(items) {
    steps.produce = [this]() -> void* {
      fail("produce", made);
      if (made == count) return nullptr;
      most_under_way = std::max(most_under_way, made + 1 - discarded.load());
      return new int(made++);
    };
    steps.work = [this](void* item) {
      // The first is late, so that others wait for their turn when something fails.
      if (number(item) == 0) std::this_thread::sleep_for(late);
      fail("work", number(item));
      number(item) += 1000;
    };
    for (std::vector<int>& seen : settled) {
      steps.settle.emplace_back([this, &seen](void* item) {
        fail("settle", number(item) - 1000);
        seen.push_back(number(item));
      });
    }
    steps.consume = [this](void* item) {
      fail("consume", number(item) - 1000);
      consumed.push_back(number(item));
    };
    steps.discard = [this](void* item) {
      ++discarded;
      delete static_cast<int*>(item);
    };
  }

  static int& number(void* item) { return *static_cast<int*>(item); }

  void fail(const std::string& step, int item) const {
    if (step == failing_step && item == failing_item) throw std::runtime_error(step);
  }

  int count;
  std::string failing_step;
  int failing_item = -1;
  std::chrono::milliseconds late{0};
  OrderedSteps steps;
  int made = 0;
  int most_under_way = 0;
  std::array<std::vector<int>, 3> settled;  // by each such step
  std::vector<int> consumed;
  std::atomic<int> discarded = 0;
};

TEST(RunOrdered, KeepsTheOrderInEveryOrderedStep) {
  for (const int threads : {0, 1, 2, 7}) {
    for (const int items : {0, 1, 2, 100}) {
      SCOPED_TRACE(testing::Message() << items << " items, " << threads << " threads");
      Line line(items);
      run_ordered(line.steps, threads);
      std::vector<int> expected(static_cast<std::size_t>(items));
      std::iota(expected.begin(), expected.end(), 1000);
      for (const auto& settled : line.settled) EXPECT_EQ(settled, expected);
      EXPECT_EQ(line.consumed, expected);
      EXPECT_EQ(line.discarded, items);
    }
  }
}

TEST(RunOrdered, HasFewItemsUnderWay) {
  for (const int threads : {1, 2, 7}) {
    Line line(300);
    run_ordered(line.steps, threads);
    EXPECT_LE(line.most_under_way, threads + 1);
  }
}

TEST(RunOrdered, HandsOnTheExceptionOfAnyStepAndDiscardsEverything) {
  for (const int threads : {1, 2, 7}) {
    for (const std::string step : {"produce", "work", "settle", "consume"}) {
      for (const int item : {0, 1, 50}) {
        SCOPED_TRACE(testing::Message() << step << " of " << item << ", " << threads << " threads");
        Line line(60);
        line.failing_step = step;
        line.failing_item = item;
        line.late = std::chrono::milliseconds(2);
        try {
          run_ordered(line.steps, threads);
          ADD_FAILURE() << "no exception";
        } catch (const std::runtime_error& error) {
          EXPECT_EQ(error.what(), step);
        }
        EXPECT_EQ(line.discarded, line.made);
        // Whatever was consumed is an unbroken start of the line.
        for (std::size_t i = 0; i < line.consumed.size(); ++i) {
          EXPECT_EQ(line.consumed[i], 1000 + static_cast<int>(i));
        }
        EXPECT_LE(static_cast<int>(line.consumed.size()), item);
      }
    }
  }
}

}  // namespace
}  // namespace tristim::detail
