#pragma once

#include <cstdint>
#include <filesystem>

#include "core/self_test/fact.h"

namespace rocinante {

/// What the system of this machine gives to the programs. `programs`: the folder that ours lie in.

/// SCHED_FIFO, by which `play` keeps its microseconds. Changes this process's own scheduling: for a
/// child that ends afterwards.
SelfTestFact schedulingFact(const std::filesystem::path& programs);
/// nice -10, by which a killed `record` loses less on a busy machine. The same.
SelfTestFact priorityFact(const std::filesystem::path& programs);
/// Whether something keeps the wall clock right.
SelfTestFact clockFact();
/// Whether logs can be written in `folder`: by this user, with locks, and room allocated ahead.
SelfTestFact filesFact(const std::filesystem::path& folder);
/// Whether SDF models can be read: the module of core/kinematics/sdformat_module.h.
SelfTestFact sdfFact();

/// The decision of clockFact(), from adjtimex(2): its answer, and its estimate of the error.
SelfTestFact judgeClock(bool is_synchronised, std::int64_t most_error_us);

}  // namespace rocinante
