#include "core/nats/jetstream_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <deque>
#include <thread>

#include "core/nats/message_queue.h"
#include "core/nats/nats_client.h"

namespace rocinante {
namespace {

using StreamInfo = std::unique_ptr<jsStreamInfo, NatsDestroy<jsStreamInfo_Destroy>>;
using ConsumerInfo = std::unique_ptr<jsConsumerInfo, NatsDestroy<jsConsumerInfo_Destroy>>;
using MetaData = std::unique_ptr<jsMsgMetaData, NatsDestroy<jsMsgMetaData_Destroy>>;

// Fetched one by one for each receive(): others wait meanwhile.
constexpr std::size_t kFetchedBatch = 128;
constexpr std::int64_t kRequestMs = 2'000;
constexpr std::int64_t kSecondNs = 1'000'000'000;
// As many are sent again by the server after a kill, so as many are fetched one by one.
constexpr std::int64_t kMaxUnconfirmed = 16'384;
constexpr std::int64_t kAckWaitNs = 60 * kSecondNs;
constexpr std::int64_t kHeartbeatNs = 5 * kSecondNs;
constexpr std::size_t kQueueBytes = std::size_t{64} << 20U;
// A purge beside a kill may be counted larger by what was recorded in this time.
constexpr auto kNotePeriod = std::chrono::seconds(5);
constexpr std::string_view kNote = "rocinante has recorded up to message ";
constexpr int kFetchAttempts = 5;
// A server needs a moment to see that the reader before was killed.
constexpr int kBoundAttempts = 20;
constexpr auto kBoundWait = std::chrono::milliseconds(100);

class JetStreamSource final : public DatagramSource {
 public:
  JetStreamSource(std::unique_ptr<NatsClient> client, StreamReading reading)
      : queue_(kQueueBytes), client_(std::move(client)), reading_(reading) {}
  ~JetStreamSource() override {
    noteProgress();
    // Removes what the server made for a passing reader; a durable stays.
    if (reading_ == StreamReading::passing && subscription_) {
      (void)natsSubscription_Unsubscribe(subscription_.get());
    }
    subscription_.reset();
    context_.reset();
    client_.reset();
    end_.wait();
  }

  Status open() {
    if (!client_->hasConnected()) return {};  // receive() tries again
    jsOptions options;
    (void)jsOptions_Init(&options);
    options.Wait = kRequestMs;
    jsCtx* context = nullptr;
    natsStatus status = natsConnection_JetStream(&context, client_->get(), &options);
    if (status != NATS_OK) return natsError("use JetStream", status, endpoint());
    context_.reset(context);
    const auto info = streamInfo();
    if (!info) return info.error();
    Status made = reading_ == StreamReading::resuming ? resume(**info) : pass();
    return made ? client_->settle() : made;
  }

  Result<std::span<const ReceivedDatagram>> receive() override {
    datagrams_.clear();
    fetched_.clear();
    if (!subscription_) {
      if (client_->isClosed()) return client_->turnedAway();
      if (Status opened = open(); !opened) return opened.error();
      if (!subscription_) return std::span<const ReceivedDatagram>(datagrams_);
    }
    if (next_ == messages_.size()) {
      queue_.swap(messages_);
      next_ = 0;
    }
    // What the server sent to a reader that was killed, it would send again only later.
    if (expected_ > 0 && expected_ <= sent_before_ && !fetchUntil(sent_before_ + 1)) {
      return std::span<const ReceivedDatagram>(datagrams_);
    }
    if (messages_.empty() && client_->isClosed()) return client_->turnedAway();
    while (next_ < messages_.size() && datagrams_.size() < kMessageBatch) {
      if (!give(messages_[next_].message.get())) break;
      ++next_;
    }
    return std::span<const ReceivedDatagram>(datagrams_);
  }

  bool keepsPlace() const override { return reading_ == StreamReading::resuming; }
  void confirm(std::uint64_t count) override {
    if (!keepsPlace()) return;
    std::string reply;
    for (; !unconfirmed_.empty() && unconfirmed_.front().count <= count; unconfirmed_.pop_front()) {
      confirmed_ = unconfirmed_.front().sequence;
      if (!unconfirmed_.front().reply.empty()) reply = std::move(unconfirmed_.front().reply);
    }
    // The server takes it for all before it too. One that is lost only means a repetition.
    if (!reply.empty()) acknowledge(reply);
    if (confirmed_ > noted_ && std::chrono::steady_clock::now() - noted_at_ >= kNotePeriod) {
      noteProgress();
    }
  }

