#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante {

/// One thing that the programs want of a machine, as `rocinante --self-test` found it
/// (docs/self-test.md).
struct SelfTestFact {
  enum class State : std::uint8_t {
    ok,       ///< as it should be
    limited,  ///< programs run, and do less: less exact, smaller, fewer kinds of files
    missing   ///< what needs it does not run here
  };

  std::string name;  ///< stable: "receive_buffer"
  State state = State::missing;
  std::string says;    ///< what was found
  std::string advice;  ///< what to do; empty when it is ok
  bool operator==(const SelfTestFact&) const = default;
};

std::string_view nameOf(SelfTestFact::State state);

/// A line for each, and how many there are of each state.
std::string factsText(std::span<const SelfTestFact> facts);
/// The same as a JSON object: `format`, `facts`, `ok`.
std::string factsJson(std::span<const SelfTestFact> facts);

/// How a program that looks at some of the facts hands them to the one that tells all: a JSON array
/// on one line.
std::string factsWire(std::span<const SelfTestFact> facts);
/// Empty when `line` is not that.
std::optional<std::vector<SelfTestFact>> factsOfWire(std::string_view line);

}  // namespace rocinante
