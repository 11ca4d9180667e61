#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addShiftCommand(CLI::App& program);

}  // namespace rocinante
