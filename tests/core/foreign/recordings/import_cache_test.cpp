#include "core/foreign/recordings/import_cache.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cstdlib>

#include "core/base/atomic_file.h"
#include "core/foreign/recordings/opened_recording.h"
#include "core/log/log_reader.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

namespace fs = std::filesystem;

const std::string kOne(64, '1');
const std::string kTwo(64, '2');

const ImportCache::Waiting kPatient = [] { return Status{}; };

ImportCache::Make making(const std::string& text, int* times = nullptr) {
  return [text, times](const fs::path& path) {
    if (times != nullptr) ++*times;
    return writeFileWhole(path, bytesOf(text), true);
  };
}

std::string contentOf(const fs::path& path) { return readFile(path).value_or("(nothing)"); }

TEST(ImportCache, MakesALogOnceAndFindsItAfterwards) {
  const TemporaryFolder folder;
  const ImportCache cache(folder / "imports");
  int times = 0;
  EXPECT_FALSE(cache.find(kOne));
  for (int turn = 0; turn < 3; ++turn) {
    const auto made = cache.findOrMake(kOne, making("a log", &times), kPatient);
    ASSERT_TRUE(made.ok()) << made.error().text();
    EXPECT_FALSE(made->trouble);
    EXPECT_EQ(contentOf(made->log), "a log");
  }
  EXPECT_EQ(times, 1);
  EXPECT_FALSE(fs::exists(folder / "imports" / (kOne + ".lock")));
}

TEST(ImportCache, MakesADamagedOneAnew) {
  const TemporaryFolder folder;
  const ImportCache cache(folder.path());
  ASSERT_TRUE(cache.findOrMake(kOne, making("a whole log"), kPatient).ok());
  for (const char* const spoilt : {"a whole lag", "a whole", ""}) {
    SCOPED_TRACE(spoilt);
    ASSERT_TRUE(writeFileWhole(folder / (kOne + ".mcap"), bytesOf(spoilt), true).ok());
    EXPECT_FALSE(cache.find(kOne));
    int times = 0;
    const auto made = cache.findOrMake(kOne, making("a whole log", &times), kPatient);
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(times, 1);
    EXPECT_EQ(contentOf(made->log), "a whole log");
  }
}

TEST(ImportCache, ForgetsTheLeastRecentlyUsedWhenItIsFull) {
  const TemporaryFolder folder;
  const ImportCache cache(folder.path(), 1000);
  ASSERT_TRUE(cache.findOrMake(kOne, making(std::string(600, 'x')), kPatient).ok());
  ASSERT_TRUE(writeFileWhole(folder / "mine.mcap", bytesOf("not the cache's"), true).ok());
  ASSERT_TRUE(cache.findOrMake(kTwo, making(std::string(600, 'y')), kPatient).ok());
  EXPECT_FALSE(cache.find(kOne));
  EXPECT_TRUE(cache.find(kTwo));
  EXPECT_TRUE(fs::exists(folder / "mine.mcap"));
}

TEST(ImportCache, SaysWhyAFolderCannotHoldIt) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileWhole(folder / "file", bytesOf("no folder"), true).ok());
  const auto made =
      ImportCache(folder / "file" / "imports").findOrMake(kOne, making("a log"), kPatient);
  ASSERT_TRUE(made.ok());
  EXPECT_TRUE(made->log.empty());
  ASSERT_TRUE(made->trouble.has_value());
  EXPECT_THAT(made->trouble->text(), testing::HasSubstr("cannot make the folder"));
}

TEST(ImportCache, PassesOnWhatIsWrongWithTheRecording) {
  const TemporaryFolder folder;
  const auto made = ImportCache(folder.path())
                        .findOrMake(
                            kOne,
                            [](const fs::path&) -> Status {
                              return Error{ErrorKind::damaged, "no bag", "/elsewhere/bag"};
                            },
                            kPatient);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().what, "no bag");
}

TEST(ImportCache, DoesNotLieInAWriteProtectedFolderEvenForRoot) {
  const TemporaryFolder folder;
  ::setenv("XDG_CACHE_HOME", "/nowhere/cache", 1);
  EXPECT_THAT(ImportCache::placesFor(folder / "bag"), SizeIs(2));
  ASSERT_EQ(::chmod(folder.path().c_str(), 0500), 0);
  const auto places = ImportCache::placesFor(folder / "bag");
  ASSERT_THAT(places, SizeIs(1));
  EXPECT_EQ(places.front().folder(), "/nowhere/cache/rocinante/imports");
  ASSERT_EQ(::chmod(folder.path().c_str(), 0700), 0);
  ::unsetenv("XDG_CACHE_HOME");
}

TEST(OpenedRecording, ImportsOnceAndSeesEveryChangeOfTheFile) {
  const TemporaryFolder folder;
  const fs::path table = folder / "t.csv";
  ASSERT_TRUE(writeFileWhole(table, bytesOf("t,arm.a\n0,1\n1,2\n"), true).ok());
  RecordingRequest request;
  request.recording = table;
  const auto first = openedRecording(request);
  ASSERT_TRUE(first.ok()) << first.error().text();
  EXPECT_TRUE(first->imported);
  EXPECT_THAT(first->not_kept, IsEmpty());
  EXPECT_THAT(first->warnings, IsEmpty());
  EXPECT_EQ(first->log.parent_path(), folder / ".rocinante/imports");
  const auto again = openedRecording(request);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->log, first->log);
  ASSERT_TRUE(writeFileWhole(table, bytesOf("t,arm.a\n0,1\n1,3\n"), true).ok());
  const auto changed = openedRecording(request);
  ASSERT_TRUE(changed.ok());
  EXPECT_NE(changed->log, first->log);
  EXPECT_EQ(LogReader::open(changed->log)->summary().messages, 2U);
  // Another device is another log.
  request.device = "other";
  EXPECT_NE(openedRecording(request)->log, changed->log);
}

TEST(OpenedRecording, IsATemporaryFileWhereNothingCanBeKept) {
  const TemporaryFolder folder;
  const fs::path table = folder / "t.csv";
  ASSERT_TRUE(writeFileWhole(table, bytesOf("t,arm.a\n0,1\n1,2\n"), true).ok());
  ASSERT_EQ(::chmod(folder.path().c_str(), 0500), 0);
  ::setenv("XDG_CACHE_HOME", table.c_str(), 1);  // a file, no folder
  RecordingRequest request;
  request.recording = table;
  fs::path log;
  {
    const auto opened = openedRecording(request);
    ASSERT_TRUE(opened.ok()) << opened.error().text();
    EXPECT_THAT(opened->not_kept, testing::HasSubstr("cannot make the folder"));
    log = opened->log;
    EXPECT_TRUE(fs::exists(log));
  }
  EXPECT_FALSE(fs::exists(log));
  ASSERT_EQ(::chmod(folder.path().c_str(), 0700), 0);
  ::unsetenv("XDG_CACHE_HOME");
}

TEST(OpenedRecording, PassesOnALogAndWhatNobodyKnows) {
  const TemporaryFolder folder;
  for (const char* const text : {"", "hello", "<robot name='arm'/>"}) {
    ASSERT_TRUE(writeFileWhole(folder / "file", bytesOf(text), true).ok());
    RecordingRequest request;
    request.recording = folder / "file";
    const auto opened = openedRecording(request);
    ASSERT_TRUE(opened.ok());
    EXPECT_FALSE(opened->imported);
    EXPECT_EQ(opened->log, folder / "file");
  }
}

}  // namespace
}  // namespace rocinante::test
