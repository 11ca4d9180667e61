#pragma once

#include <vector>

#include "golden/judge/judged_run.h"
#include "golden/judge/suite_session.h"

namespace rocinante {

/// Sets JudgedRun::changes of runs that are not as accepted: what changed in the model or cell
/// since their first log was accepted, as modelChanges() says it.
void explainRuns(const SuiteSession& session, const SuiteOptions& options,
                 std::vector<JudgedRun>& runs);

}  // namespace rocinante
