#include "tests/core/check/sound_session.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/check/check.h"
#include "core/check/session_check.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

constexpr double kStart_s = 1'770'000'000;
constexpr double kPeriod_s = 0.04;
constexpr double kLength_s = 14;

constexpr std::string_view kUrdf = R"(<robot name="arm">
  <link name="base"/>
  <link name="upper"><visual><geometry><mesh filename="upper.obj"/></geometry></visual></link>
  <link name="fore"/> <link name="hand"/> <link name="left_finger"/> <link name="right_finger"/>
  <joint name="shoulder" type="revolute"> <parent link="base"/> <child link="upper"/>
    <axis xyz="0 0 1"/> <limit lower="-2" upper="2" effort="1" velocity="2"/> </joint>
  <joint name="elbow" type="revolute"> <parent link="upper"/> <child link="fore"/>
    <axis xyz="0 1 0"/> <limit lower="-1.5" upper="1.5" effort="1" velocity="2"/> </joint>
  <joint name="wrist" type="continuous"> <parent link="fore"/> <child link="hand"/>
    <axis xyz="1 0 0"/> <limit effort="1" velocity="4"/> </joint>
  <joint name="grip" type="prismatic"> <parent link="hand"/> <child link="left_finger"/>
    <axis xyz="0 1 0"/> <limit lower="0" upper="0.05" effort="1" velocity="0.2"/> </joint>
  <joint name="other_grip" type="prismatic"> <parent link="hand"/> <child link="right_finger"/>
    <axis xyz="0 -1 0"/> <limit lower="0" upper="0.05" effort="1" velocity="0.2"/>
    <mimic joint="grip"/> </joint>
</robot>
)";

constexpr std::string_view kPart = R"(<robot name="part"> <link name="body"/> </robot>)";

constexpr std::string_view kFloater = R"(<robot name="drone">
  <link name="world"/> <link name="hull"/>
  <joint name="fly" type="floating"> <parent link="world"/> <child link="hull"/> </joint>
</robot>)";

constexpr std::string_view kObj =
    "o upper\nv 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.4\nf 1 2 3\nf 1 2 4\n";

constexpr std::string_view kCell = R"(format = 1
[[layer]]
name = "robots"
[[device]]
name = "left"
model = "arm.urdf"
layer = "robots"
[[device]]
name = "right"
model = "arm.urdf"
pose = { xyz = [2, 0, 0] }
layer = "robots"
[[device]]
name = "drone"
model = "drone.urdf"
[[device]]
name = "part"
model = "part.urdf"
optional = true
[[camera]]
name = "overview"
eye = [4, -4, 3]
target = [0, 0, 0.5]
[[source]]
name = "left_control"
rate_hz = [20, 30]
devices = ["left"]
[[source]]
name = "right_control"
rate_hz = [20, 30]
devices = ["right"]
[[source]]
name = "planner"
devices = ["part", "drone"]
)";

std::string timeText(double seconds) { return fmt::format("{:.6f}", kStart_s + seconds); }

/// A smooth motion of four joints, well within limits and velocities.
std::string jointsAt(std::string_view device, double t) {
  return fmt::format("joints {} {:.6f} {:.6f} {:.6f} {:.6f}", device, std::sin(0.7 * t),
                     std::cos(0.9 * t), std::remainder(1.2 * t, 2 * 3.14159265358979),
                     0.025 + 0.02 * std::sin(t));
}

std::string floatAt(double t) {
  return fmt::format("joints drone {:.6f} 0 2 0 0 {:.9f} {:.9f}", 0.5 * t, std::sin(t / 2),
                     std::cos(t / 2));
}

}  // namespace

