#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace rocinante::ros {

/// What something beside them says of the messages of some inputs of an import, which follow each
/// other.
struct StatedMessages {
  std::size_t first = 0, inputs = 1;
  std::optional<std::uint64_t> count;
  std::string name;         ///< of them together: "bag_0.db3", "the bag"
  std::string where;        ///< who says it: " (bag/metadata.yaml)"
  std::string compression;  ///< of each message, one that is not read; empty: none
};

}  // namespace rocinante::ros
