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

TEST(ImportCache, BelongsToTheUserAndNeverLiesBesideARecording) {
  ::setenv("XDG_CACHE_HOME", "/nowhere/cache", 1);
  EXPECT_EQ(ImportCache::ofUser()->folder(), "/nowhere/cache/rocinante/imports");
  ::setenv("XDG_CACHE_HOME", "not/absolute", 1);
  EXPECT_NE(ImportCache::ofUser()->folder(), "not/absolute/rocinante/imports");
  ::unsetenv("XDG_CACHE_HOME");
}

TEST(ImportCache, WaitsForNoPipeInItsFolder) {
  for (const char* const ending : {".sum", ".mcap", ".lock"}) {
    SCOPED_TRACE(ending);
    const TemporaryFolder folder;
    const ImportCache cache(folder.path());
    if (std::string_view(ending) == ".sum") {
      ASSERT_TRUE(writeFileWhole(folder / (kOne + ".mcap"), bytesOf("a log"), true).ok());
    }
    ASSERT_EQ(::mkfifo((folder / (kOne + ending)).c_str(), 0600), 0);
    EXPECT_FALSE(cache.find(kOne));
    const auto made = cache.findOrMake(kOne, making("a log"), kPatient);
    ASSERT_TRUE(made.ok()) << made.error().text();
    EXPECT_EQ(contentOf(made->log), "a log");
  }
}

/// What is kept lies in a folder of its own, not in that of whoever runs the tests.
class CacheOfTest {
 public:
  CacheOfTest() { ::setenv("XDG_CACHE_HOME", folder_.path().c_str(), 1); }
  ~CacheOfTest() { ::unsetenv("XDG_CACHE_HOME"); }
  fs::path imports() const { return folder_ / "rocinante/imports"; }

 private:
  TemporaryFolder folder_;
};

// A log and its sum that came with a recording say what its maker wanted.
TEST(OpenedRecording, BelievesNoLogThatCameWithIt) {
  const CacheOfTest cache;
  const TemporaryFolder folder;
  const fs::path table = folder / "t.csv";
  ASSERT_TRUE(writeFileWhole(table, bytesOf("t,arm.a\n0,1\n1,2\n"), true).ok());
  RecordingRequest request;
  request.recording = table;
  const fs::path kept = openedRecording(request)->log;
  const fs::path beside = folder / ".rocinante/imports";
  fs::create_directories(beside);
  fs::copy_file(kept, beside / kept.filename());
  fs::copy_file(fs::path(kept).replace_extension(".sum"),
                (beside / kept.filename()).replace_extension(".sum"));
  fs::remove_all(cache.imports());
  const auto opened = openedRecording(request);
  ASSERT_TRUE(opened.ok());
  EXPECT_EQ(opened->log.parent_path(), cache.imports());
}

TEST(OpenedRecording, ThatIsRefusedLeavesNothingBesideIt) {
  const CacheOfTest cache;
  const TemporaryFolder folder;
  const fs::path table = folder / "t.csv";
  ASSERT_TRUE(writeFileWhole(table, bytesOf("a,b\n0,1\n1,2\n"), true).ok());
  RecordingRequest request;
  request.recording = table;
  const auto refused = openedRecording(request);
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().text(), testing::HasSubstr("no column is the time"));
  ASSERT_TRUE(writeFileWhole(table, bytesOf("t,b\n0,1\n1,2\n"), true).ok());
  EXPECT_TRUE(openedRecording(request).ok());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(OpenedRecording, ImportsOnceAndSeesEveryChangeOfTheFile) {
  const CacheOfTest cache;
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
  EXPECT_EQ(first->log.parent_path(), cache.imports());
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
