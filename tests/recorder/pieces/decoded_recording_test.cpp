#include <gmock/gmock.h>

#include "core/copy/log_edits.h"
#include "core/log/octets_before.h"
#include "recorder/doctor/log_doctor.h"
#include "tests/recorder/pieces/capture_rig.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::CaptureRig;
using test::logTime;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

namespace fs = std::filesystem;

/// "J 12.5 MODE": a joint in degrees, and an event when MODE changes. "P" has a pose instead.
constexpr std::string_view kDeclared = R"(
[[decoder]]
name = "arm"
kind = "delimited"
separator = " "
begins_with = "J "
[[decoder.field]]
name = "q"
column = 1
[[decoder.field]]
name = "mode"
column = 2
[[decoder.joint]]
device = "arm"
joint = "j"
field = "q"
degrees = true
[[decoder.event]]
text = "mode {mode}"
changes = "mode"

[[decoder]]
name = "cart"
kind = "delimited"
separator = " "
begins_with = "P "
[[decoder.field]]
name = "x"
column = 1
[[decoder.pose]]
device = "cart"
position = ["x", 0, 0]
)";

RecordOptions decoding() {
  RecordOptions options;
  auto set = decode::parseDecoders(kDeclared, "test.decoders.toml");
  EXPECT_TRUE(set) << set.error().text();
  options.decoders = *set;
  return options;
}

/// A message with everything that a log says of it.
std::string wholeText(const LogMessage& message) {
  std::string text = message.channel->topic + " " + message.channel->encoding;
  for (const auto& [key, value] : message.channel->metadata) text += " " + key + "=" + value;
  text += " " + std::to_string(message.sequence) + " " +
          std::to_string(message.log_time.time_since_epoch().count()) + " " +
          std::to_string(message.publish_time_ns) + " " + std::string(textOf(message.payload));
  return text;
}

/// All messages of a log that keeps the rules of the format.
std::vector<std::string> wholeTexts(const fs::path& path) {
  const Result<DoctorReport> report = examineLog(path);
  EXPECT_TRUE(report.ok());
  if (report.ok()) {
    EXPECT_THAT(report->breaches(), IsEmpty()) << doctorText(*report);
  }
  auto log = LogReader::open(path);
  EXPECT_TRUE(log.ok());
  std::vector<std::string> texts;
  OctetsBefore before;
  for (auto message = log->next(); message.ok() && *message; message = log->next()) {
    EXPECT_TRUE(before.take(**message)) << (*message)->sequence;
    texts.push_back(wholeText(**message));
  }
  return texts;
}

/// The packets of a log without their first lines.
std::vector<std::string> packetsOf(const fs::path& path) {
  auto log = LogReader::open(path);
  std::vector<std::string> texts;
  for (auto message = log->next(); message.ok() && *message; message = log->next()) {
    if (!(*message)->channel->decoded()) continue;
    const std::string text(textOf((*message)->payload));
    texts.push_back(text.substr(text.find('\n') + 1));
  }
  return texts;
}

std::vector<std::string> decoderFilesOf(const fs::path& path) {
  auto log = LogReader::open(path);
  std::vector<std::string> names;
  for (const LogAttachment& each : log->attachments()) names.push_back(each.name);
  return names;
}

/// A hundred a second: telegrams of two kinds, others' octets and packet text, from two ports.
void telegrams(CaptureRig& rig, Nanoseconds from, Nanoseconds until) {
  for (Nanoseconds at = from; at < until; at += 10ms) {
    const auto number = static_cast<int>(at / 10ms);
    const std::uint16_t port = number % 4 == 0 ? 5'001 : 5'000;
    switch (number % 5) {
      case 0:
        rig.arrive(at, "P " + std::to_string(number), port);
        break;
      case 1:
        rig.arrive(at, "RK1 lamp@r " + std::to_string(number) + " -\njoints lamp 1\n", port);
        break;
      case 2:
        rig.arrive(at, "nobody's", port);
        break;
      default:
        rig.arrive(at, "J " + std::to_string(number) + (number % 50 < 25 ? " slow" : " fast"),
                   port);
    }
    if (at % 50ms == 40ms) rig.write(at);
  }
  rig.write(until - 1ns);
}