  std::uint64_t dropped() const override { return gone_; }
  Result<std::uint64_t> droppedByNow() override { return gone_; }
  std::optional<std::string> maintain() override {
    if (news_) return std::exchange(news_, std::nullopt);
    return client_->news();
  }
  int fileDescriptor() const override {
    // Messages behind a batch, or behind a gap that is being fetched, are not in the queue.
    return !subscription_ || next_ < messages_.size() ? -1 : queue_.fileDescriptor();
  }
  const Endpoint& endpoint() const override { return client_->endpoint(); }
  const SocketAddress& boundAddress() const override { return client_->endpoint().address; }

 private:
  struct Unconfirmed {
    std::uint64_t count;     ///< of the datagrams given, with this one
    std::uint64_t sequence;  ///< in the stream
    std::string reply;       ///< where to acknowledge it; empty: it was fetched
  };

  const NatsEndpoint& nats() const { return client_->endpoint().nats; }
  const char* stream() const { return nats().stream.c_str(); }
  Result<StreamInfo> streamInfo() {
    jsStreamInfo* info = nullptr;
    jsErrCode code{};
    const natsStatus status = js_GetStreamInfo(&info, context_.get(), stream(), nullptr, &code);
    if (status == NATS_OK) return StreamInfo(info);
    if (code == JSStreamNotFoundErr || status == NATS_NOT_FOUND) {
      return Error{ErrorKind::not_found,
                   fmt::format("the NATS server {} has no stream {}", nats().server(), stream()),
                   endpoint().text()};
    }
    if (code == JSNotEnabledErr || code == JSNotEnabledForAccountErr ||
        status == NATS_NO_RESPONDERS) {
      return Error{
          ErrorKind::refused,
          fmt::format("the NATS server {} keeps no streams: JetStream is off", nats().server()),
          endpoint().text()};
    }
    return natsError("ask for the stream", status, endpoint());
  }

  void startAt(jsConsumerConfig& config, jsDeliverPolicy otherwise) const {
    config.DeliverPolicy = otherwise;
    if (nats().from_sequence) {
      config.DeliverPolicy = js_DeliverByStartSequence;
      config.OptStartSeq = *nats().from_sequence;
    } else if (nats().from_time) {
      config.DeliverPolicy = js_DeliverByStartTime;
      config.OptStartTime = writableTime(*nats().from_time).time_since_epoch().count();
    }
  }

  Status pass() {
    jsSubOptions options;
    (void)jsSubOptions_Init(&options);
    options.Stream = stream();
    options.Ordered = true;
    options.Config.Heartbeat = kHeartbeatNs;
    startAt(options.Config, js_DeliverNew);
    if (nats().from_sequence) expected_ = *nats().from_sequence;
    return subscribe(">", options);
  }

  Status resume(const jsStreamInfo& stream_info) {
    const char* durable = nats().durable.c_str();
    if (Status found = findDurable(durable); !found) return found;
    const jsConsumerInfo* const made = durable_.get();
    const bool known = made != nullptr;
    if (known &&
        (made->Config->DeliverSubject == nullptr || made->Config->AckPolicy != js_AckAll)) {
      return Error{ErrorKind::refused,
                   fmt::format("the durable {} of the stream was made by another program: choose "
                               "another with durable=NAME",
                               durable),
                   endpoint().text()};
    }
    noted_ = known ? progressIn(made->Config->Description) : 0;
    confirmed_ = known ? std::max<std::uint64_t>(made->AckFloor.Stream, noted_) : 0;
    confirmed_ = std::min(confirmed_, stream_info.State.LastSeq);
    if (known && confirmed_ == 0) {
      // Nothing was ever recorded, and where it began is not known: it begins anew.
      const natsStatus status =
          js_DeleteConsumer(context_.get(), stream(), durable, nullptr, nullptr);
      if (status != NATS_OK) return natsError("renew the durable", status, endpoint());
    }
    jsSubOptions options;
    (void)jsSubOptions_Init(&options);
    options.Stream = stream();
    options.ManualAck = true;
    if (confirmed_ == 0) {
      const jsStreamState& state = stream_info.State;
      const std::uint64_t oldest = state.Msgs > 0 ? state.FirstSeq : state.LastSeq + 1;
      // Where a time begins only the server knows.
      expected_ = nats().from_sequence.value_or(nats().from_time ? 0 : oldest);
      skipGone(state.FirstSeq);
      return beginDurable(durable, options);
    }
    goOn(stream_info);
    skipGone(stream_info.State.FirstSeq);
    options.Consumer = durable;
    return subscribe(nullptr, options);
  }

