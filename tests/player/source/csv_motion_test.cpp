#include "player/source/csv_motion.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "core/base/atomic_file.h"
#include "core/foreign/table/csv_line.h"
#include "tests/support/shared_data.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

Result<CsvMotion> read(std::string_view text, const std::vector<std::string>& columns = {}) {
  return readCsvMotion(text, "m.csv", "arm", columns);
}

/// The same for a table whose columns name their devices.
Result<CsvMotion> readCell(std::string_view text) { return readCsvMotion(text, "m.csv", "", {}); }

std::string errorOf(std::string_view text, const std::vector<std::string>& columns = {}) {
  const auto motion = read(text, columns);
  return motion.ok() ? "no error" : motion.error().text();
}

/// Each signal with its changes: the row, and the value.
std::string signalsOf(const CsvMotion& motion) {
  std::string text;
  for (std::size_t i = 0; i < motion.signals.columns().size(); ++i) {
    const NamedSignal& signal = motion.signals.columns()[i].signal;
    text += signalNameText(signal.device, signal.name) + ":";
    for (const CsvSignals::Change& change : motion.signals.changes()) {
      if (change.index != i) continue;
      text += fmt::format(" {} ", change.row);
      if (change.kind == SignalKind::number) text += fmt::format("{}", change.number);
      if (change.kind == SignalKind::boolean) text += change.number != 0 ? "true" : "false";
      if (change.kind == SignalKind::text) text += motion.signals.textOf(change);
    }
    text += "\n";
  }
  return text;
}

TEST(CsvMotion, ColumnsOfSignalsAreNamedOrHaveNoNumbers) {
  const auto motion =
      readCell(
          "t,signal arm load,arm.j1,signal arm/tip f%20x,signal - estop,arm.mode,note,free.text\n"
          "0,1e-12,1,1e300,true,auto,None,nan\n1,1E-12,2,,False,auto,\"a \"\"b\"\"\",TRUE\n"
          "2,2,3,-,false,7,n/a,false\n")
          .value();
  EXPECT_EQ(signalsOf(motion),
            "signal arm load: 0 1e-12 2 2\nsignal arm/tip f%20x: 0 1e+300\n"
            "signal - estop: 0 true 1 false\nsignal arm mode: 0 auto 2 7\n"
            "signal - note: 1 a \"b\"\nsignal free text: 1 true 2 false\n");
  EXPECT_THAT(motion.devices[0].joints, ElementsAre("j1"));
  EXPECT_THAT(motion.row(2), ElementsAre(3));
  EXPECT_TRUE(motion.left_out.empty());
  // All but the explicit ones are of the device that is named.
  EXPECT_EQ(signalsOf(read("t,a,mode,arm.on,signal - x\n0,1,run,true,2\n").value()),
            "signal - x: 0 2\nsignal arm mode: 0 run\nsignal arm arm.on: 0 true\n");
  // Also where the end of its name is that of a pose.
  const auto tip = readCell("t,arm.j1,signal arm/tool0 tip:x,arm/tool0:x\n0,1,2,3\n").value();
  EXPECT_EQ(signalsOf(tip), "signal arm/tool0 tip:x: 0 2\n");
  EXPECT_EQ(accountSentence(tip.left_out), "left out: 1 column `arm/tool0:x` (the pose of a link)");
  // What is derived of other columns says nothing of its own.
  const auto derived = readCell(
                           "t,arm.j1,d/dt arm.j1,mean 0.5 d/dt arm/tool0:x,arm.j1 - arm.j2,"
                           "signal - a - signal - b\n0,1,2,3,4,5\n")
                           .value();
  EXPECT_EQ(signalsOf(derived), "");
  EXPECT_EQ(derived.devices.size(), 1U);
  EXPECT_EQ(accountSentence(derived.left_out),
            "left out: 1 column `d/dt arm.j1` (derived of others), 1 column `mean 0.5 d/dt "
            "arm/tool0:x` (derived of others), 1 column `arm.j1 - arm.j2` (derived of others), 1 "
            "column `signal - a - signal - b` (derived of others)");
  // Only signals are a table, too.
  EXPECT_EQ(signalsOf(readCell("t,signal - x\n0,2\n").value()), "signal - x: 0 2\n");
}

