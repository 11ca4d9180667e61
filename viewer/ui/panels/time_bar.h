#pragma once

#include "core/base/time.h"
#include "viewer/ui/model/transport.h"
#include "viewer/ui/model/view_model.h"

namespace rocinante {

/// The time line at the bottom, with its events.
void drawTimeBar(ViewModel& model, Transport& transport, SteadyTime now);

}  // namespace rocinante
