// Windows over the main view, and the cameras that they show.
#include <gtest/gtest.h>

#include <cstdlib>

#include "core/cell/posed_scene.h"
#include "tests/viewer/render/test_maker.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {
namespace {

using InsetsTest = test::MakerTest;

Picture partOf(const Picture& picture, const PixelRectangle& part) {
  Picture cut{part.width, part.height, {}};
  for (int y = part.y; y < part.y + part.height; ++y) {
    const auto row = picture.rgba.begin() + (std::ptrdiff_t{y} * picture.width + part.x) * 4;
    cut.rgba.insert(cut.rgba.end(), row, row + std::ptrdiff_t{part.width} * 4);
  }
  return cut;
}

/// Pixels with a component more than 8 apart.
int differing(const Picture& a, const Picture& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    bool far = false;
    for (std::size_t c = i; c < i + 4; ++c) far = far || std::abs(a.rgba[c] - b.rgba[c]) > 8;
    count += far ? 1 : 0;
  }
  return count;
}

CellInset plainInset(const std::string& camera, InsetCorner corner) {
  CellInset inset;
  inset.camera = camera;
  inset.corner = corner;
  inset.in_pixels = true;
  inset.width = 60;
  inset.height = 50;
  inset.margin_px = 5;
  inset.title = "";
  inset.border_px = 0;
  return inset;
}

TEST_F(InsetsTest, AnInsetIsThePictureOfItsCameraAtThatSize) {
  FrameMaker maker = open(test::kCameras);
  for (const int samples : {1, 4}) {
    for (const char* camera : {"top", "riding", "flat", "map", "fit"}) {
      SCOPED_TRACE(camera);
      FrameRequest request = requestAt(4300);
      request.camera = "front";
      request.samples = samples;
      // Far off, its lines follow slopes between neighbours, which pair up from even pixels on.
      request.hide = {"layer/grid"};
      request.insets = std::vector{plainInset(camera, InsetCorner::bottom_right)};
      const Picture whole = frameOf(maker, request);
      request.insets.reset();
      const Picture without = frameOf(maker, request);
      request.camera = camera;
      request.width = 60;
      request.height = 50;
      const Picture alone = frameOf(maker, request);
      const PixelRectangle part{95, 65, 60, 50};
      // But for rounding: corners lie on 1/256 pixels, counted from another place.
      EXPECT_LT(differing(partOf(whole, part), alone), 60 * 50 / 100);
      EXPECT_TRUE(partOf(whole, {0, 0, 160, 65}) == partOf(without, {0, 0, 160, 65}));
      EXPECT_TRUE(partOf(whole, {0, 0, 95, 120}) == partOf(without, {0, 0, 95, 120}));
    }
  }
}

TEST_F(InsetsTest, TheCellsInsetsWaitForASessionsView) {
  FrameMaker maker = open(std::string(test::kCameras) + "[[inset]]\ncamera = \"side\"\n");
  FrameRequest request = requestAt(4499);
  request.samples = 1;
  const Picture before = frameOf(maker, request);
  request.insets.emplace();
  EXPECT_TRUE(frameOf(maker, request) == before);
  request.time = test::sessionTime(4500);
  const Picture none = frameOf(maker, request);
  request.insets.reset();
  EXPECT_FALSE(frameOf(maker, request) == none);
  request.time = test::sessionTime(4499);
  request.insets = std::vector{plainInset("side", InsetCorner::top_left)};
  EXPECT_EQ(maker.frame(request).error().kind, ErrorKind::not_found);
}

TEST_F(InsetsTest, BuiltInCamerasYieldToTheCellsOfTheirName) {
  FrameMaker maker = open("[[camera]]\nname = \"map\"\neye = [0, -5, 0]\ntarget = [0, 0, 0]\n");
  FrameRequest request = requestAt(2000);
  const Picture unnamed = frameOf(maker, request);
  request.camera = "map";
  EXPECT_TRUE(frameOf(maker, request) == unnamed);
  request.camera = "fit";
  EXPECT_FALSE(frameOf(maker, request) == unnamed);
}

TEST_F(InsetsTest, ALookingCameraTurnsAfterWhatMoves) {
  FrameMaker maker = open(
      "[[camera]]\nname = \"watch\"\neye = [0, -6, 3]\nlook_at = \"arm/hand\"\nfov_deg = 20\n"
      "target = [0, 0, 0.2]\n");
  FrameRequest request = requestAt(0);
  request.camera = "watch";
  for (const std::int64_t time : {0, 3000, 9900}) {
    request.time = test::sessionTime(time);
    const auto state = maker.session()->stateAt(request.time);
    const PosedScene scene = poseScene(maker.cell(), **state);
    const auto hand = scene.find("arm", "hand");
    EXPECT_EQ(scene.findCamera("watch")->target, Vec3((*hand)[3]) + Vec3(0, 0, 0.2));
    EXPECT_EQ(scene.findCamera("watch")->eye, Vec3(0, -6, 3));
  }
}

