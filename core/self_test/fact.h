#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante {

/// One property of the machine that the programs need, as `rocinante --self-test` found it
/// (docs/self-test.md).
struct SelfTestFact {
  enum class State : std::uint8_t {
    ok,       ///< as it should be
    limited,  ///< programs run with less: less exact, smaller, fewer file formats
    missing   ///< programs that need it do not run here
  };

  std::string name;  ///< stable: "receive_buffer"
  State state = State::missing;
  std::string found;   ///< what was found
  std::string advice;  ///< what to do; empty when it is ok
  bool operator==(const SelfTestFact&) const = default;
};

/// One line per fact, and the count of each state.
std::string factsText(std::span<const SelfTestFact> facts);
/// The same as a JSON object: `format`, `facts`, `ok`.
std::string factsJson(std::span<const SelfTestFact> facts);

/// How a process that checks some of the facts passes them to the one that reports all: a JSON
/// array on one line.
std::string factsWire(std::span<const SelfTestFact> facts);
/// Empty when `line` is not one.
std::optional<std::vector<SelfTestFact>> factsOfWire(std::string_view line);

}  // namespace rocinante
