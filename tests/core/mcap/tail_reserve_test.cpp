#include "core/mcap/tail_reserve.h"

#include <gmock/gmock.h>

#include "core/base/hash.h"
#include "core/mcap/growing_file.h"
#include "tests/core/mcap/faulty_sink.h"

namespace rocinante::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Notes what it is asked to reserve, and has limited room.
class AskedSink final : public ByteSink {
 public:
  AskedSink(std::vector<std::uint64_t>& asked, std::uint64_t room) : asked_(asked), room_(room) {}
  Status append(ByteView) override { return {}; }
  Status truncate(std::uint64_t) override { return {}; }
  Status reserve(std::uint64_t size_bytes) override {
    asked_.push_back(size_bytes);
    if (size_bytes <= room_) return {};
    return Error{ErrorKind::unreadable, "full", name_};
  }
  Status close() override { return {}; }
  const std::string& name() const override { return name_; }

 private:
  std::vector<std::uint64_t>& asked_;
  std::uint64_t room_;
  std::string name_ = "disk";
};

constexpr std::uint64_t kKiB = 1024;
constexpr std::uint64_t kMiB = 1024 * kKiB;

TEST(TailReserve, AsksInStepsThatGrowWithTheFile) {
  std::vector<std::uint64_t> asked;
  AskedSink sink(asked, ~std::uint64_t{0});
  TailReserve reserve;
  ASSERT_TRUE(reserve.cover(sink, 10 * kKiB).ok());
  ASSERT_TRUE(reserve.cover(sink, 1034 * kKiB).ok());
  EXPECT_THAT(asked, ElementsAre(1034 * kKiB)) << "the second is covered by the first";
  asked.clear();
  ASSERT_TRUE(reserve.cover(sink, 8 * kMiB).ok());
  ASSERT_TRUE(reserve.cover(sink, 1024 * kMiB).ok());
  EXPECT_THAT(asked, ElementsAre(9 * kMiB, 1040 * kMiB));
}

TEST(TailReserve, AsksForWhatIsNeededWhereTheStepDoesNotFit) {
  std::vector<std::uint64_t> asked;
  AskedSink sink(asked, 100 * kKiB);
  TailReserve reserve;
  EXPECT_TRUE(reserve.cover(sink, 90 * kKiB).ok());
  EXPECT_THAT(asked, ElementsAre(1114 * kKiB, 90 * kKiB));
  EXPECT_FALSE(reserve.cover(sink, 101 * kKiB).ok());
  EXPECT_TRUE(reserve.cover(sink, 90 * kKiB).ok()) << "what was reserved stays so";
  asked.clear();
  reserve.forget();
  EXPECT_TRUE(reserve.cover(sink, 10 * kKiB).ok());
  EXPECT_THAT(asked, ElementsAre(1034 * kKiB, 10 * kKiB));
}

TEST(GrowingFile, ItsChecksumIsThatOfTheFileHoweverItWasCounted) {
  Bytes file;
  mcap::GrowingFile growing(makeMemorySink(file));
  ASSERT_TRUE(growing.append(bytesOf("head "), 0).ok());
  ASSERT_TRUE(growing.appendUncounted(bytesOf("?????"), 0).ok());
  ASSERT_TRUE(growing.appendUncounted(bytesOf(" body"), 0).ok());
  ASSERT_TRUE(growing.overwrite(5, bytesOf("known")).ok());
  growing.count(crc32(bytesOf("known")), 5);
  growing.count(crc32(bytesOf(" body")), 5);
  ASSERT_TRUE(growing.append(bytesOf(" tail"), 0).ok());
  EXPECT_EQ(textOf(file), "head known body tail");
  EXPECT_EQ(growing.crc(), crc32(file));
  EXPECT_EQ(growing.size(), file.size());
}

TEST(GrowingFile, WritesNothingBehindWhichItsTailHasNoRoom) {
  Bytes file;
  std::size_t writes = 0;
  DiskFaults faults;
  faults.room = 100;
  mcap::GrowingFile growing(std::make_unique<FaultySink>(file, faults, writes));
  const std::string half(50, 'x');
  EXPECT_FALSE(growing.append(bytesOf(half), 51).ok());
  EXPECT_THAT(file, IsEmpty());
  EXPECT_TRUE(growing.append(bytesOf(half), 50).ok());
  EXPECT_TRUE(growing.append(bytesOf(half), 0).ok());
  EXPECT_EQ(file.size(), 100U);
}

TEST(GrowingFile, WritesNothingBehindAnAppendThatCouldNotBeTakenBack) {
  Bytes file;
  std::size_t writes = 0;
  DiskFaults faults;
  faults.fails_at = 1;
  faults.takes_half = true;
  faults.truncates = false;
  mcap::GrowingFile growing(std::make_unique<FaultySink>(file, faults, writes));
  ASSERT_TRUE(growing.append(bytesOf("whole"), 0).ok());
  ASSERT_FALSE(growing.append(bytesOf("torn"), 0).ok());
  const Status behind = growing.append(bytesOf("lost"), 0);
  ASSERT_FALSE(behind.ok());
  EXPECT_THAT(behind.error().text(), HasSubstr("cannot write after a write that failed"));
  EXPECT_EQ(textOf(file), "wholeto");
}

}  // namespace
}  // namespace rocinante::test
