#include "core/pcap/pcap_source.h"

#include <fmt/format.h>
#include <net/if.h>
#include <pcap/pcap.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <utility>

#include "core/net/drop_counter.h"
#include "core/net/interfaces.h"
#include "core/pcap/frame_reader.h"
#include "core/pcap/pcap_filter.h"

namespace rocinante {
namespace {

constexpr std::size_t kBatch = 256;
constexpr std::size_t kMaxDatagram = 65'535;
// Whole frames, also those that a network card merged.
constexpr int kSnapBytes = 262'144;
// The kernel delivers frames in blocks, when a block is full or this old.
constexpr int kBlockAgeMs = 5;
constexpr Nanoseconds kHeldBack = std::chrono::milliseconds(15);
// No capture is from before 1970 or after the year 2255. A pcapng timestamp has 64 bits in units of
// its own, and a larger range than nanoseconds.
constexpr std::int64_t kMaxSeconds = 9'000'000'000;
// Batches per call: frames that are not UDP must not look like silence, nor keep the caller from
// its other sources.
constexpr int kTurns = 64;

struct Close {
  void operator()(pcap_t* handle) const { ::pcap_close(handle); }
};
using Handle = std::unique_ptr<pcap_t, Close>;

/// A compiled filter, freed with its owner.
class Program {
 public:
  Program() = default;
  ~Program() { ::pcap_freecode(&program_); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  Status compile(pcap_t* handle, const std::string& text, const Endpoint& endpoint) {
    if (::pcap_compile(handle, &program_, text.c_str(), 1, PCAP_NETMASK_UNKNOWN) == 0) return {};
    return Error{ErrorKind::bad_argument,
                 fmt::format("libpcap rejects this filter: {}", ::pcap_geterr(handle)),
                 endpoint.text()};
  }
  bpf_program* get() { return &program_; }

 private:
  bpf_program program_{};
};

/// Why a capture cannot begin, and the remedy.
Error activationError(pcap_t* handle, int status, const Endpoint& endpoint) {
  const std::string& name = endpoint.interface;
  std::string what;
  switch (status) {
    case PCAP_ERROR_PERM_DENIED:
    case PCAP_ERROR_PROMISC_PERM_DENIED: {
      std::error_code ignored;
      const auto self = std::filesystem::read_symlink("/proc/self/exe", ignored);
      what = fmt::format(
          "to watch {} a program needs CAP_NET_RAW: run it as root, or once: sudo setcap "
          "cap_net_raw+ep {}",
          name, ignored ? "PROGRAM" : self.string());
      break;
    }
    case PCAP_ERROR_NO_SUCH_DEVICE:
      what = fmt::format("there is no network interface {}; there are any, {}", name,
                         interfaceNames());
      break;
    case PCAP_ERROR_IFACE_NOT_UP:
      what = fmt::format("the network interface {} is down", name);
      break;
    default:
      what = fmt::format("cannot watch {}: {}", name,
                         status == PCAP_ERROR ? ::pcap_geterr(handle) : ::pcap_statustostr(status));
  }
  return {ErrorKind::refused, std::move(what), endpoint.text()};
}

Result<Handle> openInterface(const Endpoint& endpoint, const PcapOptions& options) {
  std::array<char, PCAP_ERRBUF_SIZE> fault{};
  Handle handle(::pcap_create(endpoint.interface.c_str(), fault.data()));
  if (!handle) {
    return Error{ErrorKind::refused,
                 fmt::format("cannot watch {}: {}", endpoint.interface, fault.data()),
                 endpoint.text()};
  }
  // Link types without nanoseconds (nflog, dbus) refuse here: their times would be read too small.
  for (const int set : {::pcap_set_snaplen(handle.get(), kSnapBytes),
                        ::pcap_set_promisc(handle.get(), endpoint.interface == "any" ? 0 : 1),
                        ::pcap_set_timeout(handle.get(), kBlockAgeMs),
                        ::pcap_set_buffer_size(handle.get(), options.buffer_bytes),
                        ::pcap_set_tstamp_precision(handle.get(), PCAP_TSTAMP_PRECISION_NANO)}) {
    if (set < 0) return activationError(handle.get(), set, endpoint);
  }
  const int status = ::pcap_activate(handle.get());
  if (status < 0) return activationError(handle.get(), status, endpoint);
  if (::pcap_setnonblock(handle.get(), 1, fault.data()) != 0) {
    return Error{ErrorKind::refused, fmt::format("cannot watch without waiting: {}", fault.data()),
                 endpoint.text()};
  }
  return handle;
}

Result<Handle> openFile(const Endpoint& endpoint) {
  std::error_code ignored;
  if (!std::filesystem::exists(endpoint.file, ignored)) {
    return Error{ErrorKind::not_found, "the capture file does not exist", endpoint.text()};
  }
  std::array<char, PCAP_ERRBUF_SIZE> fault{};
  Handle handle(::pcap_open_offline_with_tstamp_precision(
      endpoint.file.c_str(), PCAP_TSTAMP_PRECISION_NANO, fault.data()));
  if (handle) return handle;
  return Error{ErrorKind::damaged, fmt::format("this is not a capture file: {}", fault.data()),
               endpoint.text()};
}

class PcapSource final : public DatagramSource {
 public:
  PcapSource(const Endpoint& endpoint, const PcapOptions& options)
      : endpoint_(endpoint),
        options_(options),
        // Not initialised: pages that no datagram reaches cost nothing.
        bytes_(new std::byte[kBatch * kMaxDatagram]) {}

