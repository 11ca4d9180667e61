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
  /// Called in a child process.
  std::function<std::vector<SelfTestFact>()> find;
  /// When not empty, this program is run instead; it prints factsWire().
  std::filesystem::path program;
  std::vector<std::string> arguments;
  std::string without_program;  ///< the advice when it is not installed
};

/// All of them at once, in the order of the jobs. A job that has not answered after `limit` is
/// killed. Each fact of a job that did not answer is missing, with the reason. Call it before any
/// thread is started.
std::vector<SelfTestFact> findFacts(const std::vector<FactJob>& jobs, Nanoseconds limit);

}  // namespace rocinante
