#pragma once

#include <string>

namespace rocinante {

/// The selected object.
struct Selection {
  std::string device;  ///< empty: nothing
  std::string link;    ///< empty: the device as a whole
  bool operator==(const Selection&) const = default;
  /// The PATH, as in packets and styles.
  std::string path() const;
};

}  // namespace rocinante
