#pragma once

#include "viewer/model/command_support.h"

namespace rocinante {

ModelCommand addInfoCommand(CLI::App& program);

}  // namespace rocinante
