#include "viewer/ui/study/findings_study.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

TEST(FindingsStudy, FindsWhatCheckFinds) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  test::writeSession(
      folder / "s.mcap",
      {{0, "joints arm 0\n"}, {500, "joints stranger 1\n"}, {600, "joints arm 1\n"}});
  const auto cell = loadCell(folder / "arm.urdf", {});
  ASSERT_TRUE(cell.ok());
  FindingsStudy study(*cell, folder / "s.mcap");
  study.wait();
  ASSERT_TRUE(study.isFinished());
  EXPECT_EQ(study.progress(), 1);
  ASSERT_NE(study.report(), nullptr) << study.fault();
  const Findings& findings = study.report()->findings;
  const auto unknown = std::ranges::find(findings, "stranger", &Finding::subject);
  ASSERT_NE(unknown, findings.end());
  EXPECT_EQ(unknown->first, test::sessionTime(500));
}

TEST(FindingsStudy, ALogThatIsGoneIsASentence) {
  const test::TemporaryFolder folder;
  const Cell cell;
  FindingsStudy study(cell, folder / "gone.mcap");
  study.wait();
  EXPECT_EQ(study.report(), nullptr);
  EXPECT_NE(study.fault().find("gone.mcap"), std::string::npos);
}

}  // namespace
}  // namespace rocinante
