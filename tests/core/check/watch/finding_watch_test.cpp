#include "core/check/watch/finding_watch.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/live_blocks.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

constexpr std::string_view kArm = R"(<robot name="arm">
  <link name="base"/> <link name="hand"/>
  <joint name="turn" type="revolute"> <parent link="base"/> <child link="hand"/>
    <axis xyz="0 0 1"/> <limit lower="-2" upper="2" effort="1" velocity="3"/> </joint>
</robot>)";

constexpr std::string_view kCell = R"(format = 1
[[device]]
name = "arm"
model = "arm.urdf"
[[source]]
name = "me"
devices = ["arm"]
)";

/// A watch and the session that it judges, in simulated time.
class FindingWatchTest : public ::testing::Test {
 protected:
  void SetUp() override { load(kCell); }

  void load(std::string_view cell_text) {
    std::ofstream(folder_ / "arm.urdf") << kArm;
    std::ofstream(folder_ / "cell.toml") << cell_text;
    Result<Cell> cell = loadCell(folder_ / "cell.toml", {});
    ASSERT_TRUE(cell.ok()) << cell.error().text();
    cell_ = std::move(*cell);
    watch_.emplace(cell_, options_);
  }

  void send(std::string_view header, std::string_view statements) {
    text_.clear();
    fmt::format_to(std::back_inserter(text_), "RK1 {}\n{}\n", header, statements);
    watch_->add(now_, "rk1", true, bytesOf(text_));
  }
  /// A packet of the source with its next number.
  void say(std::string_view statements, std::string_view words = "") {
    const double time_s =
        static_cast<double>((now_.time_since_epoch() - 200us).count()) * 1e-9 + clock_off_s_;
    header_.clear();
    fmt::format_to(std::back_inserter(header_), "me@a {} {:.6f}{}", ++sequence_, time_s, words);
    send(header_, statements);
  }
  void update() {
    for (FindingChange& each : watch_->update(now_)) {
      told_.push_back(fmt::format("{}{}", each.begins ? "+" : "-", each.finding.rule));
      changes_.push_back(std::move(each));
    }
  }
  /// Time passes, with this many packets a second that hold `value`.
  void run(Nanoseconds span, int rate_hz, double value = 0.5) {
    const LogTime until = now_ + span;
    const Nanoseconds period = rate_hz > 0 ? Nanoseconds(1s) / rate_hz : Nanoseconds(250ms);
    while (now_ < until) {
      now_ += period;
      if (rate_hz > 0) {
        const bool restates = sequence_ % 50 == 0;
        say(fmt::format("joints arm {}{}", value, restates ? "\norder arm turn" : ""),
            restates && sequence_ > 0 ? " restated" : "");
      }
      if (now_ - updated_ >= 200ms) {
        updated_ = now_;
        update();
      }
    }
  }
  std::vector<std::string> take() { return std::exchange(told_, {}); }

