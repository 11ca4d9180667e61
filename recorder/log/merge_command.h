#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addMergeCommand(CLI::App& program);

}  // namespace rocinante
