// Properties of every statement and every session, not only of chosen examples.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/packet/fold_text.h"
#include "tests/core/packet/random_session.h"

namespace rocinante {
namespace {

using test::RandomSession;
using test::TextFold;

/// Names with any UTF-8 allowed in a name, biased to the bytes that matter.
rc::Gen<std::string> name() {
  const auto piece = rc::gen::element<std::string>("a", "Z", "0", "_", ".", "-", ":", "/", "%", "@",
                                                   "=", " ", "#", "\"", "*", "\xC3\xA9",
                                                   "\xF0\x9F\xA6\xBE", "layer", "in", "default");
  return rc::gen::map(
      rc::gen::resize(6, rc::gen::nonEmpty(rc::gen::container<std::vector<std::string>>(piece))),
      [](const std::vector<std::string>& pieces) {
        std::string text;
        for (const std::string& part : pieces) text += part;
        return text;
      });
}

rc::Gen<std::string> text() {
  return rc::gen::map(rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
                          "a", " ", "\"", "\\", "\n", "\t", "n", "\xC3\xA9", "\xE2\x82\xAC", "#")),
                      [](const std::vector<std::string>& pieces) {
                        std::string joined;
                        for (const std::string& part : pieces) joined += part;
                        return joined;
                      });
}

/// Any finite double, by its bits.
rc::Gen<double> number() {
  return rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t bits) {
    const double value = std::bit_cast<double>(bits);
    return std::isfinite(value) ? value : static_cast<double>(bits) / 1024;
  });
}

rc::Gen<double> positive() {
  return rc::gen::map(number(), [](double value) { return value == 0 ? 1.0 : std::abs(value); });
}

/// A statement with storage for its views.
struct OwnedStatement {
  std::vector<std::string> strings;
  std::vector<std::string_view> names;
  std::vector<double> numbers;
  std::vector<SignalKind> kinds;
  Statement statement;

  std::string_view keep(std::string string) {
    strings.push_back(std::move(string));
    return strings.back();
  }
};

PathView makeCarrier(OwnedStatement& owned) {
  if (*rc::gen::arbitrary<bool>()) return {};
  return {owned.keep(*name()), owned.keep(*name()), false};
}

std::vector<double> numbersOf(std::size_t count) {
  return *rc::gen::container<std::vector<double>>(count, number());
}

void makeSignals(OwnedStatement& owned) {
  Statement& s = owned.statement;
  const bool is_one = s.kind == StatementKind::signal;
  if (*rc::gen::inRange(0, 4) > 0) s.path.first = owned.keep(*name());
  if (!s.path.first.empty() && *rc::gen::arbitrary<bool>()) s.path.second = owned.keep(*name());
  owned.names.push_back(owned.keep(*name()));
  s.is_default = is_one && *rc::gen::inRange(0, 6) == 0;
  if (s.is_default) return;
  while (!is_one && owned.names.size() < 6 && *rc::gen::arbitrary<bool>()) {
    owned.names.push_back(owned.keep(*name()));
  }
  for (std::size_t i = 0; i < owned.names.size(); ++i) {
    const auto kind = static_cast<SignalKind>(*rc::gen::inRange(0, is_one ? 3 : 2));
    owned.kinds.push_back(kind);
    owned.numbers.push_back(kind == SignalKind::number    ? *number()
                            : kind == SignalKind::boolean ? *rc::gen::inRange(0, 2)
                                                          : 0);
  }
  if (owned.kinds[0] == SignalKind::text) s.text = owned.keep(*text());
  const bool has_unit = is_one && owned.kinds[0] == SignalKind::number;
  if (has_unit && *rc::gen::arbitrary<bool>())
    s.unit = owned.keep(*rc::gen::element<std::string>("kg", "N.m", "%", "m/s"));
  s.signal_kinds = owned.kinds;
}

