#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {

/// The other devices that cover the device when they cover more than half of it in a frame of this
/// request, by name; else none. Drawings of the session do not count.
Result<std::vector<std::string>> devicesInFront(FrameMaker& maker, const FrameRequest& request,
                                                const std::string& device);

}  // namespace rocinante
