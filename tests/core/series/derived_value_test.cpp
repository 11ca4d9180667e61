#include "core/series/derived_value.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/series/series_scan.h"
#include "tests/core/series/spoken_log.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using test::spokenTime;
using Pairs = std::vector<std::pair<double, double>>;

LogTime afterSeconds(double seconds) {
  return LogTime(std::chrono::seconds(1000)) +
         Nanoseconds(static_cast<std::int64_t>(std::llround(seconds * 1e9)));
}

/// What a derived value of `arm.a` says of samples: pairs of seconds and value; NaN ends it.
Pairs saidOf(const char* text, const Pairs& samples) {
  DerivedValue value(*parseSeriesKey(text));
  Pairs said;
  for (const auto& [seconds, number] : samples) {
    value.take(0, std::isnan(number) ? std::nullopt : std::optional(number));
    const auto here = value.at(afterSeconds(seconds));
    if (here) said.emplace_back(seconds, here->value_or(NAN));
  }
  return said;
}

TEST(DerivedValue, TextIsReadBack) {
  for (const char* text :
       {"d/dt arm.elbow", "mean 0.5 arm.elbow", "arm.elbow - arm.wrist", "d/dt arm/tool0:x in base",
        "mean 0.1 d/dt signal - load", "signal - a - signal arm b", "d/dt arm:x - tray:x",
        "mean 1e-3 mean 2 d/dt arm.j"}) {
    const auto key = parseSeriesKey(text);
    ASSERT_TRUE(key.has_value()) << text;
    EXPECT_EQ(key->kind, SeriesKey::Kind::derived) << text;
    EXPECT_EQ(key->text(), text);
  }
  const auto apart = derivationOf(*parseSeriesKey("signal - a - signal arm b"));
  ASSERT_EQ(apart->of.size(), 2U);
  EXPECT_EQ(apart->of[0].text(), "signal - a");
  EXPECT_EQ(apart->of[1].text(), "signal arm b");
  EXPECT_EQ(parseSeriesKey("signal - estop")->kind, SeriesKey::Kind::signal);
}

