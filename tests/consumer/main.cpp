// Folds one packet with an installed Rocinante.
#include <cstdio>

#include "core/packet/decoder.h"
#include "core/packet/session_state.h"

int main() {
  const auto decoder = rocinante::makeDecoder("rk1");
  const auto* packet = decoder->decode(rocinante::bytesOf("RK1 me - -\njoints arm 0.5 1\n"));
  if (packet == nullptr) return 1;
  rocinante::SessionState state;
  state.apply(rocinante::LogTime(), *packet);
  std::printf("%zu device, %zu joints\n", state.devices().size(),
              state.devices().at("arm").joints->value.size());
  return 0;
}
