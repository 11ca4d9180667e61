#include "recorder/capture/input_account.h"

namespace rocinante {

std::vector<InputAccount> inputAccounts(const std::vector<DatagramSource*>& sources,
                                        const InputLoop& loop) {
  std::vector<InputAccount> accounts;
  for (std::uint32_t i = 0; i < sources.size(); ++i) {
    InputAccount account;
    account.endpoint = boundText(*sources[i]);
    account.counts = sources[i]->counts();
    account.subscription = sources[i]->subscription();
    account.left_out = sources[i]->leftOut();
    account.left_out.add(loop.leftOut());
    account.buffer_granted_bytes = sources[i]->receiveBufferBytes();
    account.buffer_needed_bytes = neededReceiveBuffer(loop.busiest(i));
    accounts.push_back(std::move(account));
  }
  return accounts;
}

}  // namespace rocinante
