#include "core/copy/copy_merge.h"

#include <algorithm>

#include "core/base/hash.h"
#include "core/log/log_profile.h"
#include "core/log/loss_message.h"

namespace rocinante {
namespace {

/// The channel's topic without /rocinante/restated.
std::string_view plainTopic(const LogChannel& channel) {
  std::string_view topic = channel.topic;
  if (topic.starts_with(profile::kRestatedPrefix))
    topic.remove_prefix(profile::kRestatedPrefix.size());
  return topic;
}

bool isMessage(CopyItem::Kind kind) {
  return kind == CopyItem::Kind::message || kind == CopyItem::Kind::lead;
}

void addText(Bytes& out, std::string_view text) {
  const ByteView bytes = bytesOf(text);
  const std::uint64_t size = bytes.size();
  const auto* const size_bytes = reinterpret_cast<const std::byte*>(&size);
  out.insert(out.end(), size_bytes, size_bytes + sizeof size);
  out.insert(out.end(), bytes.begin(), bytes.end());
}

/// Equal for items that count as one when two pieces of a session hold them.
std::array<std::byte, 16> identityOf(const CopyItem& item) {
  Bytes all;
  if (isMessage(item.kind)) {
    const LogChannel& channel = *item.message.channel;
    addText(all, plainTopic(channel));
    addText(all, channel.encoding);
    for (const auto& [key, value] : channel.metadata) {
      addText(all, key);
      addText(all, value);
    }
    addText(all, std::to_string(item.message.sequence));
    addText(all, std::to_string(item.publish_time_ns));
    addText(all, textOf(item.message.payload));
  } else if (item.kind == CopyItem::Kind::mark) {
    addText(all, "mark");
    addText(all, item.mark->text);
  } else if (item.kind == CopyItem::Kind::loss) {
    addText(all, "loss");
    addText(all, lossText(*item.loss));
  }
  return xxh3(all);
}

}  // namespace

CopyMerge::CopyMerge(std::vector<CopySource>& sources)
    : sources_(sources), heads_(sources.size(), nullptr) {}

/// Refills heads_ from every source whose head was taken; from all sources at first.
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

/// An opening precedes everything of its time, because it states what was before.
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
      continue;
    }
    return &item;
  }
}

bool CopyMerge::sameSession(std::size_t a, std::size_t b) const {
  const std::string& id = sources_[a].reader().summary().session_id;
  return !id.empty() && id == sources_[b].reader().summary().session_id;
}

bool CopyMerge::othersAt(std::size_t source, LogTime time) const {
  for (std::size_t i = 0; i < heads_.size(); ++i) {
    if (i != source && heads_[i] != nullptr && heads_[i]->time == time) return true;
  }
  return false;
}

bool CopyMerge::isRepeated(std::size_t source, const CopyItem& item) {
  if (item.kind == CopyItem::Kind::opening) {
    // While another piece of the session continues, the fold already holds this opening.
    for (std::size_t i = 0; i < heads_.size(); ++i) {
      const bool goes_on = heads_[i] != nullptr && sources_[i].reader().summary().start < item.time;
      if (i != source && goes_on && sameSession(i, source)) return true;
    }
    return false;
  }
  if (item.time != seen_time_) {
    seen_.clear();
    seen_time_ = item.time;
  }
  if (seen_.empty() && !othersAt(source, item.time)) return false;
  // A restated datagram does not stand in for a captured one, but a captured one does for a
  // restated.
  const bool captured =
      isMessage(item.kind) && item.message.channel->captured() && item.kind != CopyItem::Kind::lead;
  std::vector<Seen>& equal = seen_[identityOf(item)];
  auto own = std::ranges::find(equal, source, &Seen::source);
  if (own == equal.end()) own = equal.insert(equal.end(), Seen{source, 0, 0});
  ++own->all;
  if (captured) ++own->captured;
  return std::ranges::any_of(equal, [&](const Seen& other) {
    if (other.source == source) return false;
    // Equal marks count as one across sessions.
    if (item.kind != CopyItem::Kind::mark && !sameSession(source, other.source)) return false;
    return captured ? other.captured >= own->captured : other.all >= own->all;
  });
}

}  // namespace rocinante
