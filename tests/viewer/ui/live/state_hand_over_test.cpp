#include "viewer/ui/live/state_hand_over.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "core/packet/decoder.h"
#include "tests/core/packet/random_session.h"

namespace rocinante {
namespace {

TEST(StateChanges, GiveTheSameStateHoweverTheyAreCut) {
  std::mt19937 random(1);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    test::RandomSession session(seed);
    const auto decoder = makeDecoder("rk1");
    const auto window_decoder = makeDecoder("rk1");
    SessionState state, window;
    StateChanges changes;
    bool whole = false;
    for (int i = 0; i < 500; ++i) {
      const auto said = session.next();
      const LogTime time{Nanoseconds(std::llround(said.seconds * 1e9))};
      if (const Packet* packet = decoder->decode(bytesOf(said.text))) {
        state.apply(time, *packet);
        whole = whole || !changes.add(time, bytesOf(said.text), state);
      }
      (void)state.takeEvents();
      if (random() % 50 != 0) continue;
      if (random() % 4 == 0 || whole) changes.replaceBy(state);
      whole = false;
      std::move(changes).applyTo(window, *window_decoder);
      ASSERT_TRUE(changes.empty());
      ASSERT_TRUE(window.sameAs(state));
      EXPECT_EQ(window.counts().size(), state.counts().size());
    }
  }
}

/// Folding thousands of packets of one device costs more than copying it.
TEST(StateChanges, AWindowGetsTheWholeStateWhenMuchWasSaidOfLittle) {
  const auto decoder = makeDecoder("rk1");
  SessionState state, window;
  StateChanges changes;
  const std::string filler = "\n# " + std::string(1000, 'x');
  int added = 0;
  bool whole = false;
  for (int i = 0; i < 5000; ++i) {
    const std::string text = "RK1 a " + std::to_string(i) + " -\njoints arm 1" + filler;
    state.apply(LogTime(Nanoseconds(i)), *decoder->decode(bytesOf(text)));
    if (whole) continue;
    whole = !changes.add(LogTime(Nanoseconds(i)), bytesOf(text), state);
    if (!whole) ++added;
  }
  EXPECT_GT(added, 10);
  EXPECT_LT(added, 20);
  ASSERT_TRUE(whole);
  changes.replaceBy(state);
  std::move(changes).applyTo(window, *decoder);
  EXPECT_TRUE(window.sameAs(state));
}

/// What changes of many devices is handed over as it was said.
TEST(StateChanges, OfALargeStateMayBeLarge) {
  const auto decoder = makeDecoder("rk1");
  SessionState state;
  const auto said = [](int i) {
    return "RK1 a - -\njoints arm" + std::to_string(i) + " 1 2 3 4 5 6";
  };
  for (int i = 0; i < 5000; ++i) {
    state.apply(LogTime(Nanoseconds(i)), *decoder->decode(bytesOf(said(i))));
  }
  StateChanges changes;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(changes.add(LogTime(Nanoseconds(5000)), bytesOf(said(i)), state));
  }
}

}  // namespace
}  // namespace rocinante
