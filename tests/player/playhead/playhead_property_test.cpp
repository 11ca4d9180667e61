// For any commands to a player, the receiver ends with the state of the log's fold, and every
// played span holds exactly its messages of the log.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>

#include "tests/core/packet/random_session.h"
#include "tests/player/playhead/deck.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::Deck;
using test::WrittenMessage;

/// A session of three sources that collide in everything, with moments of several messages, events,
/// and restatements by others.
std::vector<WrittenMessage> randomMessages(std::uint64_t seed, std::size_t count) {
  test::RandomSession session(seed);
  std::vector<WrittenMessage> messages;
  Nanoseconds last{};
  for (std::size_t i = 0; i < count; ++i) {
    const auto said = session.next();
    const auto time = Nanoseconds(static_cast<std::int64_t>(said.seconds * 1e9));
    const std::string source = said.text.substr(4, said.text.find_first_of("@ ", 4) - 4);
    const bool by_others = said.text.find(" by=") < said.text.find('\n');
    const std::string topic = (by_others ? "/rocinante/restated" : std::string()) + "/udp/1/" +
                              (source == "z%20z" ? "z z" : source);
    // Some have the same time as the previous one.
    last = session.below(4) == 0 ? std::max(last, 1ns) : time;
    messages.push_back({last, said.text, topic});
  }
  return messages;
}

std::string randomTime(std::int64_t milliseconds) { return std::to_string(milliseconds) + "ms"; }

rc::Gen<std::string> anyCommand() {
  using rc::gen::inRange;
  using rc::gen::just;
  using rc::gen::map;
  const auto number = [](const char* word) {
    return map(inRange(1, 40), [word](int n) { return std::string(word) + std::to_string(n); });
  };
  const auto time = [](const char* word, int most) {
    return map(inRange(0, most), [word](int ms) { return std::string(word) + randomTime(ms); });
  };
  return rc::gen::oneOf(
      just<std::string>("play"), just<std::string>("pause"), just<std::string>("toggle"),
      number("step "), number("back "), time("step ", 1'500), time("back ", 1'500),
      time("seek ", 6'000), just<std::string>("next"), just<std::string>("previous"),
      just<std::string>("faster"), just<std::string>("slower"), just<std::string>("loop off"),
      map(rc::gen::pair(inRange(0, 4'000), inRange(1, 2'000)),
          [](std::pair<int, int> loop) {
            return "loop " + randomTime(loop.first) + " " + randomTime(loop.first + loop.second);
          }),
      // Advances the time.
      map(inRange(0, 2'000), [](int ms) { return "wait " + std::to_string(ms); }));
}

/// The log's captured messages in order, with their places.
struct Told {
  TapePosition place;
  std::string payload;
};
std::vector<Told> allOf(const std::vector<std::filesystem::path>& paths) {
  MultiLogReader logs = MultiLogReader::open(paths).value();
  EXPECT_TRUE(logs.seek(TapePosition{}, MultiLogReader::Which::captured).ok());
  std::vector<Told> all;
  while (const auto message = logs.next().value()) {
    all.push_back({logs.place(), std::string(textOf(message->payload))});
  }
  return all;
}

/// Within a span, each message is followed by the very next one of the log.
void expectSpansWhole(const Deck& deck, const std::vector<Told>& all) {
  std::map<TapePosition, std::size_t> index;
  for (std::size_t i = 0; i < all.size(); ++i) index[all[i].place] = i;
  for (std::size_t i = 0; i < deck.dues().size(); ++i) {
    const Due& due = deck.dues()[i];
    RC_ASSERT(index.contains(due.place));
    RC_ASSERT(deck.payloads()[i] == all[index[due.place]].payload);
    RC_ASSERT(due.bounds.from <= due.place.time);
    RC_ASSERT(due.place.time < due.bounds.until);
    const bool follows = i > 0 && deck.dues()[i - 1].span == due.span;
    if (follows) RC_ASSERT(index[due.place] == index[deck.dues()[i - 1].place] + 1);
    // A new span leaves nothing out.
    if (!follows && index[due.place] > 0) {
      RC_ASSERT(all[index[due.place] - 1].place.time <= due.bounds.from);
    }
    if (due.after_turn && i > 0 && deck.dues()[i - 1].span + 1 == due.span) {
      const std::size_t last = index[deck.dues()[i - 1].place];
      // Both turns end alike; the previous message may have been sent under the earlier bounds.
      const LogTime until = due.bounds.until;
      // RC_ASSERT evaluates both sides of an "or".
      const bool at_its_end = last + 1 == all.size() || all[last + 1].place.time >= until;
      RC_ASSERT(at_its_end);
    }
  }
}

void checkCommands(const std::vector<std::filesystem::path>& logs,
                   const std::vector<std::string>& commands, PlayheadOptions options,
                   const ChannelChoice& choice = {}) {
  Deck deck(logs, options, choice);
  for (const std::string& command : commands) {
    if (command.starts_with("wait ")) {
      deck.playFor(std::stoi(command.substr(5)) * 1ms, 3'000);
    } else {
      const std::string answer = deck.say(command);
      RC_ASSERT(answer.starts_with("ok ") || answer.starts_with("error "));
    }
    const SessionState wanted = deck.finder().stateBefore(deck.playhead().place()).value();
    if (Deck::itemsOf(deck.receiver()) != Deck::itemsOf(wanted)) {
      RC_FAIL("after " + command + ":\n" + Deck::itemsOf(deck.receiver()) + "--- but the fold:\n" +
              Deck::itemsOf(wanted));
    }
  }
  if (choice.isAll()) expectSpansWhole(deck, allOf(logs));
}

RC_GTEST_PROP(PlayheadProperty, AnyCommandsLeadToTheStateOfTheFold, (std::uint32_t seed)) {
  const test::TemporaryFolder folder;
  const auto log = test::writeLog(folder / "log", randomMessages(seed, 150));
  const auto commands = *rc::gen::container<std::vector<std::string>>(anyCommand());
  PlayheadOptions options;
  options.start_paused = seed % 2 == 0;
  options.turns = seed % 3;
  if (seed % 5 == 0) options.gap_limit = 100ms;
  if (seed % 7 == 0) options.speed.reset();
  checkCommands({log}, commands, options);
}

RC_GTEST_PROP(PlayheadProperty, AlsoOfSeveralLogsAndOfChosenChannels, (std::uint32_t seed)) {
  const test::TemporaryFolder folder;
  const auto a = test::writeLog(folder / "a", randomMessages(seed, 80));
  const auto b = test::writeLog(folder / "b", randomMessages(seed + 1, 80));
  const auto commands = *rc::gen::container<std::vector<std::string>>(anyCommand());
  ChannelChoice choice;
  if (seed % 2 == 0) choice.muted = {"*/b"};
  if (seed % 3 == 0) choice.only = {"*/a", "*/b"};
  checkCommands({a, b}, commands, PlayheadOptions(), choice);
}

}  // namespace
}  // namespace rocinante
