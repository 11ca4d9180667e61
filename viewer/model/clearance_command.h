#pragma once

#include "viewer/model/command_support.h"

namespace rocinante {

ModelCommand addClearanceCommand(CLI::App& program);

}  // namespace rocinante
