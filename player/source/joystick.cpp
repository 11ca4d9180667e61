#include "player/source/joystick.h"

#include <poll.h>

#include <algorithm>
#include <optional>

#include "core/signing/signed_datagram.h"
#include "core/source/source.h"
#include "player/send/udp_send_port.h"
#include "player/source/joystick_drive.h"
#include "player/source/joystick_input.h"
#include "player/source/source.h"

namespace rocinante {
namespace {

/// While a joint moves.
constexpr Nanoseconds kCycle = Nanoseconds(1'000'000'000 / 60);
/// While none does: a signal to stop is seen, and restatements keep their pace.
constexpr Nanoseconds kIdle = std::chrono::milliseconds(100);

/// A Source that says where a drive's joints are.
class JoystickSpeaker {
 public:
  static Result<JoystickSpeaker> open(const JoystickMap& map, const SourceSettings& settings,
                                      Source::Send send) {
    Result<Source> source = Source::open(settings, std::move(send));
    if (!source) return source.error();
    JoystickSpeaker speaker(std::move(*source));
    for (const JoystickMap::Device& device : map.devices) {
      const SourceDevice handle = speaker.source_.device(device.name);
      const std::vector<std::string_view> joints(device.joints.begin(), device.joints.end());
      const SourceResult order = speaker.source_.setOrder(handle, joints);
      if (order != SourceResult::done) return refusal(order, "order of " + device.name);
      speaker.devices_.push_back(handle);
    }
    return speaker;
  }

  Status say(JoystickDrive& drive, Nanoseconds now, WallTime time) {
    for (std::size_t i = 0; i < devices_.size(); ++i) {
      drive.positionsAt(now, i, positions_);
      const SourceResult set = source_.setJoints(devices_[i], positions_);
      if (set != SourceResult::done) return refusal(set, drive.map().devices[i].name);
    }
    for (const std::string_view text : drive.takePressed()) {
      const SourceResult event = source_.event(text);
      if (event != SourceResult::done) return refusal(event, "event:" + std::string(text));
    }
    const SourceResult flushed = source_.flush(now, time);
    // Its sender says what could not be sent.
    if (flushed == SourceResult::done || flushed == SourceResult::not_sent) return {};
    return refusal(flushed, "");
  }

  Nanoseconds due() const { return source_.due().value_or(Nanoseconds::max()); }

 private:
  explicit JoystickSpeaker(Source source) : source_(std::move(source)) {}
  static Error refusal(SourceResult result, const std::string& where) {
    return {ErrorKind::bad_argument, std::string(sentenceOf(result)), where};
  }

  Source source_;
  std::vector<SourceDevice> devices_;
  std::vector<double> positions_;
};

/// Waits for the joystick until `left` has passed. A signal ends it early.
void waitFor(int descriptor, Nanoseconds left) {
  const auto whole = std::chrono::duration_cast<std::chrono::seconds>(left);
  const timespec most{whole.count(), static_cast<long>((left - whole).count())};
  pollfd readable{descriptor, POLLIN, 0};
  ::ppoll(&readable, descriptor < 0 ? 0 : 1, &most, nullptr);
}

/// Sends each datagram of a source at once, signed if there is a key.
class SendNow {
 public:
  static Result<SendNow> open(const SourceOptions& options, const SendSurroundings& surroundings) {
    std::optional<DatagramSigner> signer;
    if (!options.key.empty()) {
      Result<SigningKey> key = SigningKey::read(options.key);
      if (!key) return key.error();
      signer.emplace(std::move(*key), wallNow);
    }
    Result<UdpSendPort> port = UdpSendPort::open({{options.to, 0, false}}, options.realtime,
                                                 surroundings.stop, -1, surroundings.notify);
    if (!port) return port.error();
    return SendNow(std::move(*port), std::move(signer));
  }

  /// Since it was opened.
  Nanoseconds now() { return port_.now() - began_; }

  bool send(ByteView datagram) {
    const ByteView payload = signer_ ? signer_->sign(datagram) : datagram;
    const Nanoseconds due = now();
    SteadyTime sent_at{};
    if (Status sent = port_.send(0, {&payload, 1}, {&sent_at, 1}); !sent) {
      failure_ = sent.error();
      return false;
    }
    Due when;
    when.time = LogTime(due);
    journal_.sent(when, payload, began_ + due, sent_at);
    return true;
  }

  const std::optional<Error>& failure() const { return failure_; }

  Status finish(PlayReport& report) {
    if (Status flushed = port_.flush(); !flushed) return flushed;
    report.timing_source = port_.timingSource();
    report.scheduling = port_.scheduling();
    journal_.writeTo(report);
    return {};
  }

 private:
  SendNow(UdpSendPort port, std::optional<DatagramSigner> signer)
      : port_(std::move(port)), signer_(std::move(signer)), began_(port_.now()) {}

  UdpSendPort port_;
  std::optional<DatagramSigner> signer_;
  SteadyTime began_;
  PlayJournal journal_{LogTime{}, LogTime::max()};
  std::optional<Error> failure_;
};

/// Everything that has happened up to `now`.
Status applyEvents(JoystickInput& input, JoystickDrive& drive, Nanoseconds now) {
  while (true) {
    const Result<std::optional<JoystickEvent>> event = input.next(now);
    if (!event) return event.error();
    if (!*event) return {};
    drive.apply(**event, input.moment());
  }
}

}  // namespace

Result<PlayReport> sendJoystick(const JoystickSourceOptions& joystick, const SourceOptions& options,
                                const SendSurroundings& surroundings) {
  Result<JoystickMap> map = readJoystickMap(joystick.map);
  if (!map) return map.error();
  Result<JoystickInput> input = JoystickInput::open(joystick.device);
  if (!input) return input.error();
  Result<SendNow> out = SendNow::open(options, surroundings);
  if (!out) return out.error();

  PlayReport report;
  report.inputs = {joystick.device.string()};
  report.source = joystick.source.empty() ? map->devices.front().name : joystick.source;
  report.run = runOf(options);
  report.to = options.to.text();
  SourceSettings settings;
  settings.source = report.source;
  settings.run = report.run;
  settings.restate = joystick.restate;
  settings.max_datagram = unsignedBytes(options);
  Result<JoystickSpeaker> speaker = JoystickSpeaker::open(
      *map, settings, [&out](std::span<std::byte> datagram) { return out->send(datagram); });
  if (!speaker) return speaker.error();
  surroundings.notify("sending " + report.source + " to " + report.to);

  JoystickDrive drive(std::move(*map));
  Status events;
  for (bool over = false; !over && !out->failure();) {
    const Nanoseconds now = out->now();
    events = applyEvents(*input, drive, now);
    over = !events || input->ended();
    // A file's joints stay where its last event leaves them.
    const Nanoseconds moment = input->ended() ? input->moment() : now;
    if (Status sent = speaker->say(drive, moment, wallNow()); !sent) return sent.error();
    const Nanoseconds pause = drive.moves() ? kCycle : kIdle;
    const Nanoseconds next = std::min({now + pause, speaker->due(), input->nextMoment()});
    if (!over) waitFor(input->descriptor(), std::max(next - out->now(), Nanoseconds(0)));
    report.interrupted = surroundings.stop();
    over = over || report.interrupted || (options.duration && now >= *options.duration);
  }
  if (out->failure()) return *out->failure();
  if (!events) report.damage.push_back(events.error().text());
  if (Status finished = out->finish(report); !finished) return finished.error();
  return report;
}

}  // namespace rocinante
