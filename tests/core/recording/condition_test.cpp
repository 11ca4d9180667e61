#include "core/recording/condition.h"

#include <gtest/gtest.h>

#include "core/packet/packet_text.h"
#include "tests/core/recording/fake_clocks.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::logTime;

TEST(Condition, ReadsWhatItIs) {
  EXPECT_EQ(Condition::parse("event=picked*")->text(), "event=picked*");
  EXPECT_EQ(Condition::parse("picked")->text(), "event=picked");
  EXPECT_EQ(Condition::parse("event=a=b")->pattern, "a=b");
  EXPECT_EQ(Condition::parse("source=arm")->kind, Condition::Kind::source);
  EXPECT_EQ(Condition::parse("device=puma")->kind, Condition::Kind::device);
  EXPECT_EQ(Condition::parse("silence=1m02.5s")->silence, 62'500ms);
}

TEST(Condition, RefusesWhatItDoesNotKnow) {
  for (const std::string_view text :
       {"", "event=", "packets=5", "silence=soon", "silence=0s", "silence=-1s", "=x"}) {
    SCOPED_TRACE(text);
    const auto condition = Condition::parse(text);
    ASSERT_FALSE(condition.ok());
    EXPECT_EQ(condition.error().kind, ErrorKind::bad_argument);
  }
}

class Watch {
 public:
  explicit Watch(std::string_view condition) : watch_({Condition::parse(condition).value()}) {}
  bool metBy(std::string_view datagram, Nanoseconds at = 1ms) {
    return watch_.metBy(logTime(at), decoder_.decode(bytesOf(datagram))) != nullptr;
  }
  bool metBySilence(Nanoseconds reached) {
    return watch_.metBySilence(logTime(reached)) != nullptr;
  }
  LogTime moment() const { return watch_.moment(); }

 private:
  PacketTextDecoder decoder_;
  ConditionWatch watch_;
};

TEST(ConditionWatch, AnEventIsMetEachTime) {
  Watch watch("event=part [0-9] *");
  EXPECT_FALSE(watch.metBy("RK1 arm - -\nevent \"part x picked\"\n"));
  EXPECT_TRUE(watch.metBy("RK1 arm - -\njoints a 1\nevent \"other\"\nevent \"part 7 picked\"\n"));
  EXPECT_TRUE(watch.metBy("RK1 arm - -\nevent \"part 7 picked\"\n"));
  EXPECT_FALSE(watch.metBy("no packet"));
  EXPECT_FALSE(watch.metBy("RK1 arm 5 - restated by=relay\nevent \"part 7 picked\"\n"));
}

TEST(ConditionWatch, AnEventsTextIsAlsoMetAsItStands) {
  EXPECT_TRUE(Watch("event=[odd").metBy("RK1 arm - -\nevent \"[odd\"\n"));
}

TEST(ConditionWatch, ASourceIsMetWhenItFirstSpeaks) {
  Watch watch("source=cell/*");
  EXPECT_FALSE(watch.metBy("RK1 arm - -\n"));
  EXPECT_FALSE(watch.metBy("RK1 cell%2Farm - - by=relay\n"));
  EXPECT_TRUE(watch.metBy("RK1 cell%2Farm - -\n"));
  EXPECT_FALSE(watch.metBy("RK1 cell%2Farm - -\n"));
}

TEST(ConditionWatch, ADeviceIsMetWhenItIsFirstSpokenOf) {
  for (const std::string_view said : {"joints puma 1", "joint puma a=1", "pose puma 0 0 0 0 0 0 1",
                                      "add puma m", "remove puma", "order puma a"}) {
    SCOPED_TRACE(said);
    Watch watch("device=puma");
    EXPECT_FALSE(watch.metBy("RK1 arm - -\nlabel puma 0 0 0 \"puma\"\njoints other 1\n"));
    EXPECT_TRUE(watch.metBy("RK1 arm - -\n" + std::string(said) + "\n"));
    EXPECT_FALSE(watch.metBy("RK1 arm - -\n" + std::string(said) + "\n"));
  }
}

TEST(ConditionWatch, ASilenceFallsOnceAndAfterSomethingWasHeard) {
  Watch watch("silence=2s");
  EXPECT_FALSE(watch.metBySilence(100s));
  EXPECT_FALSE(watch.metBy("anything", 100s));
  EXPECT_FALSE(watch.metBySilence(101'999ms));
  EXPECT_TRUE(watch.metBySilence(103s));
  EXPECT_EQ(watch.moment(), logTime(102s));
  EXPECT_FALSE(watch.metBySilence(110s));
  EXPECT_FALSE(watch.metBy("anything", 120s));
  EXPECT_TRUE(watch.metBySilence(122s));
}

}  // namespace
}  // namespace rocinante