TEST(DerivedValue, OtherTextIsNone) {
  for (const char* text : {"d/dt", "d/dt ", "d/dt rate", "mean arm.j", "mean 0 arm.j",
                           "mean -1 arm.j", "d/dt d/dt d/dt d/dt d/dt arm.j", "mean nan arm.j",
                           "mean inf arm.j", "mean 3601 arm.j", "mean 1", "rate - loss"}) {
    EXPECT_FALSE(parseDerivedKey(text).has_value()) << text;
  }
  std::string deep;
  for (int i = 0; i < 20'000; ++i) deep += "d/dt ";
  const auto key = parseDerivedKey(deep + "arm.j");
  EXPECT_TRUE(!key || statedOf(*key).size() == 1) << "it is a device of that name, at most";
}

TEST(DerivedValue, ARateIsTheChangeByTheSecondsThatPassed) {
  EXPECT_EQ(saidOf("d/dt arm.a", {{0, 1}, {2, 5}, {2.5, 5}, {3.5, 4}}),
            (Pairs{{2, 2}, {2.5, 0}, {3.5, -1}}));
  // Nothing is known of the time before a gap; two samples of one moment make no infinite speed.
  const Pairs gap = saidOf("d/dt arm.a", {{0, 1}, {1, 2}, {2, NAN}, {3, 9}, {3, 10}, {4, 10}});
  ASSERT_EQ(gap.size(), 3U);
  EXPECT_EQ(gap[0], (std::pair{1.0, 1.0}));
  EXPECT_TRUE(std::isnan(gap[1].second));
  EXPECT_EQ(gap[2], (std::pair{4.0, 0.0}));
}

TEST(DerivedValue, AMeanWeighsByTheTimeThatValuesHold) {
  // 0 for nine tenths of the second, then 10: it was 1 in the mean.
  const Pairs said =
      saidOf("mean 1 arm.a", {{0, 0}, {0.9, 10}, {1, 10}, {3, 10}, {4, NAN}, {5, 7}});
  ASSERT_EQ(said.size(), 6U);
  EXPECT_EQ(said[0].second, 0);
  EXPECT_NEAR(said[2].second, 1, 1e-9);
  EXPECT_NEAR(said[3].second, 10, 1e-9);
  EXPECT_TRUE(std::isnan(said[4].second));
  EXPECT_EQ(said[5].second, 7);
}

TEST(DerivedValue, AMeanForgetsAWildValueThatHasLeftIt) {
  for (const double wild : {3.4e38, 1e308}) {
    Pairs samples;
    for (int i = 0; i < 100; ++i) samples.emplace_back(i / 10.0, i == 20 ? wild : 1);
    const Pairs said = saidOf("mean 1 arm.a", samples);
    ASSERT_EQ(said.size(), samples.size());
    EXPECT_DOUBLE_EQ(said[10].second, 1) << wild;
    for (std::size_t i = 40; i < said.size(); ++i) {
      EXPECT_NEAR(said[i].second, 1, 1e-9) << wild << ", sample " << i;
    }
  }
}

TEST(DerivedValue, AMeanFollowsAValueThatIsSentOnChange) {
  DerivedValue value(*parseSeriesKey("mean 1 arm.a"));
  const auto none = [&](double seconds) { return !value.nextBefore(afterSeconds(seconds)); };
  value.take(0, 0);
  ASSERT_TRUE(value.at(afterSeconds(0)).has_value());
  value.take(0, 10);
  EXPECT_TRUE(none(10)) << "a value that holds changes no mean";
  EXPECT_NEAR(**value.at(afterSeconds(10)), 0, 1e-9);
  // What is stated next does not count before its time.
  value.take(0, 4);
  std::size_t count = 0;
  double last = 0;
  while (const auto between = value.nextBefore(afterSeconds(12))) {
    ASSERT_LE(++count, 17U);
    const double seconds = static_cast<double>((between->time - afterSeconds(10)).count()) * 1e-9;
    ASSERT_TRUE(between->value.has_value());
    last = *between->value;
    EXPECT_NEAR(last, 10 * seconds, 1e-6) << "the part of the second that has passed";
  }
  EXPECT_GE(count, 16U);
  EXPECT_NEAR(last, 10, 1e-6);
  EXPECT_NEAR(**value.at(afterSeconds(12)), 10, 1e-6);
  // A gap ends it.
  value.take(0, std::nullopt);
  ASSERT_TRUE(value.at(afterSeconds(12.5)).has_value());
  EXPECT_TRUE(none(20));
}

TEST(DerivedValue, TheMeanOfARateIsTheChangeOverThatTime) {
  // Bursts: two samples 1 us apart, each 10 ms. The rate is wild, its mean is not.
  Pairs samples;
  for (int i = 0; i < 200; ++i) {
    samples.emplace_back(i * 0.01, i * 0.02);
    samples.emplace_back(i * 0.01 + 1e-6, i * 0.02 + 0.01);
  }
  for (const auto& [seconds, rate] : saidOf("mean 0.5 d/dt arm.a", samples)) {
    if (seconds > 0.6) {
      EXPECT_NEAR(rate, 2, 0.05) << seconds;
    }
  }
}

// A mean lies between the least and the greatest sample.
RC_GTEST_PROP(DerivedValue, AMeanIsWithinItsSamples,
              (std::vector<std::pair<std::uint8_t, int>> said)) {
  DerivedValue value(*parseSeriesKey("mean 0.05 arm.a"));
  double least = INFINITY, most = -INFINITY, seconds = 0;
  for (const auto& [wait, number] : said) {
    seconds += wait * 1e-3;
    const double sample = number % 1000;
    least = std::min(least, sample);
    most = std::max(most, sample);
    value.take(0, sample);
    const auto mean = value.at(afterSeconds(seconds));
    RC_ASSERT(mean.has_value() && mean->has_value());
    RC_ASSERT(**mean >= least - 1e-6 && **mean <= most + 1e-6);
  }
}

TEST(DerivedValue, IsGatheredWithWhatItIsMadeOf) {
  const test::TemporaryFolder folder;
  test::writeSpoken(folder / "s.mcap", {{0, "RK1 s 0 -\njoint arm a=1 b=4"},
                                        {100, "RK1 s 1 -\njoint arm a=2 b=5"},
                                        {200, "RK1 s 2 -\njoint arm a=4"},
                                        {500, "RK1 s 3 -\nremove arm"}});
  auto log = LogReader::open(folder / "s.mcap");
  ASSERT_TRUE(log.ok());
  SeriesScan::Options options;
  options.from = spokenTime(0);
  options.until = spokenTime(1000);
  const SeriesKey rate = *parseSeriesKey("d/dt arm.a");
  const SeriesKey apart = *parseSeriesKey("arm.a - arm.b");
  options.only = {{rate, apart}};
  SeriesScan scan(std::move(options));
  for (auto message = log->next(); message.ok() && *message; message = log->next()) {
    scan.add(**message);
  }
  const auto columnsOf = [&](const SeriesKey& key) {
    return scan.values(key)->columns(spokenTime(-50), spokenTime(950), 10);
  };
  const auto rates = columnsOf(rate);
  EXPECT_FALSE(rates[0].held.has_value()) << "one sample has no rate";
  EXPECT_NEAR(*rates[1].held, 10, 1e-4);
  EXPECT_NEAR(*rates[3].held, 20, 1e-4);
  EXPECT_FALSE(rates[6].held.has_value());
  const auto differences = columnsOf(apart);
  EXPECT_EQ(differences[0].held, -3);
  EXPECT_EQ(differences[1].bin.low, -3) << "both of one packet change at once";
  EXPECT_EQ(differences[1].bin.high, -3);
  EXPECT_EQ(differences[2].held, -1);
  EXPECT_FALSE(differences[6].held.has_value());
}

TEST(DerivedValue, AMeanIsGatheredBetweenItsSamples) {
  const test::TemporaryFolder folder;
  test::writeSpoken(folder / "s.mcap", {{0, "RK1 s 0 -\njoint arm a=0"},
                                        {400, "RK1 s 1 -\njoint arm a=10"},
                                        {900, "RK1 s 2 -\njoint leg a=1"}});
  auto log = LogReader::open(folder / "s.mcap");
  ASSERT_TRUE(log.ok());
  SeriesScan::Options options;
  options.from = spokenTime(0);
  options.until = spokenTime(1000);
  const SeriesKey mean = *parseSeriesKey("mean 0.1 arm.a");
  options.only = {{mean}};
  SeriesScan scan(std::move(options));
  for (auto message = log->next(); message.ok() && *message; message = log->next()) {
    scan.add(**message);
  }
  const auto columns = scan.values(mean)->columns(spokenTime(0), spokenTime(1000), 10);
  EXPECT_NEAR(*columns[2].held, 0, 1e-4);
  EXPECT_NEAR(*columns[6].held, 10, 1e-4) << "0.2 s behind the only change";
}

TEST(DerivedValue, AMeanIsKnownAtAnyMoment) {
  DerivedValue mean(*parseSeriesKey("mean 1 arm.a"));
  const auto say = [&](double seconds, double value) {
    mean.take(0, value);
    return mean.at(afterSeconds(seconds));
  };
  say(0, 0);
  say(1, 10);
  for (const double seconds : {1.01, 1.3, 1.77, 1.999}) {
    while (mean.nextBefore(afterSeconds(seconds))) {
    }
    const auto said = mean.asOf(afterSeconds(seconds));
    ASSERT_TRUE(said && *said) << seconds;
    EXPECT_NEAR(**said, (seconds - 1) * 10, 1e-6);
  }
  while (mean.nextBefore(afterSeconds(5))) {
  }
  EXPECT_FALSE(mean.asOf(afterSeconds(5)).has_value()) << "nothing changes any more";
  DerivedValue rate(*parseSeriesKey("d/dt arm.a"));
  rate.take(0, 1.0);
  rate.at(afterSeconds(0));
  EXPECT_FALSE(rate.asOf(afterSeconds(1)).has_value());
}

TEST(DerivedValue, WhatIsNoneSaysWhy) {
  EXPECT_EQ(derivationFault("mean nan arm.a"),
            "SECONDS is a number from 1e-9 to 3600, not `nan`: mean SECONDS VALUE");
  for (const char* wrong : {"inf", "0", "-1", "3601", "1e-10", "1e308", "arm.a", "0x1", "1s"}) {
    const std::string fault = derivationFault("mean " + std::string(wrong) + " arm.a");
    EXPECT_EQ(fault, "SECONDS is a number from 1e-9 to 3600, not `" + std::string(wrong) +
                         "`: mean SECONDS VALUE");
  }
  EXPECT_EQ(derivationFault("d/dt mean nan arm.a"), derivationFault("mean nan arm.a"));
  EXPECT_EQ(derivationFault("mean"), "`mean` needs SECONDS VALUE");
  EXPECT_EQ(derivationFault("mean 0.5"), "`mean` needs SECONDS VALUE");
  EXPECT_EQ(derivationFault("d/dt"), "`d/dt` needs a VALUE");
  EXPECT_EQ(
      derivationFault("d/dt rate"),
      "`rate` has no derivative: use DEVICE.JOINT, DEVICE:x, DEVICE/LINK:x, signal PATH NAME or "
      "what is derived of them");
  EXPECT_EQ(derivationFault("mean 1 arm"),
            "`arm` has no mean: use DEVICE.JOINT, DEVICE:x, DEVICE/LINK:x, signal PATH NAME or "
            "what is derived of them");
  EXPECT_EQ(derivationFault("d/dt d/dt d/dt d/dt d/dt arm.a"),
            "a value is derived at most 4 times");
  for (const char* fine : {"arm.a", "d/dt arm.a", "mean 0.5 d/dt arm.a", "arm.a - arm.b", "meaning",
                           "signal arm mean", ""}) {
    EXPECT_EQ(derivationFault(fine), "") << fine;
  }
}

TEST(DerivedValue, OfATextThereIsNone) {
  const SeriesKey mode = *parseSeriesKey("signal arm mode");
  const auto said = [&](const char* text) { return noNumberOf(*parseSeriesKey(text), mode); };
  EXPECT_EQ(said("d/dt signal arm mode"),
            "`signal arm mode` is a text, and a text has no derivative");
  EXPECT_EQ(said("mean 1 signal arm mode"), "`signal arm mode` is a text, and a text has no mean");
  EXPECT_EQ(said("mean 1 d/dt signal arm mode"), said("d/dt signal arm mode"));
  EXPECT_EQ(said("d/dt arm.a - signal arm mode"),
            "`signal arm mode` is a text, and a text has no difference");
}

RC_GTEST_PROP(DerivedValue, AnyTextIsReadOrSaysWhyInOneLine, ()) {
  const auto word = rc::gen::element<std::string>("d/dt", "mean", "0.5", "nan", "-", "arm.a",
                                                  "arm:x", "signal", "in", "", "1e308", "a/b:x");
  std::string text;
  for (const std::string& each : *rc::gen::container<std::vector<std::string>>(word)) {
    text += (text.empty() ? "" : " ") + each;
  }
  const auto key = parseSeriesKey(text);
  const std::string fault = derivationFault(text);
  RC_ASSERT(fault.find('\n') == std::string::npos);
  if (key && key->kind == SeriesKey::Kind::derived) RC_ASSERT(fault.empty());
}

}  // namespace
}  // namespace rocinante
