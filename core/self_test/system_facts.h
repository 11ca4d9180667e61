#pragma once

#include <cstdint>
#include <filesystem>

#include "core/self_test/fact.h"

namespace rocinante {

/// Facts about the system of this machine. `programs`: the folder of our programs.

/// SCHED_FIFO, which gives `play` microsecond timing. Changes the scheduling of this process: call
/// it in a child that ends afterwards.
SelfTestFact schedulingFact(const std::filesystem::path& programs);
/// nice -10, with which a killed `record` loses less on a busy machine. Also only for a child.
SelfTestFact priorityFact(const std::filesystem::path& programs);
/// Whether the wall clock is synchronised.
SelfTestFact clockFact();
/// Whether logs can be written in `folder`: by this user, with locks, and room allocated ahead.
SelfTestFact filesFact(const std::filesystem::path& folder);
/// Whether SDF models can be read: the module of core/kinematics/sdformat_module.h.
SelfTestFact sdfFact();

/// The decision of clockFact(), from adjtimex(2): its answer, and its estimate of the error.
SelfTestFact judgeClock(bool is_synchronised, std::int64_t most_error_us);

}  // namespace rocinante
