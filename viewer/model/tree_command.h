#pragma once

#include "viewer/model/command_support.h"

namespace rocinante {

ModelCommand addTreeCommand(CLI::App& program);

}  // namespace rocinante
