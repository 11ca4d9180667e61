#include "golden/why/view_blame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/golden/why/painting.h"

namespace rocinante {
namespace {

using test::kHand;
using test::kWall;
using test::Painting;
using testing::ElementsAre;

/// The main view, and an inset of 20 x 20 pixels at the top right whose camera looks along x.
std::vector<PicturedView> viewsWith(double eye_z) {
  PicturedView inset{true, "wrist", {44, 0, 20, 20}, {}};
  inset.from.eye = {0, 0, eye_z};
  inset.from.target = {1, 0, eye_z};
  return {{false, "", {0, 0, 64, 48}, {}}, inset};
}

std::vector<std::string> textsOf(const Blame& blame) {
  std::vector<std::string> texts;
  for (const LinkChange& change : blame.changes) {
    texts.push_back(changeText(change, blame.differing));
  }
  return texts;
}

TEST(BlameViews, AnInsetThatRidesOnWhatMovedIsItsCamerasAndNotTheRooms) {
  Painting golden;
  golden.add(kHand, 10, 20, 10, 200).add(kWall, 46, 4, 10, 60);
  Painting frame;
  frame.add(kHand, 11, 13, 10, 200).add(kWall, 46, 6, 10, 60);
  const Blame blame =
      blameViews(golden.side(), viewsWith(0), frame.side(), viewsWith(0.02), {{"arm", "hand"}});
  EXPECT_THAT(textsOf(blame),
              ElementsAre("arm/hand: 146 of 186 differing pixels, moved by (1.0, -7.0) px",
                          "inset wrist: 40 of 186 differing pixels, its camera moved by 20 mm"));
  // A pixel of the inset tells the second row, one of the main view the first.
  EXPECT_EQ(blame.mask.rgba[static_cast<std::size_t>(4 * 64 + 46) * 4], 2);
  EXPECT_EQ(blame.mask.rgba[static_cast<std::size_t>(13 * 64 + 11) * 4], 1);
}

TEST(BlameViews, WhatOneLinkDoesInTwoViewsIsToldOfEach) {
  Painting golden;
  golden.add(kHand, 10, 20, 10, 200).add(kHand, 46, 4, 6, 200);
  Painting frame;
  frame.add(kHand, 13, 20, 10, 200).add(kHand, 46, 9, 6, 200);
  const Blame blame = blameViews(golden.side(), viewsWith(0), frame.side(), viewsWith(0), {});
  EXPECT_THAT(textsOf(blame),
              ElementsAre("arm/hand: 60 of 120 differing pixels, moved by (3.0, 0.0) px",
                          "inset wrist, arm/hand: 60 of 120 differing pixels, moved by (0.0, 5.0) "
                          "px"));
}

TEST(BlameViews, InsetsThatComeGoOrLieElsewhereAreSaid) {
  Painting golden;
  golden.add(kWall, 46, 4, 10, 60);
  Painting frame;
  const std::vector<PicturedView> with = viewsWith(0), without = {with.front()};
  EXPECT_THAT(textsOf(blameViews(golden.side(), with, frame.side(), without, {})),
              ElementsAre("inset wrist: 100 of 100 differing pixels, it is no longer drawn"));
  EXPECT_THAT(textsOf(blameViews(golden.side(), without, frame.side(), with, {})),
              ElementsAre("inset wrist: 100 of 100 differing pixels, it is new"));
  std::vector<PicturedView> moved = with;
  moved.back().part.x = 0;
  EXPECT_THAT(textsOf(blameViews(golden.side(), with, frame.side(), moved, {})),
              ElementsAre("inset wrist: 100 of 100 differing pixels, it was moved"));
}

TEST(CameraChange, SaysWhatShowsInThePicture) {
  CameraView golden;
  golden.eye = {0, 0, 0};
  golden.target = {2, 0, 0};
  CameraView frame = golden;
  EXPECT_EQ(cameraChange(golden, frame, 300), "");
  frame.eye.x = 1e-6;
  EXPECT_EQ(cameraChange(golden, frame, 300), "") << "no picture shows a micrometre";
  frame = golden;
  frame.target = {2, 0.1, 0};
  EXPECT_EQ(cameraChange(golden, frame, 300), "its camera turned by 2.9 deg");
  frame.eye = {-1.5, 0, 0};
  frame.target = {2, 0, 0};
  frame.fov_deg = 30;
  EXPECT_EQ(cameraChange(golden, frame, 300), "its camera moved by 1.500 m and sees more or less");
}

}  // namespace
}  // namespace rocinante
