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

std::string positionsText(const DeviceState& device, const ItemKey& key, const ItemStyle& style,
                          bool restating) {
  std::vector<double> values = device.joints->value;
  for (double& value : values) value = style.value(value);
  std::string text;
  const auto order = device.orders.find(device.joints->owner);
  const bool is_ordered = order != device.orders.end();
  if (restating || is_ordered) text = orderText(key.name, {}) + '\n';
  text += jointsText(key.name, values) + '\n';
  if (is_ordered && !restating) text += orderText(key.name, order->second) + '\n';
  return text;
}

std::string roundedPoseText(const std::string& device, PoseValue value, const ItemStyle& style) {
  if (style.rounded) {
    Vec3& p = value.pose.position;
    Quat& q = value.pose.orientation;
    for (double* each : {&p.x, &p.y, &p.z, &q.x, &q.y, &q.z, &q.w}) *each = roundedTo(*each, 1e6);
  }
  return poseText(device, value);
}

Path pathOf(const ItemKey& key) { return {key.is_layer, key.name, key.second}; }

StatementKind statementOf(const SessionState& state, const ItemKey& key) {
  switch (key.kind) {
    case ItemKind::presence:
      return StatementKind::add;
    case ItemKind::positions:
      return StatementKind::joints;
    case ItemKind::order:
      return StatementKind::order;
    case ItemKind::joint:
      return StatementKind::joint;
    case ItemKind::pose:
      return StatementKind::pose;
    case ItemKind::visibility:
      return StatementKind::show;
    case ItemKind::color:
      return StatementKind::color;
    case ItemKind::drawing:
      return state.drawings().find({key.second, key.name})->second.kind;
    case ItemKind::view:
      break;
  }
  return StatementKind::view;
}

ItemKey keyOf(ItemKind kind, std::string_view name, std::string_view second = {}) {
  return {kind, false, 0, std::string(name), std::string(second)};
}

ItemKey keyOf(ItemKind kind, const Path& path) {
  return {kind, path.is_layer, 0, path.first, path.second};
}

ItemKey keyOf(ItemKind kind, const PathView& path) {
  return {kind, path.is_layer, 0, std::string(path.first), std::string(path.second)};
}

template <class T>
const std::string* ownerIn(const std::optional<Item<T>>& item) {
  return item ? &item->owner : nullptr;
}

template <class Map, class Name>
const std::string* ownerIn(const Map& items, const Name& name) {
  const auto found = items.find(name);
  return found == items.end() ? nullptr : &found->second.owner;
}

}  // namespace

double ItemStyle::value(double joint) const { return rounded ? roundedTo(joint, 1e4) : joint; }

bool isDeviceValue(const ItemKey& key) {
  return key.kind == ItemKind::positions || key.kind == ItemKind::joint ||
         key.kind == ItemKind::pose;
}

bool isOfDevice(const ItemKey& key) {
  if (key.kind == ItemKind::visibility || key.kind == ItemKind::color) return !key.is_layer;
  return key.kind < ItemKind::visibility;
}

const std::string* ownerOf(const SessionState& state, const ItemKey& key) {
  switch (key.kind) {
    case ItemKind::visibility:
      return ownerIn(state.visibility(), pathOf(key));
    case ItemKind::color:
      return ownerIn(state.colors(), pathOf(key));
    case ItemKind::drawing: {
      const auto found = state.drawings().find({key.second, key.name});
      if (found == state.drawings().end()) return nullptr;
      const auto& parts = found->second.parts;
      return key.part < parts.size() && parts[key.part] ? &found->first.first : nullptr;
    }
    case ItemKind::view:
      return ownerIn(state.views(), key.name);
    default:
      break;
  }
  const DeviceState* const device = state.findDevice(key.name);
  if (device == nullptr) return nullptr;
  switch (key.kind) {
    case ItemKind::presence:
      return ownerIn(device->presence);
    case ItemKind::positions:
      return ownerIn(device->joints);
    case ItemKind::order: {
      const auto found = device->orders.find(key.second);
      return found == device->orders.end() ? nullptr : &found->first;
    }
    case ItemKind::joint:
      return ownerIn(device->named_joints, key.second);
    default:
      return ownerIn(device->pose);
  }
}

std::string itemText(const SessionState& state, const ItemKey& key, const ItemStyle& style,
                     bool restating) {
  switch (key.kind) {
    case ItemKind::visibility:
      return visibilityText(pathOf(key), state.visibility().find(pathOf(key))->second.value) + '\n';
    case ItemKind::color:
      return colorText(pathOf(key), state.colors().find(pathOf(key))->second.value) + '\n';
    case ItemKind::drawing: {
      const Drawing& drawing = state.drawings().find({key.second, key.name})->second;
      return drawingText(key.name, drawing, key.part) + '\n';
    }
    case ItemKind::view:
      return viewText(key.name, state.views().find(key.name)->second.value) + '\n';
    default:
      break;
  }
  const DeviceState& device = *state.findDevice(key.name);
  switch (key.kind) {
    case ItemKind::presence:
      return presenceText(key.name, device.presence->value) + '\n';
    case ItemKind::positions:
      return positionsText(device, key, style, restating);
    case ItemKind::order:
      return orderText(key.name, device.orders.find(key.second)->second) + '\n';
    case ItemKind::joint: {
      const double value = device.named_joints.find(key.second)->second.value;
      return jointText(key.name, key.second, style.value(value)) + '\n';
    }
    default:
      return roundedPoseText(key.name, device.pose->value, style) + '\n';
  }
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
  return std::all_of(filters.begin(), filters.end(), [&](const RelayFilter& filter) {
    return filter.passesKind(statementOf(state, key)) &&
           filter.passesSource(*ownerOf(state, key)) &&
           (!isOfDevice(key) || filter.passesDevice(key.name));
  });
}

void forEachItem(const SessionState& state, const std::function<void(ItemKey&&)>& visit) {
  for (const auto& [name, device] : state.devices()) {
    if (device.presence) visit(keyOf(ItemKind::presence, name));
    if (device.joints) visit(keyOf(ItemKind::positions, name));
    for (const auto& order : device.orders) visit(keyOf(ItemKind::order, name, order.first));
    for (const auto& joint : device.named_joints) visit(keyOf(ItemKind::joint, name, joint.first));
    if (device.pose) visit(keyOf(ItemKind::pose, name));
  }
  for (const auto& item : state.visibility()) visit(keyOf(ItemKind::visibility, item.first));
  for (const auto& item : state.colors()) visit(keyOf(ItemKind::color, item.first));
  for (const auto& [id, drawing] : state.drawings()) {
    ItemKey key = keyOf(ItemKind::drawing, id.second, id.first);
    for (key.part = 0; key.part < drawing.parts.size(); ++key.part) {
      if (drawing.parts[key.part]) visit(ItemKey(key));
    }
  }
  for (const auto& item : state.views()) visit(keyOf(ItemKind::view, item.first));
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
    default:
      return;
  }
}

}  // namespace rocinante
