#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/self_test/fact.h"

namespace rocinante {

/// Checks some facts in a process of its own: a driver that crashes, or a file system that hangs,
/// costs only these facts.
struct FactJob {
  std::vector<std::string> names;  ///< of the facts that it answers, in their order
  /// Called in a child process, which prints what is returned, or becomes another program that
  /// prints factsWire().
  std::function<std::vector<SelfTestFact>()> find;
};

/// Runs `program --only NAME,...`. `advice`: of its facts, where it is not installed.
FactJob jobOfProgram(std::vector<std::string> names, const std::filesystem::path& program,
                     const std::string& advice);

/// All of them at once, in the order of the jobs. A job that has not answered after `limit` is
/// killed. Each fact of a job that did not answer is missing, with the reason. Call it before any
/// thread is started.
std::vector<SelfTestFact> findFacts(const std::vector<FactJob>& jobs, Nanoseconds limit);

}  // namespace rocinante
