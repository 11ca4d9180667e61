#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/net/chosen_source.h"
#include "core/net/datagram_source.h"
#include "core/packet/packet.h"
#include "core/packet/text_name.h"
#include "core/signing/signed_datagram.h"
#include "core/signing/trust_file.h"

namespace rocinante {

/// The `at=` of one key's accepted datagrams, so that none is accepted twice although the network
/// reorders. Remembers the newest kLeast to 2 kLeast; older than all of them counts as seen.
class SeenTimes {
 public:
  static constexpr std::size_t kLeast = 4096;

  bool has(std::int64_t at_ns) const;
  void add(std::int64_t at_ns);  ///< not yet seen

 private:
  std::vector<std::int64_t> times_;  ///< ascending, each above floor_
  std::int64_t floor_ = -1;
};

/// Judges datagrams by a trust file (docs/signing.md, "Acceptance"). One thread; all inputs of a
/// program share one, so that a datagram of one is not accepted again from another. Memory: 64 KiB
/// a key at most.
class TrustJudge {
 public:
  /// How far `at=` may be from the receiver's clock.
  static constexpr Nanoseconds kTolerance = std::chrono::seconds(10);

  /// By the trust file at `path`; null when the path is empty: then nothing need be signed. Fails
  /// as TrustFile::read does.
  static Result<std::shared_ptr<TrustJudge>> open(const std::filesystem::path& path);
  explicit TrustJudge(TrustFile trust) : trust_(std::move(trust)) {}

  /// Empty when the datagram, received at `received`, is accepted; then it is remembered. Takes
  /// about the time of one Ed25519 verification; what fails an earlier check costs under 1 us.
  std::optional<Untrusted> judge(ByteView datagram, WallTime received);

 private:
  std::optional<Untrusted> judgeHeader(const SignedDatagram& datagram, const TrustedKey& key);

  TrustFile trust_;
  std::unordered_map<KeyId, SeenTimes> seen_;
  TextArena arena_;
  PacketHeader header_;
  std::string scratch_;
};

/// A source without the datagrams that the judge refuses, which are counted by reason. A datagram's
/// kernel time is the receiver's clock.
class TrustedSource final : public ChosenSource {
 public:
  TrustedSource(std::unique_ptr<DatagramSource> inner, std::shared_ptr<TrustJudge> judge)
      : ChosenSource(std::move(inner)), judge_(std::move(judge)) {}

  InputCounts counts() const override;

 private:
  bool accepts(const ReceivedDatagram& datagram) override;

  std::shared_ptr<TrustJudge> judge_;
  UntrustedCounts untrusted_;
};

}  // namespace rocinante
