#include "viewer/shown/signal_rows.h"

#include <fmt/format.h>

#include <string_view>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

/// Of a text, more than a row has room for.
constexpr std::size_t kShownBytes = 256;

/// A longer text ends with dots behind a whole character.
std::string shownText(std::string_view text) {
  constexpr std::string_view kMore = "...";
  if (text.size() <= kShownBytes) return plainText(text);
  std::size_t end = kShownBytes - kMore.size();
  const auto isInside = [&] { return (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80; };
  for (int step = 0; step < 3 && isInside(); ++step) --end;
  return plainText(text.substr(0, end)).append(kMore);
}

}  // namespace

std::string signalValueText(const SignalValue& value) {
  switch (value.kind) {
    case SignalKind::number:
      return fmt::format("{:.5g}{}{}", value.number == 0 ? 0 : value.number,
                         value.unit.empty() ? "" : " ", value.unit);
    case SignalKind::boolean:
      return value.number != 0 ? "true" : "false";
    case SignalKind::text:
      break;
  }
  return shownText(value.text);
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
