#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addMarkCommand(CLI::App& program);

}  // namespace rocinante
