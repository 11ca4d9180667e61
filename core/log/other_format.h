#pragma once

#include <string_view>

namespace rocinante {

/// A reader notice (core/base/reader_notice.h) that rocinante.session of `log` gives another format
/// than profile::kFormat.
void noteOtherFormat(std::string_view format, std::string_view log);

}  // namespace rocinante