void makeStatement(OwnedStatement& owned) {
  owned.strings.reserve(64);
  Statement& s = owned.statement;
  s.kind = static_cast<StatementKind>(*rc::gen::inRange(0, 18));
  s.line = 2;
  const auto some = [] { return static_cast<std::size_t>(*rc::gen::inRange(1, 9)); };
  if (s.kind != StatementKind::event && s.kind != StatementKind::show &&
      s.kind != StatementKind::hide && s.kind != StatementKind::color && !isSignal(s.kind)) {
    s.name = owned.keep(*name());
  }
  switch (s.kind) {
    case StatementKind::joints:
      owned.numbers = numbersOf(some());
      if (*rc::gen::arbitrary<bool>()) s.order_tag = *rc::gen::arbitrary<std::uint32_t>();
      break;
    case StatementKind::order:
      for (std::size_t i = some() - 1; i > 0; --i) owned.names.push_back(owned.keep(*name()));
      break;
    case StatementKind::joint:
      for (std::size_t i = some(); i > 0; --i) owned.names.push_back(owned.keep(*name()));
      owned.numbers = numbersOf(owned.names.size());
      break;
    case StatementKind::pose:
      owned.numbers = numbersOf(3);
      owned.numbers.insert(owned.numbers.end(), {0.5, -0.5, 0.5, -0.5});
      s.carrier = makeCarrier(owned);
      break;
    case StatementKind::add:
      s.text = owned.keep(*name());
      if (*rc::gen::arbitrary<bool>()) s.kinematics = *rc::gen::arbitrary<std::uint64_t>();
      break;
    case StatementKind::show:
    case StatementKind::hide:
    case StatementKind::color:
      s.path.is_layer = *rc::gen::arbitrary<bool>();
      s.path.first = s.path.is_layer ? "layer" : owned.keep(*name());
      if (s.path.is_layer || *rc::gen::arbitrary<bool>()) s.path.second = owned.keep(*name());
      if (s.kind != StatementKind::hide) s.is_default = *rc::gen::arbitrary<bool>();
      if (s.kind == StatementKind::color && !s.is_default) {
        s.rgba = *rc::gen::arbitrary<std::uint32_t>();
      }
      break;
    case StatementKind::line:
    case StatementKind::points:
      s.rgba = *rc::gen::arbitrary<std::uint32_t>();
      s.part_count = static_cast<std::uint32_t>(*rc::gen::inRange(1, 4097));
      s.part_index = static_cast<std::uint32_t>(*rc::gen::inRange(1, int(s.part_count) + 1));
      if (*rc::gen::arbitrary<bool>()) s.size_px = *positive();
      s.carrier = makeCarrier(owned);
      owned.numbers = numbersOf(3 * some());
      break;
    case StatementKind::label:
      s.carrier = makeCarrier(owned);
      owned.numbers = numbersOf(3);
      s.text = owned.keep(*text());
      break;
    case StatementKind::erase:
      if (*rc::gen::arbitrary<bool>()) s.name = {};
      break;
    case StatementKind::event:
      s.text = owned.keep(*text());
      break;
    case StatementKind::view:
      owned.numbers = numbersOf(6);
      if (owned.numbers[0] == owned.numbers[3]) owned.numbers[3] = owned.numbers[0] + 1;
      if (owned.numbers[0] == owned.numbers[3]) owned.numbers[3] = 0;
      owned.numbers.insert(owned.numbers.end(), {45.5, *number(), *number(), *positive()});
      if (*rc::gen::arbitrary<bool>()) s.ortho_height_m = *positive();
      s.carrier = makeCarrier(owned);
      break;
    case StatementKind::signal:
    case StatementKind::signals:
      makeSignals(owned);
      break;
    case StatementKind::remove:
      break;
    case StatementKind::seen:
      s.seen_ns = *rc::gen::inRange<std::int64_t>(0, INT64_MAX);
      break;
  }
  s.names = owned.names;
  s.numbers = owned.numbers;
}

void expectSame(const PathView& a, const PathView& b) {
  RC_ASSERT(a.first == b.first);
  RC_ASSERT(a.second == b.second);
  RC_ASSERT(a.is_layer == b.is_layer);
}

RC_GTEST_PROP(AnyStatement, WrittenAndReadIsTheSame, ()) {
  OwnedStatement owned;
  makeStatement(owned);
  const Statement& s = owned.statement;
  const std::string datagram = "RK1 me - -\n" + statementText(s);
  RC_LOG() << datagram;
  PacketTextDecoder decoder;
  const Packet* const packet = decoder.decode(bytesOf(datagram));
  RC_ASSERT(packet != nullptr);
  RC_ASSERT(packet->faults.empty());
  RC_ASSERT(packet->statements.size() == 1U);
  const Statement& read = packet->statements[0];
  RC_ASSERT(read.kind == s.kind);
  RC_ASSERT(read.line == s.line);
  RC_ASSERT(read.name == s.name);
  expectSame(read.path, s.path);
  expectSame(read.carrier, s.carrier);
  RC_ASSERT(read.text == s.text);
  RC_ASSERT(
      std::equal(read.numbers.begin(), read.numbers.end(), s.numbers.begin(), s.numbers.end()));
  RC_ASSERT(std::equal(read.names.begin(), read.names.end(), s.names.begin(), s.names.end()));
  RC_ASSERT(std::equal(read.signal_kinds.begin(), read.signal_kinds.end(), s.signal_kinds.begin(),
                       s.signal_kinds.end()));
  RC_ASSERT(read.unit == s.unit);
  RC_ASSERT(read.kinematics == s.kinematics);
  RC_ASSERT(read.order_tag == s.order_tag);
  RC_ASSERT(read.rgba == s.rgba);
  RC_ASSERT(read.is_default == s.is_default);
  RC_ASSERT(read.size_px == s.size_px);
  RC_ASSERT(read.ortho_height_m == s.ortho_height_m);
  RC_ASSERT(read.part_index == s.part_index);
  RC_ASSERT(read.part_count == s.part_count);
  RC_ASSERT(read.seen_ns == s.seen_ns);
}

RestatementOptions keyframe(std::size_t mtu_bytes) {
  RestatementOptions options;
  options.by = "keyframe";
  options.part_id = "k";
  options.with_seen = true;
  options.mtu_bytes = mtu_bytes;
  return options;
}

