#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/log/log_reader.h"
#include "core/net/datagram_source.h"
#include "core/signing/trust_judge.h"

namespace rocinante {

/// A datagram in a log that is not trusted, and why.
struct UntrustedMessage {
  LogTime time{};
  std::string topic;
  std::uint32_t sequence = 0;  ///< of its channel
  Untrusted reason = Untrusted::not_signed;
};

/// Whether a trust file vouches for the datagrams of a log (docs/signing.md).
struct VerifyReport {
  /// The first this many untrusted ones are listed; all are counted.
  static constexpr std::size_t kListed = 100;

  std::string log;
  LogTime origin{};
  std::uint64_t messages = 0;  ///< captured, or received and restated by others
  UntrustedCounts untrusted;
  std::vector<UntrustedMessage> listed;  ///< in order of time
  std::vector<DamageSpan> damage;        ///< what could not be read could not be judged
  bool stopped = false;

  std::uint64_t trusted() const { return messages - untrusted.total(); }
  bool isWhole() const { return untrusted.total() == 0 && damage.empty() && !stopped; }
};

/// Judges every datagram as if it had been received at its log time. `progress` is called
/// now and then with the finished part, 0 to 1; false stops.
Result<VerifyReport> verifyLog(LogReader& log, TrustJudge& judge,
                               const std::function<bool(double)>& progress);

/// A few lines for the user, with LF.
std::string verifyText(const VerifyReport& report);
/// One JSON object (docs/programs/log.md), with LF.
std::string verifyJson(const VerifyReport& report);

}  // namespace rocinante
