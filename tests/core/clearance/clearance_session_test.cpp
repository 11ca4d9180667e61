#include "core/clearance/clearance_session.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>

#include "core/math/transform.h"
#include "core/packet/packet_text.h"
#include "tests/core/clearance/random_bodies.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

constexpr double kTolerance_m = ClearanceJudge::kTolerance_m;

std::string ballLink(const std::string& name, const std::string& at, double radius) {
  return fmt::format(
      "<link name=\"{}\"><collision><origin xyz=\"{}\"/><geometry><sphere radius=\"{}\"/>"
      "</geometry></collision></link>\n",
      name, at, radius);
}

std::string boxLink(const std::string& name, const std::string& at, const std::string& size) {
  return fmt::format(
      "<link name=\"{}\"><collision><origin xyz=\"{}\"/><geometry><box size=\"{}\"/></geometry>"
      "</collision></link>\n",
      name, at, size);
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& at, const std::string& axis) {
  return fmt::format(
      "<joint name=\"{}\" type=\"{}\"><parent link=\"{}\"/><child link=\"{}\"/>"
      "<origin xyz=\"{}\"/><axis xyz=\"{}\"/>"
      "<limit lower=\"-9\" upper=\"9\" effort=\"1\" velocity=\"9\"/></joint>\n",
      name, type, parent, child, at, axis);
}

/// A cell of models in a folder, and a session over it.
class ClearanceSessionTest : public testing::Test {
 protected:
  ClearanceSessionTest() {
    robot("arm", "<link name=\"base\"/>" + ballLink("hand", "1 0 0", 0.1) +
                     joint("turn", "revolute", "base", "hand", "0 0 0", "0 0 1"));
    robot("ball", ballLink("ball", "0 0 0", 0.05));
    robot("plate", boxLink("plate", "0 0 0", "4 4 0.1"));
    robot("box", boxLink("box", "0 0 0", "0.2 0.2 0.2"));
    robot("slide", "<link name=\"base\"/>" + boxLink("sled", "0 0 0", "0.2 0.2 0.2") +
                       joint("x", "prismatic", "base", "sled", "0 0 0", "1 0 0"));
    robot("snake", boxLink("s0", "0.15 0 0", "0.3 0.06 0.06") +
                       boxLink("s1", "0.15 0 0", "0.3 0.06 0.06") +
                       boxLink("s2", "0.15 0 0", "0.3 0.06 0.06") +
                       boxLink("s3", "0.15 0 0", "0.3 0.1 0.06") +
                       joint("a", "revolute", "s0", "s1", "0.35 0 0", "0 0 1") +
                       joint("b", "revolute", "s1", "s2", "0.35 0 0", "0 1 0") +
                       joint("c", "continuous", "s2", "s3", "0.35 0 0", "1 0 0"));
  }

  void robot(const std::string& name, const std::string& body) {
    test::writeFile(folder_ / (name + ".urdf"),
                    "<robot name=\"" + name + "\">" + body + "</robot>");
  }

  void open(const std::string& text) {
    test::writeFile(folder_ / "cell.toml", "format = 1\n" + text);
    auto cell = loadCell(folder_ / "cell.toml", {});
    ASSERT_TRUE(cell.ok()) << cell.error().text();
    for (const Finding& fault : cell->faults) {
      if (fault.rule != "model.no-visual" && fault.left_out.empty()) ADD_FAILURE() << fault.print();
    }
    cell_ = std::move(*cell);
    session_.emplace(cell_);
    state_ = {};
  }

  void say(double seconds, const std::string& lines, const std::string& words = "") {
    const std::string text = fmt::format("RK1 me {} -{}\n{}", sequence_++, words, lines);
    const Packet* const packet = decoder_.decode(bytesOf(text));
    ASSERT_NE(packet, nullptr);
    ASSERT_TRUE(packet->faults.empty()) << text;
    const LogTime time = at(seconds);
    state_.apply(time, *packet);
    session_->take(time, *packet, state_);
  }

  static LogTime at(double seconds) {
    return LogTime(Nanoseconds(static_cast<std::int64_t>(std::llround(seconds * 1e9))));
  }

  const ClearanceOutcome& outcome(std::size_t i = 0) {
    session_->settle();
    return session_->judge().outcomes().at(i);
  }

  test::TemporaryFolder folder_;
  Cell cell_;
  PacketTextDecoder decoder_;
  SessionState state_;
  std::optional<ClearanceSession> session_;
  std::uint64_t sequence_ = 0;
};

std::string device(const std::string& name, const std::string& model, const std::string& xyz) {
  return fmt::format("[[device]]\nname = \"{}\"\nmodel = \"{}.urdf\"\npose = {{ xyz = [{}] }}\n",
                     name, model, xyz);
}

