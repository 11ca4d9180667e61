#include "core/log/log_end.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/mcap/records.h"

namespace rocinante {

bool magicAt(ByteView file, std::uint64_t position) {
  const ByteView magic = mcap::magic();
  const ByteView rest = file.subspan(static_cast<std::size_t>(position));
  return rest.size() >= magic.size() && std::ranges::equal(rest.first(magic.size()), magic);
}

std::string trailingText(ByteView file, std::uint64_t end) {
  if (!magicAt(file, end)) return "bytes follow the end of the log and are not read";
  return fmt::format(
      "another log follows the end of this one and is not read; `tail -c +{}` of the file gives it "
      "alone",
      end + 1);
}

}  // namespace rocinante
