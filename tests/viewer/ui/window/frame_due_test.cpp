// When a window at rest draws a frame.
#include "viewer/ui/window/frame_due.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr SteadyTime kOpened{Nanoseconds(100'000'000'000)};
constexpr Nanoseconds kNever = Nanoseconds::max();

/// Frames drawn in a span, when asked each millisecond.
int framesIn(FrameDue& due, SteadyTime from, Nanoseconds span, Nanoseconds panels_every) {
  int frames = 0;
  for (SteadyTime now = from; now < from + span; now += 1ms) {
    if (!due.at(now, panels_every)) continue;
    due.drawn(now);
    ++frames;
  }
  return frames;
}

TEST(FrameDue, AWindowThatRestsDrawsNothing) {
  FrameDue due;
  EXPECT_EQ(framesIn(due, kOpened, 1s, kNever), FrameDue::kSettlingFrames);
  EXPECT_EQ(framesIn(due, kOpened + 1s, 60s, kNever), 0);
}

TEST(FrameDue, AfterAnythingThatHappenedFramesAreDrawnWithoutWaitingAndThenAFewMore) {
  FrameDue due;
  framesIn(due, kOpened, 1s, kNever);
  due.happened(kOpened + 5s);
  EXPECT_EQ(framesIn(due, kOpened + 5s, 10ms, kNever), FrameDue::kSettlingFrames);
  const int answers = framesIn(due, kOpened + 5s + 10ms, 2s, kNever);
  EXPECT_GE(answers, 8);
  EXPECT_LE(answers, 10);
  EXPECT_EQ(framesIn(due, kOpened + 8s, 60s, kNever), 0);
}

TEST(FrameDue, PanelsThatTellATimeAreDrawnAtTheirPace) {
  FrameDue due;
  framesIn(due, kOpened, 1s, kNever);
  EXPECT_EQ(framesIn(due, kOpened + 1s, 10s, 1s), 10);
}

}  // namespace
}  // namespace rocinante
