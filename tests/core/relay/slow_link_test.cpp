// Two six-joint arms at 60 Hz through a telephone line of 28.8 kbit/s, by a clock of the test: how
// often each arrives, how old its values are, and what waits for the line.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/relay/relay.h"
#include "core/source/source.h"
#include "tests/core/packet/fold_text.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr double kBitsPerSecond = 28'800;
constexpr Nanoseconds kLinkStep = 1ms;
constexpr LogTime kBegin(1'700'000'000s);

/// A line that sends one bit after the other; the heads of IP and UDP count, and what the line adds
/// itself. What comes too fast waits, without limit.
class Line {
 public:
  explicit Line(std::size_t own_bytes = 0) : head_bytes_(28 + own_bytes) {}

  void send(LogTime now, std::string_view text) {
    const double seconds = static_cast<double>(text.size() + head_bytes_) * 8 / kBitsPerSecond;
    free_ = std::max(free_, now) + Nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
    under_way_.emplace_back(free_, text);
  }
  /// What has arrived by `now`, one datagram a call; empty: nothing more.
  std::string receive(LogTime now) {
    if (under_way_.empty() || under_way_.front().first > now) return {};
    std::string text = std::move(under_way_.front().second);
    under_way_.pop_front();
    return text;
  }
  /// How long what waits will take.
  Nanoseconds waiting(LogTime now) const { return std::max(free_ - now, Nanoseconds(0)); }

 private:
  std::size_t head_bytes_;
  LogTime free_{};
  std::deque<std::pair<LogTime, std::string>> under_way_;
};

/// An arm at 60 Hz that says again what it said every two seconds. Its first joint is the time in
/// seconds, so that a listener can tell how old what it sees is.
class Arm {
 public:
  Arm(std::string name, Nanoseconds phase, Relay& relay)
      : name_(std::move(name)), next_(kBegin + phase) {
    SourceSettings settings;
    settings.source = name_;
    settings.run = "7f3a";
    source_.emplace(Source::open(settings, [this, &relay](std::span<std::byte> bytes) {
                      relay.receive(bytes, now_);
                      return true;
                    }).value());
    arm_ = source_->device(name_);
    const SourceDevice tray = source_->device(name_ + "_tray");
    EXPECT_EQ(source_->add(tray, "tray"), SourceResult::done);
    EXPECT_EQ(source_->setColor({name_, "", false}, 0xFF8000FF), SourceResult::done);
  }

  void advance(LogTime now) {
    if (now < next_) return;
    now_ = now;
    const double seconds = secondsOf(now - kBegin);
    std::array<double, 6> joints{seconds};
    for (std::size_t i = 1; i < joints.size(); ++i) {
      joints[i] = 3 * std::sin(0.6 * seconds + static_cast<double>(i));
    }
    EXPECT_EQ(source_->setJoints(arm_, joints), SourceResult::done);
    EXPECT_EQ(source_->flush(WallTime(now.time_since_epoch())), SourceResult::done);
    next_ = kBegin + Nanoseconds(1'000'000'000 * ++cycle_ / 60);
  }
  const std::string& name() const { return name_; }

 private:
  std::string name_;
  std::optional<Source> source_;
  SourceDevice arm_;
  LogTime next_, now_{};
  std::int64_t cycle_ = 0;
};

/// What a listener at the end of the line saw of one arm.
struct SeenArm {
  double value_s = -1;         ///< the newest; below 0: none
  int arrivals = 0;            ///< of other values than before, in this second
  int least_arrivals = 1000;   ///< in a second
  std::vector<double> ages_s;  ///< of what the listener shows, each millisecond
};

TEST(SlowLink, TwoArmsAt60HzArriveTenTimesASecondAndFreshThrough28800Bits) {
  Relay relay({"modem", "r"});
  RelayOutputOptions options;
  options.bytes_per_second = kBitsPerSecond / 8;
  (void)relay.open(std::move(options), kBegin);
  Arm first("arm1", 0ms, relay), second("arm2", 7ms, relay);
  Line line;
  test::TextFold listener;
  std::map<std::string, SeenArm> seen;
  std::vector<Nanoseconds> most_waiting;  // in each second
  constexpr int kSeconds = 120;
  for (LogTime now = kBegin; now < kBegin + std::chrono::seconds(kSeconds); now += kLinkStep) {
    first.advance(now);
    second.advance(now);
    if (relay.due() <= now) relay.advance(now);
    for (const Relay::Outgoing& each : relay.outgoing()) {
      EXPECT_LE(each.payload.size(), 180U) << textOf(each.payload);
      line.send(now, textOf(each.payload));
    }
    relay.clearOutgoing();
    const bool second_begins = (now - kBegin) % 1s == 0ms;
    if (second_begins) most_waiting.emplace_back();
    most_waiting.back() = std::max(most_waiting.back(), line.waiting(now));
    for (std::string text = line.receive(now); !text.empty(); text = line.receive(now)) {
      ASSERT_EQ(listener.fold(secondsOf(now - kBegin), text), Applied::yes) << text;
    }
    for (const Arm* arm : {&first, &second}) {
      SeenArm& what = seen[arm->name()];
      const DeviceState& device = listener.device(arm->name());
      if (second_begins && now >= kBegin + 2s) {
        what.least_arrivals = std::min(what.least_arrivals, what.arrivals);
      }
      if (second_begins) what.arrivals = 0;
      if (!device.joints) continue;
      if (what.value_s != device.joints->value.at(0)) ++what.arrivals;
      what.value_s = device.joints->value.at(0);
      what.ages_s.push_back(secondsOf(now - kBegin) - what.value_s);
    }
  }
  for (auto& [arm, what] : seen) {
    SCOPED_TRACE(arm);
    EXPECT_GE(what.least_arrivals, 10) << "in a second";
    std::sort(what.ages_s.begin(), what.ages_s.end());
    EXPECT_GE(what.ages_s.size(), kSeconds * 990U) << "it must be seen nearly all the time";
    EXPECT_LE(what.ages_s[what.ages_s.size() * 99 / 100], 0.2);
    EXPECT_EQ(listener.counts(arm).gap, 0U);
  }
  // What waits for the line is one datagram and what made up for a late wake-up, in the last second
  // as in the third.
  const Nanoseconds one_datagram(static_cast<std::int64_t>(208 * 8 / kBitsPerSecond * 1e9));
  for (std::size_t i = 2; i < most_waiting.size(); ++i) {
    EXPECT_LE(most_waiting[i], one_datagram + 10ms) << "second " << i;
  }
}

/// PPP's, of each datagram.
constexpr std::size_t kPppBytes = 8;
/// A UR10's.
constexpr std::array kJointNames = {"shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint",
                                    "wrist_1_joint",      "wrist_2_joint",       "wrist_3_joint"};

/// What an arm says in its turn `i`: each joint of it has the turn in its value, so that a listener
/// can tell of which turns it shows the joints.
std::string posePacket(const std::string& arm, int i, std::string_view form) {
  const double time_s = secondsOf(kBegin.time_since_epoch()) + i / 60.0;
  std::string text = fmt::format("RK1 {}@7f3a {} {:.9f}\n", arm, i, time_s);
  if (form == "order") {
    text += fmt::format("order {} {}\njoints {}", arm, fmt::join(kJointNames, " "), arm);
  } else {
    text += fmt::format("joint {}", arm);
  }
  for (std::size_t k = 0; k < kJointNames.size(); ++k) {
    text += form == "order" ? " " : fmt::format(" {}=", kJointNames[k]);
    text += fmt::format("{:.6f}", (k % 2 == 0 ? 1 : -1) * (static_cast<int>(k) + i / 10'000.0));
  }
  return text + '\n';
}

/// The turn of which a listener shows all joints; empty: of several.
std::optional<int> shownTurn(const DeviceState& device) {
  std::optional<int> shown;
  for (std::size_t k = 0; k < kJointNames.size(); ++k) {
    const auto found = device.named_joints.find(kJointNames[k]);
    if (found == device.named_joints.end()) return std::nullopt;
    const double part = std::abs(found->second.value) - static_cast<double>(k);
    const int turn = static_cast<int>(std::lround(part * 10'000));
    if (shown && *shown != turn) return std::nullopt;
    shown = turn;
  }
  return shown;
}

struct SeenPoses {
  int whole = 0, mixed = 0;
  std::uint64_t without_order = 0;
  Nanoseconds most_waiting{};
  bool is_positional = false;
};

/// Two arms with named joints at 60 Hz through 28.8 kbit/s of a line with PPP.
SeenPoses posesThroughTheLine(int seconds, std::string_view form, double loss) {
  Relay relay({"modem", "r"});
  RelayOutputOptions options;
  options.bytes_per_second = kBitsPerSecond / 8;
  options.head_bytes = 28 + kPppBytes;
  (void)relay.open(std::move(options), kBegin);
  Line line(kPppBytes);
  test::TextFold listener;
  SeenPoses seen;
  std::map<std::string, int> turns, newest;
  std::minstd_rand random(5);
  std::uniform_real_distribution<double> chance(0, 1);
  for (LogTime now = kBegin; now < kBegin + std::chrono::seconds(seconds); now += kLinkStep) {
    for (const char* arm : {"arm_left", "arm_right"}) {
      int& turn = turns[arm];
      const Nanoseconds phase = arm == std::string_view("arm_left") ? 0ms : 7ms;
      if (now < kBegin + phase + Nanoseconds(1'000'000'000LL * turn / 60)) continue;
      relay.receive(bytesOf(posePacket(arm, turn++, form)), now);
    }
    if (relay.due() <= now) relay.advance(now);
    for (const Relay::Outgoing& each : relay.outgoing()) line.send(now, textOf(each.payload));
    relay.clearOutgoing();
    if (now > kBegin + 2s) seen.most_waiting = std::max(seen.most_waiting, line.waiting(now));
    for (std::string text = line.receive(now); !text.empty(); text = line.receive(now)) {
      if (chance(random) < loss) continue;
      EXPECT_EQ(listener.fold(secondsOf(now - kBegin), text), Applied::yes) << text;
      for (const char* arm : {"arm_left", "arm_right"}) {
        const DeviceState* const device = listener.state.findDevice(arm);
        if (device == nullptr || text.find(std::string("joint") + "s " + arm) == text.npos) {
          continue;
        }
        if (device->joints) seen.is_positional = true;
        if (device->named_joints.empty()) continue;
        const std::optional<int> shown = shownTurn(*device);
        if (!shown) ++seen.mixed;
        if (shown.value_or(0) > newest[arm]) ++seen.whole;
        newest[arm] = shown.value_or(newest[arm]);
      }
    }
  }
  for (const char* arm : {"arm_left", "arm_right"}) {
    seen.without_order +=
        listener.counts(arm).faults[static_cast<std::size_t>(PacketFault::unknown_order)];
  }
  return seen;
}

TEST(SlowLink, TwoArmsWithNamedJointsAreTwentyWholePosesASecond) {
  for (const char* form : {"names", "order"}) {
    SCOPED_TRACE(form);
    constexpr int kSeconds = 60;
    const SeenPoses seen = posesThroughTheLine(kSeconds, form, 0);
    EXPECT_GE(seen.whole, 20 * kSeconds);
    EXPECT_EQ(seen.mixed, 0);
    EXPECT_FALSE(seen.is_positional);
    EXPECT_EQ(seen.without_order, 0U);
    // One datagram of the longest, and what makes up for a late wake-up.
    EXPECT_LE(seen.most_waiting, 120ms);
    RecordProperty("whole_a_second", fmt::format("{:.1f}", seen.whole * 1.0 / kSeconds));
  }
}

TEST(SlowLink, ALossShowsNoPoseThatNoArmHad) {
  for (const char* form : {"names", "order"}) {
    SCOPED_TRACE(form);
    const SeenPoses seen = posesThroughTheLine(60, form, 0.2);
    EXPECT_EQ(seen.mixed, 0);
    EXPECT_FALSE(seen.is_positional);
    // Only until the order is restated.
    EXPECT_GE(seen.whole, 60 * 12);
  }
}

}  // namespace
}  // namespace rocinante
