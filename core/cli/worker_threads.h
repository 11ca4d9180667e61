#pragma once

#include "core/base/parallel_for.h"

namespace rocinante::cli {

/// A ParallelFor on as many threads as the process may use, the caller's included. Each call starts
/// the others and joins them before it returns. For programs: core itself starts no threads.
ParallelFor workerThreads();

}  // namespace rocinante::cli