TEST(CsvMotion, WhatCannotBeASignalIsNamed) {
  const std::string odd = "bell \a";
  const auto motion =
      readCell("t,arm.j1,signal a%zz x,arm.on,signal arm on,signal arm mode\n0,1,2,true,3," + odd +
               "\n1,1,2,true,3," + std::string(4097, 'x') + "\n")
          .value();
  EXPECT_EQ(signalsOf(motion), "signal arm on: 0 3\nsignal arm mode:\n");
  EXPECT_EQ(
      accountSentence(motion.left_out),
      "left out: 1 column `signal a%zz x` (packets have no such name), 1 column `arm.on` (stated "
      "twice: the first of them counts), 2 values `signal arm mode` (a text of more than "
      "4,096 bytes, not in UTF-8, or with control characters; the first at line 2)");
}

TEST(CsvMotion, ReadsTheNumbersOfEachRow) {
  const auto motion = read("t,a,b\n0,1.50,-2e-3\n0.5, +.5 ,5.\n").value();
  ASSERT_EQ(motion.devices.size(), 1U);
  EXPECT_EQ(motion.devices[0].name, "arm");
  EXPECT_THAT(motion.devices[0].joints, ElementsAre("a", "b"));
  ASSERT_EQ(motion.rowCount(), 2U);
  EXPECT_THAT(motion.row(0), ElementsAre(1.5, -2e-3));
  EXPECT_THAT(motion.row(1), ElementsAre(0.5, 5));
}

TEST(CsvMotion, TimesAreExactToTheNanosecond) {
  const std::pair<const char*, Nanoseconds> times[] = {
      {"0.000000001", 1ns},
      {"1700000000.123456789", 1'700'000'000'123'456'789ns},
      {"1e-05", 10us},
      {"1.5E+1", 15s},
      {"-0.25", -250ms},
      {"0.30000000000000004", 300ms},
      {"0.0000000005", 1ns},
      {"0.00000000049999", 0ns},
      {"12345678901234567890e-15", 12'345'678'901'235ns},
      {"0e99999", 0ns},
      {".5", 500ms},
      {"1e-400", 0ns},
      {"00000000000000000000000000000000000000001", 1s},
      {"1.0000000000000000000000000000000000000001", 1s},
  };
  for (const auto& [text, time] : times) {
    SCOPED_TRACE(text);
    const auto motion = read("t,a\n" + std::string(text) + ",1\n");
    ASSERT_TRUE(motion.ok()) << motion.error().text();
    EXPECT_EQ(motion->times[0], time);
  }
}

TEST(CsvMotion, RefusesWhatIsNoTime) {
  for (const char* text :
       {"", "x", "nan", "inf", "1e30", "9223372036.9", "1,", "0x1", "1 2", "-"}) {
    SCOPED_TRACE(text);
    EXPECT_FALSE(read("t,a\n" + std::string(text) + ",1\n").ok());
  }
}

TEST(CsvMotion, SaysLineAndColumnOfWhatItRefuses) {
  EXPECT_EQ(errorOf("t,a,b\n0,1,2\n1,1\n"),
            "the row has 2 fields, the header has 3 (m.csv, line 3, column 3)");
  EXPECT_EQ(errorOf("t,a,b\n0,1,2\n\n1,1,2x\n"),
            "`2x` is not a number that packet text allows, in `b` (m.csv, line 4, column 5)");
  EXPECT_EQ(errorOf("t,a\n0,\n"), "the table has no joint column (m.csv, line 1, column 1)");
  EXPECT_EQ(errorOf("t,a\n0,nan\n"), "the table has no joint column (m.csv, line 1, column 1)");
  EXPECT_EQ(errorOf("t,a,b\n0,nan,1\n1,2,3x\n"),
            "`3x` is not a number that packet text allows, in `b` (m.csv, line 3, column 5)");
  EXPECT_THAT(errorOf("x,a\n0,1\n"), testing::HasSubstr("no column is the time"));
  EXPECT_THAT(errorOf("x,a\n0,1\n"), testing::HasSubstr("the columns are `x`, `a` (m.csv)"));
  EXPECT_EQ(errorOf("t,a\n1,1\n0.5,1\n"),
            "the time goes back: `0.5` follows a later time (m.csv, line 3, column 1)");
  EXPECT_EQ(errorOf("t,a\nsoon,1\n"), "`soon` is not a time (m.csv, line 2, column 1)");
  EXPECT_EQ(errorOf("t,a,a\n"), "two columns are named `a` (m.csv, line 1, column 1)");
  EXPECT_THAT(errorOf("t,,a\n"), testing::HasSubstr("its first line is not a header"));
  EXPECT_THAT(errorOf("t\n0\n"), testing::HasSubstr("its first line is not a header"));
  EXPECT_EQ(errorOf("t,a\n"), "there is no row below the header (m.csv, line 1, column 1)");
  EXPECT_EQ(errorOf(""), "the file has no header row (m.csv)");
  EXPECT_FALSE(read("t,\"a\n0,1\n").ok());
  EXPECT_EQ(errorOf("t,a\n0,\"1\n"), "a quoted field is not closed (m.csv, line 2, column 3)");
}

