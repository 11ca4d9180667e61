#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <clocale>
#include <optional>
#include <random>
#include <string>

#include "core/packet/text_number.h"

namespace rocinante {
namespace {

std::optional<double> numberOf(const std::string& text) {
  const char* at = text.data();
  double number = 0;
  if (!readNumber(at, text.data() + text.size(), number)) return std::nullopt;
  if (at != text.data() + text.size()) return std::nullopt;
  return number;
}

/// The C++ library's result; empty when it reports out of range.
std::optional<double> nearest(const std::string& text) {
  double number = 0;
  const auto answer = std::from_chars(text.data(), text.data() + text.size(), number);
  if (answer.ec != std::errc()) return std::nullopt;
  return number;
}

TEST(PacketNumber, IsTheNearestDoubleToTheLastBit) {
  const char* const kTexts[] = {"0.1",
                                "0.3",
                                "123456789.987654321",
                                "9007199254740993",
                                "9007199254740992.5",
                                "0.1000000000000000055511151231257827",
                                "1e22",
                                "1e23",
                                "8.98846567431158e307",
                                "1.7976931348623157e308",
                                "2.2250738585072014e-308",
                                "5e-324",
                                "2.4703282292062328e-324",
                                "0.0000000000000000000000000000001",
                                "1234567890123456789012345678901234567890",
                                "6.02214076E23",
                                "100000000000000016777215",
                                "4.35",
                                "0.000001",
                                "18014398509481985"};
  for (const char* const text : kTexts) {
    SCOPED_TRACE(text);
    ASSERT_TRUE(numberOf(text));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(*numberOf(text)),
              std::bit_cast<std::uint64_t>(nearest(text).value_or(0)));
  }
}

TEST(PacketNumber, RandomDecimalsAgreeWithTheLibraryBitForBit) {
  std::mt19937_64 random(19);
  for (int i = 0; i < 200000; ++i) {
    std::string text = std::to_string(random() >> (random() % 64));
    if (text.size() > 1 && random() % 4 != 0) {
      text.insert(1 + random() % (text.size() - 1), 1, '.');
    }
    if (random() % 8 == 0)
      text.append("e").append(std::to_string(static_cast<int>(random() % 600) - 300));
    const auto expected = nearest(text);
    if (!expected) continue;
    const auto number = numberOf(text);
    ASSERT_TRUE(number) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*number), std::bit_cast<std::uint64_t>(*expected))
        << text;
  }
}

TEST(PacketNumber, WhatIsTooSmallIsZeroAndWhatIsTooLargeIsRefused) {
  EXPECT_EQ(numberOf("1e-400"), 0);
  EXPECT_EQ(numberOf("1e400"), std::nullopt);
  EXPECT_EQ(numberOf("-1e400"), std::nullopt);
  EXPECT_EQ(numberOf("1e99999999999999999999"), std::nullopt);
}

TEST(PacketNumber, MinusZeroReadsAsZero) {
  for (const char* const text : {"-0", "-0.0", "-0e5", "-1e-400"}) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(numberOf(text).value()), 0U) << text;
  }
}

TEST(PacketNumber, IsTheSameInEveryLocale) {
  // If the locale is not installed this changes nothing, and the test still holds.
  const char* const before = std::setlocale(LC_ALL, nullptr);
  const std::string kept = before == nullptr ? "C" : before;
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  EXPECT_EQ(numberOf("1.5"), 1.5);
  EXPECT_EQ(numberOf("1.5e3"), 1500);
  EXPECT_EQ(numberOf("1,5"), std::nullopt);
  std::string text;
  appendNumber(text, 1.5);
  EXPECT_EQ(text, "1.5");
  std::setlocale(LC_ALL, kept.c_str());
}

TEST(PacketNumber, SecondsAreWrittenWithoutTrailingZeros) {
  const auto written = [](std::int64_t nanoseconds) {
    std::string text;
    appendSeconds(text, nanoseconds);
    return text;
  };
  EXPECT_EQ(written(0), "0");
  EXPECT_EQ(written(1), "0.000000001");
  EXPECT_EQ(written(12'500'000'000), "12.5");
  EXPECT_EQ(written(INT64_MAX), "9223372036.854775807");
  EXPECT_EQ(readSeconds(written(INT64_MAX)), INT64_MAX);
}

}  // namespace
}  // namespace rocinante
