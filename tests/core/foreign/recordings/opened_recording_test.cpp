#include "core/foreign/recordings/opened_recording.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "core/cli/program.h"
#include "core/log/log_reader.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

namespace fs = std::filesystem;

void putFile(const fs::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// A table whose import takes several calls of `progress` behind the hashing.
void putLongTable(const fs::path& path) {
  std::ofstream table(path);
  table << "t,arm.a\n";
  for (int i = 0; i < 20'000; ++i) table << i << "," << i % 7 << "\n";
}

std::vector<std::string> filesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

/// What is kept lies in the test's own folder.
class CacheHere {
 public:
  explicit CacheHere(const TemporaryFolder& folder) {
    ::setenv("XDG_CACHE_HOME", folder.path().c_str(), 1);
  }
  ~CacheHere() { ::unsetenv("XDG_CACHE_HOME"); }
};

TEST(OpenedFolder, ThatIsNoBagIsRefused) {
  const TemporaryFolder folder;
  RecordingRequest request;
  request.recording = folder.path();
  putFile(folder / "metadata.yaml", "rosbag2_bagfile_information:");
  EXPECT_THAT(openedRecording(request).error().text(), HasSubstr("zstd -d FILE"));
  fs::remove(folder / "metadata.yaml");
  putFile(folder / "one.bag", "#ROSBAG V2.0\n");
  EXPECT_THAT(openedRecording(request).error().text(),
              HasSubstr("any other recording is a file: name that"));
}

TEST(OpenedRecording, ThatIsStoppedLeavesNothing) {
  const TemporaryFolder folder;
  const CacheHere cache(folder);
  putLongTable(folder / "t.csv");
  RecordingRequest request;
  request.recording = folder / "t.csv";
  request.progress = [&](double part) -> Status {
    if (part <= 0.15) return {};
    // It is being made now.
    EXPECT_THAT(filesIn(folder / "rocinante/imports"), SizeIs(2));
    return Error{ErrorKind::refused, "stopped while importing", {}};
  };
  const auto stopped = openedRecording(request);
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().what, "stopped while importing");
  EXPECT_THAT(filesIn(folder / "rocinante/imports"), IsEmpty());
}

// Where the work does not look whether it shall stop, as in SQLite's sorting.
TEST(OpenedRecording, ThatIsEndedByADeadlineLeavesNothing) {
  const TemporaryFolder folder;
  const CacheHere cache(folder);
  putLongTable(folder / "t.csv");
  const pid_t child = ::fork();
  if (child == 0) {
    cli::catchStopSignals();
    const cli::StopDeadline deadline("stopped");
    RecordingRequest request;
    request.recording = folder / "t.csv";
    request.progress = [&](double part) -> Status {
      if (part <= 0.15) return {};
      if (filesIn(folder / "rocinante/imports").size() != 2) ::_exit(3);
      ::raise(SIGTERM);
      while (true) ::pause();
    };
    (void)openedRecording(request);
    ::_exit(4);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_THAT(filesIn(folder / "rocinante/imports"), IsEmpty());
}

}  // namespace
}  // namespace rocinante::test