TEST_F(ClearanceSessionTest, FindsTheMinimumBetweenTwoPackets) {
  // The hand passes the ball half way: at 0.6 rad, 0.15 m between their surfaces.
  const double x = 1.3 * std::cos(0.6), y = 1.3 * std::sin(0.6);
  open(device("arm", "arm", "0, 0, 0") + device("ball", "ball", fmt::format("{}, {}, 0", x, y)) +
       "[[clearance]]\nbetween = [\"arm\", \"ball\"]\nmin_m = 0.2\n");
  say(0, "joints arm 0\n");
  EXPECT_EQ(outcome().violations, 0U);
  say(1, "joints arm 1.2\n");
  const ClearanceOutcome& found = outcome();
  EXPECT_GE(found.least.distance_m, 0.15 - 1e-9);
  EXPECT_LE(found.least.distance_m, 0.15 + kTolerance_m);
  EXPECT_NEAR(static_cast<double>((found.least.time - at(0)).count()) * 1e-9, 0.5, 0.02);
  EXPECT_EQ(found.least.link_a, "arm/hand");
  EXPECT_EQ(found.least.link_b, "ball/ball");
  EXPECT_NEAR(lengthOf(found.least.on_a - found.least.on_b), found.least.distance_m, 1e-9);
  EXPECT_EQ(found.violations, 1U);
  EXPECT_EQ(found.spans.at(0).from, found.least.time);
  EXPECT_FALSE(found.is_violated);
}

TEST_F(ClearanceSessionTest, LosesNoPacketThatIsGathered) {
  open(device("ball", "ball", "0, 0, 0") + device("box", "box", "2, 0, 0") +
       "[[clearance]]\nbetween = [\"ball\", \"box\"]\nmin_m = 0.5\n");
  say(0, "pose ball 0 0 0 0 0 0 1\n");
  say(0.1, "pose ball 1.5 0 0 0 0 0 1\n");
  say(0.101, "pose ball 0 0 0 0 0 0 1\n");
  say(0.102, "pose ball 0.1 0 0 0 0 0 1\n");
  EXPECT_NEAR(outcome().least.distance_m, 0.35, 1e-6);
  EXPECT_EQ(outcome().violations, 1U);
  EXPECT_EQ(outcome().least.time, at(0.1));
}

TEST_F(ClearanceSessionTest, SlidingAlongAPlateStaysExactAndCheap) {
  open(device("slide", "slide", "-1, 0, 0.155") + device("plate", "plate", "0, 0, 0") +
       "[[clearance]]\nbetween = [\"slide\", \"plate\"]\nmin_m = 0.002\n");
  for (int i = 0; i <= 500; ++i) {
    say(0.02 * i, fmt::format("joints slide {:.4f}\n", 2 * std::fabs(i % 100 - 50) / 50));
  }
  EXPECT_NEAR(outcome().least.distance_m, 0.005, 1e-6);
  EXPECT_EQ(outcome().violations, 0U);
}

TEST_F(ClearanceSessionTest, SpansBeginAndEnd) {
  open(device("slide", "slide", "0, 0, 0") + device("box", "box", "1, 0, 0") +
       "[[clearance]]\nname = \"gap\"\nbetween = [\"slide\", \"b?x\"]\nmin_m = 0.1\n");
  const double way[] = {0, 0.75, 0.85, 0.2, 0.9, 0.1};
  for (int i = 0; i < 6; ++i) say(i, fmt::format("joints slide {}\n", way[i]));
  const ClearanceOutcome& found = outcome();
  EXPECT_EQ(found.violations, 2U);
  ASSERT_EQ(found.spans.size(), 2U);
  EXPECT_EQ(found.spans[0].from, at(1));
  EXPECT_EQ(found.spans[0].until, at(2));
  EXPECT_EQ(found.spans[1].from, at(4));
  EXPECT_EQ(found.least.distance_m, 0);
  EXPECT_FALSE(found.is_violated);
}

TEST_F(ClearanceSessionTest, AJumpIsNotSwept) {
  open(device("ball", "ball", "0, 0, 0") + device("box", "box", "2, 0, 0") +
       "[[clearance]]\nbetween = [\"ball\", \"box\"]\nmin_m = 0.1\n");
  say(0, "pose ball 0 0 0 0 0 0 1\n");
  say(1, "pose ball 4.5 0 0 0 0 0 1\n");
  EXPECT_EQ(outcome().violations, 0U);
  say(2, "pose ball 3 0 0 0 0 0 1\n");
  EXPECT_EQ(outcome().violations, 0U);
  say(3, "pose ball 1.2 0 0 0 0 0 1\n");
  EXPECT_EQ(outcome().violations, 1U) << "within 2 m it went through";
}

