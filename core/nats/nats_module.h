#pragma once

#include <memory>

#include "core/base/result.h"
#include "core/nats/jetstream_source.h"
#include "core/nats/nats_sink.h"
#include "core/nats/nats_source.h"

namespace rocinante {

/// What librocinante_nats_client.so gives. Unlike other modules it shares C++ with the program, so
/// that both must be of one version; its objects live as long as the program, which never closes
/// it.
struct NatsModule {
  const char* version;  ///< version() of the module's build: read before anything else
  decltype(&openNatsSource) source;
  decltype(&openJetStream) stream;
  decltype(&openNatsSink) sink;
};

/// rocinante_nats_module, the one function that the module exports. Any thread.
using NatsModuleFunction = const NatsModule* (*)();

/// Loads the module with the first call; any thread. Fails with unsupported, and names the package.
Result<const NatsModule*> natsModule(const Endpoint& endpoint);

}  // namespace rocinante
