#include "core/packet/joint_order.h"

#include "core/base/hash.h"

namespace rocinante {

std::uint32_t orderTag(std::span<const std::string> names) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) sum = crc32(bytesOf(std::string_view("\n")), sum);
    sum = crc32(bytesOf(names[i]), sum);
  }
  return sum;
}

JointsMeaning meaningOfJoints(const DeviceState* device, std::string_view source,
                              const Statement& joints) {
  JointsMeaning meaning;
  if (device != nullptr && !device->orders.empty()) {
    const auto order = device->orders.find(source);
    if (order != device->orders.end()) meaning.names = &order->second.value;
  }
  const bool is_counted =
      meaning.names != nullptr && meaning.names->size() == joints.numbers.size();
  if (joints.order_tag) {
    // The count first: it bounds what is hashed by what was sent.
    if (!is_counted || orderTag(*meaning.names) != *joints.order_tag) {
      meaning.fault = PacketFault::unknown_order;
    }
  } else if (meaning.names != nullptr && !is_counted) {
    meaning.fault = PacketFault::order_mismatch;
  }
  return meaning;
}

}  // namespace rocinante
