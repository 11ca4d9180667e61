#include "core/pcap/pcap_source.h"

#include <fmt/format.h>
#include <net/if.h>
#include <pcap/pcap.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "core/net/interfaces.h"
#include "core/net/receive_buffer.h"
#include "core/pcap/capture_file.h"
#include "core/pcap/frame_reader.h"
#include "core/pcap/pcap_filter.h"
#include "core/pcap/seen_batch.h"

namespace rocinante {
namespace {

// Frames of a call without a datagram, so that the caller can be stopped.
constexpr int kMaxFrames = 1 << 14;

class CaptureSource final : public DatagramSource {
 public:
  CaptureSource(const Endpoint& endpoint, CaptureFile file)
      : endpoint_(endpoint), file_(std::move(file)) {}

  /// Reads the first frame: it has the link type that a filter is compiled for.
  Status begin() {
    if (Status read = advance(); !read) return read;
    const int number = frame_ ? frame_->link_type : file_->firstLinkType().value_or(1);
    const auto link = linkTypeOf(number);
    if (!link) {
      return Error{ErrorKind::unsupported, fmt::format("link type {} is not supported", number),
                   endpoint_.text()};
    }
    if (endpoint_.filter.empty()) return {};
    Result<FrameReader::Filter> filter = compiledFilter(endpoint_.filter, *link);
    if (!filter) return Error{filter.error().kind, filter.error().what, endpoint_.text()};
    reader_ =
        FrameReader(std::move(*filter), FrameReader::Filtered::here, namesTags(endpoint_.filter));
    return {};
  }

  Result<std::span<const ReceivedDatagram>> receive() override {
    batch_.clear();
    for (int frames = 0; frames < kMaxFrames && frame_ && !batch_.isFull(); ++frames) {
      if (const auto link = linkTypeOf(frame_->link_type)) {
        const auto seen = reader_.read(*link, frame_->bytes, frame_->wire_bytes, frame_->time);
        if (seen) batch_.add(*seen, frame_->time);
      } else {
        reader_.passOver(frame_->link_type);
      }
      if (Status read = advance(); !read) broken_ = read.error();
    }
    // Datagrams before the break are delivered first.
    if (broken_ && batch_.size() == 0) return *broken_;
    if (!frame_ && !broken_) {
      reader_.finish();
      ended_ = true;
    }
    return batch_.datagrams();
  }

  std::uint64_t dropped() const override { return 0; }
  Result<std::uint64_t> droppedByNow() override { return dropped(); }
  InputCounts counts() const override {
    InputCounts counts = reader_.counts();
    // They break the rules of the file.
    counts.malformed += file_->withoutInterface();
    return counts;
  }
  Account leftOut() const override {
    Account account = reader_.leftOut(true);
    account.add(file_->leftOut());
    return account;
  }
  bool ended() const override { return ended_; }
  const Endpoint& endpoint() const override { return endpoint_; }
  const SocketAddress& boundAddress() const override { return endpoint_.address; }

 private:
  Status advance() {
    auto frame = file_->next();
    frame_.reset();
    if (!frame) return Error{frame.error().kind, frame.error().what, endpoint_.text()};
    frame_ = *frame;
    return {};
  }

  Endpoint endpoint_;
  std::optional<CaptureFile> file_;
  std::optional<CapturedFrame> frame_;  ///< to be read next; empty: none follows
  std::optional<Error> broken_;         ///< where the file breaks off
  FrameReader reader_;
  bool ended_ = false;
  SeenBatch batch_;
};

// Whole frames, also those that a network card merged.
constexpr int kSnapBytes = 262'144;
// The kernel delivers frames in blocks, when a block is full or this old.
constexpr int kBlockAgeMs = 5;
constexpr Nanoseconds kHeldBack = std::chrono::milliseconds(15);
// Batches per call: frames that are not UDP must not look like silence, nor keep the caller from
// its other sources.
constexpr int kTurns = 64;

struct Close {
  void operator()(pcap_t* handle) const { ::pcap_close(handle); }
};
using Handle = std::unique_ptr<pcap_t, Close>;

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

class PcapSource final : public DatagramSource {
 public:
  PcapSource(const Endpoint& endpoint, const PcapOptions& options)
      : endpoint_(endpoint), options_(options) {}

  Status begin() {
    Result<Handle> handle = openInterface(endpoint_, options_);
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
    if (Status set = setFilter(handle->get(), *link); !set) return set;
    link_ = *link;
    handle_ = std::move(*handle);
    return {};
  }

  Result<std::span<const ReceivedDatagram>> receive() override {
    batch_.clear();
    for (int turn = 0; turn < kTurns && batch_.size() == 0 && handle_; ++turn) {
      const int frames = ::pcap_dispatch(handle_.get(), static_cast<int>(SeenBatch::kMaxDatagrams),
                                         take, reinterpret_cast<unsigned char*>(this));
      if (frames > 0) continue;
      if (frames < 0) giveUpHandle();
      break;
    }
    return batch_.datagrams();
  }

