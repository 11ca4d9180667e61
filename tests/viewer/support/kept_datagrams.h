#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/net/datagram_sink.h"

namespace rocinante::test {

/// Keeps what is sent; refuses while asked to.
class KeptDatagrams final : public DatagramSink {
 public:
  struct Kept {
    std::vector<std::string> texts;
    bool refuses = false, full = false;
  };
  explicit KeptDatagrams(std::shared_ptr<Kept> kept) : kept_(std::move(kept)) {}

  Status send(std::span<const ByteView> payloads) override {
    const auto sent = sendWithoutWaiting(payloads);
    return sent ? Status{} : Status{sent.error()};
  }
  Result<std::size_t> sendWithoutWaiting(std::span<const ByteView> payloads) override {
    if (kept_->refuses) return Error{ErrorKind::refused, "no route", "nowhere"};
    if (kept_->full) return std::size_t{0};
    for (const ByteView& payload : payloads) kept_->texts.emplace_back(textOf(payload));
    return payloads.size();
  }
  int fileDescriptor() const override { return -1; }
  const Endpoint& endpoint() const override { return endpoint_; }

 private:
  std::shared_ptr<Kept> kept_;
  Endpoint endpoint_ = Endpoint::standard();
};

}  // namespace rocinante::test
