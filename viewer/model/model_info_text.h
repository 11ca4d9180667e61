#pragma once

#include <string>

#include "viewer/model/model_info.h"

namespace rocinante {

/// For people.
std::string modelInfoText(const ModelInfo& info);

}  // namespace rocinante
