#pragma once

#include "core/document/fault_list.h"
#include "core/kinematics/model.h"

namespace rocinante {

/// Warns, at `place`, of a model that has collision geometry and no visual: nothing of it is drawn
/// (docs/rules/model.md, "model.no-visual").
void judgeVisibility(const Model& model, Place place, FaultList& faults);

}  // namespace rocinante
