#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "golden/session/session_comparison.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/ui/study/parting_study.h"

namespace rocinante {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Packets = std::vector<std::pair<std::int64_t, std::string>>;

/// `golden session A B` and the window that shows B beside A give one answer.
class WindowAndSession : public testing::Test {
 protected:
  WindowAndSession() {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    test::writeText(folder_ / "cell.toml",
                    "format = 1\n[[device]]\nname = \"left\"\nmodel = \"arm.urdf\"\n"
                    "[[device]]\nname = \"right\"\nmodel = \"arm.urdf\"\n");
  }

  /// Two arms that turn for 4 s, a packet every 10 ms, each `late_ms` later.
  static Packets turning(std::int64_t late_ms = 0) {
    Packets packets;
    for (int i = 0; i <= 400; ++i) {
      const std::string turn = std::to_string(std::sin(0.01 * i));
      packets.emplace_back(i == 0 ? 0 : i * 10 + late_ms,
                           "joints left " + turn + "\njoints right " + turn + "\n");
    }
    return packets;
  }

  /// What is apart by the window, after it was found that both say the same of it.
  std::vector<std::string> apart(const Packets& accepted, const Packets& fresh) {
    test::writeSession(folder_ / "a.mcap", accepted);
    test::writeSession(folder_ / "b.mcap", fresh);
    const auto cell = loadCell(folder_ / "cell.toml", {});
    EXPECT_TRUE(cell.ok());
    auto shown = Timeline::open(folder_ / "b.mcap");
    EventAlignment origins;
    origins.anchor_a = origins.anchor_b = shown->origin();
    const PartingStudy study(*cell, folder_ / "b.mcap", folder_ / "a.mcap", origins);
    study.wait();
    EXPECT_EQ(study.fault(), "");
    SessionQuestion question;
    question.a = folder_ / "a.mcap";
    question.b = folder_ / "b.mcap";
    question.pictures = false;
    const auto compared = judgeSessions(folder_ / "cell.toml", {}, question, {});
    EXPECT_TRUE(compared.ok());
    std::set<std::string> of_session, of_window;
    for (const RunFinding& finding : compared->run().judgement.findings) {
      const std::string item = apartItem(finding);
      of_session.insert(item);
      const auto at_worst = study.apartAt(compared->origin_b + finding.at_run);
      EXPECT_THAT(at_worst, testing::Contains(item)) << finding.what;
    }
    partings_ = study.found();
    for (const Parting& parting : partings_) {
      of_window.insert(parting.items.begin(), parting.items.end());
    }
    EXPECT_EQ(of_window, of_session);
    const auto& findings = compared->run().judgement.findings;
    const auto worst = std::ranges::max_element(findings, {}, severityOf);
    largest_ = study.largest();
    EXPECT_EQ(largest_.has_value(), worst != findings.end());
    if (largest_ && worst != findings.end()) {
      EXPECT_EQ(largest_->item, worst->item);
      EXPECT_EQ(largest_->at, compared->origin_b + worst->at_run);
    }
    return {of_window.begin(), of_window.end()};
  }
  void expectFrom(std::size_t parting, std::int64_t from_ms, std::int64_t until_ms) {
    ASSERT_LT(parting, partings_.size());
    constexpr auto kReach = std::chrono::milliseconds(20);
    EXPECT_LE(std::chrono::abs(partings_[parting].from - test::sessionTime(from_ms)), kReach);
    EXPECT_LE(std::chrono::abs(partings_[parting].until - test::sessionTime(until_ms)), kReach);
  }

  test::TemporaryFolder folder_;
  std::vector<Parting> partings_;
  std::optional<PartingPeak> largest_;
};

TEST_F(WindowAndSession, TheSame) { EXPECT_THAT(apart(turning(), turning()), IsEmpty()); }

TEST_F(WindowAndSession, LateByLessThanItMayBe) {
  EXPECT_THAT(apart(turning(), turning(15)), IsEmpty());
}

TEST_F(WindowAndSession, LateByMore) {
  EXPECT_THAT(apart(turning(), turning(60)), ElementsAre("left", "right"));
}

TEST_F(WindowAndSession, OnePacketBetweenTwentyMilliseconds) {
  Packets fresh = turning();
  fresh[151].second = "joints left 1.2\njoints right " + std::to_string(std::sin(1.51)) + "\n";
  EXPECT_THAT(apart(turning(), fresh), ElementsAre("left"));
  ASSERT_EQ(partings_.size(), 1U);
  expectFrom(0, 1510, 1520);
}

TEST_F(WindowAndSession, TwiceOnItsWay) {
  Packets fresh = turning();
  for (const int first : {100, 300}) {
    for (int i = first; i < first + 50; ++i) {
      fresh[i].second = "joints left " + std::to_string(std::sin(0.01 * i)) + "\njoints right " +
                        std::to_string(std::sin(0.01 * i) + 0.1) + "\n";
    }
  }
  EXPECT_THAT(apart(turning(), fresh), ElementsAre("right"));
  ASSERT_EQ(partings_.size(), 2U);
  expectFrom(0, 1000, 1500);
  expectFrom(1, 3000, 3500);
}

TEST_F(WindowAndSession, AnotherColour) {
  Packets fresh = turning();
  fresh[250].second += "color right #2040ff\n";
  fresh[300].second += "color right default\n";
  EXPECT_THAT(apart(turning(), fresh), ElementsAre("right"));
  ASSERT_EQ(partings_.size(), 1U);
  expectFrom(0, 2500, 3000);
}

TEST_F(WindowAndSession, TheLargestHasItsFigure) {
  Packets fresh = turning();
  fresh[100].second = "joints left 3\njoints right " + std::to_string(std::sin(1.0)) + "\n";
  EXPECT_THAT(apart(turning(), fresh), ElementsAre("left"));
  ASSERT_TRUE(largest_);
  EXPECT_FALSE(largest_->size.empty());
}

TEST_F(WindowAndSession, WhatHasNoFigureIsTheLargest) {
  Packets fresh = turning();
  fresh[100].second = "joints left 3\njoints right " + std::to_string(std::sin(1.0)) + "\n";
  fresh[250].second += "color right #2040ff\n";
  EXPECT_THAT(apart(turning(), fresh), ElementsAre("left", "right"));
  ASSERT_TRUE(largest_);
  EXPECT_TRUE(largest_->item.starts_with("right")) << largest_->item;
  EXPECT_EQ(largest_->size, "");
  EXPECT_EQ(largest_->at, test::sessionTime(2500));
}

TEST_F(WindowAndSession, ADeviceThatIsMissing) {
  Packets fresh = turning();
  for (auto& [at, text] : fresh) text = text.substr(0, text.find('\n') + 1);
  EXPECT_THAT(apart(turning(), fresh), ElementsAre("right"));
  ASSERT_EQ(partings_.size(), 1U);
  expectFrom(0, 0, 4000);
}

TEST_F(WindowAndSession, AnEventThatIsMissing) {
  Packets accepted = turning();
  accepted[100].second += "event \"picked\"\n";
  EXPECT_THAT(apart(accepted, turning()), ElementsAre("event/picked"));
}

}  // namespace
}  // namespace rocinante
