#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "core/session/keyframe.h"
#include "core/session/timeline.h"
#include "tests/core/session/keyframed_log.h"
#include "tests/core/session/seconds_log.h"

namespace rocinante::test {
namespace {

/// Identifies a message in spite of damage: its position in the file changes when a chunk is lost.
using MessageName = std::tuple<std::int64_t, std::string, std::string>;  // time, topic, payload

struct NamedMessage {
  MessageName name;
  bool is_folded = false;
  bool is_keyframe = false;

  LogTime time() const { return LogTime(Nanoseconds(std::get<0>(name))); }
};

std::vector<NamedMessage> namedMessagesOf(LogReader reader) {
  std::vector<NamedMessage> messages;
  while (const auto message = reader.next().value()) {
    messages.push_back({{message->log_time.time_since_epoch().count(), message->channel->topic,
                         std::string(textOf(message->payload))},
                        message->channel->folded(),
                        isKeyframeChannel(*message->channel)});
  }
  return messages;
}

/// A timeline's answer at one moment.
struct Answer {
  std::string state;
  StateDamage damage;
  bool operator==(const Answer&) const = default;
};

Answer ask(Timeline& timeline, LogTime moment) {
  Answer answer;
  const Result<const SessionState*> state = timeline.stateAt(moment, &answer.damage);
  EXPECT_TRUE(state.ok());
  answer.state = (*state)->identityText();
  // Without the `damage` argument there is no damaged state.
  EXPECT_EQ(timeline.stateAt(moment).ok(), answer.damage.empty());
  return answer;
}

/// Damages a file in one of the usual ways.
Bytes damaged(Bytes file) {
  const auto size = static_cast<int>(file.size());
  const auto anyByte = [&] { return static_cast<std::size_t>(*rc::gen::inRange(8, size)); };
  switch (*rc::gen::inRange(0, 4)) {
    case 0: {  // bits
      const int flips = *rc::gen::inRange(1, 6);
      for (int i = 0; i < flips; ++i) {
        file[anyByte()] ^= static_cast<std::byte>(1U << *rc::gen::inRange(0U, 8U));
      }
      return file;
    }
    case 1: {  // a sector of zeros
      const std::size_t from = anyByte();
      const std::size_t to = std::min<std::size_t>(file.size(), from + 512);
      std::fill(file.begin() + static_cast<std::ptrdiff_t>(from),
                file.begin() + static_cast<std::ptrdiff_t>(to), std::byte{0});
      return file;
    }
    case 2:  // cut off
      file.resize(anyByte());
      file.shrink_to_fit();
      return file;
    default: {  // a piece is missing, so that the summary's offsets are wrong
      const std::size_t from = anyByte();
      const std::size_t to = std::min<std::size_t>(
          file.size(), from + static_cast<std::size_t>(*rc::gen::inRange(1, 20'000)));
      file.erase(file.begin() + static_cast<std::ptrdiff_t>(from),
                 file.begin() + static_cast<std::ptrdiff_t>(to));
      file.shrink_to_fit();
      return file;
    }
  }
}

/// When a state is damaged, computed from the messages of the sound log and those that are left.
class Oracle {
 public:
  Oracle(const std::vector<NamedMessage>& all, const std::vector<NamedMessage>& left) {
    std::multiset<MessageName> there;
    for (const NamedMessage& message : left) there.insert(message.name);
    for (const NamedMessage& message : all) {
      const auto found = there.find(message.name);
      const bool is_lost = found == there.end();
      if (!is_lost) there.erase(found);
      order_.push_back({message.time(), is_lost, message.is_folded, message.is_keyframe});
    }
  }

  /// A folded message is missing behind the last remaining keyframe.
  bool lacks(LogTime moment) const {
    bool lacks = false;
    for (const Message& message : order_) {
      if (message.time > moment) break;
      if (message.is_keyframe && !message.is_lost) lacks = false;
      if (message.is_folded && message.is_lost) lacks = true;
    }
    return lacks;
  }
  /// A remaining keyframe is behind everything lost, and not after the moment. `unknown` are the
  /// times of bytes that may have held anything: messages that the sound log never had, too.
  bool isMended(LogTime moment, const std::vector<UnreadableRange>& unknown) const {
    std::optional<LogTime> by;
    for (const Message& message : order_) {
      if (message.is_lost) by.reset();
      if (message.is_keyframe && !message.is_lost && message.time <= moment) by = message.time;
    }
    return by && std::ranges::none_of(unknown, [&](const UnreadableRange& range) {
             return range.first.time <= moment && range.last.time >= *by;
           });
  }
  bool lostAny() const { return std::ranges::any_of(order_, &Message::is_lost); }

 private:
  struct Message {
    LogTime time;
    bool is_lost, is_folded, is_keyframe;
  };
  std::vector<Message> order_;
};

RC_GTEST_PROP(TimelineDamage, IsToldTheSameAloneInOrderAndShuffledAndNeverForgotten, ()) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(1, 40);
  const KeyframedLog log = makeKeyframedLog(seed, 60);
  const Bytes file = damaged(log.file);
  Result<LogReader> opened = LogReader::openBytes(file, "damaged.mcap");
  if (!opened) return;  // nothing in it can be read as a log
  const std::vector<NamedMessage> left = namedMessagesOf(std::move(*opened));
  const Oracle oracle(namedMessagesOf(openLog(log.file)), left);
  Timeline whole = Timeline::of(openLog(file));
  StateDamage ignored;
  RC_ASSERT(whole.events(&ignored).ok());  // reads all of it
  // Bytes that are not a record may have been anything: only damage that is known to have cost
  // nothing counts.
  const auto costNothing = [&](const DamageSpan& each) {
    return each.messages_lost == std::uint64_t{0} || each.to == file.size();
  };
  const bool cost_nothing = std::ranges::all_of(whole.log().damage(), costNothing);
  std::vector<UnreadableRange> unknown = whole.log().unreadable();
  std::erase_if(unknown, [&](const UnreadableRange& range) {
    const DamageSpan& its = whole.log().damage()[range.damage];
    // The indexes of a chunk say what it held; one without its chunk only what there may have been.
    return costNothing(its) || (its.messages_lost && its.cause.starts_with("the chunk"));
  });
  RC_ASSERT(!cost_nothing || !oracle.lostAny() || !whole.log().summary().complete);

  std::vector<LogTime> moments;
  for (std::size_t i = 0; i < log.datagrams.size(); i += 1 + seed % 5) {
    moments.push_back(log.datagrams[i].time);
  }
  moments.push_back(log.datagrams.back().time);
  Timeline sound = Timeline::of(openLog(log.file));
  const bool any_left = whole.log().summary().messages > 0;
  // A keyframe may be the last that is left: end() counts what was captured.
  const LogTime last = left.empty() ? whole.end() : left.back().time();
  std::map<LogTime, Answer> alone;
  for (const LogTime moment : moments) {
    Timeline timeline = Timeline::of(openLog(file));
    const Answer answer = ask(timeline, moment);
    const bool is_told = !answer.damage.empty();
    // A cut file may have only one of two messages of the last moment.
    if (moment != last && oracle.lacks(moment)) RC_ASSERT(is_told);
    // With keyframes of two channels, as a broken summary may invent them, none is used.
    const bool is_mended = oracle.isMended(moment, unknown) && timeline.keyframeFaults().empty();
    if (is_mended || (cost_nothing && any_left && moment <= last)) RC_ASSERT(!is_told);
    if (!is_told && moment != last) RC_ASSERT(answer.state == ask(sound, moment).state);
    alone.emplace(moment, answer);
  }
  Timeline one = Timeline::of(openLog(file));
  for (const LogTime moment : moments) RC_ASSERT(ask(one, moment) == alone[moment]);
  std::ranges::reverse(moments);
  for (const LogTime moment : moments) RC_ASSERT(ask(one, moment) == alone[moment]);
  std::ranges::shuffle(moments, std::mt19937_64(seed));
  for (const LogTime moment : moments) RC_ASSERT(ask(one, moment) == alone[moment]);
  Timeline another = Timeline::of(openLog(file));
  for (const LogTime moment : moments) RC_ASSERT(ask(another, moment) == alone[moment]);
  // Other reads make no difference.
  StateDamage hiding;
  RC_ASSERT(another.events(&hiding).ok());
  for (const LogTime moment : moments) RC_ASSERT(ask(another, moment) == alone[moment]);
}

TEST(TimelineDamage, LastsUntilTheNextKeyframe) {
  SecondsLog log({0, 6});
  log.spoil(3);
  EXPECT_FALSE(log.isToldAt(2000));
  EXPECT_TRUE(log.isToldAt(3500));
  EXPECT_TRUE(log.isToldAt(5900));
  EXPECT_FALSE(log.isToldAt(6000));
  EXPECT_FALSE(log.isToldAt(9900));
}

TEST(TimelineDamage, OfAKeyframeReachesBackToTheOneBefore) {
  SecondsLog log({0, 6});
  log.spoil(3);
  log.spoil(6);  // with the keyframe in its chunk
  EXPECT_FALSE(log.isToldAt(2000));
  EXPECT_TRUE(log.isToldAt(9900));
  Timeline timeline = Timeline::of(openLog(log.file));
  StateDamage damage;
  ASSERT_TRUE(timeline.stateAt(SecondsLog::moment(9900), &damage).ok());
  EXPECT_EQ(damage.parts().size(), 2U);
}

TEST(TimelineDamage, WithoutKeyframesNeverEnds) {
  SecondsLog log({});
  log.spoil(3);
  EXPECT_FALSE(log.isToldAt(2000));
  EXPECT_TRUE(log.isToldAt(9900));
}

TEST(TimelineDamage, SaysWhereItIsAndWhatItMeans) {
  SecondsLog log({0});
  log.spoil(3);
  Timeline timeline = Timeline::of(openLog(log.file));
  const auto state = timeline.stateAt(SecondsLog::moment(5000));
  ASSERT_FALSE(state.ok());
  EXPECT_EQ(state.error().kind, ErrorKind::damaged);
  EXPECT_THAT(state.error().text(),
              ::testing::MatchesRegex("the state at 5.000 s is not known: the log is damaged from "
                                      "3\\.[0-9]+ to 3\\.[0-9]+ s: .* checksum.*"));
}

TEST(TimelineDamage, OfALogThatWasCutIsBehindItsEnd) {
  SecondsLog log({0});
  log.file.resize(log.file.size() / 2);
  log.file.shrink_to_fit();
  Timeline timeline = Timeline::of(openLog(log.file));
  EXPECT_TRUE(timeline.stateAt(timeline.end()).ok());
  EXPECT_FALSE(timeline.stateAt(timeline.end() + Nanoseconds(1)).ok());
}

TEST(TimelineDamage, WithoutOneMessageThatCanBeReadIsEverywhere) {
  SecondsLog log({0});
  for (int second = 0; second < 10; ++second) {
    // Breaks every chunk of the second; there may be two.
    const std::string text = "joint arm a=" + std::to_string(second);
    for (auto from = log.file.begin();;) {
      from = std::search(from, log.file.end(), bytesOf(text).begin(), bytesOf(text).end());
      if (from == log.file.end()) break;
      *from++ ^= std::byte{1};
    }
  }
  for (const int moment : {0, 100, 5000, 9900}) EXPECT_TRUE(log.isToldAt(moment)) << moment;
  // Also for one that ends after its header.
  log.file.resize(60);
  log.file.shrink_to_fit();
  EXPECT_TRUE(log.isToldAt(0));
}

TEST(TimelineDamage, ThatCostNoMessageIsNone) {
  SecondsLog log({0});
  log.file[log.file.size() - 40] ^= std::byte{1};  // in the summary
  Timeline timeline = Timeline::of(openLog(log.file));
  EXPECT_FALSE(timeline.log().damage().empty());
  EXPECT_TRUE(timeline.stateAt(SecondsLog::moment(9900)).ok());
  EXPECT_TRUE(timeline.events().ok());
}

TEST(TimelineDamage, HidesEventsAndIsToldOfAWholeSpan) {
  SecondsLog log({0, 6});
  log.spoil(3);
  Timeline timeline = Timeline::of(openLog(log.file));
  EXPECT_FALSE(timeline.events().ok());
  StateDamage hiding;
  ASSERT_TRUE(timeline.events(&hiding).ok());
  EXPECT_EQ(hiding.parts().size(), 1U);
  EXPECT_TRUE(hiding.within(std::chrono::seconds(5), std::chrono::seconds(9)).empty());
  EXPECT_FALSE(hiding.within(std::chrono::seconds(3), std::chrono::seconds(9)).empty());

  Timeline fresh = Timeline::of(openLog(log.file));
  StateDamage before, across, behind;
  ASSERT_TRUE(fresh.addDamage(SecondsLog::moment(0), SecondsLog::moment(2000), before).ok());
  ASSERT_TRUE(fresh.addDamage(SecondsLog::moment(1000), SecondsLog::moment(9000), across).ok());
  ASSERT_TRUE(fresh.addDamage(SecondsLog::moment(7000), SecondsLog::moment(9000), behind).ok());
  EXPECT_TRUE(before.empty());
  EXPECT_EQ(across.parts().size(), 1U);
  EXPECT_TRUE(behind.empty());
  EXPECT_TRUE(fresh.stateAt(SecondsLog::moment(7000)).ok());
}

TEST(TimelineDamage, OfManyStatesIsTheirUnionInAnyOrder) {
  StateDamage forwards, backwards;
  const auto part = [](int i) {
    return StateDamage::Part{"a.mcap", static_cast<std::uint64_t>(i), 0, {}, {}, "gone"};
  };
  for (int i = 0; i < 250; ++i) forwards.add(part(i));
  for (int i = 250; i-- > 0;) backwards.add(part(i));
  backwards.add(forwards);
  EXPECT_EQ(forwards, backwards);
  EXPECT_EQ(forwards.parts().size(), 100U);
  EXPECT_THAT(forwards.text(), ::testing::HasSubstr("in more than 100 places"));
}

}  // namespace
}  // namespace rocinante::test