  const test::TemporaryFolder folder_;
  Cell cell_;
  WatchOptions options_;
  std::optional<FindingWatch> watch_;
  LogTime now_{std::chrono::seconds(1'770'091'506)};
  LogTime updated_{};
  std::uint64_t sequence_ = 0;
  double clock_off_s_ = 0;
  std::string text_, header_;
  std::vector<std::string> told_;
  std::vector<FindingChange> changes_;
};

TEST_F(FindingWatchTest, ASessionThatFitsIsSilent) {
  run(20min, 5);
  EXPECT_THAT(take(), IsEmpty());
  EXPECT_FALSE(watch_->failed());
  EXPECT_GE(watch_->packets(), 6'000U);
}

TEST_F(FindingWatchTest, TellsWhenAFindingBeginsAndWhenItEnds) {
  run(90s, 10);
  const LogTime before = now_;
  run(3s, 10, 2.5);
  EXPECT_THAT(take(), ElementsAre("+joint.limit"));
  EXPECT_TRUE(watch_->failed());
  EXPECT_EQ(watch_->lasting(Severity::error), 1U);
  EXPECT_EQ(changes_[0].at, before + 100ms) << "the first packet beyond the limit";
  EXPECT_TRUE(changes_[0].fails);
  const LogTime last = now_;
  run(4s, 10);
  EXPECT_THAT(take(), IsEmpty()) << "the hold";
  run(2s, 10);
  EXPECT_THAT(take(), ElementsAre("-joint.limit"));
  EXPECT_EQ(changes_[1].at, last);
  EXPECT_EQ(changes_[1].finding.count, 30U);
  EXPECT_EQ(*changes_[1].finding.first, before + 100ms);
  EXPECT_EQ(watch_->lasting(Severity::error), 0U);
  EXPECT_TRUE(watch_->failed()) << "that one began stays true";
  run(200s, 10);
  EXPECT_THAT(take(), IsEmpty());
}

TEST_F(FindingWatchTest, ALastingFindingIsToldOnceAcrossWindows) {
  run(10s, 10);
  run(10min, 10, 2.5);
  EXPECT_THAT(take(), ElementsAre("+joint.limit"));
  run(10s, 10);
  EXPECT_THAT(take(), ElementsAre("-joint.limit"));
  EXPECT_EQ(changes_[1].finding.count, 6'000U) << "of all windows";
}

TEST_F(FindingWatchTest, ASilenceLastsAsLongAsItLasts) {
  run(30s, 50);
  const LogTime last = now_;
  run(10min, 0);
  EXPECT_THAT(take(), UnorderedElementsAre("+source.silence", "+source.unrestated"));
  for (const FindingChange& each : changes_) {
    EXPECT_THAT(each.finding.text, ::testing::ContainsRegex("(0.38|10) s are expected"));
    EXPECT_LE(each.at - last, 10s + 400ms);
  }
  changes_.clear();
  run(20s, 50);
  EXPECT_THAT(take(), UnorderedElementsAre("-source.silence", "-source.unrestated"));
  for (const FindingChange& each : changes_) {
    EXPECT_THAT(each.finding.text, ::testing::ContainsRegex("60[01] s")) << "as long as it was";
  }
}

TEST_F(FindingWatchTest, WhatNobodyEverDidIsToldAfterTheHold) {
  run(4s, 0);
  EXPECT_THAT(take(), IsEmpty()) << "a source may be started a moment later";
  run(2s, 0);
  EXPECT_THAT(take(), ElementsAre("+device.undriven"));
  run(30s, 10);
  EXPECT_THAT(take(), ElementsAre("-device.undriven"));
}

TEST_F(FindingWatchTest, WhatFlickersIsToldLessAndLess) {
  run(10s, 10);
  for (int i = 0; i < 200; ++i) {
    run(100ms, 10, 2.5);
    run(8s, 10);
  }
  // 5 s, 10 s: from then on it lasts.
  EXPECT_THAT(take(), ElementsAre("+joint.limit", "-joint.limit", "+joint.limit"));
  EXPECT_EQ(watch_->begun(), 2U);
}

TEST_F(FindingWatchTest, ACellsFaultsAreToldAtOnceAndNeverEnd) {
  load("format = 1\n[[device]]\nname = \"arm\"\nmodel = \"gone.urdf\"\n");
  update();
  ASSERT_FALSE(take().empty());
  EXPECT_TRUE(watch_->failed());
  EXPECT_GT(changes_[0].finding.line, 0);
  run(200s, 1);
  for (const FindingChange& each : changes_) {
    EXPECT_TRUE(each.begins || each.finding.file.empty()) << each.finding.text;
  }
}

TEST_F(FindingWatchTest, ABaselineAndTheLeastSeverityPassOver) {
  const Result<Baseline> baseline = Baseline::parse(
      bytesOf("{\"format\": 1, \"accepted\": [{\"rule\": \"joint.limit\", \"subject\": \"arm\", "
              "\"text\": \"arm/turn is outside its limits [#, #]; the worst is #\"}]}"),
      "known.json");
  ASSERT_TRUE(baseline.ok()) << baseline.error().text();
  options_.baseline = &*baseline;
  options_.least = Severity::error;
  load(kCell);
  run(10s, 10);
  run(5s, 10, 2.5);
  run(30s, 0);
  EXPECT_THAT(take(), IsEmpty()) << "accepted, and silences are warnings";
  EXPECT_FALSE(watch_->failed());
}

TEST_F(FindingWatchTest, ALaterDriftOfAClockIsFound) {
  // Long after the beginning the clock gains 400 ppm, and later is right again.
  run(20min, 5);
  for (int i = 0; i < 600; ++i) {
    clock_off_s_ += 400e-6;
    run(1s, 5);
  }
  EXPECT_THAT(take(), ElementsAre("+source.clock-drift"));
  run(15min, 5);
  EXPECT_THAT(take(), ElementsAre("-source.clock-drift"));
}

TEST_F(FindingWatchTest, ARateIsJudgedWhileItIsWrong) {
  load(std::string(kCell) + "rate_hz = [9, 11]\n");
  run(5min, 10);
  EXPECT_THAT(take(), IsEmpty());
  run(1min, 20);
  EXPECT_THAT(take(), ElementsAre("+source.rate"));
  run(30s, 10);
  EXPECT_THAT(take(), ElementsAre("-source.rate"));
}

TEST_F(FindingWatchTest, JitterIsThatOfTheLastMinutes) {
  load(std::string(kCell) + "jitter_ms = 5\n");
  run(5min, 20);
  EXPECT_THAT(take(), IsEmpty());
  // One packet in three is late: over the whole session hardly one in a hundred.
  for (int i = 0; i < 600; ++i) {
    run(50ms, 20);
    now_ += i % 3 == 0 ? 20ms : 0ms;
  }
  EXPECT_THAT(take(), ElementsAre("+source.jitter"));
  // Restatements, which do not count, leave a gap now and then: the part is what tells.
  run(6min, 20);
  EXPECT_THAT(take(), ElementsAre("-source.jitter"));
}

TEST_F(FindingWatchTest, TheKernelsLossesBeginAndEnd) {
  run(10s, 10);
  LossSpan loss;
  loss.endpoint = "udp://127.0.0.1:19960";
  loss.from = now_ - 1s;
  loss.until = now_;
  loss.counts.kernel = 7;
  watch_->addLoss(loss);
  run(1s, 10);
  EXPECT_THAT(take(), ElementsAre("+log.loss"));
  run(10s, 10);
  EXPECT_THAT(take(), ElementsAre("-log.loss"));
  EXPECT_EQ(changes_[1].finding.count, 7U);
}

TEST_F(FindingWatchTest, TwentyFourHoursTakeNoMoreMemoryThanOne) {
  // Findings begin and end, devices with new names come and go, a device changes its model.
  const auto step = [&](double value) {
    now_ += 4s;
    say(fmt::format("joints arm {}{}", value, sequence_ % 2 == 0 ? "\norder arm turn" : ""),
        sequence_ % 2 == 0 && sequence_ > 0 ? " restated" : "");
    update();
  };
  const auto hour = [&](int number) {
    for (int minute = 0; minute < 60; ++minute) {
      for (int i = 0; i < 12; ++i) step(0.5);
      for (int i = 0; i < 3; ++i) step(2.5);
      // A name that was removed stays in the state, within the limits of packets: these come again
      // every other hour.
      const int id = 60 * (number % 2) + minute;
      say(fmt::format("joints stranger{} 1 2 3\nhide layer/unknown{}", id, id));
      say(fmt::format("add part{} arm.urdf\njoints part{} 5\nshow part{}/none", id, id, id));
      say(fmt::format("remove part{}\nremove stranger{}\njoints part{} 1", id, id, id));
      say(fmt::format("remove part{}", id));
    }
    told_.clear();
    told_.shrink_to_fit();
    changes_.clear();
    changes_.shrink_to_fit();
    return test::liveBlocks();
  };
  std::int64_t after_two = 0, most_later = 0;
  for (int i = 0; i < 24; ++i) {
    const std::int64_t blocks = hour(i);
    if (i == 1) after_two = blocks;
    if (i > 1) most_later = std::max(most_later, blocks);
  }
  std::printf("%lld blocks after two hours, at most %lld later; %llu findings began\n",
              static_cast<long long>(after_two), static_cast<long long>(most_later),
              static_cast<unsigned long long>(watch_->begun()));
  EXPECT_GT(watch_->begun(), 1'000U);
  // Names of the last minutes differ in length; state that the fold itself keeps is bounded.
  EXPECT_LE(most_later, after_two + 64);
}

TEST_F(FindingWatchTest, ManyFindingsAreBounded) {
  run(1s, 10);
  for (int i = 0; i < 1'200; ++i) say(fmt::format("joints stranger{} 1", i));
  now_ += 1s;
  update();
  EXPECT_EQ(take().size(), FindingWatch::kMax);
  EXPECT_TRUE(watch_->isFull());
}

TEST_F(FindingWatchTest, ItsTextAndItsJsonSayTheSame) {
  run(1s, 10);
  run(1s, 10, 2.5);
  run(6s, 10);
  ASSERT_EQ(changes_.size(), 2U);
  EXPECT_EQ(findingChangeText(changes_[0]),
            "2026-02-03T04:05:07.100Z begins: error: arm/turn is outside its limits "
            "[-114.592°, 114.592°]; the worst is 143.239° [joint.limit]");
  EXPECT_EQ(findingChangeText(changes_[1]),
            "2026-02-03T04:05:08.000Z ends: error: arm/turn is outside its limits "
            "[-114.592°, 114.592°]; the worst is 143.239° [joint.limit] (10 times in 0.9 s)");
  const auto json = nlohmann::json::parse(findingChangeJson(changes_[1]));
  EXPECT_EQ(json["event"], "ends");
  EXPECT_EQ(json["rule"], "joint.limit");
  EXPECT_EQ(json["count"], 10);
  EXPECT_EQ(json["at"], json["last"]);
  EXPECT_EQ(json["fails"], true);
  EXPECT_EQ(json["subject"], "arm");
  EXPECT_THAT(findingChangeJson(changes_[0]), ::testing::EndsWith("}\n"));
}

}  // namespace
}  // namespace rocinante
