#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "recorder/export/exports.h"
#include "tests/recorder/export/written_session.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using test::Said;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Notes its calls, a line each.
class NotingFormat final : public SessionFormat {
 public:
  explicit NotingFormat(Nanoseconds last = {}) : last_(last) {}

  std::string profile() const override { return ""; }
  Nanoseconds framesLast() const override { return last_; }
  Status frames(MessageSink&, LogTime time, const std::string& device,
                std::span<const FramePose> frames) override {
    return note(time, "frames " + device + " in " + frames[0].parent);
  }
  Status joints(MessageSink&, LogTime time, const std::string& device,
                std::span<const NamedValue> values) override {
    std::string line = "joints " + device;
    for (const NamedValue& value : values) {
      line += " " + value.name + "=" + std::to_string(static_cast<int>(value.value));
    }
    return note(time, line);
  }
  Status drawings(MessageSink&, LogTime time, const std::string& source,
                  const Drawings& drawings) override {
    std::string line = "drawings " + source + ":";
    for (const auto& [id, drawing] : drawings) line += " " + id;
    return note(time, line);
  }
  Status event(MessageSink&, LogTime time, EventLevel level, std::string_view name,
               std::string_view text) override {
    return note(time, (level == EventLevel::warning ? "warning " : "event ") + std::string(name) +
                          " " + std::string(text));
  }
  bool knowSignals(const KnownSignals& known) override {
    for (const auto& [owner, signals] : known.byOwner()) {
      for (const auto& [name, signal] : signals) known_ += " " + ownerText(owner) + ":" + name;
    }
    return has_signals;
  }
  Status signals(MessageSink&, LogTime time, const SignalOwner& owner,
                 std::span<const StatedSignal> said, bool all_requested) override {
    if (!has_signals) return {};
    std::string line = (all_requested ? "all signals " : "signals ") + ownerText(owner);
    for (const StatedSignal& each : said) {
      line += " " + std::string(each.name) + (each.is_new ? "!" : "");
      if (each.in_joints) line += "*";
    }
    return note(time, line);
  }
  Status description(MessageSink&, LogTime, const std::string&, std::string_view) override {
    return {};
  }

  bool requestsAllSignals() const override { return requests_all_signals; }

  bool has_signals = false;
  bool requests_all_signals = true;
  std::string known_;

  std::vector<std::string> notes;

 private:
  Status note(LogTime time, const std::string& line) {
    notes.push_back(std::to_string(nanosecondsOf(time) - test::kWrittenOrigin) + " " + line);
    return {};
  }

  Nanoseconds last_;
};

class MessageExport : public testing::Test {
 protected:
  MessageExportReport exported(const std::vector<Said>& all, NotingFormat& format,
                               bool raw = false) {
    test::writeSession(folder_ / "s.mcap", all);
    auto session = MomentWalk::open(folder_ / "s.mcap");
    EXPECT_TRUE(session.ok());
    bytes_.clear();
    auto out = ExportedMcap::start(makeMemorySink(bytes_), "");
    EXPECT_TRUE(out.ok());
    MessageExportOptions options;
    options.until = LogTime::max();
    options.raw = raw;
    auto report = exportMessages(*session, nullptr, format, *out, options);
    EXPECT_TRUE(report.ok());
    EXPECT_TRUE(out->finish().ok());
    topics_ = out->topics();
    return std::move(*report);
  }

  test::TemporaryFolder folder_;
  Bytes bytes_;
  std::map<std::string, ExportedMcap::Topic, std::less<>> topics_;
};

TEST_F(MessageExport, SaysADeviceWhenItIsWritten) {
  NotingFormat format;
  exported({{0, "RK1 s 0 -\npose a 0 0 1 0 0 0 1\njoint a j=1\n"},
            {10, "RK1 s 1 -\njoint b k=2 j=3\n"},
            {20, "RK1 s 2 -\npose a 0 0 1 0 0 0 1\n"},
            {30, "RK1 s 3 -\nremove a\n"},
            {40, "RK1 s 4 -\nadd a m\njoints a 5 6\n"}},
           format);
  EXPECT_THAT(format.notes,
              ElementsAre("0 frames a in world", "0 joints a j=1", "10 joints b j=3 k=2",
                          "20 frames a in world", "20 joints a j=1", "40 joints a 1=5 2=6"));
}

