#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addCatCommand(CLI::App& program);

}  // namespace rocinante