TEST(CsvMotion, ChoosesColumnsInTheOrderAsked) {
  const auto motion = read("a,time,note,b\n1,0,x,2\n3,1,y,4\n", {"b", "a"}).value();
  EXPECT_THAT(motion.devices[0].joints, ElementsAre("b", "a"));
  EXPECT_THAT(motion.row(1), ElementsAre(4, 3));
  EXPECT_EQ(errorOf("t,a\n0,1\n", {"c"}), "no column is named `c` (m.csv, line 1, column 1)");
  EXPECT_EQ(errorOf("t,a\n0,1\n", {"a", "a"}),
            "column `a` is chosen twice (m.csv, line 1, column 1)");
}

TEST(CsvMotion, ColumnsNameTheirDevices) {
  const auto motion =
      readCell(
          "t,arm.j1,tray:x,tray:y,tray:z,tray:qx,tray:qy,tray:qz,tray:qw,arm.j.2,tray.lid\n"
          "0,1,2,3,4,0,0,0,1,5,6\n")
          .value();
  ASSERT_EQ(motion.devices.size(), 2U);
  EXPECT_EQ(motion.devices[0].name, "arm");
  EXPECT_THAT(motion.devices[0].joints, ElementsAre("j1", "j.2"));
  EXPECT_THAT(motion.devices[0].joint_columns, ElementsAre(0, 8));
  EXPECT_TRUE(motion.devices[0].pose_columns.empty());
  EXPECT_THAT(motion.devices[1].joints, ElementsAre("lid"));
  EXPECT_THAT(motion.devices[1].pose_columns, ElementsAre(1, 2, 3, 4, 5, 6, 7));

  EXPECT_EQ(readCell("t,j1\n0,1\n").error().text(),
            "column `j1` names no device: without --device a column is DEVICE.JOINT or DEVICE:x, "
            ":y, :z, :qx, :qy, :qz, :qw (m.csv, line 1, column 1)");
  EXPECT_FALSE(readCell("t,.j1\n0,1\n").ok());
  EXPECT_FALSE(readCell("t,arm.\n0,1\n").ok());
  EXPECT_FALSE(readCell("t,:x\n0,1\n").ok());
  EXPECT_EQ(readCell("t,tray:x,tray:qw\n0,1,1\n").error().text(),
            "a pose needs seven columns: `tray:y` is missing (m.csv, line 1, column 1)");
  EXPECT_EQ(read("t,a\n0,-9007199254740992\n").error().text(),
            "`-9007199254740992` is not below 2^53, in `a` (m.csv, line 2, column 3)");
}

TEST(CsvMotion, AnEmptyFieldSaysNothingOfItsDevice) {
  const auto motion = readCell(
      "t,a.j1,a.j2,b.j1,b:x,b:y,b:z,b:qx,b:qy,b:qz,b:qw\n"
      "0,1,2,,,,,,,,\n1,,,3,,,,,,,\n2,,,,0,0,0,0,0,0,1\n");
  ASSERT_TRUE(motion.ok()) << motion.error().text();
  const CsvMotion::Device& a = motion->devices[0];
  const CsvMotion::Device& b = motion->devices[1];
  EXPECT_TRUE(hasValues(motion->row(0), a.joint_columns));
  EXPECT_FALSE(hasValues(motion->row(0), b.joint_columns));
  EXPECT_TRUE(hasValues(motion->row(1), b.joint_columns));
  EXPECT_FALSE(hasValues(motion->row(1), b.pose_columns));
  EXPECT_TRUE(hasValues(motion->row(2), b.pose_columns));
  EXPECT_THAT(readCell("t,b:x,b:y,b:z,b:qx,b:qy,b:qz,b:qw\n0,1,,0,0,0,0,1\n1,1,2,0,0,0,0,1\n")
                  .error()
                  .text(),
              testing::HasSubstr("a pose component of `b` has no value, but others have one"));
}

TEST(CsvMotion, AJointWithoutAValueKeepsItsLastOne) {
  const auto motion = readCell("t,a.j1,a.j2\n0,1,nan\n1,2,3\n2,-,4\n3,,\n4,5,n/a\n").value();
  EXPECT_FALSE(hasValues(motion.row(0), motion.devices[0].joint_columns));  // j2 has none yet
  EXPECT_THAT(motion.row(1), ElementsAre(2, 3));
  EXPECT_THAT(motion.row(2), ElementsAre(2, 4));
  EXPECT_FALSE(hasValues(motion.row(3), motion.devices[0].joint_columns));
  EXPECT_THAT(motion.row(4), ElementsAre(5, 4));
}

