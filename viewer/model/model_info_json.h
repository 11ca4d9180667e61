#pragma once

#include <string>

#include "viewer/model/model_info.h"

namespace rocinante {

/// The information as JSON.
std::string modelInfoJson(const ModelInfo& info);

}  // namespace rocinante
