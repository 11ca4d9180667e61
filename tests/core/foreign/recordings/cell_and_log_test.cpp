#include "core/foreign/recordings/cell_and_log.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <utility>

#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

class CellAndLog : public testing::Test {
 protected:
  CellAndLog() {
    std::ofstream(cell_) << "format = 1\n";
    std::ofstream(table_) << "t,arm.a\n0,1\n";
    std::filesystem::create_directory(folder_ / "bag");
    for (const char* const name : {"bag/metadata.yaml", "bag/bag_0.db3"}) {
      std::ofstream(folder_ / name) << "";
    }
  }
  bool exchanged(std::string cell, std::string log) const {
    const std::pair before(cell, log);
    const bool exchanged = orderCellAndLog(cell, log);
    EXPECT_EQ(exchanged, std::pair(cell, log) != before);
    return exchanged;
  }

  const test::TemporaryFolder folder_;
  const std::string cell_ = (folder_ / "c.cell.toml").string();
  const std::string table_ = (folder_ / "session.csv").string();
};

TEST_F(CellAndLog, MayBeGivenInEitherOrder) {
  EXPECT_FALSE(exchanged(cell_, table_));
  EXPECT_TRUE(exchanged(table_, cell_));
  EXPECT_TRUE(exchanged(folder_ / "bag", cell_));
  EXPECT_FALSE(exchanged(folder_.path(), cell_)) << "a folder that is no bag";
}

TEST_F(CellAndLog, StayAsTheyAreWhereTheContentDoesNotTell) {
  EXPECT_FALSE(exchanged(table_, table_));
  EXPECT_FALSE(exchanged(cell_, cell_));
  EXPECT_FALSE(exchanged(table_, ""));
  EXPECT_FALSE(exchanged("", cell_));
  EXPECT_FALSE(exchanged(folder_ / "missing.mcap", cell_));
  // What can be read only once is not looked at.
  const std::string pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_FALSE(isRecording(pipe));
  EXPECT_FALSE(exchanged(pipe, cell_));
}

TEST_F(CellAndLog, OneAloneIsTheLogWhereItMayCarryItsCell) {
  std::filesystem::path cell = table_, log;
  ASSERT_TRUE(orderLogAndItsCell(cell, log).ok());
  EXPECT_EQ(cell, "");
  EXPECT_EQ(log, table_);
  cell = table_, log = cell_;
  ASSERT_TRUE(orderLogAndItsCell(cell, log).ok());
  EXPECT_EQ(cell, cell_);
  EXPECT_EQ(log, table_);
  cell = "missing.mcap", log = cell_;
  ASSERT_TRUE(orderLogAndItsCell(cell, log).ok());
  EXPECT_EQ(log, "missing.mcap");
  cell.clear();
  log.clear();
  EXPECT_EQ(orderLogAndItsCell(cell, log).error().what, "LOG is required");
}

}  // namespace
}  // namespace rocinante
