#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/net/datagram_sink.h"
#include "core/source/source.h"

namespace rocinante {

/// How a window that sends names itself as a source.
struct SendingSettings {
  std::string source;  ///< SOURCE
  std::string run;     ///< RUN; empty: a random one
};

/// An ordinary source of the window's own, sent into a sink: what changed at most 30 times a
/// second, and everything again every two seconds. Never waits: what the system has no room for is
/// lost, and restated. Main thread.
class SendingSource {
 public:
  /// At most this often is what changed sent.
  static constexpr Nanoseconds kPeriod{1'000'000'000 / 30};

  /// Fails as openSink() does; bad_argument for an invalid SOURCE.
  static Result<SendingSource> open(const Endpoint& to, const SendingSettings& settings);
  /// The same into a sink that is already open.
  static Result<SendingSource> into(std::unique_ptr<DatagramSink> sink,
                                    const SendingSettings& settings);

  Source& source() { return source_; }
  /// Takes the answer to what was said about `what`: it is sent when it is due, or told by
  /// trouble().
  void noteAnswer(SourceResult answer, std::string_view what);
  /// Sends what is due at `now`; `wall` becomes TIME. To be called at least ten times a second.
  void tick(SteadyTime now, WallTime wall);
  /// Sends what changed, due or not.
  void finish(SteadyTime now, WallTime wall);
  /// Sends what changed, then takes back everything that was said: a whole restatement without
  /// statements (docs/packet-format.md, section "Restatements"). Nothing may be sent after it.
  void withdraw(SteadyTime now, WallTime wall);

  const Endpoint& endpoint() const { return sink_->endpoint(); }
  const std::string& name() const { return name_; }
  std::uint64_t sent() const { return source_.sent(); }
  /// Why the last datagram was not sent, or something was refused; empty when all is well.
  const std::string& trouble() const { return *trouble_; }

 private:
  SendingSource(std::unique_ptr<DatagramSink> sink, std::unique_ptr<std::string> trouble,
                Source source, std::string name, std::string run)
      : sink_(std::move(sink)),
        trouble_(std::move(trouble)),
        source_(std::move(source)),
        name_(std::move(name)),
        run_(std::move(run)) {}

  // Borrowed by the source's Send, so they do not move.
  std::unique_ptr<DatagramSink> sink_;
  std::unique_ptr<std::string> trouble_;
  Source source_;
  std::string name_, run_;
  bool changed_ = false;
  std::optional<SteadyTime> flushed_at_;
};

}  // namespace rocinante
