#include <fmt/format.h>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/packet/item_text.h"
#include "core/packet/packet_text.h"
#include "recorder/contents/log_state.h"

namespace rocinante {
namespace {

/// The listing, line by line. Each item is shown as the statement that would restate it.
class StateLines {
 public:
  explicit StateLines(const ShownState& shown) : shown_(shown) {}

  std::string text() {
    const SessionState& state = *shown_.state;
    heading("sources", state.sources().size());
    for (const auto& [name, source] : state.sources()) {
      text_ += fmt::format("  {}\n", sourceText(name, source));
    }
    eachMap(state, [&](std::string_view name, const auto& map) {
      heading(name, map.size());
      for (const auto& [key, value] : map) add(key, value);
    });
    return std::move(text_);
  }

 private:
  void heading(std::string_view name, std::size_t count) {
    if (count > 0) text_ += fmt::format("{} ({})\n", name, count);
  }

  void add(const std::string& name, const DeviceState& device) {
    const Nanoseconds written = device.last_write - shown_.origin;
    text_ += fmt::format("  {}, last written at {} s\n", encodeName(name), secondsText(written, 3));
    // The orders stand behind the joints, and the pose before them; then signals.
    std::string joints, orders, signals;
    const ByKind add_line{
        [&](const PresenceItem& item) { text_ += lineOf(item); },
        [&](const PoseItem& item) { text_ += lineOf(item); },
        [&](const PositionsItem& item) { joints += lineOf(item); },
        [&](const JointItem& item) { joints += lineOf(item); },
        [&](const OrderItem& item) { orders += lineOf(item); },
        [&](const SignalItem& item) { signals += lineOf(item); },
    };
    eachItemOf(name, device, add_line);
    text_ += joints + orders + signals;
  }
  template <class Key, class Value>
  void add(const Key& key, const Value& value) {
    eachItemOf(key, value, [&](const auto& item) { text_ += lineOf(item); });
  }

  template <class Stated>
  static std::string lineOf(const Stated& item) {
    return fmt::format("    {}  ({})\n", plainText(statementText(item)), encodeName(item.owner()));
  }

  const ShownState& shown_;
  std::string text_;
};

}  // namespace

std::string stateText(const ShownState& shown) {
  return fmt::format("{} at {} s\n", plainText(shown.log),
                     secondsText(shown.moment - shown.origin, 3)) +
         StateLines(shown).text();
}

}  // namespace rocinante
