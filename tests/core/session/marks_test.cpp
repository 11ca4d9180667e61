#include "core/session/marks.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <set>

#include "core/base/atomic_file.h"
#include "core/session/timeline.h"
#include "tests/core/log/log_support.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {
namespace {

constexpr std::int64_t kNoon = 1'770'120'000'000'000'000;  // 2026-02-03T12:00:00Z

class Marks : public testing::Test {
 protected:
  void put(std::string_view text) { std::ofstream(marksPath(log_), std::ios::binary) << text; }
  std::string content() { return readFile(marksPath(log_)).value_or("unreadable"); }

  TemporaryFolder folder_;
  std::filesystem::path log_ = folder_ / "session.mcap";
};

TEST_F(Marks, AreNoneWhereThereIsNoFile) {
  const Result<std::vector<Event>> marks = readMarks(log_);
  ASSERT_TRUE(marks.ok());
  EXPECT_TRUE(marks->empty());
}

TEST_F(Marks, AreOneLineEachBesideTheLog) {
  ASSERT_TRUE(addMark(log_, {at(kNoon + 2'500'000'000), {}, "picked"}).ok());
  ASSERT_TRUE(addMark(log_, {at(kNoon), {}, "begin"}).ok());
  EXPECT_EQ(content(),
            "2026-02-03T12:00:02.500000000Z \"picked\"\n"
            "2026-02-03T12:00:00.000000000Z \"begin\"\n");
  EXPECT_FALSE(std::filesystem::exists(log_)) << "the log itself is not touched";
  const Result<std::vector<Event>> marks = readMarks(log_);
  ASSERT_TRUE(marks.ok());
  ASSERT_EQ(marks->size(), 2U);
  EXPECT_EQ((*marks)[0].text, "begin");
  EXPECT_EQ((*marks)[1].time, at(kNoon + 2'500'000'000));
  EXPECT_EQ((*marks)[1].source, "");
}

TEST_F(Marks, KeepEveryTextExactlyOnOneHarmlessLine) {
  const std::string hostile[] = {"two\nlines\r\n",
                                 "\x1b[2J\x07 bell",
                                 "\"quoted\" \\ back",
                                 "\xc2\x9b"
                                 "31m C1",
                                 std::string("zero \0 inside", 13),
                                 "Gerät ▶ 日本",
                                 "\x7f",
                                 std::string(kMaxMarkBytes, 'x'),
                                 std::string(kMaxMarkBytes, '\x01')};
  std::size_t count = 0;
  for (const std::string& text : hostile) {
    SCOPED_TRACE(testing::PrintToString(text));
    ASSERT_TRUE(addMark(log_, {at(kNoon + static_cast<int>(count)), {}, text}).ok());
    const Result<std::vector<Event>> marks = readMarks(log_);
    ASSERT_TRUE(marks.ok()) << marks.error().text();
    ASSERT_EQ(marks->size(), ++count);
    EXPECT_EQ(marks->back().text, text);
  }
  for (const char c : content()) {
    EXPECT_TRUE(c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != '\x7f'));
  }
  EXPECT_EQ(content().find("\xc2\x9b"), std::string::npos);
}

TEST_F(Marks, TakeWhatAPersonTyped) {
  put("# the good ones\r\n\n1770120000000000005 \"by nanoseconds\"\r\n"
      "2026-02-03T13:00:00.000000005+01:00 \"the same moment, later in the file\"");
  const Result<std::vector<Event>> marks = readMarks(log_);
  ASSERT_TRUE(marks.ok()) << marks.error().text();
  ASSERT_EQ(marks->size(), 2U);
  EXPECT_EQ((*marks)[0].text, "by nanoseconds");
  EXPECT_EQ((*marks)[0].time, at(kNoon + 5));
  EXPECT_EQ((*marks)[1].time, at(kNoon + 5));
  // Its last line has no end: the next mark begins on a line of its own.
  ASSERT_TRUE(addMark(log_, {at(kNoon + 6), {}, "third"}).ok());
  EXPECT_EQ(readMarks(log_)->size(), 3U);
}

TEST_F(Marks, ThatAreMalformedAreToldByTheirLine) {
  for (const std::string line :
       {"12.5 \"no calendar time\"", "1770120000000000000", "1770120000000000000 unquoted",
        "1770120000000000000 \"\"", "-5 \"before 1970\"", "1770120000000000000 7",
        "99999999999999999999 \"too late\"", "1770120000000000000 \"open",
        "1770120000000000000 \"bad \xff utf-8\"", "1770120000000000000 [[[["}) {
    SCOPED_TRACE(line);
    put("1770120000000000000 \"good\"\n" + line + "\n");
    const Result<std::vector<Event>> marks = readMarks(log_);
    ASSERT_FALSE(marks.ok());
    EXPECT_EQ(marks.error().kind, ErrorKind::damaged);
    EXPECT_THAT(marks.error().where, testing::EndsWith("session.mcap.marks, line 2"));
  }
}

TEST_F(Marks, RefuseWhatNoMarkCanBe) {
  for (const std::string& text :
       {std::string(), std::string(kMaxMarkBytes + 1, 'x'), std::string("\xff")}) {
    EXPECT_EQ(addMark(log_, {at(kNoon), {}, text}).error().kind, ErrorKind::bad_argument);
  }
  EXPECT_FALSE(addMark(log_, {at(-1), {}, "x"}).ok());
  EXPECT_FALSE(addMark(folder_ / "no" / "log.mcap", {at(1), {}, "x"}).ok());
  std::filesystem::create_directory(marksPath(log_));
  EXPECT_FALSE(addMark(log_, {at(1), {}, "x"}).ok());
  EXPECT_FALSE(readMarks(log_).ok());
}

TEST_F(Marks, ThatAreALinkAreNotFollowed) {
  const std::filesystem::path victim = folder_ / "victim";
  for (const bool is_there : {false, true}) {
    if (is_there) std::ofstream(victim) << "precious";
    std::filesystem::remove(marksPath(log_));
    std::filesystem::create_symlink(victim, marksPath(log_));
    const Status added = addMark(log_, {at(1), {}, "x"});
    ASSERT_FALSE(added.ok());
    EXPECT_EQ(added.error().what, "the marks are a link, which is not followed");
    const Result<std::vector<Event>> marks = readMarks(log_);
    ASSERT_FALSE(marks.ok());
    EXPECT_EQ(marks.error().what, "the marks are a link, which is not followed");
    EXPECT_EQ(std::filesystem::exists(victim), is_there);
  }
  EXPECT_EQ(readFile(victim).value(), "precious");
}

TEST_F(Marks, OfProcessesThatMarkAtOnceAreAllThere) {
  constexpr int kProcesses = 4;
  constexpr int kMarks = 50;
  for (int process = 0; process < kProcesses; ++process) {
    if (::fork() != 0) continue;
    for (int i = 0; i < kMarks; ++i) {
      const std::string text = std::to_string(process) + "/" + std::to_string(i);
      if (!addMark(log_, {at(i), {}, text + std::string(500, '.')}).ok()) ::_exit(1);
    }
    ::_exit(0);
  }
  for (int process = 0; process < kProcesses; ++process) {
    int status = 0;
    ASSERT_GT(::wait(&status), 0);
    EXPECT_EQ(status, 0);
  }
  const Result<std::vector<Event>> marks = readMarks(log_);
  ASSERT_TRUE(marks.ok()) << marks.error().text();
  std::set<std::string> texts;
  for (const Event& mark : *marks) texts.insert(mark.text);
  EXPECT_EQ(texts.size(), kProcesses * kMarks);
}

TEST_F(Marks, OnAFullDiskLeaveTheFileAsItWas) {
  ASSERT_TRUE(addMark(log_, {at(kNoon), {}, "first"}).ok());
  const std::string before = content();
  const ::pid_t child = ::fork();
  if (child == 0) {
    // Like a full disk, this allows only part of the line to be written.
    ::signal(SIGXFSZ, SIG_IGN);
    const struct rlimit limit { before.size() + 10, before.size() + 10 };
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::_exit(addMark(log_, {at(kNoon), {}, "does not fit"}).ok() ? 1 : 0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(content(), before);
}

TEST_F(Marks, BakedIntoALogComeBack) {
  for (const std::string text : {"picked", "\"two\"\nlines", "Gerät"}) {
    EXPECT_EQ(parseMark(bytesOf(markText(text))), text);
  }
  EXPECT_EQ(markText("picked"), "{\"text\":\"picked\"}");
  for (const std::string bad : {"", "picked", "[]", "{}", "{\"text\":5}", "{\"text\":\"open"}) {
    EXPECT_EQ(parseMark(bytesOf(bad)), std::nullopt) << bad;
  }
}

TEST_F(Marks, AreAmongTheEventsOfTheTimeLine) {
  Result<LogWriter> writer = LogWriter::create(log_, {}, "s");
  ASSERT_TRUE(writer.ok());
  const ChannelId arm = *writer->addChannel("/udp/1/arm", "rk1", {});
  const ChannelId baked = *writer->addChannel("/rocinante/mark", "json", {});
  ASSERT_TRUE(writer->write(arm, 0, at(1000), 0, bytesOf("RK1 arm - -\nevent \"told\"")).ok());
  ASSERT_TRUE(writer->write(baked, 0, at(2000), 0, bytesOf(markText("baked in"))).ok());
  ASSERT_TRUE(writer->close("finished").ok());
  ASSERT_TRUE(addMark(log_, {at(1000), {}, "beside"}).ok());
  ASSERT_TRUE(addMark(log_, {at(500), {}, "before all"}).ok());

  Result<Timeline> timeline = Timeline::open(log_);
  ASSERT_TRUE(timeline.ok());
  const Result<const std::vector<Event>*> events = timeline->events();
  ASSERT_TRUE(events.ok()) << events.error().text();
  std::vector<std::string> told;
  for (const Event& event : **events) {
    told.push_back(std::to_string(event.time.time_since_epoch().count()) + " " + event.source +
                   ":" + event.text);
  }
  EXPECT_THAT(told, testing::ElementsAre("500 :before all", "1000 arm:told", "1000 :beside",
                                         "2000 :baked in"));

  put("nonsense\n");
  Result<Timeline> spoiled = Timeline::open(log_);
  ASSERT_TRUE(spoiled.ok());
  EXPECT_FALSE(spoiled->events().ok()) << "a moment that cannot be named is no moment";
}

}  // namespace
}  // namespace rocinante::test
