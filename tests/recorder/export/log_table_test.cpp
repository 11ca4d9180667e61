#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/cell/cell.h"
#include "core/foreign/table/npy_header.h"
#include "core/foreign/table/row_spill.h"
#include "core/foreign/table/stored_zip.h"
#include "player/source/csv_stream.h"
#include "recorder/export/exports.h"
#include "tests/recorder/export/written_session.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using test::Said;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kArm =
    "<robot name=\"arm\"><link name=\"a\"/><link name=\"b\"/><link name=\"c\"/>"
    "<joint name=\"j1\" type=\"revolute\"><parent link=\"a\"/><child link=\"b\"/>"
    "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/><axis xyz=\"0 0 1\"/></joint>"
    "<joint name=\"j2\" type=\"prismatic\"><parent link=\"b\"/><child link=\"c\"/>"
    "<origin xyz=\"1 0 0\"/><limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>"
    "<axis xyz=\"0 0 1\"/></joint></robot>";

class LogTable : public testing::Test {
 protected:
  struct Made {
    std::string csv;
    std::vector<std::string> remarks, gaps;
    std::string left_out;
  };

  Made tableOf(const std::vector<Said>& all, TableOptions options = {}, const Cell* cell = nullptr,
               std::vector<std::string> devices = {}) {
    test::writeSession(folder_ / "s.mcap", all);
    return tableOf(folder_ / "s.mcap", options, cell, std::move(devices));
  }

  Made tableOf(const std::filesystem::path& log, TableOptions options = {},
               const Cell* cell = nullptr, std::vector<std::string> devices = {}) {
    auto session = MomentWalk::open(log);
    EXPECT_TRUE(session.ok());
    if (options.until == LogTime{}) options.until = LogTime::max();
    SessionTable table(cell, std::move(devices), options.signals);
    Made made;
    const auto writer = makeCsvTable([&](ByteView bytes) -> Status {
      made.csv += textOf(bytes);
      return {};
    });
    const auto report = writeTable(*session, table, *writer, options);
    if (!report.ok()) made.csv = report.error().what;
    if (report.ok()) made.left_out = accountSentence(report->left_out);
    made.remarks = table.remarks();
    made.gaps = table.gaps();
    return made;
  }

  /// The table with what is derived, or why there is none.
  std::string derivedOf(const std::vector<std::string>& texts, TableOptions options = {},
                        std::vector<std::string> devices = {}, const Cell* cell = nullptr) {
    auto session = MomentWalk::open(folder_ / "s.mcap");
    EXPECT_TRUE(session.ok());
    auto derived = DerivedColumns::of(cell, texts, folder_ / "s.mcap", *session);
    if (!derived.ok()) return derived.error().what;
    options.derived = &*derived;
    return tableOf(folder_ / "s.mcap", options, cell, std::move(devices)).csv;
  }

  Cell armCell() {
    EXPECT_TRUE(writeFileWhole(folder_ / "arm.urdf", bytesOf(kArm), true).ok());
    auto cell = loadCell(folder_ / "arm.urdf", {});
    EXPECT_TRUE(cell.ok());
    return std::move(*cell);
  }

  test::TemporaryFolder folder_;
};

