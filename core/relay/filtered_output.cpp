#include "core/relay/filtered_output.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

/// What a slow link may be given at once beyond one datagram makes up for a late wake-up. More
/// would wait in front of the link for good: whatever comes through it would be older by that.
constexpr double kBurstSeconds = 0.01;
/// On a slow link, how many other datagrams go before each one of a restatement.
constexpr int kLiveForEachRestated = 5;
constexpr std::size_t kMaxRepeatedErases = 4096;
constexpr int kErasesAgain = 2;  ///< three in all
constexpr Nanoseconds kEraseAgain = std::chrono::seconds(1);

}  // namespace

bool RelayOutputOptions::isWhole() const {
  const bool all = std::all_of(filters.begin(), filters.end(),
                               [](const RelayFilter& filter) { return filter.passesEverything(); });
  return all && !pacing.interval && !pacing.min_change.any() && !bytes_per_second;
}

FilteredOutput::FilteredOutput(OutputHeader header, RelayOutputOptions options, LogTime now)
    : header_(std::move(header)), options_(std::move(options)), pending_(options_.pacing) {
  if (!options_.bytes_per_second) return;
  style_.rounded = style_.by_order = true;
  const double rate = *options_.bytes_per_second;
  bucket_.emplace(rate, rate * kBurstSeconds, now);
}

std::size_t FilteredOutput::roomFor(const Step& step, std::string_view source) const {
  const std::size_t header = header_.mostBytes(source, step.state, step.through);
  return datagramBytes() - std::min(datagramBytes(), header);
}

bool FilteredOutput::passesImmediate(std::string_view source, const Statement& statement) const {
  const bool of_device =
      statement.kind == StatementKind::order || statement.kind == StatementKind::remove;
  const std::string_view device = of_device                  ? statement.name
                                  : isSignal(statement.kind) ? statement.path.first
                                                             : std::string_view();
  return std::all_of(options_.filters.begin(), options_.filters.end(), [&](const auto& filter) {
    return filter.passesKind(statement.kind) && filter.passesSource(source) &&
           (device.empty() || filter.passesDevice(device));
  });
}

FilteredOutCounts& FilteredOutCounts::operator+=(const FilteredOutCounts& others) {
  stopped += others.stopped;
  signals += others.signals;
  held += others.held;
  unreadable += others.unreadable;
  return *this;
}

FilteredOutCounts FilteredOutput::filteredOut() const {
  FilteredOutCounts counts = filtered_out_;
  counts.held = pending_.held();
  return counts;
}

bool FilteredOutput::passesSignal(const PathView& path, std::string_view name) const {
  return std::all_of(options_.filters.begin(), options_.filters.end(), [&](const auto& filter) {
    return filter.signals.empty() || filter.passesSignal(signalText(signalKey(path, name)));
  });
}

void FilteredOutput::countStopped(const Step& step, std::string_view source,
                                  const Statement& statement) {
  if (isStopped(step, source, statement)) {
    ++filtered_out_.stopped;
  } else if (isSignal(statement.kind)) {
    for (const std::string_view name : statement.names) {
      filtered_out_.signals += passesSignal(statement.path, name) ? 0 : 1;
    }
  }
}

/// After the statement was folded.
bool FilteredOutput::isStopped(const Step& step, std::string_view source,
                               const Statement& statement) const {
  if (statement.kind == StatementKind::event || isImmediate(statement.kind)) {
    return !passesImmediate(source, statement);
  }
  bool any_written = false, any_passes = false;
  if (isSignal(statement.kind)) return !passesImmediate(source, statement);
  forEachWritten(step.state, source, statement, [&](ItemKey&& key) {
    if (ownerOf(step.state, key) == nullptr) return;
    any_written = true;
    any_passes = any_passes || passes(options_.filters, step.state, key);
  });
  return any_written && !any_passes;
}

bool FilteredOutput::isImmediate(StatementKind kind) {
  return kind == StatementKind::order || kind == StatementKind::remove ||
         kind == StatementKind::erase;
}

/// What is never conflated goes with the datagram that brought it, or waits for the link. Events
/// are in the source's own datagram: whatever its length, since listeners ignore those of `by=`.
void FilteredOutput::takeImmediate(const Step& step, const Packet& packet,
                                   const Statement& statement, RelayDraft& draft) {
  if (!passesImmediate(packet.header.source, statement)) return;
  if (isSignal(statement.kind) && !passesSignal(statement.path, statement.names.front())) return;
  if (statement.kind == StatementKind::remove) {
    pending_.removed(statement.name);
    forgetOrders(statement.name);
  }
  // Told with the values that need it.
  if (style_.by_order && statement.kind == StatementKind::order) return;
  if (statement.kind == StatementKind::erase && forgets_nothing_ &&
      erases_.size() < kMaxRepeatedErases) {
    erases_.push_back(
        {step.now + kEraseAgain, kErasesAgain, draft.source, std::string(statement.name)});
  }
  if (bucket_) {
    paced_.add(packet.header.source, statement);
    return;
  }
  const std::string line = statementText(statement) + '\n';
  const bool fits = draft.text.size() + line.size() <= roomFor(step, draft.source);
  if (!fits && !draft.text.empty() && statement.kind != StatementKind::event) {
    send(step, draft, false);
  }
  draft.text += line;
}

