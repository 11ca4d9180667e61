#include "recorder/doctor/log_doctor.h"

#include <gmock/gmock.h>

#include <random>

#include "core/log/log_writer.h"
#include "core/packet/decoder.h"
#include "core/recording/session_writer.h"
#include "core/session/keyframe.h"
#include "tests/recorder/doctor/doctor_cases.h"

namespace rocinante::test {
namespace {

using mcap::Opcode;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> rulesOf(const DoctorReport& report) {
  std::vector<std::string> rules;
  for (const auto& [rule, count] : report.counts()) rules.push_back(rule);
  return rules;
}

TEST(LogDoctor, FindsNothingInALogThatKeepsEveryRule) {
  const Bytes file = HandMade::sound().bytes();
  const DoctorReport report = examine(file);
  EXPECT_THAT(report.breaches(), IsEmpty());
  EXPECT_EQ(report.messages, 5U);
  EXPECT_EQ(report.chunks, 2U);
  HandMade other = HandMade::sound();
  foreign(other);
  EXPECT_THAT(examine(other.bytes()).breaches(), IsEmpty());
}

TEST(LogDoctor, NamesExactlyTheRuleThatIsBroken) {
  for (std::size_t i = 0; i < doctorCases().size(); ++i) {
    const DoctorCase& each = doctorCases()[i];
    SCOPED_TRACE(each.rule + ", case " + std::to_string(i));
    HandMade log = HandMade::sound();
    if (each.change) each.change(log);
    Bytes file = log.bytes();
    if (each.change_bytes) each.change_bytes(file);
    const DoctorReport report = examine(file);
    EXPECT_THAT(rulesOf(report), ElementsAre(each.rule))
        << testing::PrintToString(report.breaches());
    for (const Finding& breach : report.breaches()) EXPECT_LE(*breach.byte, file.size());
  }
}

TEST(LogDoctor, ImportedMessagesMayBeLate) {
  HandMade log = HandMade::sound();
  log.chunks[1].messages[0].time = 1001;
  EXPECT_THAT(rulesOf(examine(log.bytes())), ElementsAre("time-order"));
  for (HandMade::Chunk& chunk : log.chunks) {
    for (mcap::Channel& channel : chunk.channels) channel.metadata["imported"] = "csv";
  }
  for (mcap::Channel& channel : log.summary_channels) channel.metadata["imported"] = "csv";
  EXPECT_THAT(examine(log.bytes()).breaches(), IsEmpty());
}

TEST(LogDoctor, TakesAKeyframeThatIsTheFoldOfWhatStandsBeforeIt) {
  HandMade log = HandMade::sound();
  SessionState state;
  const std::unique_ptr<Decoder> decoder = makeDecoder("rk1");
  for (const HandMade::Chunk& chunk : log.chunks) {
    for (const HandMade::Message& message : chunk.messages) {
      if (const Packet* packet = decoder->decode(bytesOf(message.payload))) {
        state.apply(LogTime(Nanoseconds(static_cast<std::int64_t>(message.time))), *packet);
      }
    }
  }
  addOwnMessage(log, "/rocinante/keyframe", "rk1-keyframe", 1005, keyframeText(state));
  EXPECT_THAT(examine(log.bytes()).breaches(), IsEmpty());
}

TEST(LogDoctor, TellsTheOffsetOfTheBrokenChunk) {
  HandMade log = HandMade::sound();
  log.chunks[1].change = [](mcap::Chunk& chunk) { chunk.uncompressed_crc ^= 1; };
  const Bytes file = log.bytes();
  const DoctorReport report = examine(file);
  ASSERT_EQ(report.breaches().size(), 1U);
  const auto chunk = mcap::recordAt(file, *report.breaches()[0].byte);
  ASSERT_TRUE(chunk.has_value());
  EXPECT_EQ(chunk->opcode, Opcode::chunk);
  EXPECT_THAT(report.breaches()[0].text, HasSubstr("fails its checksum"));
}

TEST(LogDoctor, ListsTwentyOfARuleAndCountsAll) {
  HandMade log = HandMade::sound();
  for (int i = 0; i < 100; ++i) log.chunks[1].messages.push_back({1, 1005, "no packet"});
  const DoctorReport report = examine(log.bytes());
  EXPECT_EQ(report.breaches().size(), DoctorReport::kMaxListed);
  EXPECT_EQ(report.counts().at("encoding"), 100U);
  EXPECT_THAT(doctorText(report), HasSubstr("and 80 more"));
}

TEST(LogDoctor, JudgesNothingThatIsNoLog) {
  for (const std::string text : {"", "\x89MCAP", "not a log at all"}) {
    const Result<DoctorReport> report = examineBytes(bytesOf(text), "x");
    ASSERT_FALSE(report.ok());
    EXPECT_EQ(report.error().kind, ErrorKind::damaged);
  }
}

TEST(LogDoctor, NoticesEveryFlippedBitAndEveryCut) {
  const Bytes whole = HandMade::sound().bytes();
  for (std::size_t bit = 64; bit < whole.size() * 8; ++bit) {
    Bytes file = whole;
    file[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
    EXPECT_FALSE(examine(file).clean()) << "bit " << bit;
  }
  for (std::size_t size = 8; size < whole.size(); ++size) {
    Bytes file(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    file.shrink_to_fit();
    EXPECT_TRUE(examine(file).broke("not-closed")) << size;
  }
}

TEST(LogDoctor, BearsAnyBytes) {
  const Bytes whole = HandMade::sound().bytes();
  std::mt19937 random(5);
  for (int round = 0; round < 3000; ++round) {
    Bytes file = whole;
    for (int i = 0; i < 8; ++i) {
      file[8 + random() % (file.size() - 8)] =
          static_cast<std::byte>(random() % 4 == 0 ? 0xFF : random());
    }
    EXPECT_FALSE(examine(file).clean());
  }
}

/// Output of our own writers, with keyframes, including opening ones, in many chunks.
TEST(LogDoctor, FindsNothingInTheLogsThatWeWrite) {
  for (const auto compression :
       {LogWriterOptions::Compression::none, LogWriterOptions::Compression::zstd}) {
    for (const bool opens_with_keyframe : {false, true}) {
      Bytes file;
      LogWriterOptions options;
      options.compression = compression;
      options.chunk_bytes = 3000;
      Result<LogWriter> log = LogWriter::createOn(makeMemorySink(file), options, "s");
      ASSERT_TRUE(log.ok());
      KeyframeOptions keyframes;
      keyframes.packets = 40;
      SessionWriter writer(std::move(*log), keyframes);
      if (opens_with_keyframe) {
        SessionState before;
        const std::unique_ptr<Decoder> decoder = makeDecoder("rk1");
        before.apply(LogTime(Nanoseconds(5)),
                     *decoder->decode(bytesOf("RK1 old@1 7 -\njoints tray 1 2")));
        ASSERT_TRUE(writer.beginWith(before, LogTime(Nanoseconds(500))).ok());
      }
      const ChannelId arm = *writer.addChannel("/udp/1/arm", "rk1", {{"source", "arm"}});
      const ChannelId raw = *writer.addChannel("/udp/1/raw", "octets", {});
      for (int i = 0; i < 700; ++i) {
        const LogTime time{Nanoseconds(1000 + i / 3)};
        const std::string text =
            "RK1 arm@7 " + std::to_string(i) + " -\njoints arm " + std::to_string(i * 7 % 13) +
            "\nevent \"padding so that keyframes have their share of the bytes\"";
        const auto n = static_cast<std::uint32_t>(i);
        ASSERT_TRUE(writer.write(arm, n, time, 0, bytesOf(text)).ok());
        if (i % 10 == 0) {
          ASSERT_TRUE(writer.write(raw, n, time, 0, bytesOf("\x01\x02")).ok());
        }
      }
      ASSERT_TRUE(writer.writeMark(LogTime(Nanoseconds(1300)), "picked").ok());
      ASSERT_TRUE(
          writer.log()
              .writeLoss({"udp://1", LogTime(Nanoseconds(1100)), LogTime(Nanoseconds(1200)), {}})
              .ok());
      ASSERT_TRUE(
          writer.log().writeAttachment("cell.toml", "application/toml", {}, bytesOf("x")).ok());
      EXPECT_GT(writer.keyframes(), 3U);
      ASSERT_TRUE(writer.log().close("finished").ok());
      const DoctorReport report = examine(file);
      EXPECT_THAT(report.breaches(), IsEmpty());
    }
  }
}

}  // namespace
}  // namespace rocinante::test
