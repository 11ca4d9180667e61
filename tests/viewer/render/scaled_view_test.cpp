// Frames on a rung of detail that was asked for.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/viewer/render/test_maker.h"
#include "viewer/detail/detail_level.h"
#include "viewer/picture/pixel_rectangle.h"

namespace rocinante {
namespace {

using DetailFrames = test::MakerTest;

FrameRequest requestOn(int detail) {
  FrameRequest request;
  request.time = test::sessionTime(4300);
  request.width = 160;
  request.height = 120;
  request.camera = "front";
  request.detail = detail;
  return request;
}

TEST_F(DetailFrames, ARungIsTheSamePictureWhateverWasDrawnBefore) {
  FrameMaker maker = open(test::kCameras);
  std::vector<Picture> first;
  for (int rung = 0; rung <= kCoarsestRung; ++rung)
    first.push_back(frameOf(maker, requestOn(rung)));
  FrameMaker other = open(test::kCameras);
  for (int rung = kCoarsestRung; rung >= 0; --rung) {
    SCOPED_TRACE(rung);
    EXPECT_TRUE(frameOf(other, requestOn(rung)) == first[static_cast<std::size_t>(rung)]);
    EXPECT_EQ(first[static_cast<std::size_t>(rung)].width, 160);
  }
  EXPECT_FALSE(first[0] == first[1]);
  EXPECT_FALSE(first[2] == first[3]);
}

TEST_F(DetailFrames, ARungThatIsNoneIsRefused) {
  FrameMaker maker = open(test::kCameras);
  for (const int rung : {-1, kCoarsestRung + 1}) {
    const auto frame = maker.frame(requestOn(rung));
    ASSERT_FALSE(frame.has_value());
    EXPECT_EQ(frame.error().kind, ErrorKind::bad_argument);
  }
}

/// How many pixels of the two are equal, inside a part of both.
int equalPixels(const Picture& a, const Picture& b, const PixelRectangle& part) {
  int equal = 0;
  for (int y = part.y; y < part.y + part.height; ++y) {
    for (int x = part.x; x < part.x + part.width; ++x) {
      const auto at = static_cast<std::ptrdiff_t>((y * a.width + x) * 4);
      equal += std::equal(a.rgba.begin() + at, a.rgba.begin() + at + 4, b.rgba.begin() + at);
    }
  }
  return equal;
}

TEST_F(DetailFrames, InsetsKeepTheirCrispFramesAndCoverWhatLiesBehindThem) {
  FrameMaker maker = open(test::kCameras);
  CellInset inset;
  inset.camera = "top";
  inset.corner = InsetCorner::bottom_left;
  inset.in_pixels = true;
  inset.width = 60;
  inset.height = 50;
  inset.margin_px = 4;
  inset.title = "";
  inset.border_px = 3;
  inset.border_rgba = 0xFF8000FF;
  FrameRequest request = requestOn(0);
  // Large enough for a gnomon.
  request.width = 240;
  request.height = 180;
  request.hide = {"layer/grid"};
  request.insets = std::vector{inset};
  const Picture full = frameOf(maker, request);
  request.detail = kCoarsestRung;
  const Picture coarse = frameOf(maker, request);
  // Its border, from 4 pixels off the corner, is what it was to the pixel.
  EXPECT_EQ(equalPixels(full, coarse, {4, 126, 60, 3}), 60 * 3);
  EXPECT_EQ(equalPixels(full, coarse, {4, 126, 3, 50}), 3 * 50);
  // And the main view's gnomon, which would stand there, is not seen through it.
  request.hide = {"layer/grid", "layer/gnomon"};
  const Picture bare = frameOf(maker, request);
  EXPECT_EQ(equalPixels(coarse, bare, {4, 126, 60, 50}), 60 * 50);
}

}  // namespace
}  // namespace rocinante
