#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/cell/posed_scene.h"
#include "core/cell/view_path.h"

namespace rocinante {

/// Every layer of a picture of the cell: the cell's layers and the built-in ones (grid, gnomon,
/// labels, lines, points).
using KnownLayers = std::set<std::string, std::less<>>;
KnownLayers knownLayers(const Cell& cell);

/// Only these layers: hides every device and the built-in layers, and shows these.
void chooseLayers(const std::vector<std::string>& layers, std::vector<std::string>& hide,
                  std::vector<std::string>& show);

/// A user's choice of visible objects by PATH (view_path.h): it overrides packets, which override
/// the cell. The most specific choice decides: a part's (of its link, its device, every device),
/// else the link's, that of links of its name, its device's, that of every device. A layer ranks
/// directly below its content: parts, a link or a device. A PATH both hidden and shown is hidden,
/// and so is an object that layers of one rank both hide and show.
///
/// Besides the cell's, these layers always exist: grid, gnomon, lines, points, labels.
class ViewChoice {
 public:
  /// bad_argument for an invalid PATH.
  static Result<ViewChoice> make(const std::vector<std::string>& hide,
                                 const std::vector<std::string>& show);

  /// Visibility of a link, except for parts with their own choice.
  bool linkVisible(const PosedDevice& device, std::size_t link) const {
    return linkVisible(device, link, chosenWhole(device));
  }
  /// The choice for all links of a device, if any.
  std::optional<bool> chosenWhole(const PosedDevice& device) const;
  /// linkVisible() for many links of one device, given its chosenWhole().
  bool linkVisible(const PosedDevice& device, std::size_t link, std::optional<bool> whole) const {
    return chosen(device, link, whole).value_or(device.visible && device.link_visible[link]);
  }
  /// Whether parts of the device need individual checks.
  bool choosesParts(const PosedDevice& device) const { return !parts_.empty() || device.has_parts; }
  bool partVisible(const PosedDevice& device, std::size_t link, std::string_view group) const;
  /// Visibility of a built-in layer; visible unless hidden.
  bool layerVisible(std::string_view layer) const;

 private:
  struct PartChoice {
    ViewPath path;
    bool visible = true;
    int nearness = 0;
  };

  std::optional<bool> chosen(const Path& path) const;
  std::optional<bool> chosen(const PosedDevice& device, std::size_t link,
                             std::optional<bool> whole) const;
  /// The choice by the device's layers for which `holds` is true.
  template <class Holds>
  std::optional<bool> chosenByLayers(const PosedDevice& device, const Holds& holds) const;

  std::map<Path, bool> visible_;   ///< an empty `first`: every device
  bool names_links_ = false;       ///< one of them names a link
  std::vector<PartChoice> parts_;  ///< the most specific first, hidden before shown
};

}  // namespace rocinante
