#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/packet/packet.h"

namespace rocinante {

/// What passes a relay's output. Statements about no device (drawings, events, views, `layer/NAME`,
/// signals of `-`) pass whatever `devices` says; paths `DEVICE/LINK` go with their device. What is
/// no signal passes whatever `signals` says. A plain value.
struct RelayFilter {
  std::vector<std::string> sources;  ///< patterns (core/base/pattern.h), one must match; empty: all
  std::vector<std::string> devices;  ///< likewise
  std::uint32_t kinds = ~std::uint32_t{0};  ///< one bit for each StatementKind
  std::vector<std::string> signals{};       ///< likewise, of `PATH NAME`

  bool passesEverything() const;
  bool passesSource(std::string_view source) const;
  bool passesDevice(std::string_view device) const;
  /// `path_and_name`: as packets write them, after `signal`.
  bool passesSignal(std::string_view path_and_name) const;
  bool passesKind(StatementKind kind) const {
    return (kinds >> static_cast<unsigned>(kind) & 1U) != 0;
  }
};

/// The kinds that one word of `--statement` names: what belongs together passes together. joints,
/// order and joint are one; so are add and remove; show and hide. `erase` passes with any drawing.
/// bad_argument for a word that is not a statement's.
Result<std::uint32_t> statementKindsOf(std::string_view word);

}  // namespace rocinante
