// Whose a frame's pixels are: what the frame shows, and what projecting boxes predicts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/math/transform.h"
#include "tests/viewer/render/test_maker.h"
#include "viewer/view/camera_choice.h"

namespace rocinante {
namespace {

using test::MakerTest;

class IdentityTest : public MakerTest {
 protected:
  static IdentityFrame identityOf(FrameMaker& maker, const FrameRequest& request) {
    auto frame = maker.identity(request);
    EXPECT_TRUE(frame.has_value()) << frame.error().text();
    return frame ? std::move(*frame) : IdentityFrame{};
  }
  static std::map<std::string, IdentityExtent> namedExtents(const IdentityFrame& frame) {
    std::map<std::string, IdentityExtent> extents;
    const std::vector<IdentityExtent> by_place = extentsOf(frame);
    for (std::size_t i = 0; i < frame.names.size(); ++i) {
      extents[frame.names[i].device + "/" + frame.names[i].link] = by_place[i];
    }
    return extents;
  }
};

TEST_F(IdentityTest, EachLinkIsWhereProjectingItsBoxSays) {
  FrameMaker maker = open(test::kCameras);
  for (const char* name : {"top", "flat", "map", "fit"}) {
    for (const std::int64_t time : {0, 1500, 7300}) {
      SCOPED_TRACE(std::string(name) + " at " + std::to_string(time));
      FrameRequest request = requestAt(time);
      request.camera = name;
      const IdentityFrame frame = identityOf(maker, request);
      const auto extents = namedExtents(frame);
      ASSERT_TRUE(extents.contains("arm/hand"));
      const auto state = maker.session()->stateAt(request.time);
      ASSERT_TRUE(state.has_value());
      const PosedScene scene = poseScene(maker.cell(), **state);
      if (scene.findCamera(name) == nullptr) continue;
      const Camera camera(viewOf(*scene.findCamera(name)), request.width, request.height,
                          ClipDepth::zero_to_one, 100);
      double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
      for (unsigned corner = 0; corner < 8; ++corner) {
        const Vec3 at(1 + ((corner & 1U) != 0 ? 0.2 : -0.2), (corner & 2U) != 0 ? 0.1 : -0.1,
                      0.2 + ((corner & 4U) != 0 ? 0.1 : -0.1));
        const Vec4 clip = camera.clipOf(transformPoint(*scene.find("arm", "hand"), at));
        left = std::min(left, (clip.x / clip.w + 1) / 2 * request.width);
        right = std::max(right, (clip.x / clip.w + 1) / 2 * request.width);
        top = std::min(top, (1 - clip.y / clip.w) / 2 * request.height);
        bottom = std::max(bottom, (1 - clip.y / clip.w) / 2 * request.height);
      }
      // A convex box fills its outline: a pixel belongs to it when its centre does.
      const IdentityExtent& hand = extents.at("arm/hand");
      EXPECT_NEAR(hand.left, left, 1.0);
      EXPECT_NEAR(hand.right, right, 1.0);
      EXPECT_NEAR(hand.top, top, 1.0);
      EXPECT_NEAR(hand.bottom, bottom, 1.0);
    }
  }
}

TEST_F(IdentityTest, ExactlyThePixelsThatHidingAThingChangesAreItsOwn) {
  FrameMaker maker = open(test::kCameras);
  struct Thing {
    std::string device, link, hidden_by;
    std::vector<std::string> out_of_the_way;  // a label's plate lets through what is behind it
  };
  const std::vector<Thing> things{{"arm", "hand", "arm", {}},
                                  {"drawing", "robot/plan", "layer/lines", {"layer/labels"}},
                                  {"drawing", "robot/here", "layer/labels", {}}};
  FrameRequest request = requestAt(4200);
  request.camera = "flat";
  request.samples = 1;
  ASSERT_EQ(identityOf(maker, request).names.size(), things.size());
  for (const Thing& thing : things) {
    SCOPED_TRACE(thing.device + " " + thing.link);
    request.hide = thing.out_of_the_way;
    const IdentityFrame frame = identityOf(maker, request);
    const Picture with = frameOf(maker, request);
    FrameRequest without = request;
    without.hide.push_back(thing.hidden_by);
    const Picture other = frameOf(maker, without);
    const auto isOwn = [&](int x, int y) {
      if (x < 0 || y < 0 || x >= frame.width || y >= frame.height) return false;
      const std::uint32_t id = frame.ids[static_cast<std::size_t>(y * frame.width + x)];
      return id != 0 && frame.names[id - 1].device == thing.device &&
             frame.names[id - 1].link == thing.link;
    };
    const auto touchesOwn = [&](int x, int y) {
      for (const int down : {-1, 0, 1}) {
        for (const int right : {-1, 0, 1}) {
          if (isOwn(x + right, y + down)) return true;
        }
      }
      return false;
    };
    std::size_t differ = 0, own = 0, both = 0, far = 0;
    for (std::size_t pixel = 0; pixel < frame.ids.size(); ++pixel) {
      const int x = static_cast<int>(pixel) % frame.width;
      const int y = static_cast<int>(pixel) / frame.width;
      const bool changed =
          !std::equal(with.rgba.begin() + static_cast<std::ptrdiff_t>(pixel * 4),
                      with.rgba.begin() + static_cast<std::ptrdiff_t>(pixel * 4 + 4),
                      other.rgba.begin() + static_cast<std::ptrdiff_t>(pixel * 4));
      const bool owned = isOwn(x, y);
      far += changed && !touchesOwn(x, y) ? 1 : 0;
      differ += changed ? 1 : 0;
      own += owned ? 1 : 0;
      both += changed && owned ? 1 : 0;
    }
    EXPECT_GT(own, 20U);
    EXPECT_EQ(both, own) << differ << " differ";
    // Lines and dots fade out over pixels that are less than half theirs: a rim, and nothing else.
    EXPECT_EQ(far, 0U);
    if (thing.device != "drawing") {
      EXPECT_EQ(differ, own);
    }
    if (thing.link != "robot/plan") {
      EXPECT_GE(own * 100, differ * 95) << differ << " differ";
    }
  }
}

TEST_F(IdentityTest, DrawingsAreNamedByTheirSourceAndId) {
  FrameMaker maker = open(test::kCameras);
  FrameRequest request = requestAt(4200);
  request.camera = "flat";
  const auto extents = namedExtents(identityOf(maker, request));
  EXPECT_TRUE(extents.contains("drawing/robot/plan"));
  EXPECT_TRUE(extents.contains("drawing/robot/here"));
  request.hide = {"layer/lines"};
  EXPECT_FALSE(namedExtents(identityOf(maker, request)).contains("drawing/robot/plan"));
  request.hide = {"arm"};
  EXPECT_FALSE(namedExtents(identityOf(maker, request)).contains("arm/hand"));
}

TEST_F(IdentityTest, InsetsHaveTheirOwn) {
  FrameMaker maker = open(test::kCameras);
  FrameRequest request = requestAt(0);
  request.camera = "flat";
  request.hide = {"layer/grid"};
  CellInset inset;
  inset.camera = "top";
  inset.in_pixels = true;
  inset.width = inset.height = 60;
  inset.margin_px = 0;
  request.insets = std::vector{inset};
  const IdentityFrame with = identityOf(maker, request);
  request.insets = std::vector<CellInset>{};
  const IdentityFrame without = identityOf(maker, request);
  request.camera = "top";
  request.width = request.height = 60;
  const IdentityFrame alone = identityOf(maker, request);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      const bool inside = x >= 100 && y < 60;
      const std::uint32_t expected = inside ? alone.ids[static_cast<std::size_t>(y * 60 + x - 100)]
                                            : without.ids[static_cast<std::size_t>(y * 160 + x)];
      ASSERT_EQ(with.ids[static_cast<std::size_t>(y * 160 + x)], expected) << x << " " << y;
    }
  }
}

