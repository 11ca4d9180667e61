// The module's side of nats_module.h.
#include "core/base/version.h"
#include "core/nats/nats_module.h"

extern "C" __attribute__((visibility("default"))) const rocinante::NatsModule*
rocinante_nats_module() {
  static const rocinante::NatsModule module{rocinante::version(), &rocinante::openNatsSource,
                                            &rocinante::openJetStream, &rocinante::openNatsSink};
  return &module;
}