TEST(CsvMotion, ReadsTheDialectsOfTheImport) {
  const auto excel = read("\xEF\xBB\xBFt;a;b\r\n0,5;0,1;0,2\r\n").value();
  EXPECT_EQ(excel.times[0], 500ms);
  EXPECT_THAT(excel.row(0), ElementsAre(0.1, 0.2));
  const auto pandas = read(",timestamp,a,note\n0,1700000000500,1,begins\n").value();
  EXPECT_EQ(pandas.times[0], 1'700'000'000'500ms);
  EXPECT_THAT(pandas.devices[0].joints, ElementsAre("a"));
  EXPECT_EQ(accountSentence(pandas.left_out), "left out: 1 column (row numbers)");
  EXPECT_EQ(signalsOf(pandas), "signal arm note: 0 begins\n");
  const auto juggler = read("__time,/js/shoulder/position,/js/shoulder/effort\n1,2,3\n").value();
  EXPECT_THAT(juggler.devices[0].joints, ElementsAre("shoulder"));
  EXPECT_EQ(signalsOf(juggler), "signal arm shoulder.effort: 0 3\n");
  const auto tum = read("# timestamp tx ty tz qx qy qz qw\n1.5 1 2 3 0 0 0 1\n").value();
  EXPECT_TRUE(tum.devices[0].joints.empty());
  EXPECT_THAT(tum.devices[0].pose_columns, ElementsAre(0, 1, 2, 3, 4, 5, 6));
}

TEST(CsvMotion, TakesWhatSpreadsheetsWrite) {
  const auto motion = read("\xEF\xBB\xBF\"t\",\"joint \"\"1\"\"\"\r\n0,\"0.5\"\r\n\r\n1,2").value();
  EXPECT_THAT(motion.devices[0].joints, ElementsAre("joint \"1\""));
  ASSERT_EQ(motion.rowCount(), 2U);
  EXPECT_THAT(motion.row(0), ElementsAre(0.5));
}

TEST(CsvMotion, CutAnywhereItIsReadOrRefusedAndNeverCrashes) {
  const std::string whole = "t,\"a\"\"b\",c\n0,1,-2.5e-3\n0.001,\"3\",4\n";
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    const auto cut = std::make_unique<char[]>(length);
    std::copy_n(whole.data(), length, cut.get());
    const auto motion = read({cut.get(), length});
    if (motion.ok()) {
      EXPECT_GT(motion->rowCount(), 0U);
    }
  }
}

TEST(CsvMotion, AMegabyteOfNonsenseMakesAShortSentence) {
  const std::string text = errorOf("t,a\n0," + std::string(1'000'000, 'x') + "\n");
  EXPECT_LT(text.size(), 200U);
}

TEST(CsvMotion, ReadsTheRealPandaWithItsJitter) {
  const auto path = test::sharedData("recordings/panda_exciting_trajectory/panda_joints.csv");
  ROCINANTE_NEEDS_SHARED_DATA("recordings/panda_exciting_trajectory/panda_joints.csv");
  const auto motion = read(readFile(path).value()).value();
  EXPECT_EQ(motion.rowCount(), 20'544U);
  EXPECT_EQ(motion.devices[0].joints.size(), 7U);
  Nanoseconds shortest = 1h;
  Nanoseconds longest{};
  for (std::size_t i = 1; i < motion.rowCount(); ++i) {
    const Nanoseconds step = motion.times[i] - motion.times[i - 1];
    shortest = std::min(shortest, step);
    longest = std::max(longest, step);
  }
  EXPECT_EQ(shortest, 700us);
  EXPECT_EQ(longest, 8'810us);
  EXPECT_EQ(motion.times.back(), 20'999'100us);
}

TEST(CsvLine, SplitsByCommasOutsideQuotes) {
  std::vector<CsvField> fields;
  ASSERT_TRUE(splitCsvLine("a,\"b,c\", d ,", fields));
  ASSERT_EQ(fields.size(), 4U);
  EXPECT_EQ(fields[1].text, "b,c");
  EXPECT_EQ(fields[2].text, "d");
  EXPECT_EQ(fields[2].column, 10U);
  EXPECT_EQ(fields[3].text, "");
  EXPECT_FALSE(splitCsvLine("\"a\"b,c", fields));
  EXPECT_FALSE(splitCsvLine("a,\"b\"\"", fields));
}

}  // namespace
}  // namespace rocinante
