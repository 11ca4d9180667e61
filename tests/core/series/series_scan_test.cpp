#include "core/series/series_scan.h"

#include <gtest/gtest.h>

#include <memory>

#include "tests/core/series/spoken_log.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using test::spokenTime;

std::unique_ptr<SeriesScan> scanOf(const std::vector<test::Spoken>& packets,
                                   SeriesScan::Options options = {}) {
  const test::TemporaryFolder folder;
  test::writeSpoken(folder / "s.mcap", packets);
  auto reader = LogReader::open(folder / "s.mcap");
  EXPECT_TRUE(reader.ok());
  options.from = spokenTime(0);
  options.until = spokenTime(1000);
  auto scan = std::make_unique<SeriesScan>(std::move(options));
  while (true) {
    const auto message = reader->next();
    EXPECT_TRUE(message.ok());
    if (!message.ok() || !*message) return scan;
    scan->add(**message);
  }
}

std::optional<float> heldAt(const SeriesScan& scan, const char* key, std::int64_t milliseconds) {
  const ValueBins* const values = scan.values(*parseSeriesKey(key));
  if (values == nullptr) return std::nullopt;
  return values
      ->columns(spokenTime(milliseconds) - Nanoseconds(1), spokenTime(milliseconds + 1), 1)[0]
      .held;
}

/// "-": none.
std::string stateAt(const SeriesScan& scan, const char* key, std::int64_t milliseconds) {
  const StateSeries* const states = scan.states(*parseSeriesKey(key));
  if (states == nullptr) return "-";
  const auto columns = states->bins.columns(spokenTime(milliseconds) - Nanoseconds(1),
                                            spokenTime(milliseconds + 1), 1);
  return columns[0].held ? states->texts[*columns[0].held] : "-";
}

PositionalNames twoJoints() {
  return [](std::string_view device, const DeviceState&) {
    return device == "arm" ? std::vector<std::string>{"j1", "j2"} : std::vector<std::string>();
  };
}

TEST(SeriesScan, KeepsEveryStateOfAStretch) {
  // Three modes within a microsecond, whose stretch is 61 us wide; more modes than have a number.
  std::vector<test::Spoken> packets{{0, "RK1 s 0 -\nsignal arm mode \"auto\""}};
  for (const char* mode : {"hold", "fault", "auto"}) {
    packets.push_back({100, "RK1 s - -\nsignal arm mode \"" + std::string(mode) + "\""});
  }
  for (int i = 0; i < 100; ++i) {
    packets.push_back({200 + i, "RK1 s - -\nsignal arm many \"m" + std::to_string(i) + "\""});
  }
  const auto scan = scanOf(packets);
  const StateSeries* const modes = scan->states(*parseSeriesKey("signal arm mode"));
  ASSERT_NE(modes, nullptr);
  EXPECT_EQ(modes->texts, (std::vector<std::string>{"auto", "hold", "fault"}));
  const auto columns = modes->bins.columns(spokenTime(0), spokenTime(1000), 4);
  EXPECT_EQ(columns[0].bin.seen, 0b111U);
  EXPECT_EQ(columns[0].held, 0);
  EXPECT_TRUE(columns[2].bin.holds());
  EXPECT_EQ(scan->values(*parseSeriesKey("signal arm mode")), nullptr);
  const StateSeries* const many = scan->states(*parseSeriesKey("signal arm many"));
  ASSERT_EQ(many->texts.size(), StateBin::kStates);
  EXPECT_EQ(many->texts[62], "m62");
  EXPECT_EQ(stateAt(*scan, "signal arm many", 290), "other texts");
  const std::vector<SeriesKey> keys = scan->keys();
  ASSERT_EQ(keys.size(), 2U);
  EXPECT_EQ(keys[0].text(), "signal arm many");
}

