// Any bytes as a recording of another program, by their own kind or, where they show none, as a
// table: imported whole. Nothing may crash, hang or take memory without bound, and what comes out
// is a log without damage.

#include <cstdlib>

#include "core/foreign/recordings/json_lines.h"
#include "core/foreign/recordings/lcm_log.h"
#include "core/foreign/recordings/recording_kind.h"
#include "core/foreign/recordings/table_recording.h"
#include "core/foreign/ros/bag_import.h"
#include "core/log/log_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rocinante;
  const ByteView bytes(reinterpret_cast<const std::byte*>(data), size);
  auto recording = [&] {
    switch (recordingKindOf(bytes)) {
      case RecordingKind::lcm:
        return openLcmBytes(bytes, "fuzz");
      case RecordingKind::json_lines:
        return openJsonBytes(bytes, "fuzz", "arm");
      default:
        return openTableBytes(bytes, "fuzz", "arm");
    }
  }();
  if (!recording) return 0;
  std::vector<std::unique_ptr<ros::BagReader>> all;
  all.push_back(std::move(*recording));
  Bytes log;
  const auto report = ros::importBags(std::move(all), makeMemorySink(log), "fuzz", {});
  if (!report) return 0;
  Result<LogReader> reader = LogReader::openBytes(log, "made");
  if (!reader || reader->summary().messages != report->messages) std::abort();
  while (*reader->next()) {
  }
  if (!reader->damage().empty()) std::abort();
  return 0;
}
