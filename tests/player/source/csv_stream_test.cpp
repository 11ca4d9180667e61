#include "player/source/csv_stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

CsvStream::Options someOptions() {
  CsvStream::Options options;
  options.source = "arm";
  options.run = "r";
  return options;
}

CsvMotion motionOf(std::string_view text, const std::string& device = "arm") {
  return readCsvMotion(text, "m", device, {}).value();
}

struct Sent {
  LogTime time;
  bool restated;
  std::string text;
};

std::vector<Sent> takeAll(DatagramStream& stream) {
  std::vector<Sent> all;
  while (const auto due = stream.due().value()) {
    all.push_back({due->time, due->restated, std::string(textOf(stream.take()))});
  }
  return all;
}

TEST(CsvStream, SaysOrderOnceAndThenEachRowAtItsTime) {
  const auto motion = motionOf("t,a b,c\n0.5,1.50,2\n0.7,+3,4e0\n", "my arm");
  auto stream = CsvStream::open(motion, someOptions()).value();
  const auto all = takeAll(stream);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].text, "RK1 arm@r 0 0.5\norder my%20arm a%20b c\n");
  EXPECT_EQ(all[1].text, "RK1 arm@r 1 0.5\njoints my%20arm 1.5 2\n");
  EXPECT_EQ(all[2].text, "RK1 arm@r 2 0.7\njoints my%20arm 3 4\n");
  EXPECT_EQ(all[0].time, LogTime(500ms));
  EXPECT_EQ(all[2].time, LogTime(700ms));
}

TEST(CsvStream, SaysNothingOfADeviceWhoseFieldsAreEmpty) {
  const auto motion = motionOf("t,a.j,b.j\n0,1,\n1,,2\n", "");
  auto stream = CsvStream::open(motion, someOptions()).value();
  const auto all = takeAll(stream);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[1].text, "RK1 arm@r 1 0\njoints a 1\n");
  EXPECT_EQ(all[2].text, "RK1 arm@r 2 1\njoints b 2\n");
}

std::vector<std::string> linesOf(const std::vector<Sent>& all) {
  std::vector<std::string> lines;
  for (const Sent& sent : all) lines.push_back(sent.text.substr(sent.text.find('\n') + 1));
  return lines;
}

TEST(CsvStream, SaysASignalWhereItChanges) {
  const auto motion = motionOf(
      "t,signal arm load,signal - on,signal arm mode\n"
      "0,0.1,true,auto\n1,0.1,true,auto\n2,0.30000000000000004,false,\n3,,,\"a b\"\n",
      "");
  auto stream = CsvStream::open(motion, someOptions()).value();
  const auto all = takeAll(stream);
  EXPECT_THAT(linesOf(all), testing::ElementsAre(
                                "signal arm load 0.1\nsignal - on true\nsignal arm mode \"auto\"\n",
                                "signals arm load=0.30000000000000004\nsignal - on false\n",
                                "signal arm mode \"a b\"\n"));
  EXPECT_EQ(all[1].time, LogTime(2s));
}

TEST(CsvStream, ATurnSaysWhatTheLastOneEndedWithout) {
  auto options = someOptions();
  options.turns = 3;
  const auto motion = motionOf("t,signal - a,signal - b\n0,1,5\n1,2,\n2,1,\n", "");
  auto stream = CsvStream::open(motion, options).value();
  const std::vector<std::string> lines = linesOf(takeAll(stream));
  EXPECT_THAT(lines, testing::ElementsAre("signal - a 1\nsignal - b 5\n", "signals - a=2\n",
                                          "signals - a=1\n", "signals - a=2\n", "signals - a=1\n",
                                          "signals - a=2\n", "signals - a=1\n"));
}

TEST(CsvStream, SignalsThatStandStillAreOnlyRestated) {
  auto options = someOptions();
  options.turns = 3;
  const auto motion = motionOf("t,signal - a\n0,1\n1,1\n", "");
  auto once = CsvStream::open(motion, options).value();
  EXPECT_THAT(takeAll(once), testing::SizeIs(1));
  options.restate = 2s;
  auto stream = CsvStream::open(motion, options).value();
  const auto all = takeAll(stream);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_TRUE(all[2].restated);
  EXPECT_EQ(all[2].time, LogTime(4s));
}

TEST(CsvStream, ARowWithoutAnythingIsNoPacket) {
  const auto motion = motionOf("t,a,b\n0,,\n1,1,\n2,1,2\n3,,\n");
  auto options = someOptions();
  options.turns = 2;
  auto stream = CsvStream::open(motion, options).value();
  EXPECT_THAT(linesOf(takeAll(stream)),
              testing::ElementsAre("order arm a b\n", "joints arm 1 2\n", "joints arm 1 2\n"));
}

