#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addVerifyCommand(CLI::App& program);

}  // namespace rocinante
