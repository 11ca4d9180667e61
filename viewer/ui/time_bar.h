#pragma once

#include "core/time.h"
#include "viewer/ui/transport.h"
#include "viewer/ui/view_model.h"

namespace rocinante {

/// The time line at the bottom, with its events.
void drawTimeBar(ViewModel& model, Transport& transport, SteadyTime now);

}  // namespace rocinante
