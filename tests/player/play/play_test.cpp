#include "player/play/play.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

TEST(ParseLoop, FindsThePlaceToCut) {
  const LogTime origin(10s);
  const LogTime end(20s);
  EXPECT_EQ(parseLoop("2s-4.5s", origin, end).value(),
            (PlayedSpan{LogTime(12s), LogTime(14'500ms)}));
  EXPECT_EQ(parseLoop("-4s--1s", origin, end).value(), (PlayedSpan{LogTime(16s), LogTime(19s)}));
  EXPECT_EQ(parseLoop("1970-01-01T00:00:11Z-1970-01-01T00:00:12Z", origin, end).value(),
            (PlayedSpan{LogTime(11s), LogTime(12s)}));
  EXPECT_FALSE(parseLoop("4s-2s", origin, end).ok());
  EXPECT_FALSE(parseLoop("-", origin, end).ok());
  EXPECT_FALSE(parseLoop("", origin, end).ok());
}

}  // namespace
}  // namespace rocinante
