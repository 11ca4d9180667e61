#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "core/packet/packet.h"
#include "core/packet/packet_limits.h"
#include "core/packet/session_state.h"
#include "core/packet/state_weight.h"

namespace rocinante {

/// How newest-wins sees a datagram of a source (docs/packet-format.md, "Newest wins").
enum class Newness : std::uint8_t {
  newest,   ///< it is applied
  restart,  ///< it is applied, after the SEQUENCE that is remembered was forgotten
  late,     ///< it is dropped
};

/// What SessionState::apply() would make of a packet with this header, but for its limits.
Newness newnessOf(const SessionState& state, const PacketHeader& header);

/// True for a source's own SEQUENCE that begins anew instead of being late.
inline bool isRestart(std::uint64_t sequence, std::uint64_t highest) {
  return sequence == 0 || (sequence < highest && highest - sequence > limits::kReorderWindow);
}

/// Folds one packet into a state (docs/packet-format.md, section "The fold"): first decides whether
/// it is applied, then applies its statements, then the removals by a restatement that it
/// completes.
class StateFolder {
 public:
  StateFolder(SessionState& state, LogTime time, const Packet& packet)
      : state_(state), time_(time), packet_(packet), header_(packet.header) {}

  Applied fold();

 private:
  using Device = SessionState::Devices::value_type;
  using NamedJoints = DeviceState::NamedJoints;

  // state_folder.cpp: the header.
  bool findSource();
  bool admit();
  void countRelay();
  void abandonOldRestatements();
  void beginPart();
  void finishPart();
  void forgetSequence();

  // fold_statement.cpp: each applies one statement.
  void foldStatement(const Statement& statement);
  void foldJoints(const Statement& statement);
  void foldJointsByName(Device& device, std::span<const std::string> names,
                        std::span<const double> values);
  void foldOrder(const Statement& statement);
  void foldJoint(const Statement& statement);
  void foldPose(const Statement& statement);
  void foldPresence(const Statement& statement);
  void foldVisibility(const Statement& statement);
  void foldColor(const Statement& statement);
  void foldDrawing(const Statement& statement);
  void foldErase(const Statement& statement);
  void foldEvent(const Statement& statement);
  void foldView(const Statement& statement);
  void foldSignals(const Statement& statement);
  void cancelSignal(const Statement& statement);
  /// The value `index` of a statement, as `found` among `signals` or as a new one.
  bool setSignal(Signals& signals, Signals::iterator found, const Statement& statement,
                 std::size_t index);
  void foldSeen(const Statement& statement);
  /// `found`: the position of `name` among the device's joints, or their end.
  bool setNamedJoint(DeviceState& device, NamedJoints::iterator found, std::string_view name,
                     double value);

  /// The device of a statement, created when new; null when there is no room.
  Device* deviceFor(std::string_view name);
  template <class T>
  Item<T> itemOf(T value) const;
  template <class T>
  void writeItem(Device& device, std::optional<Item<T>>& slot, T value);
  template <class T>
  void writePathItem(std::map<Path, Item<T>>& items, const PathView& path, T value);
  template <class T>
  void claim(Item<T>& item) const;
  /// Replaces an item of weight `before`; false, and counted, when there is no room.
  bool makeRoom(std::uint64_t before, std::uint64_t after);
  void count(PacketFault fault);

  // state_forgetting.cpp: removals of items.
  void forgetItemsOf(DeviceState& device);
  void forgetPathsOf(std::string_view device);
  void forgetIfEmpty(std::string_view device);
  SessionState::Devices::iterator eraseDevice(SessionState::Devices::iterator device);
  bool isEmpty(const Device& device) const;
  void clearNamedJoints(DeviceState& device);
  void eraseOrder(DeviceState& device, std::string_view source);
  void forgetUnrepeated(std::uint64_t first_packet);
  template <class T>
  bool isUnrepeated(const Item<T>& item, std::uint64_t first_packet) const;
  void eraseUnrepeated(SessionState::Devices& devices, std::uint64_t first_packet);
  void eraseUnrepeated(SessionState::Drawings& drawings, std::uint64_t first_packet);
  template <class T>
  void eraseUnrepeated(std::optional<Item<T>>& slot, std::uint64_t first_packet);
  template <class Map>
  void eraseUnrepeated(Map& items, std::uint64_t first_packet);
  template <class T>
  void eraseAll(std::optional<Item<T>>& slot);
  template <class Map>
  void eraseAll(Map& items);
  template <class Map>
  typename Map::iterator eraseFrom(Map& items, typename Map::iterator item);

  SessionState& state_;
  LogTime time_;
  const Packet& packet_;
  const PacketHeader& header_;
  SourceState* source_ = nullptr;
  SourceCounts* counts_ = nullptr;
};

template <class T>
Item<T> StateFolder::itemOf(T value) const {
  return {std::move(value), std::string(header_.source), {state_.packets_}};
}

template <class T>
void StateFolder::claim(Item<T>& item) const {
  if (!sameName(item.owner, header_.source)) item.owner = header_.source;
  item.stated.packet = state_.packets_;
}

template <class Map>
typename Map::iterator StateFolder::eraseFrom(Map& items, typename Map::iterator item) {
  state_.weight_ -= weightOf(item->first) + weightOf(item->second);
  if constexpr (std::is_same_v<Map, Signals>) --state_.signal_count_;
  return items.erase(item);
}

}  // namespace rocinante
