#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/packet/session_state.h"
#include "core/relay/relay_filter.h"

namespace rocinante {

/// The kinds of items of a state (docs/packet-format.md, "Items"), in the order in which the items
/// of one device are sent.
enum class ItemKind : std::uint8_t {
  presence,    ///< name: device
  positions,   ///< name: device
  order,       ///< name: device; second: SOURCE
  joint,       ///< name: device; second: joint
  pose,        ///< name: device
  signal,      ///< name: device, empty: none; second: link; signal
  visibility,  ///< name, second, is_layer: the PATH
  color,       ///< likewise
  drawing,     ///< name: ID; second: SOURCE; part
  view,        ///< name
};

/// Names an item without its value.
struct ItemKey {
  ItemKind kind = ItemKind::presence;
  bool is_layer = false;
  std::uint32_t part = 0;  ///< of a drawing, from 0
  std::string name;
  std::string second;
  std::string signal{};  ///< NAME
  auto operator<=>(const ItemKey&) const = default;
};

ItemKey signalKey(const PathView& path, std::string_view name);
/// `PATH NAME`, as packets write them: by what patterns know a signal.
std::string signalText(const ItemKey& signal);
/// True for items that belong to the device `name`.
bool isOfDevice(const ItemKey& key);
/// True for joints and pose: where a device is.
bool isDeviceValue(const ItemKey& key);

/// How values are written.
struct ItemStyle {
  bool rounded = false;   ///< joints with four decimals, poses with six
  bool by_order = false;  ///< named joints by position, under an order (core/relay/device_values.h)

  /// As a joint's value is written.
  double value(double joint) const;
};

/// The SOURCE that owns the item; null when the state has no such item.
const std::string* ownerOf(const SessionState& state, const ItemKey& key);

/// The statements that say the item, each with its LF; the item must exist. Positional joints
/// cancel an order of their owner first, and repeat it afterwards; with `restating` they always
/// cancel, and the order is left to its own item.
std::string itemText(const SessionState& state, const ItemKey& key, const ItemStyle& style,
                     bool restating);

/// Appends the item's text; a joint that follows one of the same device continues its line.
/// `before`: the item that `text` ends with, or null.
void appendItem(std::string& text, const ItemKey* before, const ItemKey& key,
                std::string item_text);

/// True when all filters pass the item, which must exist.
bool passes(const std::vector<RelayFilter>& filters, const SessionState& state, const ItemKey& key);

/// Calls `visit` for every item, device by device.
void forEachItem(const SessionState& state, const std::function<void(ItemKey&&)>& visit);

/// The items that the statement wrote for `source`, after it was folded; nothing for statements
/// that remove, for orders, for events, and for signals that are no numbers.
void forEachWritten(const SessionState& state, std::string_view source, const Statement& statement,
                    const std::function<void(ItemKey&&)>& visit);

}  // namespace rocinante
