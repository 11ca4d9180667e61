#include "player/send/send_batch.h"

namespace rocinante {

void SendBatch::add(const Due& due, SteadyTime deadline, ByteView payload) {
  items_[count_++] = {due, deadline, bytes_.size(), payload.size()};
  bytes_.insert(bytes_.end(), payload.begin(), payload.end());
}

Status SendBatch::send(SendPort& port, SendJournal& journal) {
  std::array<ByteView, kMax> payloads;
  std::array<SteadyTime, kMax> sent_at{};
  for (std::size_t i = 0; i < count_; ++i) {
    payloads[i] = ByteView(bytes_).subspan(items_[i].begin, items_[i].byte_count);
  }
  Status sent;
  for (std::size_t begin = 0; begin < count_ && sent;) {
    const std::size_t longest = port.longest(items_[begin].due.route);
    if (payloads[begin].size() > longest) {
      journal.tooLong(items_[begin++].due);
      continue;
    }
    std::size_t end = begin + 1;
    while (end < count_ && items_[end].due.route == items_[begin].due.route &&
           payloads[end].size() <= longest) {
      ++end;
    }
    sent = port.send(items_[begin].due.route, {payloads.data() + begin, end - begin},
                     {sent_at.data() + begin, end - begin});
    for (std::size_t i = begin; i < end && sent; ++i) {
      journal.sent(items_[i].due, payloads[i], items_[i].deadline, sent_at[i]);
    }
    begin = end;
  }
  count_ = 0;
  bytes_.clear();
  return sent;
}

}  // namespace rocinante
