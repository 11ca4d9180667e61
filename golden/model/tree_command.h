#pragma once

#include "golden/model/command_support.h"

namespace rocinante {

ModelCommand addTreeCommand(CLI::App& program);

}  // namespace rocinante
