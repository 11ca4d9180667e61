#pragma once

#include <string>

#include "viewer/model/model_info.h"

namespace rocinante {

/// For scripts.
std::string modelInfoJson(const ModelInfo& info);

}  // namespace rocinante