  Status begin() {
    Result<Handle> handle = isFile() ? openFile(endpoint_) : openInterface(endpoint_, options_);
    if (!handle) return handle.error();
    const int number = ::pcap_datalink(handle->get());
    const auto link = linkTypeOf(number);
    if (!link) {
      const char* name = ::pcap_datalink_val_to_name(number);
      return Error{ErrorKind::unsupported,
                   fmt::format("link type {} is not supported",
                               name != nullptr ? name : std::to_string(number)),
                   endpoint_.text()};
    }
    if (Status set = setFilter(handle->get(), *link, number); !set) return set;
    handle_ = std::move(*handle);
    return {};
  }

  Result<std::span<const ReceivedDatagram>> receive() override {
    count_ = used_ = 0;
    for (int turn = 0; turn < kTurns && count_ == 0 && handle_; ++turn) {
      const int frames = ::pcap_dispatch(handle_.get(), static_cast<int>(kBatch), take,
                                         reinterpret_cast<unsigned char*>(this));
      if (frames > 0) continue;
      if (frames < 0 && isFile()) {
        broken_ = Error{ErrorKind::damaged,
                        fmt::format("the capture ends early: {}", ::pcap_geterr(handle_.get())),
                        endpoint_.text()};
        handle_.reset();
        break;
      }
      if (frames < 0) giveUpHandle();
      if (frames == 0 && isFile()) {
        reader_->finish();
        ended_ = true;
      }
      break;
    }
    // Datagrams before the break are delivered first.
    if (broken_ && count_ == 0) return *broken_;
    return std::span<const ReceivedDatagram>(datagrams_.data(), count_);
  }

  std::uint64_t dropped() const override { return drops_before_ + drops_.total(); }
  Result<std::uint64_t> droppedByNow() override {
    pcap_stat now{};
    // A file has no drop count.
    if (handle_ && !isFile() && ::pcap_stats(handle_.get(), &now) == 0) drops_.update(now.ps_drop);
    return dropped();
  }

  InputCounts counts() const override {
    InputCounts counts = reader_->counts();
    counts.incomplete += counts_before_.incomplete;
    counts.malformed += counts_before_.malformed;
    counts.other += counts_before_.other;
    return counts;
  }

  /// Watches an interface again after it was removed and has returned.
  std::optional<std::string> maintain() override {
    if (handle_ || isFile()) return std::nullopt;
    if (!gone_told_) {
      gone_told_ = true;
      return fmt::format("{} is gone; nothing is captured until it returns", endpoint_.text());
    }
    if (::if_nametoindex(endpoint_.interface.c_str()) == 0 || !begin()) return std::nullopt;
    gone_told_ = false;
    return fmt::format("watching {} again", endpoint_.text());
  }

