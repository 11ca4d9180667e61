#include "viewer/ui/model/packet_search.h"

#include <algorithm>

#include "core/base/bytes.h"

namespace rocinante {
namespace {

/// Whether the statement says something about the item; an `order` of the source decides, for a
/// positional `joints`, which joints it is about.
bool mentions(const Statement& statement, const StatedItem& item) {
  if (statement.name != item.device) return false;
  switch (statement.kind) {
    case StatementKind::pose:
      return item.value_name.empty();
    case StatementKind::joints:
      return true;
    case StatementKind::joint:
      return item.value_name.empty() ||
             std::ranges::find(statement.names, item.value_name) != statement.names.end();
    default:
      return false;
  }
}

/// The owner and the packet's mark of a value, if one was said.
template <class T>
std::optional<std::uint64_t> markOf(const std::optional<Item<T>>& item) {
  return item ? std::optional(item->stated.packet) : std::nullopt;
}

std::optional<std::uint64_t> markOf(const SessionState& state, const StatedItem& item) {
  const DeviceState* const device = state.findDevice(item.device);
  if (device == nullptr) return std::nullopt;
  if (!item.value_name.empty()) {
    const auto named = device->named_joints.find(item.value_name);
    if (named != device->named_joints.end()) return named->second.stated.packet;
    return markOf(device->joints);
  }
  auto last = std::max(markOf(device->pose), markOf(device->joints));
  for (const auto& [name, value] : device->named_joints) {
    last = std::max(last, std::optional(value.stated.packet));
  }
  return last;
}

}  // namespace

Result<PacketSearch> PacketSearch::open(const std::filesystem::path& log) {
  auto reader = LogReader::open(log);
  if (!reader) return reader.error();
  auto states = Timeline::open(log);
  if (!states) return states.error();
  return PacketSearch(std::move(*reader), std::move(*states));
}

Status PacketSearch::begin(const StatedItem& item, LogTime moment) {
  if (begun_ && item == item_ && moment == moment_) return {};
  item_ = item;
  moment_ = moment;
  begun_ = true;
  finished_ = false;
  found_.reset();
  // Behind everything at that moment: previous() then has the last one first.
  return reader_->seek(moment + Nanoseconds(1));
}

Result<bool> PacketSearch::isBehind(const LogMessage& message, const Packet& packet) {
  if (!std::ranges::any_of(packet.statements, [this](const Statement& statement) {
        return mentions(statement, item_);
      })) {
    return false;
  }
  // What came late was dropped, and what an order leaves out was not said: the fold knows.
  StateDamage ignored;
  const auto before = states_->stateBefore(message.place(), &ignored);
  if (!before) return before.error();
  SessionState after = **before;
  if (foldPacket(after, message.log_time, packet) != Applied::yes) return false;
  const auto mark = markOf(after, item_);
  return mark && mark != markOf(**before, item_);
}

Result<bool> PacketSearch::step(std::size_t messages) {
  for (std::size_t looked = 0; begun_ && !finished_ && looked < messages; ++looked) {
    const auto message = reader_->previous();
    if (!message) return message.error();
    if (!*message) {
      finished_ = true;
      break;
    }
    const Packet* const packet = folder_->decode(**message);
    if (packet == nullptr) continue;
    const auto behind = isBehind(**message, *packet);
    if (!behind) return behind.error();
    if (!*behind) continue;
    PacketBehind found;
    found.source = packet->header.source;
    found.topic = (*message)->channel->topic;
    const auto& known = (*message)->channel->metadata;
    if (const auto remote = known.find("remote"); remote != known.end()) {
      found.sender = remote->second;
    }
    found.sequence = packet->header.sequence;
    found.by = packet->header.by;
    found.restated = packet->header.restated;
    found.time = (*message)->log_time;
    found.source_time = packet->header.time_ns;
    found.text = textOf((*message)->payload);
    found_ = std::move(found);
    finished_ = true;
  }
  return finished_;
}

void PacketLookup::look(const std::filesystem::path& log, const StatedItem& item, LogTime moment,
                        std::size_t messages) {
  if (!trouble.empty()) return;
  if (!search) {
    auto opened = PacketSearch::open(log);
    if (!opened) {
      trouble = opened.error().text();
      return;
    }
    search = std::move(*opened);
  }
  Status begun = search->begin(item, moment);
  if (begun) {
    const auto stepped = search->step(messages);
    if (!stepped) begun = stepped.error();
  }
  if (!begun) trouble = begun.error().text();
}

}  // namespace rocinante
