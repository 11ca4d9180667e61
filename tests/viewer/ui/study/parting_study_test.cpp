#include "viewer/ui/study/parting_study.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

using test::sessionTime;

TEST(PartingStudy, FindsWhereTwoSessionsArePart) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  test::writeSession(folder / "a.mcap",
                     {{0, "joints arm 0\n"}, {1000, "joints arm 1\n"}, {3000, "joints arm 0\n"}});
  test::writeSession(folder / "b.mcap", {{0, "joints arm 0\n"},
                                         {1100, "joints arm 1\n"},
                                         {2010, "joints arm 2\n"},
                                         {3000, "joints arm 0\n"}});
  const auto cell = loadCell(folder / "arm.urdf", {});
  ASSERT_TRUE(cell.ok());
  EventAlignment origin;
  origin.anchor_a = origin.anchor_b = sessionTime(0);
  PartingStudy study(*cell, folder / "a.mcap", folder / "b.mcap", origin);
  study.wait();
  EXPECT_EQ(study.fault(), "");
  const std::vector<Parting> expected{{sessionTime(1000), sessionTime(1100), {"arm"}},
                                      {sessionTime(2010), sessionTime(3000), {"arm"}}};
  EXPECT_EQ(study.found(), expected);
  EXPECT_TRUE(study.takeNews());
  EXPECT_FALSE(study.takeNews());
  EXPECT_EQ(study.beside(sessionTime(0), true), sessionTime(1000));
  EXPECT_EQ(study.apartAt(sessionTime(999)), std::vector<std::string>());
  EXPECT_EQ(study.apartAt(sessionTime(1050)), std::vector<std::string>{"arm"});
  EXPECT_EQ(study.beside(sessionTime(1000), true), sessionTime(2010));
  EXPECT_EQ(study.beside(sessionTime(2010), true), std::nullopt);
  EXPECT_EQ(study.beside(sessionTime(2010), false), sessionTime(1000));
  EXPECT_EQ(study.beside(sessionTime(1000), false), std::nullopt);
  // All that is apart is one joint: by one radian beyond its limit.
  const auto largest = study.largest();
  ASSERT_TRUE(largest);
  EXPECT_TRUE(largest->item.starts_with("arm/")) << largest->item;
  EXPECT_TRUE(largest->size.starts_with("57")) << largest->size;
  EXPECT_FALSE(largest->what.empty());
  EXPECT_FALSE(study.apartAt(largest->at).empty());
}

TEST(PartingStudy, TheLargestIsByItsLimitAndOfTheShownSessionsTime) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  const auto session = [&](const char* name, const char* there, int later_ms) {
    test::writeSession(folder / name, {{0 + later_ms, "joints arm 0\n"},
                                       {1000 + later_ms, std::string("joints arm ") + there + "\n"},
                                       {2000 + later_ms, "joints arm 0\n"},
                                       {5000 + later_ms, "joints arm 0\n"}});
  };
  session("a.mcap", "0.5", 500);
  session("b.mcap", "1.5", 0);
  const auto cell = loadCell(folder / "arm.urdf", {});
  ASSERT_TRUE(cell.ok());
  EventAlignment later;
  later.anchor_a = sessionTime(500);
  later.anchor_b = sessionTime(0);
  PartingStudy study(*cell, folder / "a.mcap", folder / "b.mcap", later);
  study.wait();
  EXPECT_EQ(study.fault(), "");
  const auto largest = study.largest();
  ASSERT_TRUE(largest);
  EXPECT_GE(largest->at, sessionTime(1500));
  EXPECT_LE(largest->at, sessionTime(2500));
  const PartingStudy alike(*cell, folder / "a.mcap", folder / "a.mcap", {});
  alike.wait();
  EXPECT_FALSE(alike.largest());
}

TEST(PartingStudy, ALogThatIsGoneIsASentence) {
  const test::TemporaryFolder folder;
  const Cell cell;
  const PartingStudy study(cell, folder / "gone.mcap", folder / "gone.mcap", {});
  study.wait();
  EXPECT_NE(study.fault().find("gone.mcap"), std::string::npos);
  EXPECT_TRUE(study.found().empty());
}

}  // namespace
}  // namespace rocinante
