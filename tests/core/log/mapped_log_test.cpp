#include <gmock/gmock.h>

#include <fstream>

#include "core/mcap/record_stepper.h"
#include "tests/core/log/log_support.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr int kMappedMessages = 3000;

/// About 400 KB in chunks of 8 KB, so that most of it is on pages of its own.
std::filesystem::path writeLog(const TemporaryFolder& folder,
                               LogWriterOptions::Compression compression) {
  const std::filesystem::path path = folder.path() / "session.mcap";
  LogWriterOptions options;
  options.compression = compression;
  options.chunk_bytes = 8192;
  Result<LogWriter> writer = LogWriter::create(path, options, "session-1");
  EXPECT_TRUE(writer.ok());
  const ChannelId channel = *writer->addChannel("/udp/1/a", "octets", {});
  for (int i = 0; i < kMappedMessages; ++i) {
    std::string payload = std::to_string(i) + " ";
    for (unsigned j = 0; j < 100; ++j) {
      payload.push_back(static_cast<char>('a' + (static_cast<unsigned>(i) * 7919U + j * j) % 26U));
    }
    EXPECT_TRUE(writer->write(channel, 0, at(1000 + i), 1, bytesOf(payload)).ok());
  }
  EXPECT_TRUE(writer->writeAttachment("note", "text/plain", at(1), bytesOf("abc")).ok());
  EXPECT_TRUE(writer->close("finished").ok());
  return path;
}

class MappedLog : public ::testing::TestWithParam<LogWriterOptions::Compression> {};

TEST_P(MappedLog, ThatIsMadeShorterWhileItIsReadEndsInDamage) {
  const TemporaryFolder folder;
  const std::filesystem::path path = writeLog(folder, GetParam());
  Result<LogReader> reader = LogReader::open(path);
  ASSERT_TRUE(reader.ok());
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(reader->next()->has_value());
  std::filesystem::resize_file(path, 20'000);
  const std::vector<KeptMessage> read = readAll(*reader);
  EXPECT_THAT(read, Not(IsEmpty()));
  EXPECT_LT(read.size(), 1000U);
  ASSERT_THAT(reader->damage(), Not(IsEmpty()));
  EXPECT_THAT(reader->damage()[0].cause, HasSubstr("truncated while it was read"));
  EXPECT_TRUE(reader->lastOf(0, at(5000)).ok());
  EXPECT_EQ(reader->readAttachment(0).error().kind, ErrorKind::unreadable);
}

TEST_P(MappedLog, ThatIsOverwrittenDoesNotChangeWhatWasGivenOut) {
  const TemporaryFolder folder;
  const std::filesystem::path path = writeLog(folder, GetParam());
  Result<LogReader> reader = LogReader::open(path);
  ASSERT_TRUE(reader.ok());
  const std::optional<LogMessage> first = *reader->next();
  const KeptMessage before = keep(*first);
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    const std::string garbage(static_cast<std::size_t>(std::filesystem::file_size(path)), '?');
    file.write(garbage.data(), static_cast<std::streamsize>(garbage.size()));
  }
  EXPECT_EQ(keep(*first), before);
  // Later reads fail their checksum, and return nothing.
  for (const KeptMessage& each : readAll(*reader)) EXPECT_THAT(each.payload, Not(HasSubstr("?")));
  EXPECT_THAT(reader->damage(), Not(IsEmpty()));
}

INSTANTIATE_TEST_SUITE_P(Compression, MappedLog,
                         ::testing::Values(LogWriterOptions::Compression::none,
                                           LogWriterOptions::Compression::zstd),
                         [](const auto& each) {
                           return each.param == LogWriterOptions::Compression::none ? "none"
                                                                                    : "zstd";
                         });

}  // namespace
}  // namespace rocinante::test
