#include "core/log/other_format.h"

#include <fmt/format.h>

#include "core/base/reader_notice.h"
#include "core/log/log_profile.h"

namespace rocinante {

void noteOtherFormat(std::string_view format, std::string_view log) {
  addReaderNotice({fmt::format("{} ({})", profile::otherFormatText(format), log),
                   fmt::format("format \"{}\"", format.substr(0, 40))});
}

}  // namespace rocinante