TEST_F(LogTable, HasAColumnForEachJointAndPoseComponent) {
  const Made made = tableOf({{0, "RK1 s 0 0\norder arm up down\njoints arm 0.1 -0.25\n"},
                             {500'000'001, "RK1 s 1 0\npose tray 1 2 3 0 0 0 1\n"},
                             {1'000'000'000, "RK1 s 2 0\njoint arm down=4 up=1e-7\n"}});
  EXPECT_EQ(made.csv,
            "t,arm.up,arm.down,tray:x,tray:y,tray:z,tray:qx,tray:qy,tray:qz,tray:qw\n"
            "0,0.1,-0.25,,,,,,,\n"
            "0.500000001,0.1,-0.25,1,2,3,0,0,0,1\n"
            "1,1e-07,4,1,2,3,0,0,0,1\n");
  EXPECT_TRUE(made.gaps.empty());
  EXPECT_TRUE(made.remarks.empty());
}

TEST_F(LogTable, WritesNoRowForWhatIsNotInTheTable) {
  const std::vector<Said> all = {{0, "RK1 s 0 0\njoint arm a=1\n"},
                                 {10, "RK1 s 1 0\nevent \"x\"\n"},
                                 {20, "not a packet"},
                                 {30, "RK1 s 2 0\njoint leg a=2\n"},
                                 {40, "RK1 s 3 0\njoint arm a=1\n"}};
  EXPECT_EQ(tableOf(all, {}, nullptr, {"a*"}).csv, "t,arm.a\n0,1\n0.00000004,1\n");
  TableOptions changes;
  changes.rows = TableOptions::Rows::changed;
  EXPECT_EQ(tableOf(all, changes, nullptr, {"arm"}).csv, "t,arm.a\n0,1\n");
  EXPECT_EQ(tableOf(all, {}, nullptr, {"nobody"}).csv,
            "no chosen device has joints or a pose; there are arm, leg");
  EXPECT_EQ(tableOf(all, {}, nullptr, {"arms"}).csv,
            "no chosen device has joints or a pose; did you mean `arm`?");
}

TEST_F(LogTable, ALinkMovesWithWhatCarriesItsDevice) {
  armCell();
  ASSERT_TRUE(writeFileWhole(folder_ / "cell.toml",
                             bytesOf("format = 1\n"
                                     "[[device]]\nname = \"arm\"\nmodel = \"arm.urdf\"\n"
                                     "[[device]]\nname = \"gripper\"\nmodel = \"arm.urdf\"\n"
                                     "on = \"arm/c\"\n"),
                             true)
                  .ok());
  const auto cell = loadCell(folder_ / "cell.toml", {});
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  const std::vector<Said> all = {{0, "RK1 s 0 0\njoint arm j2=0\n"},
                                 {10, "RK1 s 1 0\njoint arm j2=0.5\n"}};
  test::writeSession(folder_ / "s.mcap", all);
  auto session = MomentWalk::open(folder_ / "s.mcap");
  ASSERT_TRUE(session.ok());
  auto links = LinkColumns::of(*cell, {"gripper/c"}, "", *session, LogTime::max());
  ASSERT_TRUE(links.ok()) << links.error().text();
  TableOptions options;
  options.links = &*links;
  // The gripper itself is never stated.
  const Made made = tableOf(folder_ / "s.mcap", options, &*cell, {"gripper"});
  EXPECT_EQ(std::ranges::count(made.csv, '\n'), 3) << made.csv;
  EXPECT_THAT(made.csv, HasSubstr("gripper/c:z"));
}

TEST_F(LogTable, ALinkMovesWithACarrierThatComesLater) {
  const Cell cell = armCell();
  const std::vector<Said> all = {{0, "RK1 s 0 0\npose arm 0 0 0 0 0 0 1 in cart/a\n"},
                                 {10, "RK1 s 1 0\nadd cart arm\n"},
                                 {20, "RK1 s 2 0\npose cart 3 0 0 0 0 0 1\n"}};
  test::writeSession(folder_ / "s.mcap", all);
  auto session = MomentWalk::open(folder_ / "s.mcap");
  ASSERT_TRUE(session.ok());
  auto links = LinkColumns::of(cell, {"arm/a"}, "", *session, LogTime::max());
  ASSERT_TRUE(links.ok()) << links.error().text();
  TableOptions options;
  options.links = &*links;
  const Made made = tableOf(folder_ / "s.mcap", options, &cell, {"nobody"});
  EXPECT_THAT(made.csv, HasSubstr("\n0.00000002,3,0,0,")) << made.csv;
}

TEST_F(LogTable, HasWhatIsDerivedInTheWordsOfThePlots) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const std::vector<Said> all = {{0, "RK1 s 0 0\njoint arm a=1 b=4\nsignal arm mode \"x\"\n"},
                                 {kSecond / 2, "RK1 s 1 0\njoint arm a=2\n"},
                                 {kSecond, "RK1 s 2 0\njoint arm a=4\n"},
                                 {kSecond + 1, "RK1 s 3 0\njoint leg j=1\n"},
                                 {2 * kSecond, "RK1 s 4 0\nremove arm\n"}};
  test::writeSession(folder_ / "s.mcap", all);
  const std::vector<std::string> both = {"d/dt arm.a", "arm.b - arm.a", "d/dt arm.a"};
  EXPECT_EQ(derivedOf(both, {}, {"arm"}),
            "t,arm.a,arm.b,d/dt arm.a,arm.b - arm.a\n"
            "0,1,4,,3\n0.5,2,4,2,2\n1,4,4,4,0\n2,,,,\n");
  EXPECT_EQ(derivedOf({"d/dt arm.a"}, {}, {"nobody"}), "t,d/dt arm.a\n0,\n0.5,2\n1,4\n2,\n")
      << "a row for each sample of which it is made";
  TableOptions changes;
  changes.rows = TableOptions::Rows::changed;
  EXPECT_EQ(derivedOf({"d/dt arm.a"}, changes, {"nobody"}), "t,d/dt arm.a\n0,\n0.5,2\n1,4\n2,\n");
  TableOptions grid;
  grid.rows = TableOptions::Rows::grid;
  grid.every = std::chrono::milliseconds(250);
  grid.from = LogTime(Nanoseconds(test::kWrittenOrigin + kSecond * 3 / 4));
  grid.until = LogTime(Nanoseconds(test::kWrittenOrigin + kSecond * 5 / 4 + 1));
  EXPECT_EQ(derivedOf({"d/dt arm.a", "mean 0.5 arm.a"}, grid, {"arm"}),
            "t,arm.a,arm.b,d/dt arm.a,mean 0.5 arm.a\n"
            "0.75,2,4,2,1.5\n1,4,4,4,2\n1.25,4,4,4,3\n")
      << "with what was said before, and a mean also between samples";
  EXPECT_EQ(derivedOf({"d/dt signal arm mode"}),
            "`signal arm mode` is a text, and a text has no derivative");
  EXPECT_EQ(derivedOf({"d/dt arm.c"}), "no packet states `arm.c`: did you mean `arm.a`?");
  EXPECT_EQ(derivedOf({"mean 0 arm.a"}),
            "SECONDS is a number from 1e-9 to 3600, not `0`: mean SECONDS VALUE");
  EXPECT_EQ(derivedOf({"arm.a"}), "`arm.a` is not d/dt VALUE, mean SECONDS VALUE or VALUE - VALUE");
  EXPECT_EQ(derivedOf({"d/dt arm/a:x"}), "needs a cell: the log carries none, --cell CELL");
}

TEST_F(LogTable, DerivesOfLinksAndOfJointsByTheirPlaces) {
  const Cell cell = armCell();
  const std::vector<Said> all = {{0, "RK1 s 0 0\njoints arm 0 0\n"},
                                 {1'000'000'000, "RK1 s 1 0\njoints arm 0 0.5\n"}};
  test::writeSession(folder_ / "s.mcap", all);
  EXPECT_THAT(derivedOf({"d/dt arm/c:z", "d/dt arm.j2"}, {}, {"nobody"}, &cell),
              HasSubstr("\n1,0.5,0.5\n"));
  EXPECT_EQ(derivedOf({"d/dt arm/d:z"}, {}, {}, &cell), "`arm` has no link `d`: there are a, b, c");
  EXPECT_THAT(derivedOf({"d/dt arm.2"}),
              HasSubstr("t,arm.1,arm.2,d/dt arm.2\n0,0,0,\n1,0,0.5,0.5\n"))
      << "named as the columns are";
}

TEST_F(LogTable, SaysWhereAColumnGoesOnInAnotherUnit) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const auto at = [](std::int64_t seconds) {
    return LogTime(Nanoseconds(test::kWrittenOrigin + seconds * kSecond));
  };
  const std::vector<Said> all = {{kSecond, "RK1 s 0 -\nsignal arm load 5 N\n"},
                                 {12 * kSecond, "RK1 s 1 -\nsignal arm load 5 kN\n"},
                                 {14 * kSecond, "RK1 s 2 -\nsignal arm load 6 N\n"}};
  const std::string several =
      "left out: 1 unit `signal arm load` (its column has numbers in N and in kN; at 12.000 s)";
  TableOptions options;
  options.signals = true;
  EXPECT_EQ(tableOf(all, options).left_out, several);
  options.rows = TableOptions::Rows::grid;
  options.every = std::chrono::seconds(1);
  options.from = at(10);
  options.until = at(14);
  const Made grid = tableOf(all, options);
  EXPECT_EQ(grid.csv, "t,signal arm load\n10,5\n11,5\n12,5\n13,5\n");
  EXPECT_EQ(grid.left_out, several) << "its first rows hold what was said before them";
  options.from = at(12);
  EXPECT_EQ(tableOf(all, options).left_out, "") << "every row is in kN";
  options.from = at(11);
  options.every = std::chrono::seconds(3);
  options.until = at(15);
  EXPECT_EQ(tableOf(all, options).left_out, "") << "no row falls between the two";
  options = {};
  options.signals = true;
  options.rows = TableOptions::Rows::changed;
  options.until = at(14);
  EXPECT_EQ(tableOf(all, options).left_out, "") << "5 kN makes no row after 5 N";
}

TEST_F(LogTable, CountsNoUnitThatNoCellHas) {
  TableOptions options;
  options.signals = true;
  const Made made = tableOf({{0, "RK1 s 5 -\nsignal arm load 5 N\nsignal - load 1 N\n"},
                             {10, "RK1 s 4 -\nsignal arm load 5 kN\n"},  // late
                             {20, "RK1 s 5 -\nsignal arm load 5 kg\n"},  // that number again
                             {30, "RK1 s 6 -\nsignals arm load=6\n"},
                             {40, "RK1 s 7 -\nsignal arm load true\nsignal - load 2\n"},
                             {50, "RK1 s 8 -\nsignal arm load 7 N\n"}},
                            options);
  EXPECT_EQ(made.left_out,
            "left out: 1 unit `signal - load` (its column has numbers in N and in no unit; at "
            "0.000 s)");
  EXPECT_THAT(made.csv, HasSubstr("\n0.00000005,7,2\n"));
}

TEST_F(LogTable, AGridHoldsTheLastValue) {
  TableOptions grid;
  grid.rows = TableOptions::Rows::grid;
  grid.every = std::chrono::milliseconds(10);
  grid.from = LogTime(Nanoseconds(test::kWrittenOrigin + 5'000'000));
  grid.until = LogTime(Nanoseconds(test::kWrittenOrigin + 35'000'001));
  const Made made = tableOf({{0, "RK1 s 0 0\njoint arm a=1\n"},
                             {15'000'000, "RK1 s 1 0\njoint arm a=2\n"},
                             {15'000'001, "RK1 s 2 0\njoint arm a=3\n"}},
                            grid);
  EXPECT_EQ(made.csv, "t,arm.a\n0.005,1\n0.015,2\n0.025,3\n0.035,3\n");
}

TEST_F(LogTable, KnowsWhatWasSaidBeforeItsFirstRow) {
  TableOptions later;
  later.from = LogTime(Nanoseconds(test::kWrittenOrigin + 15));
  EXPECT_EQ(
      tableOf({{0, "RK1 s 0 0\njoint arm a=1\n"}, {20, "RK1 s 1 0\njoint leg a=2\n"}}, later).csv,
      "t,arm.a,leg.a\n0.00000002,1,2\n");
}

TEST_F(LogTable, ARemovedDeviceHasEmptyFields) {
  const Made made = tableOf({{0, "RK1 s 0 0\njoint arm a=1\n"},
                             {10, "RK1 s 1 0\nremove arm\n"},
                             {20, "RK1 s 2 0\nadd arm m\njoint arm a=2\n"}});
  EXPECT_EQ(made.csv, "t,arm.a\n0,1\n0.00000001,\n0.00000002,2\n");
}

TEST_F(LogTable, NamesPositionalValuesByTheModelElseByNumber) {
  const std::vector<Said> all = {{0, "RK1 s 0 0\njoints arm 0.5 0.25\n"},
                                 {10, "RK1 s 1 0\njoint arm j2=1\n"},
                                 {20, "RK1 s 2 0\njoints arm 0 0\n"}};
  const Cell cell = armCell();
  EXPECT_EQ(tableOf(all, {}, &cell).csv,
            "t,arm.j1,arm.j2\n0,0.5,0.25\n0.00000001,0.5,1\n0.00000002,0,0\n");
  const Made bare = tableOf(all);
  EXPECT_EQ(bare.csv,
            "t,arm.1,arm.2,arm.j2\n0,0.5,0.25,\n0.00000001,0.5,0.25,1\n0.00000002,0,0,\n");
  ASSERT_EQ(bare.remarks.size(), 1U);
  EXPECT_THAT(bare.remarks[0], HasSubstr("no model names them"));
}

TEST_F(LogTable, ACellGivesWhatWasNotStated) {
  const Cell cell = armCell();
  EXPECT_EQ(tableOf({{0, "RK1 s 0 0\njoint arm j2=0.5\n"}}, {}, &cell).csv,
            "t,arm.j1,arm.j2\n0,0,0.5\n");
}

TEST_F(LogTable, PosesAreInTheWorldOrAGap) {
  const std::vector<Said> all = {{0, "RK1 s 0 0\njoints arm 0 0.5\npose arm 0 2 0 0 0 0 1\n"},
                                 {10, "RK1 s 1 0\npose arm.2 1 0 0 0 0 0 1 in arm/c\n"}};
  const Made bare = tableOf(all, {}, nullptr, {"arm.2"});
  EXPECT_THAT(bare.csv, HasSubstr("\n0.00000001,,,,,,,\n"));
  ASSERT_EQ(bare.gaps.size(), 1U);
  EXPECT_THAT(bare.gaps[0], HasSubstr("where arm.2 is carried by another device"));
  ASSERT_EQ(bare.remarks.size(), 1U);
  EXPECT_THAT(bare.remarks[0], HasSubstr("holds a point"));
  const std::string cell_text =
      "format = 1\n[[device]]\nname = \"arm\"\nmodel = \"arm.urdf\"\n"
      "[[device]]\nname = \"arm.2\"\nmodel = \"arm.urdf\"\n";
  armCell();
  ASSERT_TRUE(writeFileWhole(folder_ / "c.cell.toml", bytesOf(cell_text), true).ok());
  const auto cell = loadCell(folder_ / "c.cell.toml", {});
  ASSERT_TRUE(cell.ok());
  const Made made = tableOf(all, {}, &*cell, {"arm.2"});
  EXPECT_THAT(made.csv, HasSubstr("\n0.00000001,2,2,0.5,0,0,0,1\n"));
  EXPECT_TRUE(made.gaps.empty());
}

TEST_F(LogTable, ReadsBackAsTheSameTable) {
  std::vector<Said> all;
  for (int i = 0; i < 400; ++i) {
    const double x = i * 0.037;
    all.push_back({i * 1'234'567L, "RK1 s " + std::to_string(i) + " -\norder arm a b\njoints arm " +
                                       std::to_string(std::sin(x)) + " " + std::to_string(-x) +
                                       "\npose tray 0.5 " + std::to_string(x) +
                                       " 0 0 0 0.6 0.8\n"});
    if (i < 20) all.back().text.resize(all.back().text.find("pose"));
    if (i > 40 && i % 3 == 0) all.back().text = "RK1 s " + std::to_string(i) + " -\n";
  }
  const std::string first = tableOf(all).csv;
  const auto motion = readCsvMotion(first, "t.csv", "", {});
  ASSERT_TRUE(motion.ok()) << motion.error().text();
  CsvStream::Options options;
  options.source = "anew";
  options.run = "r";
  auto stream = CsvStream::open(*motion, options);
  ASSERT_TRUE(stream.ok()) << stream.error().text();
  std::vector<Said> sent;
  while (const auto due = stream->due().value()) {
    sent.push_back({due->time.time_since_epoch().count(), std::string(textOf(stream->take()))});
  }
  EXPECT_EQ(tableOf(sent).csv, first);
}

TEST_F(LogTable, BeginsWithWhatAKeyframeSays) {
  test::writeSession(folder_ / "s.mcap", std::vector<Said>{{0, "RK1 s 0 0\njoint arm a=1 b=2\n"}});
  auto timeline = Timeline::open(folder_ / "s.mcap");
  const SessionState before = **timeline->stateAt(timeline->end());
  auto log = LogWriter::create(folder_ / "cut.mcap", {}, "session-1");
  log->setOrigin(LogTime(Nanoseconds(test::kWrittenOrigin)));
  SessionWriter session(std::move(*log), {});
  const LogTime moment(Nanoseconds(test::kWrittenOrigin + 50));
  ASSERT_TRUE(session.beginWith(before, moment).ok());
  const auto channel = session.addChannel("/udp/test", "rk1", {});
  ASSERT_TRUE(session.write(*channel, 0, moment, 0, bytesOf("RK1 s 1 0\njoint arm b=3\n")).ok());
  ASSERT_TRUE(session.log().close("done").ok());
  EXPECT_EQ(tableOf(folder_ / "cut.mcap").csv, "t,arm.a,arm.b\n0.00000005,1,3\n");
}

TEST(CsvTable, QuotesNamesThatNeedIt) {
  std::string text;
  const auto writer = makeCsvTable([&](ByteView bytes) -> Status {
    text += textOf(bytes);
    return {};
  });
  const std::vector<std::string> columns = {"a.b,c", "a.say \"x\"", "a. y "};
  ASSERT_TRUE(writer->begin(columns).ok());
  ASSERT_TRUE(writer->row(Nanoseconds(-1), std::vector<double>{0.1, kNone, -2e300}).ok());
  ASSERT_TRUE(writer->end().ok());
  EXPECT_EQ(text, "t,\"a.b,c\",\"a.say \"\"x\"\"\",\"a. y \"\n-0.000000001,0.1,,-2e+300\n");
}

TEST(NpyTable, IsAStructuredArrayToTheByte) {
  Bytes bytes;
  const auto sink = makeMemorySink(bytes);
  const auto writer = makeNpyTable(*sink);
  ASSERT_TRUE(writer->begin(std::vector<std::string>{"arm.j1"}).ok());
  ASSERT_TRUE(writer->row(Nanoseconds(500'000'000), std::vector<double>{2}).ok());
  ASSERT_TRUE(writer->end().ok());
  const std::string head =
      std::string("\x93NUMPY\x01\x00", 8) + std::string("\xB6\x00", 2) +  // 182 bytes follow
      "{'descr': [('t', '<f8'), ('t_ns', '<i8'), ('arm.j1', '<f8')], 'fortran_order': False, "
      "'shape': (1,), }";
  EXPECT_EQ(textOf(bytes).substr(0, head.size()), head);
  ASSERT_EQ(bytes.size(), 192U + 24U);
  EXPECT_EQ(textOf(bytes).substr(191), std::string("\n"
                                                   "\0\0\0\0\0\0\xE0\x3F"
                                                   "\0\x65\xCD\x1D\0\0\0\0"
                                                   "\0\0\0\0\0\0\0\x40",
                                                   25));
}

TEST(NpyHeader, KeepsItsLengthForAnyCountAndAllNames) {
  const std::string none = npyHeader("'<f8'", 0);
  const std::string most = npyHeader("'<f8'", ~std::uint64_t{0});
  EXPECT_EQ(none.size(), most.size());
  EXPECT_EQ(none.size() % 64, 0U);
  EXPECT_EQ(npyHeader("[('\xC3\xA9', '<f8')]", 1)[6], '\3');
  EXPECT_EQ(npyHeader(std::string(70'000, 'a'), 1)[6], '\2');
  EXPECT_EQ(npyHeader(std::string(70'000, 'a'), 1).size() % 64, 0U);
  EXPECT_EQ(pythonText("a'b\\"), "'a\\'b\\\\'");
}

TEST(RowSpill, GivesColumnsOfManyBlocks) {
  test::TemporaryFolder folder;
  auto spill = RowSpill::make(folder.path().string(), 40'000);  // blocks of 52 rows
  ASSERT_TRUE(spill.ok());
  std::vector<std::uint64_t> row(40'000);
  for (std::uint64_t i = 0; i < 120; ++i) {
    row[0] = i;
    row[39'999] = i * i;
    ASSERT_TRUE(spill->add(row).ok());
  }
  std::vector<std::uint64_t> squares;
  ASSERT_TRUE(spill
                  ->readColumn(39'999,
                               [&](ByteView cells) -> Status {
                                 squares.resize(squares.size() + cells.size() / 8);
                                 std::memcpy(squares.data() + squares.size() - cells.size() / 8,
                                             cells.data(), cells.size());
                                 return {};
                               })
                  .ok());
  ASSERT_EQ(squares.size(), 120U);
  for (std::uint64_t i = 0; i < 120; ++i) EXPECT_EQ(squares[i], i * i);
  EXPECT_FALSE(RowSpill::make((folder / "missing").string(), 1).ok());
}

}  // namespace
}  // namespace rocinante
