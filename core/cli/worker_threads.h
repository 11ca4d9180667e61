#pragma once

#include "core/base/parallel_for.h"

namespace rocinante::cli {

/// A ParallelFor on as many threads as the process may run on, the caller's among them. The others
/// are started by each call and have ended when it returns. For programs: core itself starts none.
ParallelFor workerThreads();

}  // namespace rocinante::cli
