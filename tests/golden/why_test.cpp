#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/session/timeline.h"
#include "golden/why/event_alignment.h"
#include "golden/why/file_change.h"
#include "golden/why/first_parting.h"
#include "golden/why/pixel_blame.h"
#include "golden/why/session_deviation.h"
#include "golden/why/view_blame.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/render/test_session.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// A grey picture on which rectangles are painted; later ones lie over earlier ones.
class Painting {
 public:
  Painting() {
    picture_ = {kWidth, kHeight, std::vector<std::uint8_t>(kWidth * kHeight * 4, 128)};
    identity_ = {kWidth, kHeight, std::vector<std::uint32_t>(kWidth * kHeight), {}};
  }
  Painting& add(const IdentityName& name, int left, int top, int size, std::uint8_t red) {
    identity_.names.push_back(name);
    for (int y = top; y < top + size; ++y) {
      for (int x = left; x < left + size; ++x) {
        const auto at = static_cast<std::size_t>(y * kWidth + x);
        picture_.rgba[at * 4] = red;
        identity_.ids[at] = static_cast<std::uint32_t>(identity_.names.size());
      }
    }
    return *this;
  }
  BlameSide side() const { return {picture_, identity_}; }
  Picture& picture() { return picture_; }

 private:
  static constexpr int kWidth = 64, kHeight = 48;
  Picture picture_;
  IdentityFrame identity_;
};

const IdentityName kHand{"arm", "hand"};
const IdentityName kWall{"hall", "wall"};

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
  EXPECT_THAT(texts, testing::UnorderedElementsAre(
                         "a/gone vanished", "a/new appeared", "a/dyed colour, by (+80, +0, +0)",
                         "a/grown another shape", "drawing plan/goal text or drawing"));
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
              ElementsAre("inset wrist: 100 of 100 differing pixels, it is drawn no more"));
  EXPECT_THAT(textsOf(blameViews(golden.side(), without, frame.side(), with, {})),
              ElementsAre("inset wrist: 100 of 100 differing pixels, it is new"));
  std::vector<PicturedView> moved = with;
  moved.back().part.x = 0;
  EXPECT_THAT(textsOf(blameViews(golden.side(), with, frame.side(), moved, {})),
              ElementsAre("inset wrist: 100 of 100 differing pixels, it lies elsewhere now"));
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

Event eventAt(std::int64_t ms, std::string text) {
  return {LogTime(std::chrono::milliseconds(ms)), "robot", std::move(text)};
}
LogTime at(std::int64_t ms) { return LogTime(std::chrono::milliseconds(ms)); }

TEST(AlignEvents, TimesAreStraightBetweenMatchedEvents) {
  const auto alignment =
      alignEvents({eventAt(100, "a"), eventAt(200, "b"), eventAt(400, "c")},
                  {eventAt(1100, "a"), eventAt(1300, "b"), eventAt(1400, "c")}, at(0), at(1000));
  ASSERT_THAT(alignment.matched, SizeIs(3));
  EXPECT_EQ(alignment.inB(at(100)), at(1100));
  EXPECT_EQ(alignment.inB(at(150)), at(1200));
  EXPECT_EQ(alignment.inB(at(300)), at(1350));
  EXPECT_EQ(alignment.inB(at(50)), at(1050));   // one to one before the first
  EXPECT_EQ(alignment.inB(at(500)), at(1500));  // and behind the last
}

TEST(AlignEvents, AnHourOfOnePaceKeepsEveryNanosecond) {
  constexpr std::int64_t kHourMs = 3'600'000;
  const auto alignment =
      alignEvents({eventAt(0, "a"), eventAt(kHourMs, "b")},
                  {eventAt(1000, "a"), eventAt(kHourMs + 1000, "b")}, at(0), at(1000));
  for (std::int64_t ns = 1; ns < kHourMs * 1'000'000; ns += 35'999'999'999) {
    const LogTime in_a{Nanoseconds(ns)};
    ASSERT_EQ(alignment.inB(in_a) - at(1000), in_a - at(0)) << ns;
  }
}

TEST(AlignEvents, MissingAndExtraEventsAreTold) {
  const auto alignment =
      alignEvents({eventAt(1, "a"), eventAt(2, "b"), eventAt(3, "c")},
                  {eventAt(1, "a"), eventAt(2, "x"), eventAt(3, "c")}, at(0), at(0));
  EXPECT_THAT(alignment.matched, SizeIs(2));
  ASSERT_THAT(alignment.only_a, SizeIs(1));
  EXPECT_EQ(alignment.only_a[0].text, "b");
  ASSERT_THAT(alignment.only_b, SizeIs(1));
  EXPECT_EQ(alignment.only_b[0].text, "x");
}

TEST(AlignEvents, EventsOfOneTimeAndNoneAtAllDoNoHarm) {
  const auto same_time =
      alignEvents({eventAt(5, "a"), eventAt(5, "b"), eventAt(9, "c")},
                  {eventAt(7, "a"), eventAt(8, "b"), eventAt(8, "c")}, at(0), at(0));
  EXPECT_EQ(same_time.inB(at(9)), at(8));
  EXPECT_EQ(same_time.inB(at(7)), at(8));
  const auto none = alignEvents({}, {{at(3), "", "a mark"}}, at(10), at(20));
  EXPECT_THAT(none.only_b, IsEmpty());
  EXPECT_EQ(none.inB(at(15)), at(25));
}

/// Differs at these moments.
PartingQuestion questionOf(std::size_t moments, std::set<std::size_t> differing) {
  PartingQuestion question;
  question.moments = moments;
  question.differs = [differing = std::move(differing)](std::size_t moment) -> Result<bool> {
    return differing.contains(moment);
  };
  return question;
}

