#include "golden/why/pixel_blame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/golden/why/painting.h"

namespace rocinante {
namespace {

using test::kHand;
using test::kWall;
using test::Painting;
using testing::ElementsAre;
using testing::SizeIs;

TEST(BlameLinks, WhatAMoverUncoversIsLaidToTheMover) {
  Painting golden;
  golden.add(kWall, 5, 5, 40, 60).add(kHand, 10, 10, 10, 200);
  Painting frame;
  frame.add(kWall, 5, 5, 40, 60).add(kHand, 13, 9, 10, 200);
  const Blame blame = blameLinks(golden.side(), frame.side(), {});
  ASSERT_THAT(blame.changes, SizeIs(1));
  EXPECT_EQ(blame.differing, 2 * (100 - 7 * 9));
  EXPECT_EQ(changeText(blame.changes[0], blame.differing),
            "arm/hand: 74 of 74 differing pixels, moved by (3.0, -1.0) px");
}

TEST(BlameLinks, KnowsAppearedVanishedColourDrawingAndShape) {
  Painting golden;
  golden.add({"a", "gone"}, 2, 2, 6, 10)
      .add({"a", "dyed"}, 20, 2, 6, 10)
      .add({"a", "grown"}, 30, 20, 6, 10);
  Painting frame;
  frame.add({"a", "new"}, 2, 30, 6, 10)
      .add({"a", "dyed"}, 20, 2, 6, 90)
      .add({"a", "grown"}, 30, 20, 12, 10);
  frame.add({"drawing", "plan/goal"}, 50, 2, 4, 255);
  std::vector<std::string> texts;
  for (const LinkChange& change : blameLinks(golden.side(), frame.side(), {}).changes) {
    texts.push_back(nameText(change.name) + " " + whatText(change));
  }
  EXPECT_THAT(texts, testing::UnorderedElementsAre("a/gone vanished", "a/new appeared",
                                                   "a/dyed colour changed by (+80, +0, +0)",
                                                   "a/grown shape changed",
                                                   "drawing plan/goal text or drawing"));
}

TEST(BlameLinks, TheMaskTellsEachPixelsRow) {
  Painting golden;
  golden.add(kHand, 10, 10, 10, 200);
  Painting frame;
  frame.add(kHand, 12, 10, 10, 200);
  const Blame blame = blameLinks(golden.side(), frame.side(), {});
  const auto at = [&](int x, int y) {
    const std::uint8_t* pixel = &blame.mask.rgba[static_cast<std::size_t>(y * 64 + x) * 4];
    return std::array<int, 3>{pixel[0], pixel[1], pixel[2]};
  };
  EXPECT_THAT(at(0, 0), ElementsAre(0, 0, 0));
  EXPECT_THAT(at(10, 10), ElementsAre(1, 0, 1));  // it was there
  EXPECT_THAT(at(15, 15), ElementsAre(0, 1, 1));  // nothing differs
  EXPECT_THAT(at(21, 10), ElementsAre(1, 1, 0));  // it is there
}

TEST(BlameLinks, AHostileIdentityIsNobodys) {
  Painting golden;
  Painting frame;
  frame.picture().rgba[0] = 1;
  IdentityFrame lies = frame.side().identity;
  lies.ids[0] = 77;  // no such name
  const Blame blame = blameLinks(golden.side(), {frame.side().picture, lies}, {});
  ASSERT_THAT(blame.changes, SizeIs(1));
  EXPECT_EQ(nameText(blame.changes[0].name), "background");
}

TEST(GuessBlame, FindsWhereALinkWasByItsColours) {
  Painting golden;
  golden.add(kWall, 5, 5, 40, 60).add(kHand, 10, 10, 10, 200);
  Painting frame;
  frame.add(kWall, 5, 5, 40, 60).add(kHand, 15, 8, 10, 200);
  const Blame blame = guessBlame(golden.side().picture, frame.side());
  ASSERT_FALSE(blame.changes.empty());
  EXPECT_EQ(nameText(blame.changes[0].name), "arm/hand");
  EXPECT_EQ(blame.changes[0].pixels, blame.differing);
  ASSERT_TRUE(blame.changes[0].moved_px.has_value());
  EXPECT_NEAR((*blame.changes[0].moved_px)[0], 5, 0.1);
  EXPECT_NEAR((*blame.changes[0].moved_px)[1], -2, 0.1);
}

}  // namespace
}  // namespace rocinante