TEST(CsvStream, EveryRowIsAPacketWithoutFaults) {
  const auto motion = motionOf("t,a,b\n0,.5,5.\n1,-0,1e-3\n");
  auto stream = CsvStream::open(motion, someOptions()).value();
  PacketTextDecoder decoder;
  for (const Sent& sent : takeAll(stream)) {
    const Packet* packet = decoder.decode(bytesOf(sent.text));
    ASSERT_NE(packet, nullptr);
    EXPECT_TRUE(packet->faults.empty()) << sent.text;
  }
}

TEST(CsvStream, RestatesAllThatWasSaidUnderItsOwnNumbers) {
  const auto motion = motionOf("t,a\n0,1\n1,2\n2,3\n2.5,4\n4,5\n");
  auto options = someOptions();
  options.restate = 2s;
  auto stream = CsvStream::open(motion, options).value();
  const auto all = takeAll(stream);
  ASSERT_EQ(all.size(), 8U);
  // When both are due, the restatement precedes the next row.
  EXPECT_TRUE(all[3].restated);
  EXPECT_EQ(all[3].time, LogTime(2s));
  EXPECT_EQ(all[3].text, "RK1 arm@r 3 2 restated part=r1:1/1\norder arm a\njoints arm 2\n");
  EXPECT_EQ(all[6].text, "RK1 arm@r 6 4 restated part=r2:1/1\norder arm a\njoints arm 4\n");
  EXPECT_EQ(all[7].text, "RK1 arm@r 7 4\njoints arm 5\n");
}

TEST(CsvStream, ARestatementChangesNothingForWhoHeardAll) {
  std::string csv = "t";
  for (int joint = 0; joint < 100; ++joint) {
    csv += ",joint_with_a_long_name_";
    csv += std::to_string(joint);
  }
  for (int row = 0; row < 50; ++row) {
    csv += '\n';
    csv += std::to_string(row);
    for (int joint = 0; joint < 100; ++joint) {
      csv += ',';
      csv += std::to_string(row * joint);
    }
  }
  const auto motion = motionOf(csv);
  auto options = someOptions();
  options.restate = 10s;
  options.mtu_bytes = 3'000;
  auto stream = CsvStream::open(motion, options).value();
  SessionState all_heard;
  SessionState no_restatement;
  SessionState late_joiner;
  PacketTextDecoder decoder;
  int restated = 0;
  std::uint64_t sequence = 0;
  for (const Sent& sent : takeAll(stream)) {
    EXPECT_LE(sent.text.size(), options.mtu_bytes);
    const Packet* packet = decoder.decode(bytesOf(sent.text));
    ASSERT_NE(packet, nullptr);
    EXPECT_EQ(packet->header.sequence, sequence++);
    EXPECT_EQ(all_heard.apply(sent.time, *packet), Applied::yes);
    if (!sent.restated) no_restatement.apply(sent.time, *packet);
    restated += sent.restated;
    if (restated > 0) late_joiner.apply(sent.time, *packet);
  }
  EXPECT_GT(restated, 4);
  EXPECT_EQ(all_heard.devices(), no_restatement.devices());
  EXPECT_EQ(all_heard.devices(), late_joiner.devices());
}

TEST(CsvStream, TurnsJoinAtTheMeanStepAndTimeGoesOn) {
  const auto motion = motionOf("t,a\n10,1\n11,2\n12,3\n");
  auto options = someOptions();
  options.turns = 2;
  auto stream = CsvStream::open(motion, options).value();
  EXPECT_EQ(stream.period(), 3s);
  const auto all = takeAll(stream);
  ASSERT_EQ(all.size(), 7U);
  EXPECT_EQ(all[4].time, LogTime(13s));
  EXPECT_EQ(all[4].text, "RK1 arm@r 4 13\njoints arm 1\n");
}

