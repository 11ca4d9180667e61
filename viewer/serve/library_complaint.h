#pragma once

#include <string>

namespace rocinante {

/// From now on libwebsockets prints nothing.
void collectComplaints();
/// What it said last; it has no other way to say why it fails.
std::string lastComplaint();

}  // namespace rocinante
