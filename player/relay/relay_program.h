#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/foreign/decode/decoder_set.h"
#include "core/net/address_filter.h"
#include "core/net/endpoint.h"
#include "core/relay/relay.h"
#include "player/relay/relay_report.h"
#include "player/send/realtime.h"
#include "player/send/send_plan.h"

namespace rocinante {

struct RelayProgramOptions {
  std::vector<Endpoint> from;
  std::vector<Endpoint> to;
  std::vector<Endpoint> serve;
  std::string name;            ///< NAME
  std::string run;             ///< chosen anew at each start
  RelayOutputOptions outputs;  ///< of every output
  AddressFilter allow;         ///< senders and subscribers
  std::string trust;           ///< a trust file: pass only what it accepts (docs/signing.md)
  std::string key;             ///< a secret key: sign what the relay writes itself
  /// Make packets of what is not packet text, which then pass; null for none.
  std::shared_ptr<const decode::DecoderSet> decoders;
  Nanoseconds restate = std::chrono::seconds(2);
  Realtime realtime = Realtime::automatic;
  bool progress = false;
};

/// Opens everything, and relays until `surroundings.stop` returns true.
Result<RelayReport> relayUntilStopped(const RelayProgramOptions& options,
                                      const SendSurroundings& surroundings);

}  // namespace rocinante
