// How a window at rest refines its picture, on machines that are simulated.
#include "viewer/detail/rest_plan.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr SteadyTime kStart{Nanoseconds(1'000'000'000)};

TEST(RestPlan, NothingIsDrawnBeforeAPictureIsShown) {
  const RestPlan plan;
  EXPECT_EQ(plan.rowsAt(kStart), 0);
  EXPECT_FALSE(plan.nextAt());
  EXPECT_FALSE(plan.whole());
}

TEST(RestPlan, WaitsUntilNothingHasChangedForAWhile) {
  RestPlan plan;
  plan.changed(kStart, 720);
  EXPECT_EQ(plan.rowsAt(kStart + RestPlan::kRest - 1ns), 0);
  EXPECT_EQ(plan.nextAt(), kStart + RestPlan::kRest);
  plan.changed(kStart + 90ms, 720);
  EXPECT_EQ(plan.rowsAt(kStart + RestPlan::kRest), 0);
  EXPECT_GT(plan.rowsAt(kStart + 90ms + RestPlan::kRest), 0);
}

struct Machine {
  Nanoseconds each_slice, each_row;
};

/// Refines a picture of 720 rows; the number of slices, the longest one and the time of all.
struct Refined {
  int slices = 0;
  Nanoseconds longest{}, all{};
};

Refined refine(const Machine& machine) {
  RestPlan plan;
  plan.changed(kStart, 720);
  SteadyTime now = kStart + RestPlan::kRest;
  Refined refined;
  int below = 0;
  while (const int rows = plan.rowsAt(now)) {
    EXPECT_EQ(plan.rowsDrawn(), below);
    const Nanoseconds took = machine.each_slice + machine.each_row * rows;
    plan.drawn(rows, took);
    below += rows;
    now += took;
    ++refined.slices;
    refined.longest = std::max(refined.longest, took);
    refined.all += took;
  }
  EXPECT_EQ(below, 720);
  EXPECT_TRUE(plan.whole());
  EXPECT_FALSE(plan.nextAt());
  return refined;
}

TEST(RestPlan, AFastMachineNeedsFewSlices) {
  const Refined refined = refine({50us, 1us});
  EXPECT_LE(refined.slices, 5);
}

TEST(RestPlan, ASlowFillIsCutIntoShortSlices) {
  const Refined refined = refine({1ms, 100us});  // 73 ms in one
  EXPECT_LE(refined.longest, 10ms);
}

TEST(RestPlan, DearGeometryIsNotRepeatedWithoutEnd) {
  const Refined refined = refine({40ms, 100us});
  EXPECT_LE(refined.slices, RestPlan::kMaxSlices);
}

TEST(RestPlan, ASliceThatTakesSecondsIsTheLast) {
  RestPlan plan;
  plan.changed(kStart, 720);
  const SteadyTime rest = kStart + RestPlan::kRest;
  plan.drawn(plan.rowsAt(rest), 4s);
  EXPECT_EQ(plan.rowsAt(rest + 10s), 0);
  EXPECT_FALSE(plan.whole());
  EXPECT_FALSE(plan.nextAt());
  plan.changed(rest, 720);
  EXPECT_GT(plan.rowsAt(rest + RestPlan::kRest), 0);
}

TEST(RestPlan, AChangeStartsOver) {
  RestPlan plan;
  plan.changed(kStart, 720);
  const SteadyTime rest = kStart + RestPlan::kRest;
  plan.drawn(plan.rowsAt(rest), 8ms);
  EXPECT_GT(plan.rowsDrawn(), 0);
  plan.changed(rest, 600);
  EXPECT_EQ(plan.rowsDrawn(), 0);
  EXPECT_EQ(plan.rowsAt(rest), 0);
}

}  // namespace
}  // namespace rocinante
