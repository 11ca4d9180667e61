#include "viewer/shown/state_shape.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace rocinante {
namespace {

LogTime binTime(std::int64_t nanoseconds) { return LogTime(Nanoseconds(nanoseconds)); }

TEST(StateShape, HoldsAStateUntilTheNext) {
  StateBins bins(binTime(0), Nanoseconds(10), 64);
  bins.add(binTime(10), 0);
  bins.add(binTime(30), 0);
  bins.add(binTime(40), 2);
  bins.end(binTime(60));
  bins.add(binTime(80), 1);
  const StateShape shape = stateShape(bins.columns(binTime(0), binTime(100), 10));
  const std::vector<StateShape::Band> expected{{1, 4, 0}, {4, 6, 2}, {8, 10, 1}};
  EXPECT_EQ(shape.bands, expected);
  EXPECT_TRUE(shape.mixed.empty());
}

TEST(StateShape, ShowsAllStatesOfAColumn) {
  StateBins bins(binTime(0), Nanoseconds(10), 64);
  bins.add(binTime(0), 0);
  bins.add(binTime(20), 1);
  bins.add(binTime(21), 5);
  bins.add(binTime(22), 0);
  const StateShape shape = stateShape(bins.columns(binTime(0), binTime(50), 5));
  const std::vector<StateShape::Band> expected{{0, 2, 0}, {3, 5, 0}};
  EXPECT_EQ(shape.bands, expected);
  ASSERT_EQ(shape.mixed.size(), 1U);
  EXPECT_EQ(shape.mixed[0], (StateShape::Mixed{2, 0b100011}));
}

// However wide stretches and columns are, no state is lost.
TEST(StateShape, LosesNoState) {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    StateBins bins(binTime(0), Nanoseconds(1), 16);
    std::uint64_t expected = 0;
    std::int64_t time = 0;
    for (std::size_t i = 0; i < 1 + random() % 90; ++i) {
      time += random() % 700;
      const auto state = static_cast<std::uint8_t>(random() % StateBin::kStates);
      bins.add(binTime(time), state);
      expected |= std::uint64_t{1} << state;
    }
    const StateShape shape = stateShape(bins.columns(binTime(0), binTime(70'000), 7));
    std::uint64_t seen = 0;
    for (const StateShape::Band& band : shape.bands) seen |= std::uint64_t{1} << band.state;
    for (const StateShape::Mixed& mixed : shape.mixed) seen |= mixed.seen;
    ASSERT_EQ(expected & ~seen, 0U) << round;
  }
}

TEST(ColorOfState, IsTheSameForTheSameText) {
  EXPECT_EQ(colorOfState("auto", 20), colorOfState("auto", 20));
  EXPECT_LT(colorOfState("fault", 20), 20U);
  EXPECT_NE(colorOfState("auto", 20), colorOfState("fault", 20));
}

}  // namespace
}  // namespace rocinante