TEST_F(MessageExport, SaysAllSignalsOfAnOwnerWhenOneIsSaid) {
  NotingFormat format;
  format.has_signals = true;
  const std::vector<Said> all = {
      {0, "RK1 s 0 -\nsignals arm b=1 a=2\nsignal arm/tip f 3 N\nsignal - on true\n"},
      {10, "RK1 s 1 -\nsignals arm a=2\n"},
      {20, "RK1 s 2 -\njoint arm j=1\nsignals arm j.velocity=5 k.effort=6\n"},
      {30, "RK1 s 3 -\nsignal arm b default\nsignal - on default\n"},
      {40, "RK1 s 4 -\nremove arm\n"}};
  const MessageExportReport report = exported(all, format);
  EXPECT_THAT(format.notes,
              ElementsAre("0 all signals - on!", "0 all signals arm a! b!",
                          "0 all signals arm/tip f!", "10 signals arm a! b", "20 joints arm j=1",
                          "20 signals arm a b j.velocity!* k.effort!", "30 joints arm j=1",
                          "30 all signals arm a j.velocity* k.effort", "30 all signals -",
                          "40 all signals arm", "40 all signals arm/tip"));
  EXPECT_EQ(format.known_, " -:on arm:a arm:b arm:j.velocity arm:k.effort arm/tip:f");
  EXPECT_TRUE(report.left_out.empty());

  NotingFormat without;
  EXPECT_EQ(accountSentence(exported(all, without).left_out),
            "left out: 4 statements `signal` (signals are not exported), "
            "3 statements `signals` (signals are not exported)");
}

TEST_F(MessageExport, GivesOnlyNewSignalsToAFormatThatWantsNoOther) {
  NotingFormat format;
  format.has_signals = true;
  format.requests_all_signals = false;
  exported({{0, "RK1 s 0 -\nsignals arm b=1 a=2\nsignal arm/tip f 3 N\nsignal - on true\n"},
            {10, "RK1 s 1 -\nsignals arm a=2\n"},
            {20, "RK1 s 2 -\njoint arm j=1\nsignals arm j.velocity=5 k.effort=6\n"},
            {25, "RK1 s 1 -\nsignals arm a=3\n"},  // late
            {30, "RK1 s 3 -\nsignal arm b default\nsignal - on default\n"},
            {35, "RK1 s 4 -\nsignals arm c=1\nsignals - n=1\nsignal arm/tip f 3 N\n"},
            {40, "RK1 s 5 -\nremove arm\nsignals arm c=1\n"}},
           format);
  EXPECT_THAT(
      format.notes,
      ElementsAre("0 all signals - on!", "0 all signals arm a! b!", "0 all signals arm/tip f!",
                  "10 signals arm a!", "20 joints arm j=1", "20 signals arm j.velocity!* k.effort!",
                  "30 joints arm j=1", "30 all signals arm a j.velocity* k.effort",
                  "30 all signals -", "35 joints arm j=1", "35 all signals - n!",
                  "35 signals arm c!", "35 signals arm/tip f!", "40 all signals arm c!",
                  "40 all signals arm/tip"));
}

TEST_F(MessageExport, EachMessageOfManySignalsHasTheNewOne) {
  NotingFormat format;
  format.has_signals = true;
  format.requests_all_signals = false;
  constexpr int kSignals = 3'000;
  std::vector<Said> all;
  for (int i = 0; i < kSignals; ++i) {
    const std::string number = std::to_string(i);
    all.push_back({i, "RK1 s " + number + " -\nsignals arm n" + number + "=1\n"});
  }
  exported(all, format);
  ASSERT_EQ(format.notes.size(), std::size_t{kSignals});
  EXPECT_EQ(format.notes.front(), "0 all signals arm n0!");
  EXPECT_EQ(format.notes.back(), "2999 signals arm n2999!");
}

/// As a format sees them that has no use for others than new ones.
std::vector<std::string> newSignals(const std::vector<std::string>& notes) {
  std::vector<std::string> shorter;
  for (const std::string& note : notes) {
    if (note.find(" all signals ") != note.npos || note.find(" signals ") == note.npos) {
      shorter.push_back(note);
      continue;
    }
    std::istringstream words(note);
    std::string time, what, owner, line;
    words >> time >> what >> owner;
    line = time + " " + what + " " + owner;
    for (std::string word; words >> word;) {
      if (word.find('!') != word.npos) line += " " + word;
    }
    shorter.push_back(line);
  }
  return shorter;
}

TEST_F(MessageExport, NewSignalsAreThoseOfAFormatThatWantsAll) {
  std::mt19937 random(38);  // the same each time: a failure can be looked at
  const auto below = [&](unsigned count) { return static_cast<unsigned>(random() % count); };
  const std::vector<std::string> owners = {"-", "arm", "arm/tip", "leg"};
  for (int session = 0; session < 12; ++session) {
    std::vector<Said> all;
    std::array<unsigned, 2> sequences{};
    for (int i = 0; i < 150; ++i) {
      const unsigned source = below(2);
      const unsigned sequence = sequences[source]++;
      // Now and then one that is late; several at one time.
      std::string text = "RK1 s" + std::to_string(source) + " " +
                         std::to_string(below(9) == 0 ? sequence / 2 : sequence) + " -\n";
      for (unsigned line = 0; line <= below(3); ++line) {
        const std::string& owner = owners[below(4)];
        const std::string name(1, static_cast<char>('a' + below(5)));
        const unsigned kind = below(12);
        if (kind == 0) {
          text += "signal " + owner + " " + name + " default\n";
        } else if (kind == 1 && owner != "-") {
          text += "remove " + owner.substr(0, 3) + "\n";
        } else if (kind == 2) {
          text += "signal " + owner + " " + name + " \"t" + std::to_string(below(3)) + "\"\n";
        } else {
          text += "signals " + owner + " " + name + "=" + std::to_string(below(3)) + "\n";
        }
      }
      all.push_back({i / 2 * 10, text});
    }
    NotingFormat whole, news;
    whole.has_signals = news.has_signals = true;
    news.requests_all_signals = false;
    exported(all, whole);
    exported(all, news);
    EXPECT_EQ(newSignals(news.notes), newSignals(whole.notes)) << session;
    EXPECT_GT(news.notes.size(), 100U);
  }
}

