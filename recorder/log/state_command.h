#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addStateCommand(CLI::App& program);

}  // namespace rocinante