TEST_F(InsetsTest, CamerasCountFromTheWorldUntilTheirCarrierComes) {
  std::filesystem::remove(folder_ / "arm.mcap");
  test::writeSession(folder_ / "arm.mcap", {{0, "joints arm 0\n"},
                                            {1000, "add tool arm.urdf\npose tool 5 0 0 0 0 0 1\n"},
                                            {2000, "remove tool\n"},
                                            {3000, "joints arm 0\n"}});
  FrameMaker maker = open(
      "[[device]]\nname = \"tool\"\nmodel = \"arm.urdf\"\noptional = true\n"
      "[[camera]]\nname = \"on\"\non = \"tool/hand\"\neye = [0, -3, 1]\ntarget = [0, 0, 0]\n"
      "[[camera]]\nname = \"follow\"\nfollow = \"tool\"\neye = [0, -3, 1]\ntarget = [0, 0, 0]\n"
      "[[camera]]\nname = \"look\"\nlook_at = \"tool\"\neye = [0, -3, 1]\n");
  const auto cameraAt = [&](std::int64_t time, const char* name) {
    const auto state = maker.session()->stateAt(test::sessionTime(time));
    return *poseScene(maker.cell(), **state).findCamera(name);
  };
  for (const std::int64_t away : {0, 999, 2000}) {
    for (const char* name : {"on", "follow", "look"}) {
      EXPECT_EQ(cameraAt(away, name).eye, Vec3(0, -3, 1)) << name << " at " << away;
      EXPECT_EQ(cameraAt(away, name).target, Vec3(0, 0, 0)) << name << " at " << away;
    }
  }
  EXPECT_EQ(cameraAt(1000, "on").eye, Vec3(5, -3, 1));
  EXPECT_EQ(cameraAt(1500, "follow").target, Vec3(5, 0, 0));
  EXPECT_EQ(cameraAt(1999, "look").target, Vec3(5, 0, 0));
  EXPECT_EQ(cameraAt(1999, "look").eye, Vec3(0, -3, 1));
  FrameRequest request = requestAt(500);
  request.camera = "on";
  EXPECT_TRUE(maker.frame(request).has_value());
}

TEST(InsetLayout, StacksInCornersAndLeavesOutWhatFindsNoRoom) {
  CellInset inset;
  inset.camera = "map";
  EXPECT_EQ(placeInsets({inset}, 640, 480).front(), (PixelRectangle{436, 12, 192, 144}));
  const auto stacked = placeInsets({inset, inset, inset, inset}, 640, 480);
  EXPECT_EQ(stacked[1], (PixelRectangle{436, 168, 192, 144}));
  // What is left of the height is less than was asked for, then too little.
  EXPECT_EQ(stacked[2], (PixelRectangle{436, 324, 192, 144}));
  EXPECT_EQ(stacked[3], PixelRectangle{});
  inset.corner = InsetCorner::bottom_left;
  EXPECT_EQ(placeInsets({inset}, 640, 480).front(), (PixelRectangle{12, 324, 192, 144}));
  EXPECT_EQ(placeInsets({inset}, 40, 39).front(), PixelRectangle{});
  inset.in_pixels = true;
  inset.width = inset.height = 16384;
  EXPECT_EQ(placeInsets({inset}, 100, 80).front(), (PixelRectangle{12, 12, 76, 56}));
}

TEST(InsetLayout, ReadsACameraAndItsCorner) {
  EXPECT_EQ(parseInset("map")->corner, InsetCorner::top_right);
  EXPECT_EQ(parseInset("map:bottom-left")->corner, InsetCorner::bottom_left);
  EXPECT_EQ(parseInset("map:bottom-left")->camera, "map");
  EXPECT_EQ(parseInset("a:b")->camera, "a:b");
  const auto sized = parseInset("a:b:top-left:0.25x0.5");
  EXPECT_EQ(sized->camera, "a:b");
  EXPECT_EQ(sized->corner, InsetCorner::top_left);
  EXPECT_EQ(sized->width, 0.25);
  EXPECT_EQ(sized->height, 0.5);
  EXPECT_TRUE(parseInset("map:160x120px")->in_pixels);
  for (const char* no_size :
       {"map:0x1", "map:2x1", "map:8x8px", "map:nanx1", "map:1x", "map:0.5"}) {
    EXPECT_EQ(parseInset(no_size)->camera, no_size);
  }
  for (const char* text :
       {"map:top-right", "map:bottom-left:0.333x0.1", "a:b:bottom-right:160x120px"}) {
    EXPECT_EQ(insetText(*parseInset(text)), text);
  }
  EXPECT_FALSE(parseInset(":0.5x0.5").has_value());
  EXPECT_FALSE(parseInset("").has_value());
  EXPECT_FALSE(parseInset(":top-left").has_value());
}

}  // namespace
}  // namespace rocinante
