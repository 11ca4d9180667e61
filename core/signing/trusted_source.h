#pragma once

#include <memory>
#include <utility>

#include "core/net/chosen_source.h"
#include "core/signing/trust_judge.h"

namespace rocinante {

/// A source without the datagrams that the judge refuses, which are counted by reason. A datagram's
/// kernel time is the receiver's clock.
class TrustedSource final : public ChosenSource {
 public:
  TrustedSource(std::unique_ptr<DatagramSource> inner, std::shared_ptr<TrustJudge> judge)
      : ChosenSource(std::move(inner)), judge_(std::move(judge)) {}

  InputCounts counts() const override;

 private:
  bool wants(const ReceivedDatagram& datagram) override;

  std::shared_ptr<TrustJudge> judge_;
  UntrustedCounts untrusted_;
};

}  // namespace rocinante
