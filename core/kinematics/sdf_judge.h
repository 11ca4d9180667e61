#pragma once

#include "core/document/fault_list.h"
#include "core/document/xml_document.h"

namespace rocinante {

/// Judges an SDF whose root is <sdf> before libsdformat reads it, since libsdformat names neither
/// the value nor, often, the place: the version, and every value of an element that is read. Adds
/// to the account what the reader does not use. False: with an error, for which libsdformat refuses
/// the file.
bool judgeSdf(const XmlDocument& document, FaultList& faults);

}  // namespace rocinante
