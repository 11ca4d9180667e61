#include "core/relay/item_key.h"

#include <algorithm>
#include <cmath>

#include "core/packet/item_text.h"
#include "core/packet/joint_order.h"

namespace rocinante {
namespace {

double roundedTo(double value, double steps) {
  const double whole = std::round(value * steps) / steps;
  return std::isfinite(whole) ? whole : value;
}

/// `orders`: those of the device.
std::string positionsText(const PositionsItem& item, const DeviceState::Orders& orders,
                          const ItemStyle& style, bool restating) {
  std::vector<double> values = item.item.value;
  for (double& value : values) value = style.value(value);
  std::string text;
  const auto order = orders.find(item.owner());
  const bool is_ordered = order != orders.end();
  if (restating || is_ordered) text = orderText(item.device, {}) + '\n';
  text += jointsText(item.device, values);
  if (is_ordered && !restating) text += '\n' + orderText(item.device, order->second.value);
  return text;
}

std::string roundedPoseText(const PoseItem& item) {
  PoseValue value = item.item.value;
  Vec3& p = value.pose.position;
  Quat& q = value.pose.orientation;
  for (double* each : {&p.x, &p.y, &p.z, &q.x, &q.y, &q.z, &q.w}) *each = roundedTo(*each, 1e6);
  return poseText(item.device, value);
}

Path pathOf(const ItemKey& key) { return {key.is_layer, key.name, key.second}; }

ItemKey keyOf(ItemKind kind, std::string_view name, std::string_view second = {}) {
  return {kind, false, 0, std::string(name), std::string(second)};
}

ItemKey keyOf(ItemKind kind, const Path& path) {
  return {kind, path.is_layer, 0, path.first, path.second};
}

ItemKey keyOf(ItemKind kind, const PathView& path) {
  return {kind, path.is_layer, 0, std::string(path.first), std::string(path.second)};
}

ItemKey keyOf(const PresenceItem& item) { return keyOf(ItemKind::presence, item.device); }
ItemKey keyOf(const PositionsItem& item) { return keyOf(ItemKind::positions, item.device); }
ItemKey keyOf(const OrderItem& item) { return keyOf(ItemKind::order, item.device, item.owner()); }
ItemKey keyOf(const JointItem& item) { return keyOf(ItemKind::joint, item.device, item.joint); }
ItemKey keyOf(const PoseItem& item) { return keyOf(ItemKind::pose, item.device); }
ItemKey keyOf(const VisibilityItem& item) { return keyOf(ItemKind::visibility, item.path); }
ItemKey keyOf(const ColorItem& item) { return keyOf(ItemKind::color, item.path); }
ItemKey keyOf(const DrawingItem& item) {
  ItemKey key = keyOf(ItemKind::drawing, item.id, item.source);
  key.part = static_cast<std::uint32_t>(item.part);
  return key;
}
ItemKey keyOf(const ViewItem& item) { return keyOf(ItemKind::view, item.name); }
ItemKey keyOf(std::string_view device, std::string_view link, std::string_view signal) {
  ItemKey key = keyOf(ItemKind::signal, device, link);
  key.signal = signal;
  return key;
}
ItemKey keyOf(const SignalItem& item) { return keyOf(item.device, item.name.link, item.name.name); }

/// The kind of statement by which filters judge an item.
constexpr ByKind kStatementOf{
    [](const PresenceItem&) { return StatementKind::add; },
    [](const PositionsItem&) { return StatementKind::joints; },
    [](const OrderItem&) { return StatementKind::order; },
    [](const JointItem&) { return StatementKind::joint; },
    [](const PoseItem&) { return StatementKind::pose; },
    [](const VisibilityItem&) { return StatementKind::show; },
    [](const ColorItem&) { return StatementKind::color; },
    [](const DrawingItem& item) { return item.drawing.kind; },
    [](const ViewItem&) { return StatementKind::view; },
    [](const SignalItem&) { return StatementKind::signal; },
};

/// Calls `visit` with the item that has this key, if the state has one.
template <class Visit>
void visitItem(const SessionState& state, const ItemKey& key, Visit visit) {
  const auto visitIn = [&](const auto& items, const auto& name) {
    const auto found = items.find(name);
    if (found != items.end()) eachItemOf(found->first, found->second, visit);
  };
  const bool is_slot = key.kind < ItemKind::visibility && !key.name.empty();
  const DeviceState* const device = is_slot ? state.findDevice(key.name) : nullptr;
  if (device == nullptr && is_slot) return;
  switch (key.kind) {
    case ItemKind::presence:
      return eachItemIn(key.name, device->presence, visit);
    case ItemKind::positions:
      return eachItemIn(key.name, device->joints, visit);
    case ItemKind::order: {
      const auto found = device->orders.find(key.second);
      if (found != device->orders.end()) visit(OrderItem{key.name, found->second});
      return;
    }
    case ItemKind::joint: {
      const auto found = device->named_joints.find(key.second);
      if (found != device->named_joints.end()) {
        visit(JointItem{{key.name, found->second}, key.second});
      }
      return;
    }
    case ItemKind::pose:
      return eachItemIn(key.name, device->pose, visit);
    case ItemKind::signal: {
      const Signals& signals = device == nullptr ? state.signals() : device->signals;
      const auto found = signals.find(SignalNameView(key.second, key.signal));
      if (found != signals.end()) visit(SignalItem{key.name, found->first, found->second});
      return;
    }
    case ItemKind::visibility:
      return visitIn(state.visibility(), pathOf(key));
    case ItemKind::color:
      return visitIn(state.colors(), pathOf(key));
    case ItemKind::drawing: {
      const auto found = state.drawings().find({key.second, key.name});
      if (found == state.drawings().end()) return;
      const auto& [id, drawing] = *found;
      if (key.part >= drawing.parts.size() || !drawing.parts[key.part]) return;
      return visit(DrawingItem{id.first, id.second, drawing, key.part});
    }
    case ItemKind::view:
      return visitIn(state.views(), key.name);
  }
}

}  // namespace

double ItemStyle::value(double joint) const { return rounded ? roundedTo(joint, 1e4) : joint; }

ItemKey signalKey(const PathView& path, std::string_view name) {
  ItemKey key = keyOf(ItemKind::signal, path.first, path.second);
  key.signal = name;
  return key;
}

std::string signalText(const ItemKey& signal) {
  constexpr std::size_t kWord = sizeof "signal";
  return signalNameText(signal.name, {signal.second, signal.signal}).substr(kWord);
}

bool isDeviceValue(const ItemKey& key) {
  return key.kind == ItemKind::positions || key.kind == ItemKind::joint ||
         key.kind == ItemKind::pose;
}

bool isOfDevice(const ItemKey& key) {
  if (key.kind == ItemKind::visibility || key.kind == ItemKind::color) return !key.is_layer;
  return key.kind < ItemKind::visibility && !key.name.empty();
}

const std::string* ownerOf(const SessionState& state, const ItemKey& key) {
  const std::string* owner = nullptr;
  visitItem(state, key, [&](const auto& item) { owner = &item.owner(); });
  return owner;
}

std::string itemText(const SessionState& state, const ItemKey& key, const ItemStyle& style,
                     bool restating) {
  std::string text;
  const auto say = ByKind{
      [&](const PositionsItem& item) {
        text = positionsText(item, state.findDevice(item.device)->orders, style, restating);
      },
      [&](const JointItem& item) {
        text = jointText(item.device, item.joint, style.value(item.item.value));
      },
      [&](const PoseItem& item) {
        text = style.rounded ? roundedPoseText(item) : statementText(item);
      },
      [&](const auto& item) { text = statementText(item); },
  };
  visitItem(state, key, say);
  text += '\n';
  return text;
}

void appendItem(std::string& text, const ItemKey* before, const ItemKey& key,
                std::string item_text) {
  if (before != nullptr && before->kind == ItemKind::joint && key.kind == ItemKind::joint &&
      before->name == key.name) {
    text.pop_back();
    item_text.erase(0, item_text.rfind(' '));
  }
  text += item_text;
}

bool passes(const std::vector<RelayFilter>& filters, const SessionState& state,
            const ItemKey& key) {
  if (filters.empty()) return true;
  bool passes_all = true;
  visitItem(state, key, [&](const auto& item) {
    const StatementKind kind = kStatementOf(item);
    passes_all = std::ranges::all_of(filters, [&](const RelayFilter& filter) {
      return filter.passesKind(kind) && filter.passesSource(item.owner()) &&
             (!isOfDevice(key) || filter.passesDevice(key.name)) &&
             (key.kind != ItemKind::signal || filter.signals.empty() ||
              filter.passesSignal(signalText(key)));
    });
  });
  return passes_all;
}

void forEachItem(const SessionState& state, const std::function<void(ItemKey&&)>& visit) {
  eachItem(state, [&](const auto& item) { visit(keyOf(item)); });
}

void forEachWritten(const SessionState& state, std::string_view source, const Statement& statement,
                    const std::function<void(ItemKey&&)>& visit) {
  switch (statement.kind) {
    case StatementKind::joints: {
      const DeviceState* const device = state.findDevice(statement.name);
      const JointsMeaning meaning = meaningOfJoints(device, source, statement);
      if (device == nullptr || meaning.fault) return;
      if (meaning.names == nullptr) return visit(keyOf(ItemKind::positions, statement.name));
      for (const std::string& joint : *meaning.names) {
        visit(keyOf(ItemKind::joint, statement.name, joint));
      }
      return;
    }
    case StatementKind::joint:
      for (const std::string_view joint : statement.names) {
        visit(keyOf(ItemKind::joint, statement.name, joint));
      }
      return;
    case StatementKind::pose:
      return visit(keyOf(ItemKind::pose, statement.name));
    case StatementKind::add:
      return visit(keyOf(ItemKind::presence, statement.name));
    case StatementKind::show:
    case StatementKind::hide:
      return visit(keyOf(ItemKind::visibility, statement.path));
    case StatementKind::color:
      return visit(keyOf(ItemKind::color, statement.path));
    case StatementKind::line:
    case StatementKind::points:
    case StatementKind::label: {
      ItemKey key = keyOf(ItemKind::drawing, statement.name, source);
      key.part = statement.part_index - 1;
      return visit(std::move(key));
    }
    case StatementKind::view:
      return visit(keyOf(ItemKind::view, statement.name));
    case StatementKind::signal:
    case StatementKind::signals:
      for (std::size_t i = 0; i < statement.signal_kinds.size(); ++i) {
        if (statement.signal_kinds[i] != SignalKind::number) continue;
        visit(signalKey(statement.path, statement.names[i]));
      }
      return;
    default:
      return;
  }
}

}  // namespace rocinante
