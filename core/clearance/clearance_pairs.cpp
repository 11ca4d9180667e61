#include "core/clearance/clearance_pairs.h"

#include <algorithm>
#include <map>

#include "core/base/pattern.h"
#include "core/cell/layer_index.h"

namespace rocinante {
namespace {

/// The links that one pattern names.
using Members = std::vector<std::vector<bool>>;  // by device and link

class LinkPatterns {
 public:
  LinkPatterns(const Cell& cell, const PosedScene& scene, const CellPlacement& placement)
      : layers_(layerNames(cell)), scene_(scene), placement_(placement) {}

  const Members& named(const std::string& pattern) {
    const auto [found, is_new] = known_.try_emplace(pattern);
    if (is_new) found->second = find(pattern);
    return found->second;
  }

 private:
  Members find(const std::string& pattern) const {
    constexpr std::string_view kLayer = "layer/";
    std::vector<std::string_view> layers;
    if (pattern.starts_with(kLayer)) {
      const std::string_view wanted = std::string_view(pattern).substr(kLayer.size());
      for (const std::string& layer : layers_) {
        if (patternMatches(wanted, layer)) layers.push_back(layer);
      }
    }
    Members members;
    for (const PlacedDevice& device : placement_.devices) {
      const PosedDevice* const posed = scene_.findDevice(device.name);
      const bool is_whole = patternMatches(pattern, device.name);
      std::vector<bool>& links = members.emplace_back();
      for (std::size_t link = 0; link < device.model->links.size(); ++link) {
        const auto is_in = [&](std::string_view layer) {
          return posed != nullptr && posed->inLayer(layer, link);
        };
        links.push_back(
            is_whole || std::ranges::any_of(layers, is_in) ||
            patternMatches(pattern, device.name + "/" + device.model->links[link].name));
      }
    }
    return members;
  }

  std::set<std::string, std::less<>> layers_;
  const PosedScene& scene_;
  const CellPlacement& placement_;
  std::map<std::string, Members> known_;
};

/// By link: the first link of those that fixed joints join to it.
std::vector<std::size_t> rigidGroups(const Model& model) {
  std::vector<std::size_t> group(model.links.size());
  for (std::size_t link = 0; link < group.size(); ++link) group[link] = link;
  for (const std::size_t i : model.update_order) {
    const Joint& joint = model.joints[i];
    if (joint.type == JointType::fixed) group[joint.child] = group[joint.parent];
  }
  return group;
}

bool areAdjacent(const Model& model, const std::vector<std::size_t>& group, std::size_t a,
                 std::size_t b) {
  if (group[a] == group[b]) return true;
  return std::ranges::any_of(model.joints, [&](const Joint& joint) {
    const std::size_t parent = group[joint.parent], child = group[joint.child];
    return (parent == group[a] && child == group[b]) || (parent == group[b] && child == group[a]);
  });
}

class PairFinder {
 public:
  PairFinder(const Cell& cell, const PosedScene& scene, const CellPlacement& placement,
             BodyStore& bodies)
      : cell_(cell), placement_(placement), bodies_(bodies), patterns_(cell, scene, placement) {
    for (const PlacedDevice& device : placement.devices) {
      if (!groups_.contains(device.model)) groups_[device.model] = rigidGroups(*device.model);
    }
  }

  ClearancePairs find() {
    for (std::size_t i = 0; i < cell_.clearances.size(); ++i) {
      const std::size_t before = found_.pairs.size();
      findOf(i);
      if (found_.pairs.size() == before) found_.empty.push_back(i);
    }
    return std::move(found_);
  }

 private:
  void findOf(std::size_t clearance) {
    const CellClearance& wanted = cell_.clearances[clearance];
    const Members& first = patterns_.named(wanted.between.first);
    const Members& second = patterns_.named(wanted.between.second);
    std::vector<std::pair<const Members*, const Members*>> except;
    for (const ClearancePatterns& each : wanted.except) {
      except.emplace_back(&patterns_.named(each.first), &patterns_.named(each.second));
    }
    const auto is_either = [](const Members& x, const Members& y, LinkId a, LinkId b) {
      return (x[a.device][a.link] && y[b.device][b.link]) ||
             (x[b.device][b.link] && y[a.device][a.link]);
    };
    forEachPair(wanted.is_self, [&](LinkId a, LinkId b) {
      if (!is_either(first, second, a, b) || areJoined(a, b)) return;
      for (const auto& [x, y] : except) {
        if (is_either(*x, *y, a, b)) return;
      }
      add(clearance, a, b);
    });
  }

  template <class Each>
  void forEachPair(bool is_self, const Each& each) const {
    const auto linksOf = [&](std::size_t device) {
      return placement_.devices[device].model->links.size();
    };
    for (std::size_t a = 0; a < placement_.devices.size(); ++a) {
      for (std::size_t b = is_self ? a : a + 1; b < (is_self ? a + 1 : placement_.devices.size());
           ++b) {
        for (std::size_t i = 0; i < linksOf(a); ++i) {
          for (std::size_t j = is_self ? i + 1 : 0; j < linksOf(b); ++j) each({a, i}, {b, j});
        }
      }
    }
  }

  bool areJoined(LinkId a, LinkId b) const {
    const PlacedDevice& device_a = placement_.devices[a.device];
    const PlacedDevice& device_b = placement_.devices[b.device];
    if (a.device == b.device) {
      return areAdjacent(*device_a.model, groups_.at(device_a.model), a.link, b.link);
    }
    return device_a.carrier == b || device_b.carrier == a;
  }

  void add(std::size_t clearance, LinkId a, LinkId b) {
    if (found_.pairs.size() >= kMaxClearancePairs) {
      found_.too_many = true;
      return;
    }
    ClearancePair pair{clearance, a, b, nullptr, nullptr, std::nullopt};
    pair.body_a = bodies_.find(*placement_.devices[a.device].model, a.link);
    if (pair.body_a == nullptr) return;
    pair.body_b = bodies_.find(*placement_.devices[b.device].model, b.link);
    if (pair.body_b == nullptr) return;
    pair.common = commonCarrier(placement_, a, b);
    found_.pairs.push_back(pair);
  }

  const Cell& cell_;
  const CellPlacement& placement_;
  BodyStore& bodies_;
  LinkPatterns patterns_;
  std::map<const Model*, std::vector<std::size_t>> groups_;
  ClearancePairs found_;
};

}  // namespace

ClearancePairs clearancePairs(const Cell& cell, const PosedScene& scene,
                              const CellPlacement& placement, BodyStore& bodies) {
  return PairFinder(cell, scene, placement, bodies).find();
}

}  // namespace rocinante
