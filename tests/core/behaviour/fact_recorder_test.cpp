// Facts of signals: noted as if the whole state were looked at each time, at the cost of what was
// said.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/behaviour/track_recorder.h"
#include "core/packet/decoder.h"
#include "core/session/message_folder.h"

namespace rocinante {
namespace {

constexpr Nanoseconds kApart = std::chrono::milliseconds(20);  // longer than a burst

/// Records packets, and beside them notes the whole state after each that was applied.
class FactRecording {
 public:
  FactRecording() {
    recorder_.begin({});
    whole_.note(state_, LogTime(), true);
  }

  void say(const std::string& text) {
    const Packet* const packet = decoder_->decode(bytesOf(text));
    ASSERT_NE(packet, nullptr) << text;
    recorder_.add(now_, *packet);
    if (foldPacket(state_, now_, *packet) == Applied::yes) {
      whole_.note(state_, now_, packet->header.restated);
    }
    now_ += kApart;
  }

  void expectSame() {
    ASSERT_TRUE(recorder_.finish().ok());
    EXPECT_EQ(textOf(track_.facts), textOf(facts_));
  }

  std::uint64_t looked() const { return recorder_.factsLooked(); }
  const FactRecorder::Facts& facts() const { return track_.facts; }

 private:
  static std::string textOf(const FactRecorder::Facts& facts) {
    std::string text;
    for (const auto& [name, changes] : facts) {
      for (const FactChange& change : changes) {
        text += fmt::format("{} at {}: [{}]{}\n", name, nanosecondsOf(change.at), change.text,
                            change.is_restated ? " restated" : "");
      }
    }
    return text;
  }

  Cell cell_;
  SessionTrack track_;
  std::vector<std::string> links_;
  TrackRecorder recorder_{cell_, track_, links_};
  std::unique_ptr<Decoder> decoder_ = makeDecoder("rk1");
  SessionState state_;
  FactRecorder::Facts facts_;
  FactRecorder whole_{facts_};
  LogTime now_{};
};

TEST(FactRecorder, LooksOnlyAtSignalsThatWereSaid) {
  constexpr int kSignals = 200, kPackets = 600;
  FactRecording recording;
  for (int i = 0; i < kSignals; ++i) {
    recording.say(fmt::format("RK1 s - -\nsignal arm n{} {} kg\nsignal arm t{} \"a\"\n", i, i, i));
  }
  for (int i = 0; i < kPackets; ++i) {
    recording.say(fmt::format("RK1 s - -\nsignals arm n{}={}\nsignal arm t{} \"b{}\"\n",
                              i % kSignals, i, i % kSignals, i));
  }
  // An item, and at most both of its facts, for each that says another one; and the beginning.
  EXPECT_LE(recording.looked(), 3U * (2 * kSignals + kPackets) + 100);
  recording.expectSame();
  EXPECT_EQ(recording.facts().size(), 2U * kSignals);
}

TEST(FactRecorder, NotesWhatTheWholeStateSays) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 dice(seed);
    const auto roll = [&](unsigned sides) { return static_cast<unsigned>(dice() % sides); };
    const auto statement = [&]() -> std::string {
      constexpr std::array kPaths = {"arm", "hand", "arm/tip", "-"};
      constexpr std::array kDevices = {"arm", "hand"};
      const char* const path = kPaths[roll(4)];
      const char* const device = kDevices[roll(2)];
      const char name = static_cast<char>('p' + roll(4));
      switch (roll(12)) {
        case 0:
          return fmt::format("signal {} {} true\n", path, name);
        case 1:
          return fmt::format("signal {} {} default\n", path, name);
        case 2:
          return fmt::format("remove {}\n", device);
        case 3:
          return fmt::format("hide {}\nline {} #ffffff 0 0 0 1 1 1\n", device, name);
        case 4:
          return "erase *\n";
        case 5:
        case 6:
          return fmt::format("signal {} {} {} {}\n", path, name, roll(3), roll(2) ? "kg" : "g");
        case 7:
        case 8:
          return fmt::format("signals {} {}={}\n", path, name, roll(3));
        default:
          return fmt::format("signal {} {} \"{}\"\n", path, name, roll(3));
      }
    };
    FactRecording recording;
    for (int i = 0; i < 150; ++i) {
      std::string text = fmt::format("RK1 {} - -", roll(2) ? "a" : "b");
      if (roll(10) == 0) text += fmt::format(" restated part=r:{}/2", roll(2) + 1);
      text += "\n";
      for (unsigned said = roll(3); said > 0; --said) text += statement();
      recording.say(text);
    }
    recording.expectSame();
  }
}

}  // namespace
}  // namespace rocinante
