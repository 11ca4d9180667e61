#include "recorder/export/statement_census.h"

#include <fmt/format.h>

#include "core/base/count_text.h"

namespace rocinante {

std::vector<std::string> StatementCensus::leftOut() const {
  constexpr std::array kUnknownThere = {StatementKind::show, StatementKind::hide,
                                        StatementKind::color, StatementKind::view};
  std::vector<std::string> sentences;
  for (const StatementKind kind : kUnknownThere) {
    const std::uint64_t count = counts_[static_cast<std::size_t>(kind)];
    if (count == 0) continue;
    sentences.push_back(fmt::format("{} left out: the format has nothing for {}",
                                    countText(count, fmt::format("`{}` statement", nameOf(kind))),
                                    count == 1 ? "it" : "them"));
  }
  return sentences;
}

}  // namespace rocinante