TEST_F(MessageExport, AKeyframeSaysNoSignalAndHidesNone) {
  NotingFormat format;
  format.has_signals = true;
  std::vector<Said> all;
  std::vector<std::string> expected;
  constexpr std::int64_t kSecond = 1'000'000'000;
  for (int i = 0; i < 40; ++i) {
    const bool is_said = i % 3 != 1;
    all.push_back({i * kSecond, "RK1 s - -\n" + std::string(is_said ? "signals - a=1\n" : "") +
                                    "signals arm b=" + std::to_string(i) + "\n"});
    if (i == 0) all.back().text += "signal - mode \"auto\"\nsignal arm mode \"auto\"\n";
    const std::string time = std::to_string(i * kSecond) + (i == 0 ? " all" : "");
    if (is_said) expected.push_back(time + (i == 0 ? " signals - a! mode!" : " signals - a! mode"));
    expected.push_back(time + (i == 0 ? " signals arm b! mode!" : " signals arm b! mode"));
  }
  exported(all, format);
  // What a keyframe covers may hide that the same was said again, but no change.
  std::erase_if(expected, [&](const std::string& line) {
    return line.find(" signals - ") != line.npos && !std::ranges::count(format.notes, line);
  });
  EXPECT_GT(expected.size(), 60U);
  EXPECT_EQ(format.notes, expected);
}

TEST_F(MessageExport, SaysSpacesAgainWhereReadersForget) {
  NotingFormat format(Nanoseconds(100));
  exported({{0, "RK1 s 0 -\npose a 0 0 1 0 0 0 1\n"},
            {50, "RK1 s 1 -\nevent \"x\"\n"},
            {150, "RK1 s 2 -\nevent \"y\"\n"}},
           format);
  EXPECT_THAT(format.notes, ElementsAre("0 frames a in world", "50 event s x",
                                        "150 frames a in world", "150 event s y"));
}

TEST_F(MessageExport, DrawingsAreWholeAndEnd) {
  NotingFormat format;
  exported({{0, "RK1 s 0 -\nline p #ffffff 0 0 0 1 1 1\n"},
            {10, "RK1 s 1 -\nlabel q 0 0 0 \"hi\"\n"},
            {20, "RK1 s 2 -\nlabel q 0 0 0 \"hi\"\n"},
            {30, "RK1 s 3 -\nerase p\n"},
            {40, "RK1 t 0 -\nerase p\n"},
            {50, "RK1 s 4 -\nerase *\n"}},
           format);
  EXPECT_THAT(format.notes, ElementsAre("0 drawings s: p", "10 drawings s: p q", "30 drawings s: q",
                                        "50 drawings s:"));
}

TEST_F(MessageExport, ASourceThatRestartsHasDrawnNothing) {
  NotingFormat format;
  exported({{0, "RK1 s@1 0 -\nline p #ffffff 0 0 0 1 1 1\n"},
            {10, "RK1 s@1 1 -\nevent \"x\"\n"},
            {20, "RK1 s@2 0 - restated part=r:1/1\nlabel q 0 0 0 \"hi\"\n"}},
           format);
  EXPECT_THAT(format.notes, ElementsAre("0 drawings s: p", "10 event s x", "20 drawings s: q"));
}

TEST_F(MessageExport, TellsWhatIsLeftOut) {
  NotingFormat format;
  const std::vector<Said> all = {{0, "not a packet"},
                                 {10, "RK1 s 0 -\npose a 0 0 1 0 0 0 1 in b/c\nhide a\nhide b\n"}};
  const MessageExportReport report = exported(all, format);
  EXPECT_THAT(format.notes, ElementsAre("10 frames a in b/c"));
  EXPECT_THAT(report.gaps, ElementsAre(HasSubstr("1 datagram of /udp/test holds no packet"),
                                       HasSubstr("a is on a link")));
  EXPECT_EQ(accountSentence(report.left_out),
            "left out: 2 statements `hide` (the format has nothing for it)");
  EXPECT_THAT(exported(all, format, true).gaps, ElementsAre(HasSubstr("a is on a link")));
  ASSERT_TRUE(topics_.contains("/udp/test"));
  EXPECT_EQ(topics_.at("/udp/test").messages, 2U);
}

}  // namespace
}  // namespace rocinante
