#pragma once

#include "golden/model/command_support.h"

namespace rocinante {

ModelCommand addConvertCommand(CLI::App& program);

}  // namespace rocinante
