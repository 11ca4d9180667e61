#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "core/self_test/fact.h"

namespace rocinante {

/// A fact about this machine, and what finds it. `programs`: the folder of our programs, for its
/// advice. It may change the scheduling of its process, opens its own sockets on free ports, so
/// that it disturbs no listener, and waits at most a second: call it in a child process.
struct MachineCheck {
  const char* name;
  SelfTestFact (*find)(const std::filesystem::path& programs);
};
std::span<const MachineCheck> machineChecks();

/// The decision of `receive_buffer`: bytes as the kernel counts them, twice what was asked for.
SelfTestFact judgeReceiveBuffer(std::uint64_t granted_bytes, std::uint64_t asked_bytes);

/// The decision of `clock`, from adjtimex(2): its answer, and its estimate of the error.
SelfTestFact judgeClock(bool is_synchronised, std::int64_t most_error_us);

}  // namespace rocinante
