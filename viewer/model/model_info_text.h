#pragma once

#include <string>

#include "viewer/model/model_info.h"

namespace rocinante {

/// The information as text.
std::string modelInfoText(const ModelInfo& info);

}  // namespace rocinante