  Nanoseconds deliveryDelay() const override { return isFile() ? Nanoseconds(0) : kHeldBack; }
  bool ended() const override { return ended_; }
  int fileDescriptor() const override {
    return handle_ && !isFile() ? ::pcap_get_selectable_fd(handle_.get()) : -1;
  }
  const Endpoint& endpoint() const override { return endpoint_; }
  const SocketAddress& boundAddress() const override { return endpoint_.address; }

 private:
  bool isFile() const { return !endpoint_.file.empty(); }

  Status setFilter(pcap_t* handle, LinkType link, int number) {
    const FilterPlan plan = planFilter(endpoint_.filter, link);
    FrameReader::Filter asked;
    if (!endpoint_.filter.empty()) {
      // Compiled for frames as they arrive here: the kernel keeps VLAN tags outside the frame.
      const Handle dead(::pcap_open_dead(number, kSnapBytes));
      auto program = std::make_shared<Program>();
      Status compiled = program->compile(dead.get(), endpoint_.filter, endpoint_);
      if (!compiled) return compiled;
      asked = [program](ByteView frame) {
        pcap_pkthdr header{};
        header.caplen = header.len = static_cast<bpf_u_int32>(frame.size());
        return ::pcap_offline_filter(program->get(), &header,
                                     reinterpret_cast<const unsigned char*>(frame.data())) != 0;
      };
    }
    Program kernel;
    if (Status compiled = kernel.compile(handle, plan.kernel, endpoint_); !compiled)
      return compiled;
    if (::pcap_setfilter(handle, kernel.get()) != 0) {
      return Error{ErrorKind::refused,
                   fmt::format("cannot set the filter: {}", ::pcap_geterr(handle)),
                   endpoint_.text()};
    }
    reader_ = std::make_unique<FrameReader>(link, std::move(asked), plan.filtered);
    return {};
  }

  static void take(unsigned char* self, const pcap_pkthdr* header, const unsigned char* frame) {
    reinterpret_cast<PcapSource*>(self)->takeFrame(*header, frame);
  }

  void takeFrame(const pcap_pkthdr& header, const unsigned char* frame) {
    // With the precision requested, tv_usec holds nanoseconds.
    const auto seconds = std::clamp<std::int64_t>(header.ts.tv_sec, 0, kMaxSeconds);
    const WallTime time(std::chrono::seconds(seconds) + Nanoseconds(header.ts.tv_usec));
    const auto seen =
        reader_->read({reinterpret_cast<const std::byte*>(frame), header.caplen}, time);
    if (!seen || count_ == kBatch) return;
    std::byte* const payload = bytes_.get() + used_;
    if (!seen->payload.empty()) std::memcpy(payload, seen->payload.data(), seen->payload.size());
    used_ += seen->payload.size();
    destinations_[count_] = seen->destination;
    datagrams_[count_] = {
        {payload, seen->payload.size()}, seen->sender, time, seen->cut, &destinations_[count_]};
    ++count_;
  }

  void giveUpHandle() {
    drops_before_ += drops_.total();
    drops_ = DropCounter();
    reader_->finish();
    counts_before_ = counts();
    reader_ = std::make_unique<FrameReader>(LinkType::raw_ip);
    handle_.reset();
  }

  Endpoint endpoint_;
  PcapOptions options_;
  Handle handle_;  ///< null while the interface is gone
  std::unique_ptr<FrameReader> reader_;
  std::optional<Error> broken_;  ///< a file that ends in the middle of a frame
  bool ended_ = false;
  bool gone_told_ = false;
  DropCounter drops_;
  std::uint64_t drops_before_ = 0;  ///< of the interface before it was removed
  InputCounts counts_before_;
  std::unique_ptr<std::byte[]> bytes_;
  std::size_t used_ = 0;
  std::size_t count_ = 0;
  std::array<ReceivedDatagram, kBatch> datagrams_{};
  std::array<SocketAddress, kBatch> destinations_{};
};

}  // namespace

Result<std::unique_ptr<DatagramSource>> openPcap(const Endpoint& endpoint,
                                                 const PcapOptions& options) {
  auto source = std::make_unique<PcapSource>(endpoint, options);
  if (Status begun = source->begin(); !begun) return begun.error();
  return source;
}

}  // namespace rocinante
