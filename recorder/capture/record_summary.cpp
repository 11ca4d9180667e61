#include "recorder/capture/record_summary.h"

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

RecordSummary summaryOf(const CaptureWriter& writer, const Status& received) {
  RecordSummary summary;
  summary.files = writer.files();
  for (const PieceFacts& each : summary.files.pieces) {
    summary.log = each.file.path;
    summary.log_bytes += each.bytes;
  }
  summary.endpoints = writer.accounts();
  for (const EndpointAccount& each : summary.endpoints) {
    summary.packets += each.recorded;
    summary.losses += each.losses;
  }
  summary.restated = writer.restated();
  summary.payload_bytes = writer.payloadBytes();
  summary.packets_before = writer.packetsBefore();
  summary.channels = writer.channelCount();
  summary.late = writer.late();
  if (writer.trouble()) {
    summary.trouble = writer.trouble();
  } else if (!received) {
    summary.trouble = received.error();
  }
  return summary;
}

}  // namespace rocinante