  /// What the server knows of the durable, null for nothing, once no other reader has it.
  Status findDurable(const char* durable) {
    for (int attempt = 0; attempt < kBoundAttempts; ++attempt) {
      jsConsumerInfo* made = nullptr;
      jsErrCode code{};
      const natsStatus status =
          js_GetConsumerInfo(&made, context_.get(), stream(), durable, nullptr, &code);
      durable_.reset(made);
      if (code == JSConsumerNotFoundErr || status == NATS_NOT_FOUND) return {};
      if (status != NATS_OK) return natsError("ask for the durable", status, endpoint());
      if (!made->PushBound) return {};
      std::this_thread::sleep_for(kBoundWait);
    }
    return Error{
        ErrorKind::refused,
        fmt::format("another reader has the durable {}: choose another with durable=NAME", durable),
        endpoint().text()};
  }

  void goOn(const jsStreamInfo& stream_info) {
    const std::uint64_t first = stream_info.State.FirstSeq;
    news_ = fmt::format("{} resumes after message {} of the stream, which has {} to {}",
                        endpoint().text(), confirmed_, first, stream_info.State.LastSeq);
    sent_before_ = durable_->Delivered.Stream;
    expected_ = confirmed_ + 1;
    // The server counts what was purged as confirmed; only the note tells what a purge took.
    const bool removed = stream_info.Config->Retention == js_LimitsPolicy && first == expected_;
    if (noted_ > 0 && removed) expected_ = noted_ + 1;
  }

  static std::uint64_t progressIn(const char* description) {
    const std::string_view text = description != nullptr ? description : "";
    std::uint64_t sequence = 0;
    if (!text.starts_with(kNote)) return 0;
    (void)std::from_chars(text.data() + kNote.size(), text.data() + text.size(), sequence);
    return sequence;
  }

  /// Leaves with the server how far the recording has come.
  void noteProgress() {
    if (!durable_ || confirmed_ == noted_) return;
    const std::string note = fmt::format("{}{}", kNote, confirmed_);
    jsConsumerConfig config = *durable_->Config;
    config.Description = note.c_str();
    (void)js_UpdateConsumer(nullptr, context_.get(), stream(), &config, nullptr, nullptr);
    noted_ = confirmed_;
    noted_at_ = std::chrono::steady_clock::now();
  }

  /// Subscribes first, so that the server sees a listener when it makes the durable.
  Status beginDurable(const char* durable, jsSubOptions& options) {
    jsConsumerConfig& config = options.Config;
    config.Durable = durable;
    config.AckPolicy = js_AckAll;
    config.AckWait = kAckWaitNs;
    config.MaxAckPending = kMaxUnconfirmed;
    config.FlowControl = true;
    config.Heartbeat = kHeartbeatNs;
    startAt(config, js_DeliverAll);
    if (Status made = subscribe(">", options); !made) return made;
    jsConsumerInfo* info = nullptr;
    (void)js_GetConsumerInfo(&info, context_.get(), stream(), durable, nullptr, nullptr);
    durable_.reset(info);
    return {};
  }

  Status subscribe(const char* subject, jsSubOptions& options) {
    natsSubscription* made = nullptr;
    natsStatus status = js_Subscribe(&made, context_.get(), subject, MessageQueue::take, &queue_,
                                     nullptr, &options, nullptr);
    subscription_.reset(made);
    if (status == NATS_OK) status = end_.watch(made);
    return status == NATS_OK ? Status() : natsError("read the stream", status, endpoint());
  }

  /// Gives the message, or what is missing before it. False: it must wait.
  bool give(natsMsg* message) {
    jsMsgMetaData* made = nullptr;
    // A message without them was not sent by the stream.
    if (natsMsg_GetMetaData(&made, message) != NATS_OK) return true;
    const MetaData data(made);
    const std::uint64_t sequence = data->Sequence.Stream;
    const char* reply = natsMsg_GetReply(message);
    const WallTime time{Nanoseconds(data->Timestamp)};
    if (expected_ == 0 && nats().from_time && time < *nats().from_time) return true;
    // A server that lost its disk's last writes gives their numbers again, to newer messages.
    if (sequence < expected_ && newest_ns_ > 0 && data->Timestamp > newest_ns_) {
      news_ = fmt::format("{} went back from message {} to {}: the server lost the rest",
                          endpoint().text(), expected_ - 1, sequence);
      expected_ = sequence;
    } else if (sequence < expected_) {
      if (sequence <= confirmed_ && reply != nullptr) acknowledge(reply);
      return true;
    }
    if (expected_ > 0 && sequence > expected_ && !fetchUntil(sequence)) return false;
    add(message, data->Timestamp, sequence, reply != nullptr ? reply : "");
    return true;
  }

