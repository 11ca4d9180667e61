#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace rocinante::ros {

/// How many messages some inputs of an import have, which follow each other, as something beside
/// them says.
struct StatedMessages {
  std::size_t first = 0, inputs = 1;
  std::uint64_t count = 0;
  std::string name;   ///< of them together: "bag_0.db3", "the bag"
  std::string where;  ///< who says it: " (bag/metadata.yaml)"
};

}  // namespace rocinante::ros
