#include "viewer/ui/live/other_windows.h"

#include <gtest/gtest.h>

#include "core/packet/decoder.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr SteadyTime kNow{Nanoseconds(1'000'000'000'000)};

void say(SessionState& state, const std::string& text) {
  const auto decoder = makeDecoder("rk1");
  const Packet* const packet = decoder->decode(bytesOf(text));
  ASSERT_NE(packet, nullptr);
  foldPacket(state, LogTime{}, *packet);
}

LiveSource heardAt(const std::string& name, SteadyTime heard) {
  LiveSource source;
  source.name = name;
  source.heard = heard;
  return source;
}

TEST(OtherWindows, OneThatWasKilledIsSilentUntilItSpeaksAgain) {
  SessionState state;
  say(state, "RK1 ann@a 0 -\nview ann 1 2 3 0 0 0 45\n");
  OtherWindows others;
  EXPECT_FALSE(others.look(state, std::array{heardAt("ann", kNow)}, kNow + 5900ms));
  EXPECT_FALSE(others.isSilent("ann"));
  EXPECT_TRUE(others.look(state, std::array{heardAt("ann", kNow)}, kNow + 6s));
  EXPECT_TRUE(others.isSilent("ann"));
  EXPECT_FALSE(others.hasLeft("ann"));
  EXPECT_TRUE(others.look(state, std::array{heardAt("ann", kNow + 7s)}, kNow + 7s));
  EXPECT_FALSE(others.isSilent("ann"));
}

TEST(OtherWindows, OneThatClosedHasLeftAndNoOtherSourceHas) {
  SessionState state;
  say(state, "RK1 ann@a 0 -\nview ann 1 2 3 0 0 0 45\n");
  say(state, "RK1 arm@a 0 -\njoints arm 0\n");
  OtherWindows others;
  const std::array sources{heardAt("ann", kNow), heardAt("arm", kNow)};
  others.look(state, sources, kNow);
  say(state, "RK1 ann@a 1 - restated part=end0:1/1\n");
  EXPECT_FALSE(others.look(state, sources, kNow + 60s)) << "neither is a silent window";
  EXPECT_TRUE(others.hasLeft("ann"));
  EXPECT_FALSE(others.hasLeft("arm"));
}

}  // namespace
}  // namespace rocinante
