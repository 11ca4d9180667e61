#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addDoctorCommand(CLI::App& program);

}  // namespace rocinante
