#include "core/relay/device_values.h"

#include <algorithm>

#include "core/packet/item_text.h"
#include "core/packet/joint_order.h"
#include "core/packet/packet_text.h"

namespace rocinante {
namespace {

std::string taggedText(const std::string& device, std::uint32_t tag,
                       const std::vector<double>& values) {
  Statement joints;
  joints.kind = StatementKind::joints;
  joints.name = device;
  joints.order_tag = tag;
  joints.numbers = values;
  return statementText(joints) + '\n';
}

}  // namespace

std::vector<std::string> orderOfValues(const DeviceState& device, const std::string& source,
                                       const ItemStyle& style) {
  // Positions of the same SOURCE are not to be read under an order.
  const bool has_positions = device.joints && device.joints->owner == source;
  if (!style.by_order || has_positions) return {};
  std::vector<std::string> names;
  for (const auto& [name, item] : device.named_joints) {
    if (item.owner == source) names.push_back(name);
  }
  const auto own = device.orders.find(source);
  if (own == device.orders.end() || own->second.value.size() != names.size()) return names;
  std::vector<std::string> sorted = own->second.value;
  std::ranges::sort(sorted);
  return sorted == names ? own->second.value : names;
}

std::vector<std::string> DeviceValues::texts(bool restating, SentOrders& sent_orders) const {
  std::vector<std::string> texts(1);
  const auto add = [&](const ItemKey* before, const ItemKey& key, std::string text) {
    if (!texts.back().empty() && texts.back().size() + text.size() > kMostBytes) {
      texts.emplace_back();
      before = nullptr;
    }
    appendItem(texts.back(), before, key, std::move(text));
  };
  const ItemKey* before = nullptr;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    const ItemKey& key = keys_[i];
    if (key.kind == ItemKind::joint && (i == 0 || keys_[i - 1].kind != ItemKind::joint)) {
      if (std::string text = byOrder(key, restating, sent_orders); !text.empty()) {
        add(nullptr, key, std::move(text));
        while (i + 1 < keys_.size() && keys_[i + 1].kind == ItemKind::joint) ++i;
        before = nullptr;
        continue;
      }
    }
    std::string text = itemText(state_, key, style_, restating);
    if (key.kind == ItemKind::positions || key.kind == ItemKind::order) {
      const std::string& owner = *ownerOf(state_, key);
      const DeviceState& device = *state_.findDevice(key.name);
      const bool was_sent = sent_orders.erase({key.name, owner}) > 0;
      const auto order = device.orders.find(owner);
      const bool is_ordered = order != device.orders.end();
      // The text cancels the order itself where it restates, or where the state has one.
      if (key.kind == ItemKind::positions && was_sent && !restating && !is_ordered) {
        text.insert(0, orderText(key.name, {}) + '\n');
      }
      const bool states_order = is_ordered && (key.kind == ItemKind::order || !restating);
      if (style_.by_order && states_order)
        sent_orders[{key.name, owner}] = orderTag(order->second.value);
    }
    add(before, key, std::move(text));
    before = &key;
  }
  return texts;
}

/// All named joints of the owner under an order, which is sent first unless it is known; empty when
/// those in `keys_` are as short by name.
std::string DeviceValues::byOrder(const ItemKey& first, bool restating,
                                  SentOrders& sent_orders) const {
  const DeviceState& device = *state_.findDevice(first.name);
  const std::string& owner = *ownerOf(state_, first);
  const std::vector<std::string> names = orderOfValues(device, owner, style_);
  if (names.empty()) return {};
  std::vector<double> values;
  for (const std::string& name : names) {
    values.push_back(style_.value(device.named_joints.find(name)->second.value));
  }
  const std::uint32_t tag = orderTag(names);
  std::string text = taggedText(first.name, tag, values);
  std::size_t by_name = 0;
  const ItemKey* before = nullptr;
  for (const ItemKey& key : keys_) {
    if (key.kind != ItemKind::joint) continue;
    std::string one = itemText(state_, key, style_, restating);
    by_name += before == nullptr ? one.size() : one.size() - one.rfind(' ');
    before = &key;
  }
  if (!restating && by_name <= text.size()) return {};
  const std::pair key{first.name, owner};
  const auto known = sent_orders.find(key);
  if (restating || known == sent_orders.end() || known->second != tag) {
    text.insert(0, orderText(first.name, names) + '\n');
  }
  if (text.size() > kMostBytes) return {};
  sent_orders[key] = tag;
  return text;
}

}  // namespace rocinante