TEST(SeriesScan, FindsJointsByPositionByOrderAndByName) {
  SeriesScan::Options options;
  options.names = twoJoints();
  const auto scan = scanOf({{0, "RK1 s 0 -\njoints arm 1 2\njoints other 7"},
                            {100, "RK1 s 1 -\norder arm j2 j1"},
                            {200, "RK1 s 2 -\njoints arm 20 10"},
                            {300, "RK1 s 3 -\njoint arm j1=11"}},
                           options);
  EXPECT_EQ(heldAt(*scan, "arm.j1", 50), 1);
  EXPECT_EQ(heldAt(*scan, "arm.j2", 50), 2);
  EXPECT_EQ(heldAt(*scan, "other.1", 50), 7);
  EXPECT_EQ(heldAt(*scan, "arm.j1", 250), 10);
  EXPECT_EQ(heldAt(*scan, "arm.j2", 350), 20);
  EXPECT_EQ(heldAt(*scan, "arm.j1", 350), 11);
  EXPECT_EQ(heldAt(*scan, "arm.j3", 350), std::nullopt);
}

TEST(SeriesScan, AWrongNumberOfPositionsIsDrawnAsNone) {
  SeriesScan::Options options;
  options.names = twoJoints();
  const auto scan =
      scanOf({{0, "RK1 s 0 -\njoints arm 1 2"}, {100, "RK1 s 1 -\njoints arm 1 2 3"}}, options);
  EXPECT_EQ(heldAt(*scan, "arm.j1", 50), 1);
  EXPECT_EQ(heldAt(*scan, "arm.j1", 150), std::nullopt);
}

TEST(SeriesScan, NumbersAndBooleansOfSignals) {
  const auto scan = scanOf({{0, "RK1 s 0 -\nsignal arm load 5 kg\nsignal - estop false"},
                            {100, "RK1 s 1 -\nsignals arm load=6\nsignals arm/tip force=1"},
                            {200, "RK1 s 2 -\nsignals - estop=true\nsignal arm load \"off\""},
                            {300, "RK1 s 3 -\nsignal arm load 7\nsignal - estop default"},
                            {400, "RK1 s 4 -\nremove arm"}});
  EXPECT_EQ(heldAt(*scan, "signal arm load", 50), 5);
  EXPECT_EQ(heldAt(*scan, "signal arm load", 150), 6);
  EXPECT_EQ(heldAt(*scan, "signal arm load", 250), std::nullopt);
  EXPECT_EQ(heldAt(*scan, "signal arm load", 350), 7);
  EXPECT_EQ(heldAt(*scan, "signal arm load", 450), std::nullopt);
  EXPECT_EQ(heldAt(*scan, "signal arm/tip force", 150), 1);
  EXPECT_EQ(stateAt(*scan, "signal arm load", 150), "-");
  EXPECT_EQ(stateAt(*scan, "signal arm load", 250), "off");
  EXPECT_EQ(stateAt(*scan, "signal arm load", 350), "-");
  EXPECT_TRUE(scan->states(*parseSeriesKey("signal arm load"))->has_numbers);
  EXPECT_EQ(stateAt(*scan, "signal - estop", 150), "false");
  EXPECT_EQ(stateAt(*scan, "signal - estop", 250), "true");
  EXPECT_EQ(stateAt(*scan, "signal - estop", 350), "-");
  EXPECT_FALSE(scan->states(*parseSeriesKey("signal - estop"))->has_numbers);
  EXPECT_EQ(heldAt(*scan, "signal - estop", 150), 0);
  EXPECT_EQ(heldAt(*scan, "signal - estop", 250), 1);
  EXPECT_EQ(heldAt(*scan, "signal - estop", 350), std::nullopt);
}

/// What a unit's numbers end with at a time; empty: nothing.
std::optional<double> inUnit(const SeriesScan& scan, std::string_view signal, std::string_view unit,
                             int ms) {
  for (const UnitSeries& each : scan.unitsOf(*parseSeriesKey(signal))) {
    if (each.unit != unit || each.values == nullptr) continue;
    const auto held =
        each.values->columns(spokenTime(ms) - Nanoseconds(1), spokenTime(ms + 1), 1)[0].held;
    return held ? std::optional<double>(*held) : std::nullopt;
  }
  return std::nullopt;
}

std::vector<std::string> unitNames(const SeriesScan& scan, std::string_view signal) {
  std::vector<std::string> names;
  for (const UnitSeries& each : scan.unitsOf(*parseSeriesKey(signal))) {
    names.emplace_back(each.unit);
  }
  return names;
}

