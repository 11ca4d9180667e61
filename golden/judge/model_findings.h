#pragma once

#include <string>

#include "core/behaviour/run_judgement.h"
#include "core/cell/cell.h"

namespace rocinante {

/// Puts what moves the links in a model that has changed in front of what was judged.
void addModelFindings(const Cell& then, const Cell& now, RunJudgement& judged);

/// Where a model has changed and cannot be put back, the accepted log is judged as today's cell has
/// it, so that the same motion means nothing: a finding. `why`: a clause.
void addUnknownModel(const std::string& why, RunJudgement& judged);

}  // namespace rocinante
