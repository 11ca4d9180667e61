#include "golden/session/session_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "golden/why/frame_why.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

constexpr const char* kTwoBars = R"(<robot name="arm"><link name="base"/>
<link name="one"><visual><origin xyz="0.5 0 0.3"/><geometry><box size="1 0.2 0.2"/></geometry></visual></link>
<link name="two"><visual><origin xyz="0.5 0 -0.3"/><geometry><box size="1 0.2 0.2"/></geometry></visual></link>
<joint name="first" type="continuous"><parent link="base"/><child link="one"/><axis xyz="0 0 1"/></joint>
<joint name="second" type="continuous"><parent link="base"/><child link="two"/><axis xyz="0 0 1"/></joint>
</robot>)";

/// Both joints turn at 5 rad/s, the first one `ahead` of the second.
std::vector<std::pair<std::int64_t, std::string>> turning(double ahead) {
  std::vector<std::pair<std::int64_t, std::string>> packets;
  for (int i = 0; i <= 20; ++i) {
    const double angle = 0.05 * i;
    packets.emplace_back(
        i * 10, "joints arm " + std::to_string(angle + ahead) + " " + std::to_string(angle) + "\n");
  }
  return packets;
}

TEST(SessionComparison, NamesTheJointThatChangedAndByAllOfIt) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", kTwoBars);
  test::writeText(folder / "cell.toml",
                  "format = 1\n[[device]]\nmodel = \"arm.urdf\"\n[[camera]]\nname = \"above\"\n"
                  "eye = [0, -2, 3]\ntarget = [0, 0, 0]\n");
  test::writeSession(folder / "a.mcap", turning(0));
  test::writeSession(folder / "b.mcap", turning(0.2));
  SessionQuestion question;
  question.a = folder / "a.mcap";
  question.b = folder / "b.mcap";
  question.picture.width = 96;
  question.picture.height = 72;
  question.tolerance = Tolerance();
  const auto found = judgeSessions(folder / "cell.toml", {}, question, {});
  ASSERT_TRUE(found.ok()) << found.error().text();
  EXPECT_EQ(found->verdict(), Verdict::different);
  ASSERT_EQ(found->times_b.size(), found->report.frames.size());
  bool any_between = false;
  for (std::size_t i = 0; i < found->report.frames.size(); ++i) {
    const JudgedFrame& judged = found->report.frames[i];
    SCOPED_TRACE(judged.frame.name);
    // At the ends a joint that is late has nowhere to come from.
    if (!judged.frame.name.starts_with("between")) continue;
    any_between = true;
    EXPECT_EQ(judged.verdict, FrameVerdict::different);
    ASSERT_NE(judged.why, nullptr);
    ASSERT_EQ(judged.why->state.size(), 1U);
    EXPECT_EQ(judged.why->state[0].item, "arm/first");
    EXPECT_NEAR(judged.why->state[0].amount.value_or(0), 0.2, 1e-9);
    EXPECT_EQ(found->times_b[i], *judged.frame.time);
  }
  EXPECT_TRUE(any_between);
  EXPECT_THAT(sessionText(*found), testing::HasSubstr(", b at "));
  // Behaviour names the joint alone, too.
  for (const RunFinding& finding : found->run().judgement.findings) {
    EXPECT_THAT(finding.item, testing::AnyOf("arm/first", "arm/one"));
  }
}

TEST(SessionComparison, WhatIsLateBeyondTheLimitIsNamedWithItsTime) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", kTwoBars);
  const auto packets = [](std::int64_t late_ms) {
    std::vector<std::pair<std::int64_t, std::string>> said = {{0, "event \"go\"\n"}};
    for (int i = 1; i < 200; ++i) {
      said.emplace_back(i * 10 + (i > 100 ? late_ms : 0),
                        "joints arm " + std::to_string(0.01 * i) + " 0\n");
    }
    return said;
  };
  test::writeSession(folder / "a.mcap", packets(0));
  test::writeSession(folder / "b.mcap", packets(15));
  test::writeSession(folder / "c.mcap", packets(200));
  SessionQuestion question;
  question.a = folder / "a.mcap";
  question.b = folder / "b.mcap";
  question.pictures = false;
  const auto near = judgeSessions(folder / "arm.urdf", {}, question, {});
  ASSERT_TRUE(near.ok()) << near.error().text();
  EXPECT_EQ(near->verdict(), Verdict::same) << sessionText(*near);
  question.b = folder / "c.mcap";
  const auto late = judgeSessions(folder / "arm.urdf", {}, question, {});
  ASSERT_TRUE(late.ok()) << late.error().text();
  EXPECT_EQ(late->verdict(), Verdict::different);
  ASSERT_FALSE(late->run().judgement.findings.empty());
  const RunFinding& first = late->run().judgement.findings.front();
  EXPECT_EQ(first.item, "arm/first");
  EXPECT_NEAR(secondsOf(first.first_accepted), 1.05, 0.1);
}

TEST(SessionComparison, SeveralAcceptedRecordingsAreABand) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", kTwoBars);
  test::writeSession(folder / "a.mcap", turning(0));
  test::writeSession(folder / "c.mcap", turning(0.2));
  test::writeSession(folder / "within.mcap", turning(0.1));
  test::writeSession(folder / "beyond.mcap", turning(0.4));
  SessionQuestion question;
  question.a = folder / "a.mcap";
  question.picture.width = 96;
  question.picture.height = 72;
  const auto judged = [&](const char* b) {
    question.b = folder / b;
    auto found = judgeSessions(folder / "arm.urdf", {}, question, {});
    EXPECT_TRUE(found.ok()) << found.error().text();
    return std::move(*found);
  };
  EXPECT_EQ(judged("within.mcap").verdict(), Verdict::different);
  question.more_accepted = {folder / "c.mcap"};
  const SessionComparison within = judged("within.mcap");
  EXPECT_EQ(within.verdict(), Verdict::same) << sessionText(within);
  EXPECT_TRUE(within.report.frames.empty()) << "it looks like neither of them";
  EXPECT_EQ(within.run().accepted.size(), 2U);
  EXPECT_EQ(judged("c.mcap").verdict(), Verdict::same);
  const SessionComparison beyond = judged("beyond.mcap");
  EXPECT_EQ(beyond.verdict(), Verdict::different);
  EXPECT_FALSE(beyond.report.frames.empty());
  EXPECT_EQ(beyond.run().judgement.findings.front().item, "arm/first");
}

}  // namespace
}  // namespace rocinante
