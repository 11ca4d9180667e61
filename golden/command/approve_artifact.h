#pragma once

#include "core/base/result.h"
#include "core/cli/program.h"
#include "golden/approval/approval_list.h"
#include "golden/command/approve_command.h"

namespace rocinante {

/// Makes the pictures that a job of CI drew the goldens of the frames in `list`. Draws nothing and
/// needs no log: what the manifest says of them (key, session, inputs) is what their report says.
Result<cli::Exit> approveArtifact(const ApproveArguments& arguments, const ApprovalList& list);

}  // namespace rocinante
