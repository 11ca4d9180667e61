#include "core/nats/nats_module.h"

#include <string>
#include <string_view>

#include "core/base/loaded_module.h"
#include "core/base/version.h"

namespace rocinante {
namespace {

constexpr const char* kFile = "librocinante_nats_client.so";

struct Loaded {
  const NatsModule* module = nullptr;
  std::string reason;

  Loaded() {
    const Result<void*> library = loadModule(kFile);
    if (!library) {
      reason = library.error().what;
      return;
    }
    const auto function =
        reinterpret_cast<NatsModuleFunction>(functionOf(*library, "rocinante_nats_module"));
    const NatsModule* const found = function != nullptr ? function() : nullptr;
    if (found != nullptr && std::string_view(found->version) == version()) {
      module = found;
    } else {
      reason = std::string(kFile) + " has a different version";
    }
  }
};

}  // namespace

Result<const NatsModule*> natsModule(const Endpoint& endpoint) {
  static const Loaded loaded;
  if (loaded.module != nullptr) return loaded.module;
  return Error{
      ErrorKind::unsupported,
      "nats:// and jetstream:// need the NATS module (package rocinante-nats); " + loaded.reason,
      endpoint.text()};
}

Result<std::unique_ptr<DatagramSource>> openNatsSource(const Endpoint& endpoint,
                                                       const NatsSourceOptions& options) {
  const auto module = natsModule(endpoint);
  if (!module) return module.error();
  return (*module)->source(endpoint, options);
}

Result<std::unique_ptr<DatagramSource>> openJetStream(const Endpoint& endpoint,
                                                      StreamReading reading) {
  const auto module = natsModule(endpoint);
  if (!module) return module.error();
  return (*module)->stream(endpoint, reading);
}

Result<std::unique_ptr<DatagramSink>> openNatsSink(const Endpoint& to) {
  const auto module = natsModule(to);
  if (!module) return module.error();
  return (*module)->sink(to);
}

}  // namespace rocinante
