#include "viewer/ui/program/pointer_pace.h"

#include <gtest/gtest.h>

#include "viewer/ui/program/panel_pace.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

TEST(PointerPace, LooksTenTimesASecondAndWhereTheMouseRests) {
  PointerPace pace;
  int looks = 0;
  PicturePlace last;
  for (int ms = 0; ms < 1000; ++ms) {
    const PicturePlace place(ms, 5);
    if (!pace.due(place, SteadyTime(ms * 1ms))) continue;
    ++looks;
    last = place;
  }
  EXPECT_EQ(looks, 10);
  EXPECT_EQ(last, PicturePlace(900, 5));
  EXPECT_TRUE(pace.due(PicturePlace(999, 5), SteadyTime(1050ms)));
  EXPECT_FALSE(pace.due(PicturePlace(999, 5), SteadyTime(1300ms)));
  EXPECT_TRUE(pace.due(std::nullopt, SteadyTime(1301ms)));  // it left the picture
  EXPECT_FALSE(pace.due(std::nullopt, SteadyTime(2000ms)));
}

TEST(PanelPace, TellsOfALongSilenceLessOften) {
  EXPECT_EQ(agesChangeEvery(0s), 1s);
  EXPECT_EQ(agesChangeEvery(4999ms), 1s) << "the reason of a silence is there after two";
  EXPECT_EQ(agesChangeEvery(5s), 5s);
}

}  // namespace
}  // namespace rocinante
