#pragma once

#include "viewer/model/command_support.h"

namespace rocinante {

ModelCommand addConvertCommand(CLI::App& program);

}  // namespace rocinante
