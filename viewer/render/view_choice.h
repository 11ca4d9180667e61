#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/posed_scene.h"
#include "core/result.h"

namespace rocinante {

/// What a viewer chose to see, by PATH (DEVICE, DEVICE/LINK or layer/NAME, percent-encoded as in a
/// packet): it outranks packets, which outrank the cell. The nearest choice decides: the link's
/// own, else its device's, else its layer's. A PATH both hidden and shown is hidden.
///
/// Besides the cell's, these layers are always there: grid, gnomon, lines, points, labels.
class ViewChoice {
 public:
  /// bad_argument for a PATH that is none.
  static Result<ViewChoice> make(const std::vector<std::string>& hide,
                                 const std::vector<std::string>& show);

  bool linkVisible(const PosedDevice& device, std::size_t link) const;
  /// One of the built-in layers; they are visible unless hidden.
  bool layerVisible(std::string_view layer) const;

 private:
  std::map<Path, bool> visible_;
};

}  // namespace rocinante
