#include "core/signing/trust_judge.h"

#include <algorithm>

#include "core/base/pattern.h"
#include "core/packet/header_reader.h"

namespace rocinante {

bool SeenTimes::has(std::int64_t at_ns) const {
  return at_ns <= floor_ || std::binary_search(times_.begin(), times_.end(), at_ns);
}

void SeenTimes::add(std::int64_t at_ns) {
  times_.insert(std::upper_bound(times_.begin(), times_.end(), at_ns), at_ns);
  if (times_.size() < 2 * kLeast) return;
  floor_ = times_[kLeast - 1];
  times_.erase(times_.begin(), times_.begin() + kLeast);
}

Result<std::shared_ptr<TrustJudge>> TrustJudge::open(const std::filesystem::path& path) {
  if (path.empty()) return std::shared_ptr<TrustJudge>();
  Result<TrustFile> trust = TrustFile::read(path);
  if (!trust) return trust.error();
  return std::make_shared<TrustJudge>(std::move(*trust));
}

std::optional<Untrusted> TrustJudge::judgeHeader(const SignedDatagram& datagram,
                                                 const TrustedKey& key) {
  if (!datagram.is_packet) {
    return key.is_relay ? std::nullopt : std::optional(Untrusted::not_allowed);
  }
  arena_.begin(datagram.header.size());
  std::uint32_t column = 0;
  if (!readHeader(datagram.header, arena_, header_, column)) return Untrusted::malformed;
  const bool is_relayed = !header_.by.empty() || header_.via;
  if (is_relayed && !key.is_relay) return Untrusted::not_allowed;
  if (!anyPatternMatches(key.sources, header_.source)) return Untrusted::not_allowed;
  return std::nullopt;
}

std::optional<Untrusted> TrustJudge::judge(ByteView datagram, WallTime received) {
  const ParsedSignature parsed = parseSignature(datagram);
  if (parsed.fault) return parsed.fault;
  const SignedDatagram& signed_one = parsed.datagram;
  const TrustedKey* const key = trust_.find(signed_one.key);
  if (key == nullptr) return Untrusted::unknown_key;
  if (const auto fault = judgeHeader(signed_one, *key)) return fault;
  const std::int64_t now_ns = received.time_since_epoch().count();
  // Both are at least 0, so that the difference cannot overflow.
  if (now_ns < 0 || signed_one.at_ns - now_ns > kTolerance.count() ||
      now_ns - signed_one.at_ns > kTolerance.count()) {
    return Untrusted::out_of_time;
  }
  SeenTimes& seen = seen_[key->id];
  if (seen.has(signed_one.at_ns)) return Untrusted::repeated;
  if (!isSignedBy(key->key, signed_one, scratch_)) return Untrusted::forged;
  seen.add(signed_one.at_ns);
  return std::nullopt;
}

bool TrustedSource::accepts(const ReceivedDatagram& datagram) {
  const auto reason = judge_->judge(datagram.payload, datagram.kernel_time);
  if (reason) untrusted_.add(*reason);
  return !reason;
}

InputCounts TrustedSource::counts() const {
  InputCounts counts = ChosenSource::counts();
  if (!counts.untrusted) counts.untrusted.emplace();
  *counts.untrusted += untrusted_;
  return counts;
}

}  // namespace rocinante