void foldSome(TextFold& fold, RandomSession& session, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const RandomSession::Datagram datagram = session.next();
    fold.fold(datagram.seconds, datagram.text);
  }
}

RC_GTEST_PROP(AnySession, AKeyframeIsTheStateExactly, (std::uint64_t seed)) {
  RandomSession session(seed);
  TextFold fold;
  foldSome(fold, session, session.below(300));
  const SessionState& state = fold.state;
  TextFold fresh;
  fresh.foldAll(1e6, restateAll(state, keyframe(session.below(2) == 0 ? 1200 : 90)));
  RC_ASSERT(fresh.state.identityText() == state.identityText());
  RC_ASSERT(fresh.state.sameAs(state));
  RC_ASSERT(fresh.state.weight() == state.weight());
}

RC_GTEST_PROP(AnySession, GoingOnFromAKeyframeIsGoingOn, (std::uint64_t seed)) {
  RandomSession session(seed);
  TextFold fold;
  foldSome(fold, session, session.below(200));
  // Keyframes are only written while no restatement is unfinished.
  while (fold.state.restatementOpen()) {
    const RandomSession::Datagram datagram = session.next();
    fold.fold(datagram.seconds, datagram.text);
  }
  TextFold fresh;
  fresh.foldAll(1e3, restateAll(fold.state, keyframe(1200)));
  for (int i = 0; i < 100; ++i) {
    const RandomSession::Datagram datagram = session.next();
    RC_ASSERT(fold.fold(1e3 + datagram.seconds, datagram.text) ==
              fresh.fold(1e3 + datagram.seconds, datagram.text));
  }
  RC_ASSERT(fresh.state.identityText() == fold.state.identityText());
}

RC_GTEST_PROP(AnySession, RestatingIntoTheSameStateChangesNothing, (std::uint64_t seed)) {
  RandomSession session(seed);
  TextFold fold;
  foldSome(fold, session, session.below(300));
  const SessionState before = fold.state;
  fold.foldAll(1e6, restateAll(before, keyframe(300)));
  RC_ASSERT(fold.state.identityText() == before.identityText());
}

RC_GTEST_PROP(AnySession, GoingBackTakesLaterThingsAway, (std::uint64_t seed)) {
  RandomSession session(seed);
  TextFold fold;
  foldSome(fold, session, session.below(100));
  const SessionState earlier = fold.state;
  for (int i = 0; i < 100; ++i) {
    const RandomSession::Datagram datagram = session.next();
    fold.fold(datagram.seconds, datagram.text);
  }
  RestatementOptions options = keyframe(300);
  options.reset = true;
  const SessionState later = fold.state;
  fold.foldAll(1e6, restateAll(earlier, options));
  TextFold expected;
  expected.state = earlier;
  for (const auto& [name, source] : later.sources()) {
    if (earlier.sources().count(name) != 0) continue;
    const std::vector<std::string> parts = restate(earlier, name, options);
    fold.foldAll(1e6, parts);
    expected.foldAll(1e6, parts);
  }
  RC_ASSERT(fold.state.identityText() == expected.state.identityText());
}

RC_GTEST_PROP(AnySession, ACopyIsAStateOfItsOwn, (std::uint64_t seed)) {
  RandomSession session(seed);
  TextFold fold;
  foldSome(fold, session, session.below(100));
  TextFold copy;
  copy.state = fold.state;
  for (int i = 0; i < 50; ++i) {
    const RandomSession::Datagram datagram = session.next();
    fold.fold(datagram.seconds, datagram.text);
    copy.fold(datagram.seconds, datagram.text);
  }
  RC_ASSERT(copy.state.identityText() == fold.state.identityText());
  RC_ASSERT(copy.state.sameAs(fold.state));
}

RC_GTEST_PROP(AnySession, SameIdentityTextMeansSameState, (std::uint64_t seed)) {
  RandomSession session(seed);
  TextFold fold;
  foldSome(fold, session, session.below(30));
  TextFold other;
  other.state = fold.state;
  const RandomSession::Datagram datagram = session.next();
  other.fold(datagram.seconds, datagram.text);
  RC_ASSERT((other.state.identityText() == fold.state.identityText()) ==
            other.state.sameAs(fold.state));
}

RC_GTEST_PROP(AnySession, OneStatementADatagramIsTheSameAsManyForItsItems, (std::uint64_t seed)) {
  RandomSession session(seed);
  TextFold whole;
  TextFold split;
  for (int i = 0; i < 60; ++i) {
    const std::string text = session.next().text;
    const std::size_t body = text.find('\n') + 1;
    whole.fold(i, "RK1 s - -\n" + text.substr(body));
    for (std::size_t at = body; at < text.size();) {
      const std::size_t next = text.find('\n', at) + 1;
      split.fold(i, "RK1 s - -\n" + text.substr(at, next - at));
      at = next;
    }
    if (body == text.size()) split.fold(i, "RK1 s - -\n");
  }
  RC_ASSERT(split.state.identityText() == whole.state.identityText());
}

}  // namespace
}  // namespace rocinante
