#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addSplitCommand(CLI::App& program);

}  // namespace rocinante