  void add(const natsMsg* message, std::int64_t time_ns, std::uint64_t sequence,
           std::string reply) {
    datagrams_.push_back(
        datagramOf(message, WallTime(Nanoseconds(std::max<std::int64_t>(time_ns, 0)))));
    newest_ns_ = std::max(newest_ns_, time_ns);
    expected_ = sequence + 1;
    ++given_;
    if (reading_ == StreamReading::resuming) {
      // What was gone before the first one is settled.
      if (given_ == 1 && confirmed_ == 0 && sequence > 1) {
        confirmed_ = sequence - 1;
        noteProgress();
      }
      unconfirmed_.push_back({given_, sequence, std::move(reply)});
    }
  }

  /// Messages before `first` are no longer in the stream.
  void skipGone(std::uint64_t first) {
    if (expected_ == 0 || first <= expected_) return;
    gone_ += first - expected_;
    expected_ = first;
  }

  /// Fetches what lies between the last message and `sequence`. True when nothing more does.
  bool fetchUntil(std::uint64_t sequence) {
    if (const auto info = streamInfo()) skipGone(std::min((*info)->State.FirstSeq, sequence));
    while (expected_ < sequence) {
      if (datagrams_.size() >= kMessageBatch || fetched_.size() >= kFetchedBatch) return false;
      natsMsg* made = nullptr;
      jsErrCode code{};
      const natsStatus status =
          js_GetMsg(&made, context_.get(), stream(), expected_, nullptr, &code);
      if (status == NATS_OK) {
        fetched_.emplace_back(made);
        add(made, natsMsg_GetTime(made), expected_, {});
      } else if (code == JSNoMessageFoundErr || status == NATS_NOT_FOUND) {
        skipGone(expected_ + 1);
      } else if (client_->isConnected() && ++failed_fetches_ >= kFetchAttempts) {
        news_ = fmt::format("cannot fetch {} messages of {} that did not arrive; they are lost",
                            sequence - expected_, endpoint().text());
        skipGone(sequence);
      } else {
        return false;
      }
      failed_fetches_ = expected_ < sequence && status != NATS_OK ? failed_fetches_ : 0;
    }
    return true;
  }

  void acknowledge(const std::string& reply) {
    (void)natsConnection_PublishString(client_->get(), reply.c_str(), "+ACK");
  }

  MessageQueue queue_;
  CallbackEnd end_;
  std::unique_ptr<NatsClient> client_;
  StreamReading reading_;
  std::unique_ptr<jsCtx, NatsDestroy<jsCtx_Destroy>> context_;
  ConsumerInfo durable_;  ///< as it was at the beginning
  NatsSubscription subscription_;

  std::vector<ArrivedMessage> messages_;
  std::size_t next_ = 0;  ///< of messages_, to be given
  std::vector<NatsMessage> fetched_;
  std::vector<ReceivedDatagram> datagrams_;
  std::int64_t newest_ns_ = 0;   ///< the time of the newest message given
  std::uint64_t expected_ = 0;   ///< the next message's sequence; 0: unknown
  std::uint64_t confirmed_ = 0;  ///< the last one that the caller keeps
  std::uint64_t noted_ = 0;      ///< what the durable's note says of it
  SteadyTime noted_at_{};
  std::uint64_t sent_before_ = 0;  ///< the last one that the server sent to the reader before
  std::uint64_t given_ = 0;
  std::uint64_t gone_ = 0;
  int failed_fetches_ = 0;
  std::deque<Unconfirmed> unconfirmed_;
  std::optional<std::string> news_;
};

}  // namespace

Result<std::unique_ptr<DatagramSource>> openJetStream(const Endpoint& endpoint,
                                                      StreamReading reading) {
  auto client = NatsClient::connect(endpoint);
  if (!client) return client.error();
  auto source = std::make_unique<JetStreamSource>(std::move(*client), reading);
  if (Status opened = source->open(); !opened) return opened.error();
  return source;
}

}  // namespace rocinante
