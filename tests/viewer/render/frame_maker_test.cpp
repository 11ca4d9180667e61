#include "viewer/render/frame_maker.h"

#include <gtest/gtest.h>

#include "tests/viewer/render/test_maker.h"

namespace rocinante {
namespace {

using test::kCameras;
using FrameMakerTest = test::MakerTest;

TEST_F(FrameMakerTest, AFrameIsTheSameHoweverItsTimeWasReached) {
  const std::vector<std::int64_t> times{0, 250, 3000, 4000, 4550, 5000, 6999, 7000, 10000};
  FrameMaker forwards = open();
  std::vector<Picture> frames;
  for (const std::int64_t time : times) frames.push_back(frameOf(forwards, requestAt(time)));
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_FALSE(frames[i] == frames[i - 1]) << "nothing moved before " << times[i] << " ms";
  }
  FrameMaker backwards = open();
  for (std::size_t i = times.size(); i-- > 0;) {
    EXPECT_TRUE(frameOf(backwards, requestAt(times[i])) == frames[i]) << times[i] << " ms";
  }
  for (const std::size_t i : {std::size_t{4}, std::size_t{0}, std::size_t{7}}) {
    FrameMaker alone = open();
    EXPECT_TRUE(frameOf(alone, requestAt(times[i])) == frames[i]) << times[i] << " ms";
  }
}

TEST_F(FrameMakerTest, ValuesHoldBetweenPackets) {
  FrameMaker maker = open();
  EXPECT_TRUE(frameOf(maker, requestAt(1000)) == frameOf(maker, requestAt(1099)));
  EXPECT_FALSE(frameOf(maker, requestAt(1000)) == frameOf(maker, requestAt(1100)));
}

TEST_F(FrameMakerTest, OtherSizesInBetweenChangeNothing) {
  FrameMaker maker = open();
  const Picture before = frameOf(maker, requestAt(2000));
  FrameRequest other = requestAt(3000);
  other.width = 333;
  other.height = 77;
  other.samples = 1;
  other.hide = {"arm"};
  EXPECT_EQ(frameOf(maker, other).width, 333);
  EXPECT_TRUE(frameOf(maker, requestAt(2000)) == before);
}

TEST_F(FrameMakerTest, ATimeOutsideTheLogIsRefused) {
  FrameMaker maker = open();
  for (const std::int64_t time : {-1, 10001, 1'000'000}) {
    const auto frame = maker.frame(requestAt(time));
    ASSERT_FALSE(frame.has_value()) << time;
    EXPECT_EQ(frame.error().kind, ErrorKind::bad_argument);
    EXPECT_NE(frame.error().what.find("outside the log, which has 0.000 to 10.000 s"),
              std::string::npos)
        << frame.error().what;
  }
}

TEST_F(FrameMakerTest, WithoutASessionTheCellIsAtRest) {
  FrameMaker at_rest = open(kCameras, false);
  FrameRequest request = requestAt(0);
  request.time = {};
  FrameMaker with_session = open(kCameras);
  // At 0 ms the joint is at 0 as well.
  EXPECT_TRUE(frameOf(at_rest, request) == frameOf(with_session, requestAt(0)));
}

TEST_F(FrameMakerTest, TheFirstCameraOfTheCellIsTheDefault) {
  FrameMaker maker = open(kCameras);
  FrameRequest request = requestAt(2000);
  const Picture unnamed = frameOf(maker, request);
  request.camera = "top";
  EXPECT_TRUE(frameOf(maker, request) == unnamed);
  request.camera = "flat";
  EXPECT_FALSE(frameOf(maker, request) == unnamed);
}

TEST_F(FrameMakerTest, ARidingCameraSeesItsCarrierStandStill) {
  FrameMaker maker = open(kCameras);
  FrameRequest request = requestAt(500);
  request.camera = "riding";
  request.hide = {"layer/grid", "layer/gnomon"};
  const auto middle = [&](std::int64_t time) {
    request.time = test::sessionTime(time);
    const Picture frame = frameOf(maker, request);
    return frame.rgba[(60 * 160 + 80) * 4] > frame.rgba[(60 * 160 + 80) * 4 + 1] + 40;
  };
  EXPECT_TRUE(middle(500));
  EXPECT_TRUE(middle(4400));
}

TEST_F(FrameMakerTest, ViewsOfTheSessionAreCamerasOnceTheyWereSaid) {
  FrameMaker maker = open();
  FrameRequest request = requestAt(4500);
  request.camera = "side";
  EXPECT_TRUE(maker.frame(request).has_value());
  request.time = test::sessionTime(4499);
  const auto early = maker.frame(request);
  ASSERT_FALSE(early.has_value());
  EXPECT_EQ(early.error().what, "unknown camera `side`: there are none");
}

TEST_F(FrameMakerTest, AnUnknownCameraIsAnsweredWithThoseThereAre) {
  FrameMaker maker = open(kCameras);
  FrameRequest request = requestAt(0);
  request.camera = "elsewhere";
  const auto frame = maker.frame(request);
  ASSERT_FALSE(frame.has_value());
  EXPECT_EQ(frame.error().what, "unknown camera `elsewhere`: there are top, riding, flat, front");
}

TEST_F(FrameMakerTest, TheInputsHashFollowsTheGeometryAlone) {
  const std::string hash = open().inputsHash();
  EXPECT_EQ(open(kCameras).inputsHash(), hash);
  std::string urdf = test::kArmUrdf;
  urdf.replace(urdf.find("0.4 0.2"), 7, "0.4 0.3");
  test::writeText(folder_ / "arm.urdf", urdf);
  EXPECT_NE(open().inputsHash(), hash);
}

TEST_F(FrameMakerTest, KnowsItsRenderer) {
  EXPECT_EQ(open().key().renderer, "llvmpipe");
  EXPECT_EQ(open().key().caps, pinnableCaps().front());
}

}  // namespace
}  // namespace rocinante
