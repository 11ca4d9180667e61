#include "viewer/shown/signal_rows.h"

#include <fmt/format.h>

#include "core/base/plain_text.h"

namespace rocinante {

std::string signalValueText(const SignalValue& value) {
  /// Of a text, more than a row has room for.
  constexpr std::size_t kShownBytes = 256;
  switch (value.kind) {
    case SignalKind::number:
      return fmt::format("{:.5g}{}{}", value.number == 0 ? 0 : value.number,
                         value.unit.empty() ? "" : " ", value.unit);
    case SignalKind::boolean:
      return value.number != 0 ? "true" : "false";
    case SignalKind::text:
      break;
  }
  return plainText(std::string_view(value.text).substr(0, kShownBytes));
}

std::vector<SignalRow> signalRows(const std::string& device, const Signals& signals,
                                  const std::string& link, std::size_t most) {
  std::vector<SignalRow> rows;
  for (const auto& [name, item] : signals) {
    if (rows.size() == most) break;
    if (!link.empty() && name.link != link) continue;
    SignalRow row;
    row.series = {SeriesKey::Kind::signal, device, name.name, name.link};
    row.name = plainText(name.link.empty() ? name.name : name.link + " " + name.name);
    row.text = signalValueText(item.value);
    row.owner = item.owner;
    row.kind = item.value.kind;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace rocinante
