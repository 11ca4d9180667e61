#include "core/recording/reorder_window.h"

namespace rocinante {

void ReorderWindow::add(DatagramBlock& block) {
  for (const Arrival& arrival : block.arrivals()) {
    waiting_[arrival.endpoint].push_back({&block, &arrival, arrival.time});
  }
}

std::optional<std::size_t> ReorderWindow::earliest() const {
  std::optional<std::size_t> first;
  for (std::size_t endpoint = 0; endpoint < waiting_.size(); ++endpoint) {
    if (waiting_[endpoint].empty()) continue;
    if (!first || waiting_[endpoint].front().time < waiting_[*first].front().time) {
      first = endpoint;
    }
  }
  return first;
}

std::optional<ReorderWindow::Held> ReorderWindow::take(std::size_t endpoint) {
  Held held = waiting_[endpoint].front();
  waiting_[endpoint].pop_front();
  if (held.time < reached_) {
    held.time = reached_;
    ++late_;
  }
  reached_ = held.time;
  return held;
}

std::optional<ReorderWindow::Held> ReorderWindow::next(LogTime drained_until) {
  const std::optional<std::size_t> first = earliest();
  if (!first || waiting_[*first].front().time > drained_until - kWidth) return std::nullopt;
  return take(*first);
}

std::optional<ReorderWindow::Held> ReorderWindow::nextOfAll() {
  const std::optional<std::size_t> first = earliest();
  if (!first) return std::nullopt;
  return take(*first);
}

}  // namespace rocinante