void FilteredOutput::takeStates(const Step& step, const Packet& packet, const Statement& signals,
                                RelayDraft& draft) {
  if (signals.is_default) {
    pending_.cancelled(signalKey(signals.path, signals.names.front()));
    return takeImmediate(step, packet, signals, draft);
  }
  Statement state = signals;
  state.kind = StatementKind::signal;
  for (std::size_t i = 0; i < signals.names.size(); ++i) {
    if (signals.signal_kinds[i] == SignalKind::number) continue;
    if (options_.pacing.min_change.any()) {
      pending_.cancelled(signalKey(signals.path, signals.names[i]));
    }
    state.names = signals.names.subspan(i, 1);
    state.numbers = signals.numbers.subspan(i, 1);
    state.signal_kinds = signals.signal_kinds.subspan(i, 1);
    takeImmediate(step, packet, state, draft);
  }
}

void FilteredOutput::applied(const SessionState& state, const ThroughBySource& through,
                             const Packet& packet, LogTime now, std::vector<std::string>& out) {
  const Step step{state, through, now, out};
  RelayDraft draft{std::string(packet.header.source), {}, {}};
  filtered_out_.unreadable += packet.faults.size();
  if (!options_.filters.empty()) {
    for (const Statement& each : packet.statements) {
      countStopped(step, packet.header.source, each);
    }
  }
  if (packet.header.by.empty()) {
    for (const Statement& each : packet.statements) {
      if (each.kind == StatementKind::event) takeImmediate(step, packet, each, draft);
    }
  }
  // A source's restatement does not pass: the relay's own says what it said.
  if (!packet.header.part) {
    for (const Statement& each : packet.statements) {
      if (isImmediate(each.kind)) takeImmediate(step, packet, each, draft);
      if (isSignal(each.kind)) takeStates(step, packet, each, draft);
      forEachWritten(state, packet.header.source, each, [&](ItemKey&& key) {
        if (ownerOf(state, key) == nullptr || !passes(options_.filters, state, key)) return;
        pending_.written(state, std::move(key), now);
      });
    }
  }
  pending_.advance(now);
  sendReady(step, draft);
}

void FilteredOutput::forgetOrders(std::string_view device) {
  std::erase_if(sent_orders_, [&](const auto& each) { return each.first.first == device; });
}

bool FilteredOutput::statesOrder(const SessionState& state,
                                 const SentOrders::key_type& device_and_source) const {
  const auto& [name, source] = device_and_source;
  const DeviceState* const device = state.findDevice(name);
  return device != nullptr &&
         (device->orders.contains(source) || !orderOfValues(*device, source, style_).empty());
}

void FilteredOutput::send(const Step& step, RelayDraft& draft, bool restating) {
  step.out.push_back(header_.datagramOf(draft, step.state, step.through, restating));
  if (bucket_) {
    bucket_->spend(step.out.back().size() + options_.head_bytes + options_.link_bytes);
  }
  draft.text.clear();
  ++live_datagrams_;
}

/// Adds what is next to `draft`, which is sent when it is full. What one SOURCE owns of a device's
/// values is in one datagram, whatever its size.
void FilteredOutput::sendUnit(const Step& step, RelayDraft& draft) {
  std::map<std::string, std::vector<ItemKey>> by_owner;
  for (ItemKey& key : pending_.takeReady(step.state, step.now)) {
    if (!passes(options_.filters, step.state, key)) continue;
    by_owner[*ownerOf(step.state, key)].push_back(std::move(key));
  }
  for (const auto& [owner, keys] : by_owner) {
    for (std::string& text : DeviceValues(step.state, keys, style_).texts(false, sent_orders_)) {
      const bool fits =
          draft.source == owner && draft.text.size() + text.size() <= roomFor(step, owner);
      if (!draft.text.empty() && !fits) send(step, draft, false);
      draft.source = owner;
      draft.text += text;
    }
  }
}

/// Sends `draft`, filled with what is ready, and the rest as far as the link allows.
void FilteredOutput::sendReady(const Step& step, RelayDraft& draft) {
  if (bucket_) return sendPaced(step);
  while (pending_.anyReady()) sendUnit(step, draft);
  if (!draft.text.empty()) send(step, draft, false);
}

