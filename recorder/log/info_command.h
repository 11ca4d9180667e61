#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addInfoCommand(CLI::App& program);

}  // namespace rocinante
