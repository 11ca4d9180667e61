#include "core/packet/session_state.h"

#include <algorithm>
#include <utility>

#include "core/packet/item_text.h"
#include "core/packet/packet_limits.h"
#include "core/packet/packet_text.h"

namespace rocinante {

std::vector<Event> SessionState::takeEvents() { return std::exchange(events_, {}); }

bool SessionState::restatementOpen(LogTime now) const {
  return std::any_of(open_.begin(), open_.end(), [&](const auto& open) {
    return now < open.second.began + limits::kRestatementSpan;
  });
}

bool SessionState::sameAs(const SessionState& other) const {
  return maps() == other.maps() && sources_ == other.sources_;
}

std::string SessionState::identityText() const {
  std::vector<std::string> lines;
  for (const auto& [name, source] : sources_) lines.push_back("source " + sourceText(name, source));
  for (const auto& [name, device] : devices_) {
    lines.push_back("device" + seenText(name, device.last_write).substr(4));
  }
  eachItem(*this, [&](const auto& item) {
    lines.push_back("item " + encodeName(item.owner()) + ' ' + statementText(item));
  });
  std::sort(lines.begin(), lines.end());
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

}  // namespace rocinante