SoundSession::SoundSession() : urdf(kUrdf), obj(kObj), cell(kCell) {
  for (const std::string source : {"left_control", "right_control", "planner"}) {
    const std::string device = source.substr(0, source.find('_'));
    const bool is_planner = source == "planner";
    const std::string statics =
        is_planner ? "add part part.urdf\ncolor part #ff8800\n"
                     "line path #00ff00 in left/hand 0 0 0 0 0 1"
                   : "show " + device + "\norder " + device + " shoulder elbow wrist grip";
    std::uint64_t sequence = 0;
    double restated_s = 0;
    for (double t = 0; t < kLength_s; t += is_planner ? 4 * kPeriod_s : kPeriod_s) {
      SaidPacket packet;
      packet.source = source;
      packet.sequence = std::to_string(sequence++);
      packet.time = timeText(t);
      // Networks always delay a little.
      packet.arrives_s = t + 0.002 + 0.001 * static_cast<double>(sequence % 3);
      packet.statements.push_back(is_planner ? floatAt(t) : jointsAt(device, t));
      if (t == 0) packet.statements.insert(packet.statements.begin(), statics);
      packets.push_back(packet);
      if (t - restated_s < 2) continue;
      restated_s = t;
      packet.sequence = std::to_string(sequence++);
      packet.words = fmt::format(" restated part={}:1/1", sequence);
      packet.arrives_s += 0.0005;
      packet.statements.insert(packet.statements.begin(), statics);
      packets.push_back(packet);
    }
  }
  sort();
}

void SoundSession::sort() {
  std::stable_sort(packets.begin(), packets.end(), [](const SaidPacket& a, const SaidPacket& b) {
    return a.arrives_s < b.arrives_s;
  });
}

void SoundSession::replace(std::string& text, std::string_view what, std::string_view by) {
  std::size_t at = text.find(what);
  if (at == std::string::npos) ADD_FAILURE() << "there is no " << what;
  for (; at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

void SoundSession::replaceSaid(std::string_view source, std::string_view what, std::string_view by,
                               double from_s, double until_s) {
  bool found = false;
  for (SaidPacket& packet : packets) {
    if (packet.source != source || packet.arrives_s < from_s || packet.arrives_s >= until_s) {
      continue;
    }
    for (std::string& statement : packet.statements) {
      if (statement.find(what) == std::string::npos) continue;
      found = true;
      replace(statement, what, by);
    }
  }
  if (!found) ADD_FAILURE() << source << " never says " << what;
}

std::vector<SaidPacket*> SoundSession::of(std::string_view source, double from_s, double until_s,
                                          bool restated) {
  std::vector<SaidPacket*> found;
  for (SaidPacket& packet : packets) {
    if (packet.source == source && packet.arrives_s >= from_s && packet.arrives_s < until_s &&
        packet.words.empty() != restated) {
      found.push_back(&packet);
    }
  }
  return found;
}

void SoundSession::say(std::string_view source, double at_s, std::string statement) {
  of(source, at_s).at(0)->statements.push_back(std::move(statement));
}

void SoundSession::erase(std::string_view source, double from_s, double until_s) {
  std::erase_if(packets, [&](const SaidPacket& packet) {
    return packet.source == source && packet.arrives_s >= from_s && packet.arrives_s < until_s;
  });
}

void SoundSession::insert(SaidPacket packet) {
  packets.push_back(std::move(packet));
  sort();
}

CheckReport SoundSession::judge() const {
  const TemporaryFolder folder;
  std::ofstream(folder / "arm.urdf") << urdf;
  std::ofstream(folder / "part.urdf") << kPart;
  std::ofstream(folder / "drone.urdf") << kFloater;
  std::ofstream(folder / "upper.obj") << obj;
  std::ofstream(folder / "cell.toml") << cell;
  const Result<Cell> read = loadCell(folder / "cell.toml", {});
  if (!read) {
    ADD_FAILURE() << read.error().text();
    return {};
  }
  SessionCheck session(*read);
  for (const SaidPacket& packet : packets) {
    std::string text = fmt::format("RK1 {}@{} {} {}{}\n", packet.source, packet.run,
                                   packet.sequence, packet.time, packet.words);
    for (const std::string& statement : packet.statements) text += statement + "\n";
    const auto arrives = static_cast<std::int64_t>(packet.arrives_s * 1e9);
    session.add(LogTime(Nanoseconds(static_cast<std::int64_t>(kStart_s) * 1'000'000'000 + arrives)),
                packet.encoding, true, bytesOf(text));
  }
  return checkSession(*read, session);
}

}  // namespace rocinante::test