TEST(CsvStream, StampsTheClockWhenSendingAndNotBefore) {
  const auto motion = motionOf("t,a\n0,1\n1,2\n");
  auto options = someOptions();
  WallTime now(1'700'000'000s);
  options.wall_now = [&now] { return now; };
  auto stream = CsvStream::open(motion, options).value();
  ASSERT_TRUE(stream.due()->has_value());
  now += 250ms;
  EXPECT_EQ(textOf(stream.take()), "RK1 arm@r 0 1700000000.25\norder arm a\n");
}

TEST(CsvStream, ATimeBeforeTheEpochIsNotSaid) {
  const auto motion = motionOf("t,a\n-1,1\n1,2\n");
  auto stream = CsvStream::open(motion, someOptions()).value();
  const auto all = takeAll(stream);
  EXPECT_EQ(all[1].text, "RK1 arm@r 1 -\njoints arm 1\n");
  EXPECT_EQ(all[2].text, "RK1 arm@r 2 1\njoints arm 2\n");
}

TEST(CsvStream, RefusesWhatASourceWouldBeforeAnythingIsSent) {
  const auto motion = motionOf("t,a_joint,another_joint,a_third_joint\n0,1,2,3\n");
  auto options = someOptions();
  options.mtu_bytes = 120;
  const auto stream = CsvStream::open(motion, options);
  ASSERT_FALSE(stream.ok());
  EXPECT_NE(stream.error().what.find("--mtu is 120"), std::string::npos);
  options.mtu_bytes = 400;
  EXPECT_TRUE(CsvStream::open(motion, options).ok());
  EXPECT_FALSE(CsvStream::open(motionOf("t,a\n0,1\n", std::string(256, 'x')), options).ok());
  const auto poses =
      motionOf("t,a:x,a:y,a:z,a:qx,a:qy,a:qz,a:qw\n0,1,2,3,0,0,0,1\n1,1,2,3,0,0,0,0\n", "");
  EXPECT_EQ(CsvStream::open(poses, options).error().text(),
            "the length of a quaternion differs from 1 by more than 0.001 (a, row 2)");
}

TEST(CsvStream, SeveralDevicesShareAPacketAndRestate) {
  const auto motion = motionOf(
      "t,arm.j1,tray:x,tray:y,tray:z,tray:qx,tray:qy,tray:qz,tray:qw,gantry.x\n"
      "0,1,0,0,1,0,0,0,1,5\n0.5,1,0,0,1,0,0,0,1,6\n1,2,0,0,1,0,0,0,1,6\n",
      "");
  auto options = someOptions();
  options.restate = 700ms;
  auto stream = CsvStream::open(motion, options).value();
  const auto all = takeAll(stream);
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(all[0].text, "RK1 arm@r 0 0\norder arm j1\norder gantry x\n");
  // Rows are said whole, as every row of a table is.
  EXPECT_EQ(all[2].text,
            "RK1 arm@r 2 0.5\njoints arm 1\npose tray 0 0 1 0 0 0 1\njoints gantry 6\n");
  EXPECT_EQ(all[3].text,
            "RK1 arm@r 3 0.7 restated part=r1:1/1\norder arm j1\njoints arm 1\n"
            "pose tray 0 0 1 0 0 0 1\norder gantry x\njoints gantry 6\n");
  EXPECT_TRUE(all[3].restated);
}

TEST(CsvStream, RestatementsAreSpreadInRealTime) {
  std::string csv = "t";
  for (int device = 0; device < 100; ++device)
    csv += ",device_" + std::to_string(device) + ".joint";
  for (int row = 0; row < 300; ++row) {
    csv += "\n" + std::to_string(row);
    for (int device = 0; device < 100; ++device) csv += "," + std::to_string(row + device);
  }
  const auto motion = motionOf(csv, "");
  for (const char* speed : {"0.1", "1/3", "1", "100"}) {
    SCOPED_TRACE(speed);
    auto options = someOptions();
    options.restate = 2s;
    options.speed = PlaybackSpeed::parse(speed).value();
    auto stream = CsvStream::open(motion, options).value();
    LogTime before = LogTime::min();
    SessionState late;
    PacketTextDecoder decoder;
    std::size_t restated = 0;
    for (const Sent& sent : takeAll(stream)) {
      EXPECT_GE(sent.time, before);
      before = sent.time;
      restated += sent.restated;
      // What a receiver counts is real time.
      const LogTime heard(options.speed.realDuration(sent.time.time_since_epoch()));
      if (restated > 0) late.apply(heard, *decoder.decode(bytesOf(sent.text)));
    }
    EXPECT_GT(restated, 3U);
    EXPECT_EQ(late.devices().size(), 100U);
    for (const auto& [name, device] : late.devices()) EXPECT_FALSE(device.joints) << name;
  }
}

TEST(CutStream, EndsBeforeItsMoment) {
  const auto motion = motionOf("t,a\n0,1\n1,2\n2,3\n");
  auto stream = CsvStream::open(motion, someOptions()).value();
  CutStream cut(stream, LogTime(2s));
  EXPECT_EQ(takeAll(cut).size(), 3U);
}

}  // namespace
}  // namespace rocinante
