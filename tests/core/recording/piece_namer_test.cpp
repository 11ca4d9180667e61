#include "core/recording/piece_namer.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/duration_text.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

const LogTime kStart{parseRfc3339("2026-02-03T04:05:06.789Z").value().time_since_epoch()};

class PieceNames : public ::testing::Test {
 protected:
  PieceNamer namer(const std::string& output, bool several = true, bool overwrite = false) {
    return PieceNamer({(folder / output).string(), several, overwrite});
  }
  std::string next(PieceNamer& from, LogTime start = kStart, bool ours = false) {
    const auto path = from.next(start, [&](const auto&) { return ours; });
    return path ? path->lexically_relative(folder.path()).string() : path.error().text();
  }
  void take(const std::string& name) { std::ofstream(folder / name) << "taken"; }

  test::TemporaryFolder folder;
};

TEST_F(PieceNames, FillTheNumberAnew) {
  PieceNamer pieces = namer("cell-%n.mcap");
  EXPECT_EQ(next(pieces), "cell-001.mcap");
  EXPECT_EQ(next(pieces), "cell-002.mcap");
}

TEST_F(PieceNames, FillTheTimeAnew) {
  PieceNamer pieces = namer("%Y%m%dT%H%M%S.mcap");
  EXPECT_EQ(next(pieces), "20260203T040506.mcap");
  EXPECT_EQ(next(pieces, kStart + 1h), "20260203T050506.mcap");
}

TEST_F(PieceNames, HaveANumberBeforeTheExtensionWhereNothingElseChanges) {
  PieceNamer pieces = namer("cell.mcap");
  EXPECT_EQ(next(pieces), "cell-001.mcap");
  EXPECT_EQ(next(pieces), "cell-002.mcap");
  PieceNamer rotated = namer("other.mcap", /*several=*/false);
  EXPECT_EQ(next(rotated), "other.mcap");
  EXPECT_EQ(next(rotated), "other-002.mcap");
  PieceNamer percent = namer("100%%.mcap");
  EXPECT_EQ(next(percent), "100%-001.mcap");
}

TEST_F(PieceNames, HaveANumberWhereTheTimeIsTheSameAgain) {
  PieceNamer pieces = namer("%H.mcap");
  EXPECT_EQ(next(pieces), "04.mcap");
  take("04.mcap");
  EXPECT_EQ(next(pieces), "04-002.mcap");
  EXPECT_EQ(next(pieces, kStart + 1h), "05.mcap");
}

TEST_F(PieceNames, OfAFolderAreTheDefault) {
  PieceNamer pieces = namer("");
  EXPECT_EQ(next(pieces), "session-20260203T040506Z.mcap");
  take("session-20260203T040506Z.mcap");
  EXPECT_EQ(next(pieces), "session-20260203T040506Z-002.mcap");
}

TEST_F(PieceNames, GiveWayToOthersFiles) {
  take("cell-002.mcap");
  take("cell-003.mcap");
  PieceNamer pieces = namer("cell-%n.mcap");
  EXPECT_EQ(next(pieces), "cell-001.mcap");
  EXPECT_EQ(next(pieces), "cell-004.mcap");
  EXPECT_EQ(next(pieces), "cell-005.mcap");
}

TEST_F(PieceNames, ReplaceOthersFilesByForceAndNeverTheirOwn) {
  take("cell-002.mcap");
  PieceNamer forced = namer("cell-%n.mcap", true, true);
  EXPECT_EQ(next(forced), "cell-001.mcap");
  EXPECT_EQ(next(forced), "cell-002.mcap");
  PieceNamer own = namer("cell-%n.mcap", true, true);
  EXPECT_EQ(next(own), "cell-001.mcap");
  EXPECT_EQ(next(own, kStart, /*ours=*/true), "cell-003.mcap");
}

TEST_F(PieceNames, TheFirstIsAsTheUserWantsIt) {
  take("cell-001.mcap");
  PieceNamer pieces = namer("cell-%n.mcap");
  EXPECT_EQ(next(pieces), "cell-001.mcap") << "who makes the file refuses it";
}

}  // namespace
}  // namespace rocinante
