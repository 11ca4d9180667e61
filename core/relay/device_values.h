#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/relay/item_key.h"

namespace rocinante {

/// The orders that a listener of one output knows if it lost nothing, by device and SOURCE: their
/// TAGs.
using SentOrders = std::map<std::pair<std::string, std::string>, std::uint32_t>;

/// The values of a device that one SOURCE owns go out together, so that no listener shows a pose
/// that the device never had.
class DeviceValues {
 public:
  /// What no datagram of UDP holds is cut between items.
  static constexpr std::size_t kMostBytes = 60'000;

  /// `keys`: existing items of one device, all values (isDeviceValue) of one owner and sorted; or
  /// another item alone.
  DeviceValues(const SessionState& state, std::span<const ItemKey> keys, const ItemStyle& style)
      : state_(state), keys_(keys), style_(style) {}

  /// Statements, each with its LF: one text, or several beyond kMostBytes. `sent_orders` is what
  /// the listeners know, and becomes what they know then.
  std::vector<std::string> texts(bool restating, SentOrders& sent_orders) const;

 private:
  std::string byOrder(const ItemKey& first, bool restating, SentOrders& sent_orders) const;

  const SessionState& state_;
  std::span<const ItemKey> keys_;
  const ItemStyle& style_;
};

/// The order under which an output with ItemStyle::by_order says the SOURCE's named joints of a
/// device: its own if it has all of them and no other, else their names as sorted. Empty when it
/// says them by name.
std::vector<std::string> orderOfValues(const DeviceState& device, const std::string& source,
                                       const ItemStyle& style);

}  // namespace rocinante