TEST(FindParting, FindsTheFirstSinceTheLastProbeThatIsAlike) {
  auto question = questionOf(100, {37, 38, 39, 60, 61, 62, 63, 64});
  question.probes = {20, 40, 60};
  const auto parting = findParting(question);
  ASSERT_TRUE(parting.ok());
  // 37 lies between two probes that are alike: only what lies before a probe that differs is seen.
  EXPECT_EQ(parting->first, 60U);
  EXPECT_TRUE(parting->is_first_since_probe);
  EXPECT_EQ(parting->searched_from, 41U);
  EXPECT_EQ(parting->last_alike, 59U);
}

TEST(FindParting, HalvesWhatIsTooLong) {
  std::set<std::size_t> differing;
  for (std::size_t moment = 6543; moment < 10'000; ++moment) differing.insert(moment);
  auto question = questionOf(10'000, differing);
  question.most_frames = 100;
  const auto parting = findParting(question);
  ASSERT_TRUE(parting.ok());
  EXPECT_EQ(parting->first, 6543U);
  EXPECT_FALSE(parting->is_first_since_probe);
  EXPECT_LT(parting->frames, 20U);
}

TEST(FindParting, NothingToFindIsNoParting) {
  EXPECT_FALSE(findParting(questionOf(50, {}))->first.has_value());
  EXPECT_FALSE(findParting(questionOf(0, {}))->first.has_value());
  EXPECT_EQ(findParting(questionOf(50, {0, 49}))->first, 0U);
}

TEST(FileChanges, NameWhatAFileIs) {
  EXPECT_THAT(fileChanges({{"a.obj", "1"}, {"a.mtl", "1"}, {"t.PNG", "1"}, {"same.stl", "1"}},
                          {{"a.obj", "2"}, {"a.mtl", "2"}, {"same.stl", "1"}, {"b.urdf", "1"}}),
              ElementsAre("a.mtl: the materials have changed", "a.obj: the mesh has changed",
                          "b.urdf: the kinematics is new",
                          "t.PNG: the texture is no part of the cell any more"));
}

class CompareSessions : public testing::Test {
 protected:
  CompareSessions() {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    auto cell = loadCell(folder_ / "arm.urdf", {});
    if (cell.ok()) cell_ = std::move(*cell);
  }
  /// The arm turns by 0.01 rad a packet, each `step_ms`, from 0; `off` from 500 ms of it on.
  Timeline session(const std::string& name, std::int64_t step_ms, std::int64_t late_ms,
                   double off) {
    std::vector<std::pair<std::int64_t, std::string>> packets = {{0, "event \"go\"\n"}};
    for (int i = 1; i < 100; ++i) {
      const double q = i * 0.01 + (i >= 50 ? off : 0);
      packets.emplace_back(i * step_ms + late_ms, "joint arm turn=" + std::to_string(q) + "\n");
    }
    packets.emplace_back(100 * step_ms, "event \"stop\"\n");
    test::writeSession(folder_ / name, packets);
    return std::move(*Timeline::open(folder_ / name));
  }
  SessionDeviation compareThem(Timeline a, Timeline b) {
    const auto events_a = a.events();
    const auto events_b = b.events();
    const auto alignment = alignEvents(**events_a, **events_b, a.start(), b.start());
    StateDamage damage;
    auto found = compareSessions(cell_, a, b, alignment, {}, damage);
    EXPECT_TRUE(damage.empty());
    EXPECT_TRUE(found.ok());
    return found.ok() ? *found : SessionDeviation{};
  }

  test::TemporaryFolder folder_;
  Cell cell_;
};

TEST_F(CompareSessions, LatePacketsAndAnotherPaceAreNoDifference) {
  const auto found = compareThem(session("a.mcap", 10, 0, 0), session("b.mcap", 20, 7, 0));
  EXPECT_GT(found.samples, 40U);
  EXPECT_THAT(found.beyond, IsEmpty());
}

TEST_F(CompareSessions, AJointThatGoesElsewhereIsNamedWithItsTime) {
  const auto found = compareThem(session("a.mcap", 10, 0, 0), session("b.mcap", 10, 0, 0.2));
  ASSERT_THAT(found.beyond, SizeIs(1));
  EXPECT_EQ(found.beyond[0].item, "arm/turn");
  EXPECT_EQ(found.beyond[0].unit, "rad");
  EXPECT_NEAR(*found.beyond[0].largest, 0.2, 0.06);  // less what comes within the slack
  EXPECT_NEAR(
      std::chrono::duration<double>(found.beyond[0].first_at - test::sessionTime(0)).count(), 0.5,
      0.07);
}

TEST_F(CompareSessions, WhatOneSessionNeverSaysIsNotTheSame) {
  test::writeSession(folder_ / "a.mcap", {{0, "joint arm turn=1\n"}, {1000, "joint arm turn=1\n"}});
  test::writeSession(folder_ / "b.mcap",
                     {{0, "joint arm turn=1\nhide arm\n"}, {1000, "joint arm turn=1\n"}});
  const auto found = compareThem(std::move(*Timeline::open(folder_ / "a.mcap")),
                                 std::move(*Timeline::open(folder_ / "b.mcap")));
  ASSERT_THAT(found.beyond, SizeIs(1));
  EXPECT_EQ(found.beyond[0].item, "show arm");
  EXPECT_FALSE(found.beyond[0].largest.has_value());
}

}  // namespace
}  // namespace rocinante
