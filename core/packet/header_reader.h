#pragma once

#include <string_view>

#include "core/packet/packet.h"
#include "core/packet/text_lines.h"
#include "core/packet/text_name.h"

namespace rocinante {

/// True when `line` is the header line of packet text version 1, well formed or not.
bool isHeaderLine(std::string_view line);

/// Reads a header line (docs/packet-format.md, section "The header") for which isHeaderLine()
/// holds. On false `column` is where it is malformed.
bool readHeader(std::string_view line, TextArena& arena, PacketHeader& header,
                std::uint32_t& column);

}  // namespace rocinante
