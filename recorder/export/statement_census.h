#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/packet/packet.h"

namespace rocinante {

/// Counts statements for which the formats of others have no messages.
class StatementCensus {
 public:
  void count(const Packet& packet) {
    for (const Statement& statement : packet.statements) {
      ++counts_[static_cast<std::size_t>(statement.kind)];
    }
  }

  /// Sentences: "3 hide statements have no counterpart there".
  std::vector<std::string> leftOut() const;

 private:
  std::array<std::uint64_t, static_cast<std::size_t>(StatementKind::seen) + 1> counts_{};
};

}  // namespace rocinante