  std::uint64_t dropped() const override { return drops_before_ + drops_.total(); }
  Result<std::uint64_t> droppedByNow() override {
    pcap_stat now{};
    if (handle_ && ::pcap_stats(handle_.get(), &now) == 0) drops_.update(now.ps_drop);
    return dropped();
  }

  InputCounts counts() const override {
    InputCounts counts = reader_.counts();
    counts.incomplete += counts_before_.incomplete;
    counts.malformed += counts_before_.malformed;
    counts.other += counts_before_.other;
    return counts;
  }

  Account leftOut() const override {
    Account account = left_out_before_;
    account.add(reader_.leftOut(false));
    return account;
  }

  /// Watches an interface again after it was removed and has returned.
  std::optional<std::string> maintain() override {
    if (handle_) return std::nullopt;
    if (!gone_reported_) {
      gone_reported_ = true;
      return fmt::format("{} is gone; nothing is captured until it returns", endpoint_.text());
    }
    if (::if_nametoindex(endpoint_.interface.c_str()) == 0 || !begin()) return std::nullopt;
    gone_reported_ = false;
    return fmt::format("watching {} again", endpoint_.text());
  }

  Nanoseconds deliveryDelay() const override { return kHeldBack; }
  int fileDescriptor() const override {
    return handle_ ? ::pcap_get_selectable_fd(handle_.get()) : -1;
  }
  const Endpoint& endpoint() const override { return endpoint_; }
  const SocketAddress& boundAddress() const override { return endpoint_.address; }

 private:
  Status setFilter(pcap_t* handle, LinkType link) {
    const FilterPlan plan = planFilter(endpoint_.filter);
    FrameReader::Filter asked;
    if (!endpoint_.filter.empty()) {
      // Compiled for frames as they arrive here: the kernel keeps VLAN tags outside the frame.
      Result<FrameReader::Filter> compiled = compiledFilter(endpoint_.filter, link);
      if (!compiled) return Error{compiled.error().kind, compiled.error().what, endpoint_.text()};
      asked = std::move(*compiled);
    }
    bpf_program kernel{};
    if (::pcap_compile(handle, &kernel, plan.kernel.c_str(), 1, PCAP_NETMASK_UNKNOWN) != 0) {
      return Error{ErrorKind::bad_argument,
                   fmt::format("libpcap rejects this filter: {}", ::pcap_geterr(handle)),
                   endpoint_.text()};
    }
    const int set = ::pcap_setfilter(handle, &kernel);
    ::pcap_freecode(&kernel);
    if (set != 0) {
      return Error{ErrorKind::refused,
                   fmt::format("cannot set the filter: {}", ::pcap_geterr(handle)),
                   endpoint_.text()};
    }
    reader_ = FrameReader(std::move(asked), plan.filtered, plan.keep_tags);
    return {};
  }

  static void take(unsigned char* self, const pcap_pkthdr* header, const unsigned char* frame) {
    reinterpret_cast<PcapSource*>(self)->takeFrame(*header, frame);
  }

  void takeFrame(const pcap_pkthdr& header, const unsigned char* frame) {
    // With the precision requested, tv_usec holds nanoseconds.
    const WallTime time(std::chrono::seconds(std::max<std::int64_t>(header.ts.tv_sec, 0)) +
                        Nanoseconds(header.ts.tv_usec));
    const auto seen = reader_.read(
        link_, {reinterpret_cast<const std::byte*>(frame), header.caplen}, header.len, time);
    if (seen) batch_.add(*seen, time);
  }

  void giveUpHandle() {
    drops_before_ += drops_.total();
    drops_ = DropCounter();
    reader_.finish();
    counts_before_ = counts();
    left_out_before_ = leftOut();
    reader_ = FrameReader();
    handle_.reset();
  }

  Endpoint endpoint_;
  PcapOptions options_;
  Handle handle_;  ///< null while the interface is gone
  LinkType link_ = LinkType::raw_ip;
  FrameReader reader_;
  bool gone_reported_ = false;
  DropCounter drops_;
  std::uint64_t drops_before_ = 0;  ///< of the interface before it was removed
  InputCounts counts_before_;
  Account left_out_before_;
  SeenBatch batch_;
};

}  // namespace

Result<std::unique_ptr<DatagramSource>> openCaptureSource(const Endpoint& endpoint) {
  Result<CaptureFile> file = CaptureFile::open(endpoint.file);
  if (!file) return Error{file.error().kind, file.error().what, endpoint.text()};
  auto source = std::make_unique<CaptureSource>(endpoint, std::move(*file));
  if (Status begun = source->begin(); !begun) return begun.error();
  return source;
}

Result<std::unique_ptr<DatagramSource>> openPcap(const Endpoint& endpoint,
                                                 const PcapOptions& options) {
  if (!endpoint.file.empty()) return openCaptureSource(endpoint);
  auto source = std::make_unique<PcapSource>(endpoint, options);
  if (Status begun = source->begin(); !begun) return begun.error();
  return source;
}

}  // namespace rocinante
