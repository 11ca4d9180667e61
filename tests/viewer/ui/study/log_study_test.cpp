#include "viewer/ui/study/log_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

using test::sessionTime;

SeriesKey turn() { return {SeriesKey::Kind::joint, "arm", "turn"}; }

/// Ten seconds of an arm that turns, a packet each 100 ms.
class StudiedLog : public testing::Test {
 protected:
  void SetUp() override {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    test::writeArmSession(folder_ / "s.mcap");
    auto cell = loadCell(folder_ / "arm.urdf", {});
    ASSERT_TRUE(cell.ok());
    cell_ = std::move(*cell);
  }
  static StudyQuery wish(std::int64_t from_ms, std::int64_t until_ms) {
    StudyQuery wish;
    wish.keys = {turn(), {SeriesKey::Kind::rate, "robot"}, {SeriesKey::Kind::joint, "arm", "no"}};
    wish.from = sessionTime(from_ms);
    wish.until = sessionTime(until_ms);
    wish.columns = wish.strip_columns = 100;
    return wish;
  }

  const test::TemporaryFolder folder_;
  Cell cell_;
};

TEST_F(StudiedLog, HasEveryValueAndRate) {
  LogStudy study(cell_, folder_ / "s.mcap");
  study.waits = true;
  const auto picture = study.show(wish(0, 10'000));
  ASSERT_NE(picture, nullptr);
  EXPECT_TRUE(picture->whole);
  EXPECT_EQ(picture->fault, "");
  ASSERT_EQ(picture->curves.size(), 3U);
  ASSERT_EQ(picture->curves[0].size(), 100U);
  EXPECT_NEAR(*picture->curves[0][0].held, 0, 0.051);
  EXPECT_NEAR(*picture->curves[0][55].held, 55 * 0.05, 0.051);
  EXPECT_NEAR(*picture->curves[1][50].held, 10, 1.5);
  EXPECT_TRUE(picture->curves[2].empty());
  ASSERT_EQ(picture->strips.size(), 2U);
  EXPECT_EQ(picture->strips[1].source, "robot");
  EXPECT_NEAR(picture->strips[0].most, 10, 2);
  EXPECT_FALSE(study.hasNews());
  EXPECT_FALSE(study.isBusy());
}

TEST_F(StudiedLog, GathersTheLinksThatAreAskedFor) {
  LogStudy study(cell_, folder_ / "s.mcap");
  study.waits = true;
  StudyQuery asked = wish(0, 10'000);
  asked.keys = {turn(), {SeriesKey::Kind::link, "arm", "qz", "hand"}};
  const auto picture = study.show(asked);
  EXPECT_TRUE(picture->whole);
  ASSERT_EQ(picture->curves.size(), 2U);
  ASSERT_EQ(picture->curves[1].size(), 100U);
  for (const std::size_t column : {10U, 40U, 60U}) {
    const float turned = *picture->curves[0][column].held;
    EXPECT_NEAR(*picture->curves[1][column].held, std::sin(turned / 2), 1e-6) << column;
  }
  // Another one, and a part that is shown larger: it is read for all of them.
  asked.keys.push_back({SeriesKey::Kind::link, "arm", "qw", "hand", "arm"});
  asked.from = sessionTime(5000) - Nanoseconds(5000);
  asked.until = sessionTime(5000) + Nanoseconds(5000);
  const auto close = study.show(asked);
  ASSERT_EQ(close->curves[2].size(), 100U);
  EXPECT_NEAR(*close->curves[2][10].held, std::cos(49 * 0.05 / 2), 1e-6);
  EXPECT_NEAR(*close->curves[2][90].held, std::cos(50 * 0.05 / 2), 1e-6);
}

TEST_F(StudiedLog, GathersWhatIsDerived) {
  LogStudy study(cell_, folder_ / "s.mcap");
  study.waits = true;
  StudyQuery asked = wish(0, 10'000);
  asked.keys = {*parseSeriesKey("d/dt arm.turn"), *parseSeriesKey("mean 2 d/dt arm.turn")};
  const auto picture = study.show(asked);
  ASSERT_EQ(picture->curves.size(), 2U);
  // 0.05 each 100 ms; a part that is shown larger begins with what lies before it.
  EXPECT_NEAR(*picture->curves[0][50].held, 0.5, 1e-3);
  EXPECT_NEAR(*picture->curves[1][50].held, 0.5, 1e-3);
  asked.from = sessionTime(5000) - Nanoseconds(5000);
  asked.until = sessionTime(5000) + Nanoseconds(5000);
  const auto close = study.show(asked);
  EXPECT_NEAR(*close->curves[1][10].held, 0.5, 1e-3);
  EXPECT_NEAR(*close->curves[1][90].held, 0.5, 1e-3);
}

TEST_F(StudiedLog, GathersOneValueOverAnother) {
  LogStudy study(cell_, folder_ / "s.mcap");
  study.waits = true;
  StudyQuery asked = wish(0, 10'000);
  asked.keys.clear();
  const SeriesKey x = *parseSeriesKey("arm/hand:qw"), y = *parseSeriesKey("arm/hand:qz");
  asked.paths = {{x, y}};
  const auto picture = study.show(asked);
  ASSERT_TRUE(picture->whole);
  ASSERT_EQ(picture->paths.size(), 1U);
  const XyColumns& path = picture->paths[0];
  ASSERT_EQ(path.x.size(), StudyQuery::kPathColumns);
  ASSERT_EQ(path.y.size(), StudyQuery::kPathColumns);
  for (const double part : {0.1, 0.5, 0.9}) {
    const auto pair = pairAt(path, part);
    ASSERT_TRUE(pair.has_value());
    EXPECT_NEAR(pair->first * pair->first + pair->second * pair->second, 1, 1e-5) << "on a circle";
  }
  // A part that is shown larger is read again for both.
  asked.from = sessionTime(5000) - Nanoseconds(5000);
  asked.until = sessionTime(5000) + Nanoseconds(5000);
  const auto close = study.show(asked);
  ASSERT_EQ(close->paths.size(), 1U);
  EXPECT_NEAR(pairAt(close->paths[0], 0.1)->second, std::sin(49 * 0.05 / 2), 1e-5);
  EXPECT_NEAR(pairAt(close->paths[0], 0.9)->second, std::sin(50 * 0.05 / 2), 1e-5);
}

TEST_F(StudiedLog, KeepsStatesWithTheirTexts) {
  test::writeSession(folder_ / "m.mcap", {{0, "signal arm mode \"auto\"\nsignal - estop false\n"},
                                          {5000, "signal arm mode \"fault\"\n"},
                                          {5000, "signal arm mode \"auto\"\n"},
                                          {9000, "signal - estop true\n"}});
  LogStudy study(cell_, folder_ / "m.mcap");
  study.waits = true;
  StudyQuery asked = wish(0, 9'001);
  asked.keys = {turn(), *parseSeriesKey("signal arm mode"), *parseSeriesKey("signal - estop")};
  const auto picture = study.show(asked);
  ASSERT_EQ(picture->states.size(), 3U);
  EXPECT_TRUE(picture->states[0].columns.empty());
  const StateCurve& mode = picture->states[1];
  EXPECT_EQ(mode.texts, (std::vector<std::string>{"auto", "fault"}));
  ASSERT_EQ(mode.columns.size(), 100U);
  EXPECT_EQ(mode.columns[55].bin.seen, 0b11U) << "the fault of one packet is there";
  EXPECT_EQ(mode.columns[70].held, 0);
  EXPECT_FALSE(mode.has_numbers);
  EXPECT_TRUE(picture->curves[1].empty());
  EXPECT_EQ(picture->curves[2].size(), 100U) << "a boolean is a number too";
  ASSERT_NE(picture->stated, nullptr);
  EXPECT_EQ(picture->stated->size(), 2U);
  ASSERT_NE(picture->texts, nullptr);
  EXPECT_EQ(*picture->texts, (std::set<SeriesKey>{*parseSeriesKey("signal arm mode")}));
}

TEST_F(StudiedLog, GathersASignalByUnit) {
  test::writeSession(folder_ / "u.mcap", {{0, "signal arm load 5 kg\nsignal arm heat 20 degC\n"},
                                          {5000, "signal arm load 6500 g\n"},
                                          {9000, "signals arm load=7000\n"}});
  LogStudy study(cell_, folder_ / "u.mcap");
  study.waits = true;
  StudyQuery asked = wish(0, 9'001);
  const SeriesKey load = *parseSeriesKey("signal arm load");
  const SeriesKey heat = *parseSeriesKey("signal arm heat");
  asked.keys = {turn(), load, heat};
  const auto picture = study.show(asked);
  EXPECT_FALSE(picture->units.contains(turn()));
  ASSERT_EQ(picture->units.at(heat).size(), 1U);
  EXPECT_EQ(picture->units.at(heat)[0].unit, "degC");
  const std::vector<UnitCurve>& units = picture->units.at(load);
  ASSERT_EQ(units.size(), 2U);
  EXPECT_EQ(units[0].unit, "kg");
  EXPECT_EQ(units[0].columns[20].held, 5);
  EXPECT_FALSE(units[0].columns[70].held.has_value());
  EXPECT_EQ(units[1].unit, "g");
  EXPECT_FALSE(units[1].columns[20].held.has_value());
  EXPECT_EQ(units[1].columns[70].held, 6500);
  // Where a part is shown that has one of them alone, both have a curve.
  asked.from = sessionTime(1000);
  asked.until = sessionTime(1000) + Nanoseconds(10'000);
  const auto close = study.show(asked);
  ASSERT_EQ(close->units.at(load).size(), 2U);
  EXPECT_EQ(close->units.at(load)[0].columns[50].held, 5);
  EXPECT_FALSE(close->units.at(load)[1].columns[50].held.has_value());
}

TEST_F(StudiedLog, ReadsAPartAgainWhenPixelsAreFiner) {
  LogStudy study(cell_, folder_ / "s.mcap");
  study.waits = true;
  // Ten microseconds about a packet: a pixel is 100 ns, and a bin of the whole log 610 us.
  StudyQuery close = wish(0, 1);
  close.from = sessionTime(5000) - Nanoseconds(5000);
  close.until = sessionTime(5000) + Nanoseconds(5000);
  const auto picture = study.show(close);
  EXPECT_TRUE(picture->whole);
  const auto& columns = picture->curves[0];
  EXPECT_NEAR(*columns[0].held, 49 * 0.05, 1e-5);
  EXPECT_FALSE(columns[40].bin.hasSample());
  EXPECT_NEAR(*columns[99].held, 50 * 0.05, 1e-5);
  // Where exactly it steps.
  std::size_t step = 0;
  while (step < 100 && !columns[step].bin.hasSample()) ++step;
  EXPECT_NEAR(static_cast<double>(step), 50, 1);
}

TEST_F(StudiedLog, AnswersWithoutWaiting) {
  LogStudy study(cell_, folder_ / "s.mcap");
  const StudyQuery all = wish(0, 10'000);
  std::shared_ptr<const StudyPicture> picture;
  for (int i = 0; i < 2000 && !(picture && picture->whole); ++i) {
    picture = study.show(all);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_TRUE(picture && picture->whole);
  EXPECT_EQ(picture->wish, all);
}

TEST_F(StudiedLog, WritesATable) {
  LogStudy study(cell_, folder_ / "s.mcap");
  study.waits = true;
  study.writeTable({turn()}, sessionTime(1000), sessionTime(1200), folder_ / "t.csv");
  const auto made = study.takeTable();
  ASSERT_TRUE(made.has_value());
  ASSERT_TRUE(made->ok()) << made->error().text();
  EXPECT_EQ(*readFile(folder_ / "t.csv"), "t,arm.turn\n1,0.5\n1.1,0.55\n1.2,0.6\n");
  study.writeTable({turn()}, sessionTime(1000), sessionTime(1200), folder_ / "none" / "t.csv");
  EXPECT_FALSE(study.takeTable()->ok());
  EXPECT_FALSE(study.takeTable().has_value());
}

TEST_F(StudiedLog, ATableHasNoColumnOfTextsAndNamesThem) {
  test::writeSession(folder_ / "texts.mcap",
                     {{0, "signal arm mode \"auto\"\nsignal arm load 5\nsignal - estop false\n"},
                      {1000, "signal arm mode \"hold\"\nsignal arm load 6\n"}});
  LogStudy study(cell_, folder_ / "texts.mcap");
  study.waits = true;
  const SeriesKey mode = *parseSeriesKey("signal arm mode");
  study.writeTable({mode, *parseSeriesKey("signal arm load"), *parseSeriesKey("signal - estop")},
                   sessionTime(0), sessionTime(1000), folder_ / "t.csv");
  const auto made = study.takeTable();
  ASSERT_TRUE(made.has_value() && made->ok());
  EXPECT_TRUE((*made)->ends_with("; texts are left out: signal arm mode")) << **made;
  const std::string table = *readFile(folder_ / "t.csv");
  EXPECT_EQ(table.find("mode"), table.npos) << table;
  EXPECT_NE(table.find("load"), table.npos) << table;
  EXPECT_NE(table.find("estop"), table.npos) << "true is 1: " << table;
  study.writeTable({mode}, sessionTime(0), sessionTime(1000), folder_ / "none.csv");
  const auto none = study.takeTable();
  ASSERT_TRUE(none.has_value() && !none->ok());
  EXPECT_EQ(none->error().what, "a table needs a value that is a number");
}

TEST_F(StudiedLog, ALogThatIsGoneIsASentence) {
  LogStudy study(cell_, folder_ / "gone.mcap");
  study.waits = true;
  const auto picture = study.show(wish(0, 10'000));
  ASSERT_NE(picture, nullptr);
  EXPECT_NE(picture->fault.find("gone.mcap"), std::string::npos);
  study.writeTable({turn()}, sessionTime(0), sessionTime(1), folder_ / "t.csv");
  EXPECT_FALSE(study.takeTable()->ok());
}

TEST_F(StudiedLog, ALogCutAtAnyLengthIsShownAsFarAsItGoes) {
  const std::string whole = *readFile(folder_ / "s.mcap");
  for (std::size_t bytes = 0; bytes < whole.size(); bytes += 1 + whole.size() / 60) {
    SCOPED_TRACE(bytes);
    test::writeText(folder_ / "cut.mcap", whole.substr(0, bytes));
    LogStudy study(cell_, folder_ / "cut.mcap");
    study.waits = true;
    const auto picture = study.show(wish(0, 10'000));
    ASSERT_NE(picture, nullptr);
    EXPECT_TRUE(picture->whole);
  }
}

TEST_F(StudiedLog, EndsWhileItReads) {
  for (int i = 0; i < 20; ++i) {
    LogStudy study(cell_, folder_ / "s.mcap");
    study.show(wish(i * 100, i * 100 + 1));
  }
}

}  // namespace
}  // namespace rocinante
