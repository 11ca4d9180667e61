#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addRecoverCommand(CLI::App& program);

}  // namespace rocinante
