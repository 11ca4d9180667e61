#include "viewer/ui/model/misfits.h"

#include <gtest/gtest.h>

#include "core/packet/decoder.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

TEST(Misfits, AreWhatWasSaidAndMovesNothing) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  test::writeText(folder / "cell.toml",
                  "format = 1\n[[device]]\nname = \"arm\"\nmodel = \"arm.urdf\"\n"
                  "[[device]]\nname = \"other\"\nmodel = \"arm.urdf\"\n"
                  "[[device]]\nname = \"fits\"\nmodel = \"arm.urdf\"\n"
                  "[[device]]\nname = \"later\"\nmodel = \"arm.urdf\"\noptional = true\n");
  const auto cell = loadCell(folder / "cell.toml", {});
  ASSERT_TRUE(cell.ok());
  SessionState state;
  const auto decoder = makeDecoder("rk1");
  const Packet* packet = decoder->decode(
      bytesOf("RK1 me - -\njoints arm 1 2 3\njoint other trun=1\njoints fits 1\njoints later 1\n"
              "joints amr 1\nadd part box\njoints gone 1\nremove gone\n"));
  ASSERT_NE(packet, nullptr);
  state.apply(LogTime{}, *packet);
  const auto found = mismatchedDevices(*cell, poseScene(*cell, state), state);
  std::string text;
  for (const Misfit& one : found) text += one.device + " " + one.what + "\n";
  EXPECT_EQ(text,
            "amr is not a device of the cell and was not added: did you mean `arm`?\n"
            "arm received 3 joint values, but its model has 1, so none is used\n"
            "other has no joint `trun`\n"
            "part was added with the model `box`, which is not in the cell\n");
}

TEST(WhyNoSession, IsThatNothingOfTheCellIsMoved) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  const auto cell = loadCell(folder / "arm.urdf", {});
  ASSERT_TRUE(cell.ok());
  const auto why = [&](const std::string& statements) {
    SessionState state;
    const auto decoder = makeDecoder("rk1");
    if (!statements.empty()) {
      state.apply(LogTime{}, *decoder->decode(bytesOf("RK1 me - -\n" + statements)));
    }
    return whyNoSession(*cell, state);
  };
  EXPECT_EQ(why(""), "has no packets");
  EXPECT_EQ(why("joints arm 1\n"), "");
  EXPECT_EQ(why("joints welder 1 2\njoints arm 1\n"), "") << "one is enough";
  EXPECT_EQ(why("event \"begun\"\n"), "") << "of any cell";
  EXPECT_EQ(why("joints welder 1\n"),
            "moves nothing of this cell: welder is not a device of the cell and was not added");
  EXPECT_EQ(why("joints arm 1 2\n"),
            "moves nothing of this cell: arm received 2 joint values, but its model has 1, so none "
            "is used");
}

}  // namespace
}  // namespace rocinante
