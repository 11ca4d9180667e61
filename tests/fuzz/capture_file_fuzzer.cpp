// A capture file (pcap or pcapng) that a stranger made: read to its end or to where it breaks, by
// the source and on the time line of a recording. Whatever it holds, datagrams come out no longer
// than there can be, their times do not go back, and the same ones on the same bytes.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "core/recording/reorder_window.h"
#include "core/transport/open_source.h"
#include "recorder/capture/capture_file_loop.h"

namespace {

using namespace rocinante;

void require(bool holds) {
  if (!holds) std::abort();
}

struct Outcome {
  std::vector<std::size_t> sizes;
  std::vector<LogTime> times;
  InputCounts counts;
  std::string trouble;
  bool operator==(const Outcome&) const = default;
};

Outcome readAll(const Endpoint& endpoint) {
  Outcome outcome;
  const auto source = openSource(endpoint);
  if (!source) {
    outcome.trouble = source.error().text();
    require(!outcome.trouble.empty());
    return outcome;
  }
  CaptureTime line;
  while (!(*source)->ended()) {
    const auto batch = (*source)->receive();
    if (!batch) {
      outcome.trouble = batch.error().text();
      break;
    }
    for (const ReceivedDatagram& each : *batch) {
      require(each.payload.size() <= 65'527);
      outcome.sizes.push_back(each.payload.size());
      const LogTime time = line.at(each.kernel_time);
      // As the recorder counts: to this and a little further.
      require(time.time_since_epoch().count() >= 0 && time + ReorderWindow::kWidth > time);
      require(outcome.times.empty() || outcome.times.back() <= time);
      outcome.times.push_back(time);
      (void)line.takeStep();
    }
  }
  outcome.counts = (*source)->counts();
  return outcome;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const int file = ::memfd_create("capture", MFD_CLOEXEC);
  static const Endpoint endpoint = [] {
    Endpoint made = Endpoint::parse("pcap://./capture").value();
    made.file = "/proc/self/fd/" + std::to_string(file);
    return made;
  }();
  require(::ftruncate(file, 0) == 0);
  require(::pwrite(file, data, size, 0) == static_cast<ssize_t>(size));
  require(readAll(endpoint) == readAll(endpoint));
  return 0;
}