TEST_F(ClearanceSessionTest, WhatIsCarriedMayTouchItsCarrierAndExceptionsAnything) {
  const std::string devices = device("slide", "slide", "0, 0, 0") +
                              device("box", "box", "0, 0, 0") + device("ball", "ball", "0, 0.3, 0");
  open(devices + "[[clearance]]\nbetween = [\"*\", \"*\"]\nmin_m = 0.01\n");
  say(0, "pose box 0.15 0 0 0 0 0 1 in slide/sled\n");
  for (const ClearanceOutcome& each : session_->judge().outcomes()) {
    EXPECT_NE(each.device_a + each.device_b, "slidebox");
    EXPECT_EQ(each.violations, 0U);
  }
  say(1, "pose box 0.15 0 0 0 0 0 1\n");
  const auto& outcomes = session_->judge().outcomes();
  EXPECT_EQ(std::ranges::count_if(outcomes, [](const auto& each) { return each.violations > 0; }),
            1)
      << "let go, but still touching";
  open(devices +
       "[[clearance]]\nbetween = [\"*\", \"*\"]\nmin_m = 0.01\n"
       "except = [[\"b[o]x\", \"slide/sled\"]]\n");
  say(0, "pose box 0 0 0 0 0 0 1\n");
  for (const ClearanceOutcome& each : session_->judge().outcomes()) EXPECT_EQ(each.violations, 0U);
}

TEST_F(ClearanceSessionTest, WhatAppearsLaterIsJudgedAndTheRestGoesOn) {
  open(device("slide", "slide", "0, 0, 0") + device("box", "box", "1, 0, 0") +
       device("ball", "ball", "0, 0.5, 0") + "optional = true\n" +
       "[[clearance]]\nbetween = [\"slide\", \"*\"]\nmin_m = 0.1\n");
  say(0, "joints slide 0.75\n");
  say(1, "add ball ball\n");
  say(2, "joints slide 0\n");
  session_->settle();
  const auto& outcomes = session_->judge().outcomes();
  ASSERT_EQ(outcomes.size(), 2U);
  EXPECT_NEAR(outcomes[0].least.distance_m, 0.05, 1e-6);
  EXPECT_EQ(outcomes[0].violations, 1U) << "one span, whatever appears meanwhile";
  EXPECT_EQ(outcomes[1].device_b, "ball");
  EXPECT_NEAR(outcomes[1].least.distance_m, 0.35, 1e-6);
  EXPECT_EQ(outcomes[1].violations, 0U);
}

TEST_F(ClearanceSessionTest, SelfLeavesOutAdjacentLinks) {
  open(device("snake", "snake", "0, 0, 0") + "[[clearance]]\nself = \"snake\"\nmin_m = 0.02\n");
  say(0, "joints snake 0 0 0\n");
  // s0 to s2 and s1 to s3 are a link apart, less what stands out behind.
  EXPECT_NEAR(outcome().least.distance_m, 0.4, 1e-6);
  say(1, "joints snake 3 0 0\n");
  EXPECT_GT(outcome().violations, 0U) << "folded back on itself";
}

TEST_F(ClearanceSessionTest, PatternsThatNameNothingAreTold) {
  open(device("ball", "ball", "0, 0, 0") + device("box", "box", "2, 0, 0") +
       "[[clearance]]\nbetween = [\"ball\", \"layer/nothing\"]\nmin_m = 0.1\n"
       "[[clearance]]\nbetween = [\"ball\", \"b*\"]\nmin_m = 0.1\n");
  say(0, "pose ball 0 0 0 0 0 0 1\n");
  EXPECT_EQ(session_->judge().unjudged(), std::vector<std::size_t>{0});
}

/// Calls `each` with the placements at every 2^-depth of the way, but for the first.
void walk(const CellPlacement& from, const CellPlacement& to, int depth,
          const std::function<void(const CellPlacement&)>& each) {
  if (depth == 0) return each(to);
  const CellPlacement middle = halfWay(from, to);
  walk(from, middle, depth - 1, each);
  walk(middle, to, depth - 1, each);
}

