#include "core/foreign/ros/device_finder.h"

#include <algorithm>

#include "core/base/name_hint.h"

namespace rocinante::ros {
namespace {

/// "arm/link6" as "arm" and "link6"; empty without a slash.
std::optional<std::pair<std::string_view, std::string_view>> prefixed(std::string_view name) {
  const std::size_t slash = name.find('/');
  if (slash == name.npos || slash == 0 || slash + 1 == name.size()) return std::nullopt;
  return std::pair{name.substr(0, slash), name.substr(slash + 1)};
}

/// The device of a name that one device alone has.
template <class Map>
const std::string* onlyOne(const Map& map, std::string_view name) {
  const auto [first, last] = map.equal_range(name);
  return first != last && std::next(first) == last ? &first->second : nullptr;
}

template <class Map>
bool holds(const Map& map, std::string_view name, std::string_view device) {
  const auto [first, last] = map.equal_range(name);
  return std::any_of(first, last, [&](const auto& each) { return each.second == device; });
}

std::vector<std::string_view> partsOf(std::string_view topic) {
  std::vector<std::string_view> parts;
  while (!topic.empty()) {
    const std::size_t slash = topic.find('/');
    if (slash != 0) parts.push_back(topic.substr(0, slash));
    if (slash == topic.npos) break;
    topic.remove_prefix(slash + 1);
  }
  return parts;
}

/// A joint of several values is named with its components.
void addValueNames(const rocinante::Joint& joint, std::vector<std::string>& out) {
  const std::size_t values = valueCount(joint.type);
  if (values <= 1) return out.push_back(joint.name);
  static constexpr const char* kPlanar[] = {".x", ".y", ".yaw"};
  static constexpr const char* kFloating[] = {".x", ".y", ".z", ".qx", ".qy", ".qz", ".qw"};
  for (std::size_t i = 0; i < values; ++i) {
    out.push_back(joint.name + (joint.type == JointType::planar ? kPlanar[i] : kFloating[i]));
  }
}

}  // namespace

DeviceFinder::DeviceFinder(const Cell* cell, std::string fallback)
    : fallback_(std::move(fallback)) {
  if (cell == nullptr) return;
  for (const CellDevice& device : cell->devices) {
    devices_.insert(device.name);
    const Model* const model = cell->modelOf(device);
    if (model == nullptr) continue;
    modelled_.insert(device.name);
    for (const rocinante::Joint& joint : model->joints) {
      const bool driven = joint.type != JointType::fixed && !joint.mimic;
      std::vector<std::string> names;
      addValueNames(joint, names);
      for (std::string& name : names) joints_.emplace(std::move(name), Joint{device.name, driven});
    }
    for (std::size_t i = 0; i < model->links.size(); ++i) {
      links_.emplace(model->links[i].name, device.name);
      if (i == model->root) roots_.emplace(model->links[i].name, device.name);
    }
  }
}

std::optional<std::string> DeviceFinder::onlyDevice() const {
  return devices_.size() == 1 ? std::optional(*devices_.begin()) : std::nullopt;
}

std::optional<std::string> DeviceFinder::deviceOfFrame(std::string_view frame) const {
  if (!knowsDevices()) return std::string(frame);
  if (const auto both = prefixed(frame); both && holds(roots_, both->second, both->first)) {
    return std::string(both->first);
  }
  if (devices_.contains(frame)) return std::string(frame);
  if (const std::string* const device = onlyOne(roots_, frame)) return *device;
  return std::nullopt;
}

std::optional<DeviceFinder::Link> DeviceFinder::linkOfFrame(std::string_view frame) const {
  if (const auto both = prefixed(frame); both && holds(links_, both->second, both->first)) {
    return Link{std::string(both->first), std::string(both->second)};
  }
  if (const std::string* const device = onlyOne(links_, frame)) {
    return Link{*device, std::string(frame)};
  }
  return std::nullopt;
}

std::optional<DeviceFinder::PrefixedLink> DeviceFinder::prefixedLinkOf(
    std::string_view frame) const {
  const std::size_t slash = frame.rfind('/');
  if (slash == frame.npos || slash == 0 || slash + 1 == frame.size()) return std::nullopt;
  const std::string_view link = frame.substr(slash + 1);
  PrefixedLink found;
  found.prefix = frame.substr(0, slash);
  std::optional<std::string> device = deviceOfTopic(found.prefix);
  found.is_named = device && holds(links_, link, *device);
  if (!found.is_named) {
    const std::string* const only = onlyOne(links_, link);
    if (only == nullptr) return std::nullopt;
    device = *only;
  }
  found.link = {*device, std::string(link)};
  found.is_root = holds(roots_, link, *device);
  return found;
}

std::optional<std::string> DeviceFinder::deviceOfTopic(std::string_view topic) const {
  std::optional<std::string> found;
  for (const std::string_view part : partsOf(topic)) {
    if (devices_.contains(part)) found = part;
  }
  return found;
}

std::string DeviceFinder::madeUpDevice(std::string_view topic, std::string_view otherwise) const {
  if (!fallback_.empty()) return fallback_;
  const std::vector<std::string_view> parts = partsOf(topic);
  return std::string(parts.size() > 1 ? parts.front() : otherwise);
}

const DeviceFinder::Joint* DeviceFinder::jointOf(std::string_view device,
                                                 std::string_view name) const {
  const auto [first, last] = joints_.equal_range(name);
  const auto found =
      std::find_if(first, last, [&](const auto& each) { return each.second.device == device; });
  return found == last ? nullptr : &found->second;
}

bool DeviceFinder::lacksJoint(std::string_view device, std::string_view joint) const {
  constexpr std::size_t kTellingBytes = 4;  // of short names any two are close
  if (!modelled_.contains(device) || jointOf(device, joint) != nullptr) return false;
  if (joint.size() < kTellingBytes) return true;
  std::vector<std::string_view> names;
  for (const auto& [name, of] : joints_) {
    if (of.device == device) names.push_back(name);
  }
  return didYouMean(joint, names).empty();
}

DeviceFinder::JointHome DeviceFinder::homeOf(std::string_view joint,
                                             const std::optional<std::string>& by_topic) const {
  const auto home = [](const Joint& of, std::string_view name) {
    return JointHome{of.driven ? JointMatch::driven : JointMatch::passive, of.device,
                     std::string(name)};
  };
  if (const auto both = prefixed(joint)) {
    if (const Joint* const of = jointOf(both->first, both->second)) return home(*of, both->second);
  }
  if (by_topic) {
    if (const Joint* const of = jointOf(*by_topic, joint)) return home(*of, joint);
  }
  const auto [first, last] = joints_.equal_range(joint);
  if (first == last) return {JointMatch::unknown, {}, std::string(joint)};
  if (std::next(first) != last) return {JointMatch::ambiguous, {}, std::string(joint)};
  return home(first->second, joint);
}

std::vector<DeviceFinder::JointHome> DeviceFinder::homesOf(std::string_view topic,
                                                           std::span<const std::string_view> joints,
                                                           std::string_view stated) const {
  std::vector<JointHome> homes;
  homes.reserve(joints.size());
  const std::optional<std::string> by_topic =
      stated.empty() ? deviceOfTopic(topic) : std::optional(std::string(stated));
  std::map<std::string, std::size_t> driven;  // joints by device
  for (const std::string_view joint : joints) {
    homes.push_back(homeOf(joint, by_topic));
    if (homes.back().match == JointMatch::driven) ++driven[homes.back().device];
  }
  // Unknown joints go to the device that this message is about, so that `check` can name them.
  std::string rest = fallback_;
  std::size_t most = 0;
  for (const auto& [device, count] : driven) {
    if (count > most) rest = device;
    most = std::max(most, count);
  }
  if (most == 0 && by_topic) rest = *by_topic;
  if (!knowsDevices()) rest = stated.empty() ? madeUpDevice(topic, "robot") : std::string(stated);
  for (JointHome& home : homes) {
    if (home.match != JointMatch::unknown || rest.empty()) continue;
    home.match = JointMatch::driven;
    home.device = rest;
  }
  return homes;
}

}  // namespace rocinante::ros
