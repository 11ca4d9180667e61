#include "core/relay/paced_statements.h"

#include <algorithm>
#include <utility>

#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

/// Of a statement that waits, beside its bytes: so empty ones are bounded too.
constexpr std::size_t kStatementCost = 128;

}  // namespace

PacedCounts& PacedCounts::operator+=(const PacedCounts& others) {
  waiting += others.waiting;
  most += others.most;
  dropped += others.dropped;
  return *this;
}

std::size_t PacedStatements::bytesOf(const Waiting& waiting) {
  return kStatementCost + waiting.source.size() + waiting.text.size();
}

void PacedStatements::add(std::string_view source, const Statement& statement) {
  Waiting waiting{std::string(source), statementText(statement) + '\n'};
  const std::size_t bytes = bytesOf(waiting);
  if (statement.kind == StatementKind::event) {
    if (!hasRoom(bytes)) {
      ++dropped_;
      return;
    }
    bytes_ += bytes;
    events_.push_back(std::move(waiting));
    noteMost();
    return;
  }
  Subject subject = subjectOf(source, statement);
  const bool is_state = isSignal(statement.kind);
  const auto older = about_.find(subject);
  if (older != about_.end() && older->second.size() >= (is_state ? kMaxStates : 1)) {
    dropped_ += is_state ? 1 : 0;
    erase(older->second.back());
  }
  if (!hasRoom(bytes)) {
    ++dropped_;
    return;
  }
  bytes_ += bytes;
  about_[subject].push_back(++came_);
  changes_.emplace(came_, std::pair(std::move(waiting), std::move(subject)));
  noteMost();
}

/// A device is removed and a signal set whoever says so; drawings and orders are a SOURCE's own.
PacedStatements::Subject PacedStatements::subjectOf(std::string_view source,
                                                    const Statement& statement) {
  if (isSignal(statement.kind)) {
    const PathView& path = statement.path;
    std::string item = encodeName(path.first) + '/' + encodeName(path.second) + ' ';
    item += statement.names.front();
    return {StatementKind::signal, {}, std::move(item)};
  }
  const bool of_source = statement.kind != StatementKind::remove;
  return {statement.kind, std::string(of_source ? source : std::string_view()),
          std::string(statement.name)};
}

void PacedStatements::erase(std::uint64_t change) {
  const auto waiting = changes_.find(change);
  bytes_ -= bytesOf(waiting->second.first);
  const auto about = about_.find(waiting->second.second);
  std::erase(about->second, change);
  if (about->second.empty()) about_.erase(about);
  changes_.erase(waiting);
}

RelayDraft PacedStatements::takeEvents(const RoomFor& room) {
  RelayDraft draft{events_.front().source, {}, {}, true};
  const std::size_t most = room(draft.source);
  do {
    bytes_ -= bytesOf(events_.front());
    draft.text += events_.front().text;
    events_.pop_front();
  } while (!events_.empty() && events_.front().source == draft.source &&
           draft.text.size() + events_.front().text.size() <= most);
  return draft;
}

RelayDraft PacedStatements::takeChanges(const RoomFor& room) {
  RelayDraft draft{changes_.begin()->second.first.source, {}, {}};
  const std::size_t most = room(draft.source);
  do {
    draft.text += changes_.begin()->second.first.text;
    erase(changes_.begin()->first);
  } while (!changes_.empty() && changes_.begin()->second.first.source == draft.source &&
           draft.text.size() + changes_.begin()->second.first.text.size() <= most);
  return draft;
}

void PacedStatements::noteMost() {
  most_ = std::max<std::uint64_t>(most_, events_.size() + changes_.size());
}

PacedCounts PacedStatements::counts() const {
  return {events_.size() + changes_.size(), most_, dropped_};
}

}  // namespace rocinante
