#include "viewer/ui/panels/frame_state.h"

#include <gtest/gtest.h>

#include "viewer/ui/panels/panel_parts.h"

namespace rocinante {
namespace {

TEST(FrameState, IsSaidInWords) {
  EXPECT_EQ(frameStateText(FrameState::at_rest, 10'033, 30), "at rest");
  EXPECT_EQ(frameStateText(FrameState::refining, 10'033, 30), "refining");
  EXPECT_EQ(frameStateText(FrameState::drawing, 10'033, 30), "drawing slowly");
  EXPECT_EQ(frameStateText(FrameState::drawing, 90, 30), "drawing 11/s");
  EXPECT_EQ(frameStateText(FrameState::drawing, 4, 30), "drawing 30/s");
  EXPECT_EQ(frameStateText(FrameState::drawing, 0, 60), "drawing 60/s");
}

TEST(FrameState, CostsAreInUnitsThatCanBeRead) {
  EXPECT_EQ(frameCostText(12.34), "12.3 ms, 81 frames/s");
  EXPECT_EQ(frameCostText(400), "400.0 ms, 2.5 frames/s");
  EXPECT_EQ(frameCostText(10'033), "10.0 s a frame");
}

TEST(ListScroll, MovesOnlyToWhatIsNotSeen) {
  EXPECT_EQ(scrollToShow(100, 100, 20, 60), 100);
  EXPECT_EQ(scrollToShow(100, 140, 20, 60), 100);
  EXPECT_EQ(scrollToShow(100, 141, 20, 60), 121);
  EXPECT_EQ(scrollToShow(100, 99, 20, 60), 79);
  EXPECT_EQ(scrollToShow(100, 0, 20, 60), 0);
}

TEST(ListScroll, FollowsUntilTheUserScrollsUp) {
  EXPECT_TRUE(followsNewest(0, 0));
  EXPECT_TRUE(followsNewest(300, 300));
  EXPECT_TRUE(followsNewest(299.5F, 300));
  EXPECT_FALSE(followsNewest(280, 300));
}

}  // namespace
}  // namespace rocinante
