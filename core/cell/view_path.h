#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/cell/posed_scene.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// A PATH of a view: DEVICE, DEVICE/LINK or layer/NAME. `#GROUP` after the first two means only the
/// parts of a mesh group, and `*` as DEVICE every device. Names are percent-encoded as in a packet,
/// leniently, because users type these: any byte but `#` may be written as it is. Packets have
/// neither `#` nor `*`, so neither clashes with a name in a packet.
struct ViewPath {
  Path path;               ///< decoded; `first` is empty for every device
  std::string group;       ///< a pattern (core/base/pattern.h) of MeshPart::group; empty: all parts
  bool has_group = false;  ///< only those parts
  bool all_devices = false;  ///< `*`

  bool operator==(const ViewPath&) const = default;

  /// Whether the link is named: by itself, by its device or by a layer; ignores parts.
  bool namesLink(const PosedDevice& device, std::size_t link) const;
  /// Whether a part of that link is named.
  bool namesPart(const PosedDevice& device, std::size_t link, std::string_view part_group) const;

 private:
  bool namesPartByLayer(const PosedDevice& device, std::size_t link,
                        std::string_view part_group) const;
};

/// bad_argument when the text is not a PATH.
Result<ViewPath> parseViewPath(std::string_view text);

}  // namespace rocinante
