#pragma once

#include "viewer/model/command_support.h"

namespace rocinante {

ModelCommand addFkCommand(CLI::App& program);

}  // namespace rocinante