TEST(DecodedRecording, IsByteForByteWhatDecodingTheLogWouldMake) {
  CaptureRig rig(decoding());
  telegrams(rig, 0s, 5s);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 1U);
  EXPECT_EQ(files.pieces[0].packets, 500U);
  const fs::path recorded = rig.folder / "log.mcap";
  // The same traffic without decoders, decoded afterwards.
  CaptureRig plain({});
  telegrams(plain, 0s, 5s);
  plain.close();
  const RecordOptions options = decoding();
  decode::DatagramDecoders decoders(options.decoders);
  MakeOptions make;
  make.output = rig.folder / "decoded.mcap";
  const Result<DecodeReport> decoded = decodeLog(plain.folder / "log.mcap", decoders, make);
  ASSERT_TRUE(decoded.ok()) << decoded.error().text();
  EXPECT_EQ(decoded->copy.counts.decoded, 300U);
  const std::vector<std::string> live = wholeTexts(recorded);
  EXPECT_EQ(live, wholeTexts(make.output));
  EXPECT_EQ(packetsOf(recorded).size(), 300U);
  EXPECT_EQ(decoderFilesOf(recorded), decoderFilesOf(make.output));
  // And decoding anew changes nothing.
  decode::DatagramDecoders anew(options.decoders);
  MakeOptions again;
  again.output = rig.folder / "again.mcap";
  ASSERT_TRUE(decodeLog(recorded, anew, again).ok());
  EXPECT_EQ(live, wholeTexts(again.output));
}

TEST(DecodedRecording, KeepsPairsAndTheDeclarationInEveryPiece) {
  RecordOptions options = decoding();
  options.split.time = 1s;
  options.attach_once = true;
  CaptureRig rig(options);
  telegrams(rig, 0s, 4s);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 4U);
  std::size_t packets = 0;
  for (const PieceFacts& piece : files.pieces) {
    SCOPED_TRACE(piece.file.path);
    wholeTexts(piece.file.path);
    EXPECT_THAT(decoderFilesOf(piece.file.path),
                ElementsAre("decoders/" + options.decoders->hash + ".toml"));
    packets += packetsOf(piece.file.path).size();
  }
  EXPECT_EQ(packets, 240U);
  // A piece opens with what was decoded before it.
  auto timeline = Timeline::open(files.pieces[1].file.path).value();
  const SessionState* const state = timeline.stateAt(logTime(1s)).value();
  EXPECT_TRUE(state->devices().contains("arm"));
}

TEST(DecodedRecording, BeginsAndEndsByWhatWasDecoded) {
  CaptureLimits limits;
  limits.start_on = {Condition::parse("event=mode fast").value()};
  limits.stop_on = {Condition::parse("device=cart").value()};
  CaptureRig rig(decoding(), limits);
  rig.arrive(10ms, "J 1 slow");
  rig.arrive(20ms, "J 2 fast");
  rig.arrive(30ms, "J 3 fast");
  rig.arrive(40ms, "P 1");
  rig.arrive(50ms, "J 4 fast");
  rig.write(1s);
  rig.close();
  EXPECT_EQ(rig.writer->endReason(), "condition");
  EXPECT_EQ(rig.writer->packetsBefore(), 1U);
  EXPECT_EQ(rig.writer->channelCount(), 1U);
  EXPECT_THAT(packetsOf(rig.folder / "log.mcap"),
              ElementsAre("joint arm j=0.03490658503988659\nevent \"mode fast\"",
                          "joint arm j=0.05235987755982989", "pose cart 1 0 0 0 0 0 1"));
  auto timeline = Timeline::open(rig.folder / "log.mcap").value();
  const SessionState* const state = timeline.stateAt(logTime(20ms)).value();
  EXPECT_EQ(state->counts().at("decoded:arm").packets, 1U);
  EXPECT_TRUE(state->devices().contains("arm"));
  wholeTexts(rig.folder / "log.mcap");
}

TEST(DecodedRecording, ARingIsSavedWhenADecoderSaysAnEvent) {
  RecordOptions options = decoding();
  options.ring = RingRule{1s, 500ms};
  options.ring_on = {Condition::parse("event=mode *").value()};
  CaptureRig rig(options);
  rig.arrive(0ms, "P 7");
  for (Nanoseconds at = 10ms; at < 3s; at += 10ms) {
    rig.arrive(at, at < 2s ? "J 1 slow" : "J 2 fast");
    if (at % 50ms == 40ms) rig.write(at);
  }
  rig.write(3s);
  const RecordedFiles files = rig.close();
  ASSERT_EQ(files.pieces.size(), 1U);
  EXPECT_EQ(files.pieces[0].why, "event=mode *");
  const fs::path file = files.pieces[0].file.path;
  const std::vector<std::string> packets = packetsOf(file);
  EXPECT_EQ(packets.size(), files.pieces[0].packets);
  EXPECT_EQ(
      std::ranges::count_if(
          packets, [](const std::string& text) { return text.find("event") != std::string::npos; }),
      1);
  wholeTexts(file);
  EXPECT_THAT(decoderFilesOf(file), ElementsAre("decoders/" + options.decoders->hash + ".toml"));
  // What left the ring was folded with its packets.
  auto timeline = Timeline::open(file).value();
  const SessionState* const state = timeline.stateAt(*files.pieces[0].start).value();
  ASSERT_TRUE(state->devices().contains("cart"));
  EXPECT_EQ(state->devices().at("cart").pose->value.pose.position.x, 7);
}

}  // namespace
}  // namespace rocinante