TEST(SeriesScan, EachUnitOfASignalHasItsOwnNumbers) {
  const auto scan = scanOf({{0, "RK1 s 0 -\nsignal arm load 5 kg"},
                            {100, "RK1 s 1 -\nsignals arm load=6"},
                            {200, "RK1 s 2 -\nsignal arm load 6500 g"},
                            {300, "RK1 s 3 -\nsignals arm load=7000"},
                            {400, "RK1 s 4 -\nsignal arm load 8 kg"},
                            {500, "RK1 s 5 -\nsignal arm load \"off\""},
                            {600, "RK1 s 6 -\nsignals arm load=9"},
                            {700, "RK1 s 7 -\nremove arm"}});
  constexpr const char* kLoad = "signal arm load";
  EXPECT_EQ(unitNames(*scan, kLoad), (std::vector<std::string>{"kg", "g", ""}));
  EXPECT_EQ(inUnit(*scan, kLoad, "kg", 150), 6);
  EXPECT_EQ(inUnit(*scan, kLoad, "kg", 250), std::nullopt);
  EXPECT_EQ(inUnit(*scan, kLoad, "kg", 450), 8);
  EXPECT_EQ(inUnit(*scan, kLoad, "kg", 650), std::nullopt);
  EXPECT_EQ(inUnit(*scan, kLoad, "g", 150), std::nullopt);
  EXPECT_EQ(inUnit(*scan, kLoad, "g", 250), 6500);
  EXPECT_EQ(inUnit(*scan, kLoad, "g", 350), 7000);
  EXPECT_EQ(inUnit(*scan, kLoad, "g", 450), std::nullopt);
  EXPECT_EQ(inUnit(*scan, kLoad, "", 650), 9) << "a text has no unit to keep";
  EXPECT_EQ(inUnit(*scan, kLoad, "", 750), std::nullopt);
  // No bin of the first unit has a number of another one.
  for (const ValueBin& bin : scan->unitsOf(*parseSeriesKey(kLoad))[0].values->bins()) {
    EXPECT_FALSE(bin.hasSample() && bin.high > 8);
  }
  EXPECT_EQ(heldAt(*scan, kLoad, 350), 7000) << "all of them, as before";
}

TEST(SeriesScan, UnitsOfASignalAreBounded) {
  std::vector<test::Spoken> packets;
  for (int i = 0; i < 100; ++i) {
    const std::string unit = "u" + std::to_string(i % 50);
    packets.push_back({5 * i, "RK1 s " + std::to_string(i) + " -\nsignal arm load " +
                                  std::to_string(i) + " " + unit});
  }
  const auto scan = scanOf(packets);
  const auto names = unitNames(*scan, "signal arm load");
  ASSERT_EQ(names.size(), SignalSeries::kMaxUnits);
  EXPECT_EQ(names.back(), "other units");
  EXPECT_EQ(inUnit(*scan, "signal arm load", "other units", 202), 40);
  EXPECT_EQ(inUnit(*scan, "signal arm load", "u0", 202), std::nullopt);
  EXPECT_EQ(inUnit(*scan, "signal arm load", "u3", 267), 53) << "again in a unit that is known";
}

TEST(SeriesScan, KeepsTheOnlyUnitOfASignal) {
  const auto scan = scanOf({{0, "RK1 s 0 -\nsignal arm load 5 kg\nsignal - speed 1"},
                            {100, "RK1 s 1 -\nsignals arm load=6"},
                            {200, "RK1 s 2 -\nremove arm"}});
  EXPECT_EQ(unitNames(*scan, "signal arm load"), std::vector<std::string>{"kg"});
  EXPECT_EQ(unitNames(*scan, "signal - speed"), std::vector<std::string>{""});
  EXPECT_TRUE(unitNames(*scan, "signal oven heat").empty());
  EXPECT_EQ(inUnit(*scan, "signal arm load", "kg", 150), 6);
}

TEST(SeriesScan, PosesAndWhatIsRemoved) {
  const auto scan = scanOf({{0, "RK1 s 0 -\npose tray 1 2 3 0 0 0 1"},
                            {100, "RK1 s 1 -\nremove tray"},
                            {200, "RK1 s 2 -\npose tray 4 5 6 0 0 0 1"}});
  EXPECT_EQ(heldAt(*scan, "tray:y", 50), 2);
  EXPECT_EQ(heldAt(*scan, "tray:qw", 50), 1);
  EXPECT_EQ(heldAt(*scan, "tray:y", 150), std::nullopt);
  EXPECT_EQ(heldAt(*scan, "tray:y", 250), 5);
}

