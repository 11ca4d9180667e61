// What is not judged is never the same, and is named.
#include "golden/run/run_coverage.h"

#include <gtest/gtest.h>

#include "tests/golden/run/demo_regressions.h"
#include "tests/golden/run/run_test.h"

namespace rocinante {
namespace {

using test::cellAt;
using test::kDemo;
using test::plus;
using test::SaidSession;
using test::textOfFindings;

class RunCoverageTest : public test::RunTest {};

/// No verdict without its coverage (docs/decisions/040).
TEST_F(RunCoverageTest, WhatIsNotJudgedIsNeverTheSame) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  const auto accepted = trackOf(cell, session);
  ASSERT_TRUE(accepted.ok());
  EXPECT_TRUE(accepted->left_out.empty()) << accountSentence(accepted->left_out);
  const RunJudgement whole = judgeRun({}, {&*accepted}, *accepted);
  EXPECT_TRUE(whole.coverage.judged.contains("arm/joint2"));
  EXPECT_TRUE(whole.coverage.judged.contains("event/" + accepted->events.front().text));
  EXPECT_TRUE(whole.coverage.lost.empty() && whole.coverage.masked.empty());

  // A seventh value: the model takes none of them.
  SaidSession changed = session;
  for (auto& said : changed.packets) {
    std::size_t at = said.body.find("joints arm ");
    if (at == std::string::npos) continue;
    at = said.body.find('\n', at);
    said.body.insert(at, " 0");
  }
  const auto unfit = trackOf(cell, changed);
  ASSERT_TRUE(unfit.ok());
  const RunJudgement judged = judgeRun({}, {&*accepted}, *unfit);
  ASSERT_FALSE(judged.findings.empty());
  EXPECT_NE(judged.rule.find("arm/joint1: no"), std::string::npos) << textOfFindings(judged);
  EXPECT_NE(whyLeftOut(judged.coverage.left_out, "arm").find("it states 7 values"),
            std::string::npos);
  // Accepted so, nothing of the joints is judged, and nobody takes it for more.
  const RunJudgement both = judgeRun({}, {&*unfit}, *unfit);
  EXPECT_FALSE(both.notes.empty());

  // A cell that has none of the devices.
  const Cell empty;
  SaidSession silent;
  for (auto said : session.packets) {
    const std::size_t joints = said.body.find("joints arm ");
    if (joints == std::string::npos) continue;
    said.body = said.body.substr(joints, said.body.find('\n', joints) + 1 - joints);
    silent.packets.push_back(said);
  }
  const auto nothing = trackOf(empty, silent);
  ASSERT_TRUE(nothing.ok());
  RunSpec by_origin;
  by_origin.align = RunAlign::origin;
  const RunJudgement none = judgeRun(by_origin, {&*nothing}, *nothing);
  EXPECT_FALSE(none.comparable) << none.rule;
  EXPECT_NE(none.rule.find("nothing was judged"), std::string::npos) << none.rule;
  EXPECT_NE(none.rule.find("`arm`"), std::string::npos) << none.rule;
}

TEST_F(RunCoverageTest, ADeviceOfAnyAcceptedSessionIsJudged) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  const SaidSession session = SaidSession::read(kDemo / "session.mcap");
  SaidSession without = session;
  without.erase("gantry", 0, 1e9);
  const auto whole = trackOf(cell, session);
  const auto part = trackOf(cell, without);
  ASSERT_TRUE(whole.ok() && part.ok());
  RunSpec spec;
  spec.align = RunAlign::origin;
  // Absent is accepted, and so is what the other one does.
  expectSilent("with", judgeRun(spec, {&*part, &*whole}, *whole));
  SaidSession changed = session;
  changed.joint("gantry", 0, 5, 6, plus(0.1));
  const auto run = trackOf(cell, changed);
  ASSERT_TRUE(run.ok());
  const RunJudgement judged = judgeRun(spec, {&*part, &*whole}, *run);
  EXPECT_FALSE(judged.findings.empty()) << "only the second accepted session has the gantry";
}

TEST(RunNames, NamesThatMatchNothingAreNamed) {
  const Cell cell = cellAt(kDemo / "demo.cell.toml");
  RunSpec spec;
  spec.masks.push_back({"drawing/planner/*"});
  spec.masks.push_back({"gantri"});
  spec.own_limits["arm/joint9"].joint_deg = 1;
  spec.own_limits["arm"].joint_deg = 1;
  const auto complaints = namesThatMatchNothing(spec, cell, {"drawing/planner/path"});
  ASSERT_EQ(complaints.size(), 2U);
  EXPECT_NE(complaints[0].find("did you mean `gantry`"), std::string::npos) << complaints[0];
  EXPECT_NE(complaints[1].find("`arm/joint9`"), std::string::npos) << complaints[1];
}

}  // namespace
}  // namespace rocinante
