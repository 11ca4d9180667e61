#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cell/posed_scene.h"
#include "core/cell/view_path.h"

namespace rocinante {

/// What a viewer chose to see, by PATH (view_path.h): it outranks packets, which outrank the cell.
/// The nearest choice decides: a part's (of its link, of its device, of every device), else the
/// link's own, that of links of its name, its device's, that of every device. A layer stands
/// directly below what it holds: parts, a link or a device. A PATH both hidden and shown is hidden,
/// and so is what several layers of one nearness hide and show.
///
/// Besides the cell's, these layers are always there: grid, gnomon, lines, points, labels.
class ViewChoice {
 public:
  /// bad_argument for a PATH that is none.
  static Result<ViewChoice> make(const std::vector<std::string>& hide,
                                 const std::vector<std::string>& show);

  /// Of a link, but for parts that were chosen by themselves.
  bool linkVisible(const PosedDevice& device, std::size_t link) const {
    return linkVisible(device, link, chosenWhole(device));
  }
  /// What was chosen for all links of a device alike; empty: nothing.
  std::optional<bool> chosenWhole(const PosedDevice& device) const;
  /// linkVisible() for link after link of one device, whose chosenWhole() is at hand.
  bool linkVisible(const PosedDevice& device, std::size_t link, std::optional<bool> whole) const {
    return chosen(device, link, whole).value_or(device.visible && device.link_visible[link]);
  }
  /// Whether parts of that device must be asked for one by one.
  bool choosesParts(const PosedDevice& device) const { return !parts_.empty() || device.has_parts; }
  bool partVisible(const PosedDevice& device, std::size_t link, std::string_view group) const;
  /// One of the built-in layers; they are visible unless hidden.
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
  /// By those layers of the device that `holds` is true of.
  template <class Holds>
  std::optional<bool> chosenByLayers(const PosedDevice& device, const Holds& holds) const;

  std::map<Path, bool> visible_;   ///< an empty `first`: every device
  bool names_links_ = false;       ///< one of them is of a link
  std::vector<PartChoice> parts_;  ///< the nearest first, among equals what is hidden
};

}  // namespace rocinante
