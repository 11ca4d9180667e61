#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addTableCommand(CLI::App& program);

}  // namespace rocinante
