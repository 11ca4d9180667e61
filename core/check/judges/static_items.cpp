#include "core/check/judges/static_items.h"

#include <algorithm>
#include <functional>
#include <string_view>

namespace rocinante {
namespace {

std::size_t hashOf(std::string_view text) { return std::hash<std::string_view>{}(text); }

std::size_t deviceOf(const Statement& statement) {
  if (isOfPath(statement.kind) || isSignal(statement.kind)) {
    return statement.path.is_layer ? 0 : hashOf(statement.path.first);
  }
  return hashOf(statement.name);
}

/// What the statement sets, of signals the one of this name: `hide` and `show` set the same, and so
/// do `signal` and `signals`.
std::size_t keyOf(const Statement& statement, std::string_view signal) {
  const StatementKind kind = statement.kind == StatementKind::hide      ? StatementKind::show
                             : statement.kind == StatementKind::signals ? StatementKind::signal
                                                                        : statement.kind;
  std::size_t key = static_cast<std::size_t>(kind) + 1;
  const auto mix = [&](std::size_t part) { key = key * 0x9E3779B97F4A7C15U + part; };
  mix(deviceOf(statement));
  mix(statement.path.is_layer ? 1 : 0);
  mix(hashOf(statement.path.second));
  mix(statement.part_index);
  mix(hashOf(signal));
  return key;
}

}  // namespace

bool StaticItems::isStatic(const Statement& statement) {
  const StatementKind kind = statement.kind;
  if (isSignal(kind)) return hasStateSignal(statement);
  return !isDeviceValue(kind) && kind != StatementKind::event && kind != StatementKind::seen;
}

void StaticItems::take(const Statement& statement, LogTime time) {
  if (statement.kind == StatementKind::remove || statement.kind == StatementKind::erase) {
    return forget(statement);
  }
  if (!isSignal(statement.kind)) {
    if (isStatic(statement)) take(statement, {}, time);
    return;
  }
  for (std::size_t i = 0; i < statement.names.size(); ++i) {
    if (!statement.is_default && statement.signal_kinds[i] != SignalKind::number) {
      take(statement, statement.names[i], time);
    } else if (!items_.empty()) {
      items_.erase(keyOf(statement, statement.names[i]));
    }
  }
}

void StaticItems::take(const Statement& statement, std::string_view signal, LogTime time) {
  const std::size_t key = keyOf(statement, signal);
  const auto known = items_.find(key);
  if (known != items_.end()) {
    known->second.stated_at = time;
  } else if (items_.size() < kMaxItems) {
    items_.emplace(key, Item{isDrawing(statement.kind) ? 0 : deviceOf(statement), time});
  } else {
    is_full_ = true;
  }
}

// A drawing may have gone by its time or by `erase`: its parts are forgotten with all others.
void StaticItems::forget(const Statement& statement) {
  const std::size_t device = statement.kind == StatementKind::erase ? 0 : hashOf(statement.name);
  std::erase_if(items_, [&](const auto& each) { return each.second.device == device; });
}

std::optional<LogTime> StaticItems::oldest() const {
  if (items_.empty() || is_full_) return std::nullopt;
  return std::ranges::min_element(items_, {},
                                  [](const auto& each) { return each.second.stated_at; })
      ->second.stated_at;
}

}  // namespace rocinante