TEST_F(ClearanceSessionTest, AgreesWithBruteForceAtManyMomentsOfEachStep) {
  test::Random random(5);
  const std::string text = device("snake", "snake", "0, 0, 0") +
                           device("slide", "slide", "0.2, 0.35, 0.1") +
                           device("ball", "ball", "0.5, 0, 0.6") +
                           "[[clearance]]\nbetween = [\"snake\", \"*\"]\nmin_m = 5\n";
  for (int round = 0; round < 6; ++round) {
    SCOPED_TRACE(round);
    open(text);
    const auto lines = [&](double size) {
      const Vec3 snake = random.point(size), ball = random.point(0.3);
      const Quat turn = random.turn();
      return fmt::format(
          "joints snake {} {} {}\njoints slide {}\npose ball {} {} {} {} {} {} {} in "
          "slide/sled\n",
          snake.x, snake.y, snake.z, random.number(0.8), ball.x, ball.y, ball.z + 0.6, turn.x,
          turn.y, turn.z, turn.w);
    };
    say(0, lines(0.8));
    session_->settle();
    const CellPlacement before = session_->judge().placement();
    std::vector<double> least;
    for (const ClearanceOutcome& each : session_->judge().outcomes()) {
      least.push_back(each.least.distance_m);
    }
    say(1, lines(0.8));
    session_->settle();
    BodyStore bodies;
    const PosedScene scene = poseScene(cell_, state_);
    const auto pairs = clearancePairs(cell_, scene, before, bodies).pairs;
    const auto& outcomes = session_->judge().outcomes();
    walk(before, session_->judge().placement(), 7, [&](const CellPlacement& now) {
      for (const ClearancePair& pair : pairs) {
        const auto place = [&](LinkId id) { return now.devices[id.device].link_world[id.link]; };
        const double apart =
            treeDistance(*pair.body_a, *pair.body_b, inverseOfRigid(place(pair.b)) * place(pair.a))
                .distance_m;
        for (std::size_t i = 0; i < outcomes.size(); ++i) {
          if (outcomes[i].device_a == before.devices[pair.a.device].name &&
              outcomes[i].device_b == before.devices[pair.b.device].name) {
            least[i] = std::min(least[i], apart);
          }
        }
      }
    });
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      EXPECT_LE(outcomes[i].least.distance_m, least[i] + kTolerance_m) << outcomes[i].device_b;
      // Between two of its moments the brute force misses what moves in 1/128 of the step.
      EXPECT_GE(outcomes[i].least.distance_m, least[i] - 0.04) << outcomes[i].device_b;
    }
  }
}

TEST_F(ClearanceSessionTest, AboveTheAllowedDistanceThoseOfTheSamplesCount) {
  open(device("arm", "arm", "0, 0, 0") + device("ball", "ball", "1.3, 0, 0") +
       "[[clearance]]\nbetween = [\"arm\", \"ball\"]\nmin_m = 0.1\n");
  say(0, "joints arm -0.5\n");
  const double before = outcome().least.distance_m;
  say(1, "joints arm 0.6\n");
  EXPECT_EQ(outcome().least.distance_m, before) << "between them it was 0.15 m away";
  EXPECT_EQ(outcome().violations, 0U);
  say(2, "joints arm 0\n");
  EXPECT_NEAR(outcome().least.distance_m, 0.15, 1e-9);
}

TEST_F(ClearanceSessionTest, ManySmallStepsMissNoNewLeastDistance) {
  test::Random random(11);
  open(device("snake", "snake", "0, 0, 0") + device("slide", "slide", "0.2, 0.6, 0.1") +
       device("ball", "ball", "0.5, 0, 0.6") +
       "[[clearance]]\nbetween = [\"*\", \"*\"]\nmin_m = 0.05\n"
       "[[clearance]]\nself = \"snake\"\nmin_m = 0.01\n");
  std::map<std::tuple<std::size_t, std::string, std::string>, double> least;
  BodyStore bodies;
  double angle[4] = {};
  for (int i = 0; i < 400; ++i) {
    for (int k = 0; k < 4; ++k) angle[k] += random.number(0.05) + 0.01 * std::sin(0.02 * i + k);
    say(0.05 * i, fmt::format("joints snake {} {} {}\njoints slide {}\n", angle[0], angle[1],
                              angle[2], std::sin(angle[3])));
    session_->settle();
    const CellPlacement& now = session_->judge().placement();
    for (const ClearancePair& pair :
         clearancePairs(cell_, poseScene(cell_, state_), now, bodies).pairs) {
      const auto place = [&](LinkId id) { return now.devices[id.device].link_world[id.link]; };
      const double apart =
          treeDistance(*pair.body_a, *pair.body_b, inverseOfRigid(place(pair.b)) * place(pair.a))
              .distance_m;
      double& known = least
                          .try_emplace({pair.clearance, now.devices[pair.a.device].name,
                                        now.devices[pair.b.device].name},
                                       apart)
                          .first->second;
      known = std::min(known, apart);
    }
    for (const ClearanceOutcome& each : session_->judge().outcomes()) {
      const double of_samples = least.at({each.clearance, each.device_a, each.device_b});
      // Below the allowed distance, those between the samples count too.
      EXPECT_LE(each.least.distance_m, of_samples + kTolerance_m) << i << each.device_b;
      if (each.least.distance_m > each.min_m) {
        EXPECT_NEAR(each.least.distance_m, of_samples, 2e-9) << i << each.device_b;
      }
      if (of_samples < each.min_m) {
        EXPECT_GT(each.violations, 0U);
      }
    }
  }
}

}  // namespace
}  // namespace rocinante
