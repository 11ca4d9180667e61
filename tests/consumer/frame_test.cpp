// Tests of somebody else's pictures with the installed matcher.
#include <gtest/gtest.h>
#include <rocinante/matches_golden.h>

#include <vector>

namespace somebody {

/// A frame as this project holds it: bottom row first, as glReadPixels gives it.
struct Frame {
  int width, height;
  std::vector<unsigned char> rgba;
};

rocinante::PictureView viewOf(const Frame& frame) {
  const std::ptrdiff_t row = frame.width * 4;
  return {frame.width, frame.height, -row, frame.rgba.data() + row * (frame.height - 1)};
}

Frame drawnFrame(unsigned char blue) {
  Frame frame{32, 24, {}};
  for (int y = 23; y >= 0; --y) {
    for (int x = 0; x < 32; ++x) {
      frame.rgba.insert(frame.rgba.end(), {static_cast<unsigned char>(x * 8),
                                           static_cast<unsigned char>(y * 10), blue, 255});
    }
  }
  return frame;
}

TEST(Frames, AreTheAcceptedOnes) {
  EXPECT_THAT(drawnFrame(40), rocinante::MatchesGolden("gradient"));
  EXPECT_THAT(drawnFrame(41), rocinante::MatchesGolden("gradient", rocinante::Tolerance::cpu()));
}

TEST(Frames, AnotherBlueMustFail) {
  EXPECT_THAT(drawnFrame(90), rocinante::MatchesGolden("gradient"));
}

}  // namespace somebody
