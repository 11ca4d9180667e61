#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addCutCommand(CLI::App& program);
LogCommand addFilterCommand(CLI::App& program);

}  // namespace rocinante
