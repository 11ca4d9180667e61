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
  // A device is removed whoever asks; drawings and orders are a SOURCE's own.
  const bool of_source = statement.kind != StatementKind::remove;
  Subject subject(statement.kind, of_source ? source : std::string_view(), statement.name);
  if (const auto older = newest_.find(subject); older != newest_.end()) {
    const auto change = changes_.find(older->second);
    bytes_ -= bytesOf(change->second.first);
    changes_.erase(change);
    newest_.erase(older);
  }
  if (!hasRoom(bytes)) {
    ++dropped_;
    return;
  }
  bytes_ += bytes;
  newest_.emplace(subject, ++came_);
  changes_.emplace(came_, std::pair(std::move(waiting), std::move(subject)));
  noteMost();
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
    const auto& [waiting, subject] = changes_.begin()->second;
    bytes_ -= bytesOf(waiting);
    draft.text += waiting.text;
    newest_.erase(subject);
    changes_.erase(changes_.begin());
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
