#pragma once

#include "golden/model/command_support.h"

namespace rocinante {

ModelCommand addInfoCommand(CLI::App& program);

}  // namespace rocinante