TEST(SeriesScan, WhatAWholeRestatementForgetsEnds) {
  const auto scan = scanOf({{0, "RK1 s@r 0 -\njoint arm j1=1\njoint arm j2=2"},
                            {100, "RK1 s@r 1 - restated part=a:1/1\njoint arm j1=3"}});
  EXPECT_EQ(heldAt(*scan, "arm.j2", 50), 2);
  EXPECT_EQ(heldAt(*scan, "arm.j1", 150), 3);
  EXPECT_EQ(heldAt(*scan, "arm.j2", 150), std::nullopt);
}

TEST(SeriesScan, LatePacketsDoNotCountAndGapsDo) {
  const auto scan = scanOf({{0, "RK1 s 10 -\njoint arm j1=1"},
                            {100, "RK1 s 14 -\njoint arm j1=2"},
                            {200, "RK1 s 12 -\njoint arm j1=9"}});
  EXPECT_EQ(heldAt(*scan, "arm.j1", 250), 2);
  const SourceSeries& source = scan->sources().at("s");
  EXPECT_EQ(source.packets.total(), 3);
  EXPECT_EQ(source.lost.total(), 2);  // 11 and 13
  EXPECT_EQ(scan->all().lost.total(), 2);
}

TEST(SeriesScan, StaysWithinItsMemory) {
  std::vector<test::Spoken> packets;
  for (int i = 0; i < 200; ++i) {
    std::string text = "RK1 s " + std::to_string(i) + " -\n";
    for (int joint = 0; joint < 50; ++joint) {
      text += "joint d" + std::to_string(i) + " j" + std::to_string(joint) + "=1\n";
    }
    packets.push_back({i * 5, text});
  }
  SeriesScan::Options options;
  options.max_bytes = std::uint64_t{16} << 20U;
  const auto scan = scanOf(packets, options);
  EXPECT_EQ(scan->keys().size(), 10'000U);
  EXPECT_LE(scan->bytes(), options.max_bytes * 2);  // capacity may be twice the size
}

TEST(SeriesScan, TextsStayWithinItsMemoryToo) {
  std::vector<test::Spoken> packets;
  for (int i = 0; i < 50; ++i) {
    const std::string text = std::string(200, 'x') + std::to_string(i);
    packets.push_back(
        {i, "RK1 s - -\nsignal arm a \"" + text + "\"\nsignal arm b \"" + text + "\""});
  }
  SeriesScan::Options options;
  options.max_bytes = std::uint64_t{64} << 10U;
  const auto scan = scanOf(packets, options);
  std::size_t bytes = 0;
  for (const char* key : {"signal arm a", "signal arm b"}) {
    const StateSeries* const states = scan->states(*parseSeriesKey(key));
    ASSERT_NE(states, nullptr);
    EXPECT_EQ(states->texts.front(), std::string(200, 'x') + "0");
    EXPECT_EQ(states->texts.back(), "other texts");
    for (const std::string& text : states->texts) bytes += text.size();
    EXPECT_EQ(stateAt(*scan, key, 100), "other texts");
  }
  EXPECT_LE(bytes, options.max_bytes / 4);

  SeriesScan::Options of_numbers;
  of_numbers.states = false;
  const auto numbers =
      scanOf({{0, "RK1 s 0 -\nsignal arm mode \"auto\"\nsignal - estop true"}}, of_numbers);
  EXPECT_EQ(numbers->states(*parseSeriesKey("signal arm mode")), nullptr);
  ASSERT_EQ(numbers->keys().size(), 1U);
  EXPECT_EQ(numbers->keys()[0].text(), "signal - estop");
}

TEST(SeriesScan, OnlyWhatIsAskedFor) {
  SeriesScan::Options options;
  options.only.emplace();
  options.only->insert(*parseSeriesKey("arm.j2"));
  const auto scan = scanOf({{0, "RK1 s 0 -\njoint arm j1=1\njoint arm j2=2"}}, options);
  ASSERT_EQ(scan->keys().size(), 1U);
  EXPECT_EQ(heldAt(*scan, "arm.j2", 50), 2);
}

}  // namespace
}  // namespace rocinante
