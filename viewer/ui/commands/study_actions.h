#pragma once

#include <filesystem>

#include "core/base/time.h"
#include "viewer/ui/model/view_model.h"

/// What commands and panels both do with the study of a log.
namespace rocinante {

/// Writes what the plots show as a table: the numbers that are stated, what is derived of them, and
/// not rates of packets. bad_argument when there are none of them. The study says how it went, and
/// which texts are left out.
Status writePlotted(ViewModel& model, const std::filesystem::path& path);

/// Shows a finding of model.findings(), by its number from 1: selects its device and goes to its
/// first moment. Nothing happens for a number that there is not.
void showFinding(ViewModel& model, TimelineCursor& cursor, std::size_t number, SteadyTime now);

}  // namespace rocinante
