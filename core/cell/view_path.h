#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/cell/posed_scene.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// What a PATH of a view names: DEVICE, DEVICE/LINK, layer/NAME, with `#GROUP` behind the first two
/// only the parts of a mesh group, and `*` in place of DEVICE every device. Names are
/// percent-encoded as in a packet, leniently, because people type these: any byte but `#` may stand
/// for itself. Packets know no `#` and no `*`, so neither clashes with a name that they carry.
struct ViewPath {
  Path path;               ///< decoded; `first` is empty for every device
  std::string group;       ///< a pattern (core/base/pattern.h) of MeshPart::group; empty: all parts
  bool has_group = false;  ///< only those parts
  bool all_devices = false;  ///< `*`

  bool operator==(const ViewPath&) const = default;

  /// Whether the link is named, be it alone, by its device or by a layer; parts apart.
  bool namesLink(const PosedDevice& device, std::size_t link) const;
  /// Whether a part of that link is named.
  bool namesPart(const PosedDevice& device, std::size_t link, std::string_view part_group) const;

 private:
  bool namesPartByLayer(const PosedDevice& device, std::size_t link,
                        std::string_view part_group) const;
};

/// bad_argument for what is no PATH.
Result<ViewPath> parseViewPath(std::string_view text);

}  // namespace rocinante