TEST_F(IdentityTest, DepthIsInMetresAlongTheView) {
  FrameMaker maker = open(test::kCameras);
  FrameRequest request = requestAt(0);
  for (const char* name : {"flat", "front", "top"}) {
    SCOPED_TRACE(name);
    request.camera = name;
    const auto depth = maker.depth(request);
    ASSERT_TRUE(depth.has_value()) << depth.error().text();
    const IdentityFrame ids = identityOf(maker, request);
    float nearest = 1e9F;
    for (std::size_t i = 0; i < ids.ids.size(); ++i) {
      EXPECT_EQ(std::isfinite(depth->metres[i]), ids.ids[i] != 0);
      nearest = std::min(nearest, depth->metres[i]);
    }
    // The box reaches to y = -0.1 and up to z = 0.3.
    EXPECT_NEAR(nearest, std::string(name) == "top" ? 5.7F : 4.9F, 1e-4F);
  }
}

TEST_F(IdentityTest, AFrameInBetweenChangesNothing) {
  FrameMaker maker = open(test::kCameras);
  const IdentityFrame first = identityOf(maker, requestAt(3000));
  const Picture picture = frameOf(maker, requestAt(3000));
  const IdentityFrame second = identityOf(maker, requestAt(3000));
  EXPECT_EQ(first.ids, second.ids);
  EXPECT_EQ(first.names, second.names);
  EXPECT_TRUE(frameOf(maker, requestAt(3000)) == picture);
  FrameMaker alone = open(test::kCameras);
  EXPECT_TRUE(frameOf(alone, requestAt(3000)) == picture);
}

TEST(IdentityFrame, ColoursFollowTheNameAloneAndNeverMeet) {
  std::vector<IdentityName> names;
  for (int i = 0; i < 3000; ++i) names.push_back({"device" + std::to_string(i), "link"});
  const auto colors = identityColors(names);
  std::map<std::uint32_t, int> seen;
  for (const std::uint32_t color : colors) {
    EXPECT_EQ(++seen[color], 1);
    EXPECT_NE(color, 0x000000FFU);
  }
  EXPECT_EQ(identityColors({names[7]}).front(), colors[7]);
  EXPECT_NE(identityColors({{"ab", "c"}}), identityColors({{"a", "bc"}}));
}

TEST(IdentityFrame, ExtentsAreTightAndExclusive) {
  IdentityFrame frame{4, 3, {0, 1, 0, 0, 2, 1, 1, 0, 0, 0, 0, 2}, {{"a", "x"}, {"b", "y"}}};
  const auto extents = extentsOf(frame);
  ASSERT_EQ(extents.size(), 2U);
  EXPECT_EQ(extents[0].pixels, 3U);
  EXPECT_EQ(std::vector({extents[0].left, extents[0].top, extents[0].right, extents[0].bottom}),
            std::vector({1, 0, 3, 2}));
  EXPECT_EQ(extents[1].pixels, 2U);
  EXPECT_EQ(std::vector({extents[1].left, extents[1].top, extents[1].right, extents[1].bottom}),
            std::vector({0, 1, 4, 3}));
  const Picture picture = identityPicture(frame);
  EXPECT_EQ(picture.rgba[0], 0);
  EXPECT_EQ(picture.rgba[3], 255);
  EXPECT_EQ(std::uint32_t{picture.rgba[4]} << 24U | std::uint32_t{picture.rgba[5]} << 16U |
                std::uint32_t{picture.rgba[6]} << 8U | 0xFFU,
            identityColors(frame.names)[0]);
}

}  // namespace
}  // namespace rocinante
