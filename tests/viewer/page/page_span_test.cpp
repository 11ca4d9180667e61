#include <gmock/gmock.h>

#include <fstream>

#include "core/base/atomic_file.h"
#include "core/bundle/cell_bundle.h"
#include "core/log/content_hash.h"
#include "core/log/log_reader.h"
#include "core/recording/session_writer.h"
#include "tests/support/temporary_folder.h"
#include "viewer/page/page_job.h"

namespace rocinante::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* kPagedArm = R"(<robot name="arm"><link name="base"/><link name="tool"/>
  <joint name="j" type="continuous"><parent link="base"/><child link="tool"/></joint></robot>)";

class PageSpanTest : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "arm.urdf") << kPagedArm;
    const Result<CellBundle> bundle = collectCell(folder_ / "arm.urdf", {});
    ASSERT_TRUE(bundle.ok());
    LogWriterOptions options;
    options.compression = LogWriterOptions::Compression::none;
    auto log = LogWriter::create(folder_ / "s.mcap", options, "session-1");
    ASSERT_TRUE(log.ok());
    ASSERT_TRUE(AttachedBundle(*bundle).writeTo(*log, at(1)).ok());
    ASSERT_TRUE(log->writeAttachment("notes.txt", "text/plain", at(1), bytesOf("a note")).ok());
    SessionWriter session(std::move(*log), {});
    const auto channel = session.addChannel("/udp/1/a", "rk1", {});
    for (std::uint32_t i = 0; i < 100; ++i) {
      const std::string text = "RK1 a " + std::to_string(i) + " -\njoint arm j=0.5\n";
      ASSERT_TRUE(session.write(*channel, i, at(i + 1), 0, bytesOf(text)).ok());
    }
    ASSERT_TRUE(session.log().close("done").ok());
    job_.log = folder_ / "s.mcap";
    job_.output = folder_ / "s.html";
  }

  static LogTime at(std::uint32_t seconds) { return LogTime(std::chrono::seconds(seconds)); }

  TemporaryFolder folder_;
  PageJob job_;
  PageReport report_;
};

TEST_F(PageSpanTest, TheCellOfALogIsNotInThePageTwice) {
  const auto carried = carriedLog(job_, report_);
  ASSERT_TRUE(carried.ok()) << carried.error().text();
  auto reader = LogReader::openBytes(*carried, "carried");
  auto before = LogReader::open(job_.log);
  ASSERT_TRUE(reader.ok() && before.ok());
  ASSERT_THAT(before->attachments(), SizeIs(testing::Gt(2)));
  ASSERT_THAT(reader->attachments(), SizeIs(1));
  EXPECT_EQ(reader->attachments()[0].name, "notes.txt");
  for (const LogMetadata& record : reader->metadata()) EXPECT_NE(record.name, "rocinante.cell");
  EXPECT_EQ(*contentSha256(*reader), *contentSha256(*before));
  EXPECT_EQ(reader->summary().session_id, "session-1");
  EXPECT_TRUE(report_.is_whole);
  EXPECT_THAT(report_.warnings, IsEmpty());
  // Nothing of it stays beside the page.
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
    names.push_back(entry.path().filename().string());
  }
  EXPECT_THAT(names, testing::UnorderedElementsAre("arm.urdf", "s.mcap"));
}

TEST_F(PageSpanTest, ADamagedLogStaysAsItIs) {
  const auto text = readFile(job_.log, 1U << 20U);
  ASSERT_TRUE(text.ok());
  std::string bytes = *text;
  const std::size_t place = bytes.find("RK1 a 50");
  ASSERT_NE(place, bytes.npos);
  bytes.replace(place, 8, "damage!!");
  std::ofstream(job_.log, std::ios::binary) << bytes;
  const auto carried = carriedLog(job_, report_);
  ASSERT_TRUE(carried.ok());
  EXPECT_EQ(textOf(*carried), bytes);
}

}  // namespace
}  // namespace rocinante::test
