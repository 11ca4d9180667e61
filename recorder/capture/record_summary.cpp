#include "recorder/capture/record_summary.h"

namespace rocinante {

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
