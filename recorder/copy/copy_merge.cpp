#include <algorithm>

#include "core/log/loss_message.h"
#include "recorder/copy/log_copy.h"

namespace rocinante {
namespace {

/// A channel as what it is a part of: without /rocinante/restated.
std::string_view plainTopic(const LogChannel& channel) {
  std::string_view topic = channel.topic;
  if (topic.starts_with(kRestatedPrefix)) topic.remove_prefix(kRestatedPrefix.size());
  return topic;
}

bool sameFlow(const LogChannel& a, const LogChannel& b) {
  return plainTopic(a) == plainTopic(b) && a.encoding == b.encoding && a.metadata == b.metadata;
}

bool isMessage(CopyItem::Kind kind) {
  return kind == CopyItem::Kind::message || kind == CopyItem::Kind::lead;
}

/// What two items must have in common to be one, beside channel and numbers.
Bytes contentOf(const CopyItem& item) {
  if (isMessage(item.kind)) return {item.message.payload.begin(), item.message.payload.end()};
  const std::string text = item.kind == CopyItem::Kind::mark   ? item.mark->text
                           : item.kind == CopyItem::Kind::loss ? lossText(*item.loss)
                                                               : std::string();
  const ByteView bytes = bytesOf(text);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

CopyMerge::CopyMerge(std::vector<CopySource>& sources)
    : sources_(sources), heads_(sources.size(), nullptr), begun_(sources.size(), false) {}

/// Puts the next of every source that was taken from into heads_; at first, of all.
Status CopyMerge::refill() {
  for (std::size_t i = filled_ && taken_ ? *taken_ : 0; i < sources_.size(); ++i) {
    if (taken_) sources_[i].pop();
    const Result<const CopyItem*> head = sources_[i].peek();
    if (!head) return head.error();
    heads_[i] = *head;
    if (taken_) break;
  }
  filled_ = true;
  taken_.reset();
  return {};
}

/// An opening goes before everything of its time: it tells what was before.
std::optional<std::size_t> CopyMerge::earliest() const {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < heads_.size(); ++i) {
    if (heads_[i] == nullptr) continue;
    if (!best || heads_[i]->time < heads_[*best]->time ||
        (heads_[i]->time == heads_[*best]->time && heads_[i]->kind == CopyItem::Kind::opening &&
         heads_[*best]->kind != CopyItem::Kind::opening)) {
      best = i;
    }
  }
  return best;
}

Result<const CopyItem*> CopyMerge::next() {
  while (true) {
    if (Status filled = refill(); !filled) return filled.error();
    const std::optional<std::size_t> source = earliest();
    if (!source) return nullptr;
    taken_ = source;
    const CopyItem& item = *heads_[*source];
    if (sources_.size() > 1 && isRepeated(*source, item)) {
      if (item.kind == CopyItem::Kind::message) ++repeated_;
      begun_[*source] = true;
      continue;
    }
    begun_[*source] = true;
    return &item;
  }
}

bool CopyMerge::sameSession(std::size_t a, std::size_t b) const {
  const std::string& id = sources_[a].reader().summary().session_id;
  return !id.empty() && id == sources_[b].reader().summary().session_id &&
         sources_[a].options().shift == sources_[b].options().shift;
}

/// Another piece of the same session is being given: the fold holds what this one opens with.
bool CopyMerge::covered(std::size_t source) const {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (i != source && begun_[i] && heads_[i] != nullptr && sameSession(i, source)) return true;
  }
  return false;
}

bool CopyMerge::othersAt(std::size_t source, LogTime time) const {
  for (std::size_t i = 0; i < heads_.size(); ++i) {
    if (i != source && heads_[i] != nullptr && heads_[i]->time == time) return true;
  }
  return false;
}

/// What a piece says again of the time before it: a restated datagram that its source said itself.
bool CopyMerge::isLead(const CopyItem& item) {
  if (item.kind == CopyItem::Kind::lead) return true;
  if (item.kind != CopyItem::Kind::message || item.message.channel->captured()) return false;
  if (!item.message.channel->folded()) return false;
  const PacketHeader* const header = decoder_.decodeHeader(item.message.payload);
  return header != nullptr && header->by.empty();
}

bool CopyMerge::isRepeated(std::size_t source, const CopyItem& item) {
  if (item.kind == CopyItem::Kind::opening) return covered(source);
  if (isLead(item) && covered(source)) return true;
  if (item.time != given_time_) {
    given_.clear();
    given_time_ = item.time;
  }
  if (given_.empty() && !othersAt(source, item.time)) return false;
  Given one{source, item.kind, nullptr, 0, 0, contentOf(item), {}};
  if (isMessage(item.kind)) {
    one.channel = item.message.channel;
    one.sequence = item.message.sequence;
    one.publish_time_ns = item.publish_time_ns;
  }
  for (Given& other : given_) {
    if (other.source == source || other.payload != one.payload) continue;
    if (other.sequence != one.sequence || other.publish_time_ns != one.publish_time_ns) continue;
    if ((one.channel == nullptr) != (other.channel == nullptr)) continue;
    if (one.channel == nullptr && one.kind != other.kind) continue;
    if (one.channel != nullptr && !sameFlow(*one.channel, *other.channel)) continue;
    // One that was said again stands in no place of a captured one.
    if (one.channel != nullptr && one.channel->captured() && !other.channel->captured()) continue;
    // A person's mark is one whatever sessions it was set in.
    if (item.kind != CopyItem::Kind::mark && !sameSession(source, other.source)) continue;
    if (std::ranges::find(other.repeated_by, source) != other.repeated_by.end()) continue;
    other.repeated_by.push_back(source);
    return true;
  }
  given_.push_back(std::move(one));
  return false;
}

}  // namespace rocinante
