#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/cell/cell.h"

namespace rocinante {

/// The names of all layers of a cell: those that it lists, and `layer` and `tags` of its devices.
std::set<std::string, std::less<>> layerNames(const Cell& cell);

/// A layer's membership of a device, or of some of its links or parts. Borrows from the cell.
struct LayerShare {
  std::string_view layer;
  const CellLayer* listed = nullptr;    ///< null: no [[layer]] has this name
  const LayerMember* member = nullptr;  ///< null: the whole device
};

/// Finds the layers of a device without asking each member of each layer. Borrows the cell, whose
/// layers must stay as they are meanwhile.
class LayerIndex {
 public:
  explicit LayerIndex(const Cell& cell);

  /// Null when no [[layer]] has the name.
  const CellLayer* find(std::string_view layer) const;
  /// Memberships of the device of that name, in the order of the cell.
  std::vector<LayerShare> sharesOf(std::string_view device) const;

 private:
  struct Member {
    std::size_t layer = 0, number = 0;  // of it: the order of the cell
    auto operator<=>(const Member&) const = default;
  };
  const Cell* cell_;
  std::map<std::string_view, std::size_t> by_name_;
  std::map<std::string_view, std::vector<Member>> by_device_;
  std::vector<Member> of_all_;  // devices
};

}  // namespace rocinante