/// Changes go before values that are newer, and a datagram is one device: the next may have newer
/// values when its turn comes.
void FilteredOutput::sendPaced(const Step& step) {
  const auto room = [&](const std::string& source) { return roomFor(step, source); };
  while (bucket_->allows(step.now)) {
    RelayDraft draft;
    const bool any_others = paced_.anyChanges() || pending_.anyReady();
    if (paced_.anyEvents() && !(values_first_ && any_others)) {
      draft = paced_.takeEvents(room);
      values_first_ = true;
    } else if (any_others) {
      if (paced_.anyChanges()) draft = paced_.takeChanges(room);
      if (!paced_.anyChanges() && pending_.anyReady()) sendUnit(step, draft);
      values_first_ = false;
    } else {
      return;
    }
    if (!draft.text.empty()) send(step, draft, false);
    if (restating_ && live_datagrams_ >= kLiveForEachRestated) sendRestating(step);
  }
}

void FilteredOutput::restate(const SessionState& state, const ThroughBySource& through,
                             std::string id) {
  Restating::Options options;
  options.filters = options_.filters;
  options.style = style_;
  options.text_bytes = header_.roomInParts(state, through, id, datagramBytes());
  options.id = std::move(id);
  restating_.emplace(state, std::move(options));
  pending_.sweep(state);
  // Listeners forget an order that a whole restatement does not repeat.
  std::erase_if(sent_orders_, [&](const auto& each) { return !statesOrder(state, each.first); });
  std::size_t most = RestatingPace::kMaxWithParts;
  if (options_.bytes_per_second) {
    const double bytes = *options_.bytes_per_second * secondsOf(RestatingPace::kLongest) /
                         (kLiveForEachRestated + 1);
    most = static_cast<std::size_t>(bytes) /
           (datagramBytes() + options_.head_bytes + options_.link_bytes);
  }
  forgets_nothing_ = restating_->left() > most;
  if (forgets_nothing_) restating_->leaveOutParts();
}

void FilteredOutput::sendRestating(const Step& step) {
  while (restating_ && !restating_->ended()) {
    if (!pace_.allows(step.now) || (bucket_ && !bucket_->allows(step.now))) return;
    // What a change undoes must not be said behind it again.
    if (paced_.anyChanges()) return;
    const bool any_waits = pending_.anyReady() || paced_.anyEvents();
    if (bucket_ && any_waits && live_datagrams_ < kLiveForEachRestated) return;
    std::vector<ItemKey> restated;
    std::vector<RelayDraft> drafts = restating_->next(step.state, &restated, sent_orders_);
    for (RelayDraft& draft : drafts) send(step, draft, true);
    for (const ItemKey& key : restated) pending_.markStated(step.state, key);
    pace_.sent(drafts.size());
    live_datagrams_ = 0;
  }
  pending_.sweep(step.state);
  restating_.reset();
}

bool FilteredOutput::isDrawn(const SessionState& state, const RepeatedErase& erase) {
  const auto found = state.drawings().lower_bound({erase.source, erase.id});
  return found != state.drawings().end() && found->first.first == erase.source &&
         (erase.id.empty() || found->first.second == erase.id);
}

void FilteredOutput::repeatErases(const Step& step) {
  for (RepeatedErase& each : erases_) {
    if (each.due > step.now) continue;
    each.due += kEraseAgain;
    // One that was drawn again must not disappear.
    const bool is_drawn = isDrawn(step.state, each);
    each.left = is_drawn ? 0 : each.left - 1;
    if (is_drawn) continue;
    Statement erase;
    erase.kind = StatementKind::erase;
    erase.name = each.id;
    if (bucket_) {
      paced_.add(each.source, erase);
      continue;
    }
    RelayDraft draft{each.source, statementText(erase) + '\n', {}};
    send(step, draft, true);
  }
  std::erase_if(erases_, [](const RepeatedErase& each) { return each.left == 0; });
}

void FilteredOutput::advance(const SessionState& state, const ThroughBySource& through, LogTime now,
                             std::vector<std::string>& out) {
  const Step step{state, through, now, out};
  if (!erases_.empty()) repeatErases(step);
  pending_.advance(now);
  RelayDraft draft;
  sendReady(step, draft);
  if (restating_) sendRestating(step);
}

LogTime FilteredOutput::due() const {
  LogTime due = pending_.due();
  for (const RepeatedErase& each : erases_) due = std::min(due, each.due);
  if (pending_.anyReady() || paced_.anyChanges() || paced_.anyEvents()) {
    due = std::min(due, bucket_->allowsAt());
  }
  if (restating_) {
    due = std::min(due, std::max(pace_.allowsAt(), bucket_ ? bucket_->allowsAt() : LogTime::min()));
  }
  return due;
}

}  // namespace rocinante
