#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addDiffCommand(CLI::App& program);

}  // namespace rocinante
