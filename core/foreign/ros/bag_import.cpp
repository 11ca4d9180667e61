#include "core/foreign/ros/bag_import.h"

#include <algorithm>

#include "core/base/figure_text.h"
#include "core/base/hash.h"
#include "core/foreign/ros/names.h"
#include "core/foreign/ros/robot_description.h"
#include "core/log/import_record.h"
#include "core/log/log_profile.h"
#include "core/log/mapped_file.h"
#include "core/mcap/chunk_expander.h"

namespace rocinante::ros {
namespace {

/// Messages or bytes between two calls of `progress`.
constexpr std::uint64_t kProgressMessages = 4096;
constexpr std::uint64_t kProgressBytes = std::uint64_t{8} << 20;
/// The largest payload that a log takes.
constexpr std::size_t kMaxPayload = mcap::kMaxChunkBytes / 2;

/// A topic of the log may not look like one of our own.
std::string topicInLog(const std::string& name) {
  std::string topic = name.starts_with('/') ? name : "/" + name;
  if (topic.starts_with(profile::kOwnTopics)) topic.insert(0, kImportedPrefix);
  return topic;
}

/// Why a topic has no packets.
std::string reasonOf(const ImportedTopic& topic) {
  const std::string messages = countText(topic.messages, "message");
  if (!topic.translated) {
    const bool is_ros = topic.encoding == "cdr" || topic.encoding == "ros1";
    const std::string type = topic.type.empty() ? "an unnamed type" : topic.type;
    return messages + " of " + type + (is_ros ? "" : " as " + topic.encoding) +
           ", which do not become packets";
  }
  if (topic.malformed == topic.messages) return messages + ", none of the stated type";
  if (!topic.notes.empty()) return messages + "; the warnings of the import say why";
  return messages + " with nothing that a packet says of the cell";
}

/// What is still there, with the bytes of each message, but moves and shows nothing.
Account topicsWithoutPackets(const ImportReport& report) {
  Account account;
  for (const ImportedTopic& topic : report.topics) {
    if (topic.packets > 0 || topic.described) continue;
    // Datagrams are reported as those of any log.
    if (topic.encoding == "rk1" || topic.encoding == "octets") continue;
    account.leaveOut({.kind = "topic",
                      .name = topic.name,
                      .reason = reasonOf(topic),
                      .severity = topic.translated ? Severity::warning : Severity::note});
  }
  return account;
}

class Import {
 public:
  Import(std::vector<std::unique_ptr<BagReader>> bags, SessionWriter session,
         const DeviceFinder& devices, const ImportOptions& options, std::string described)
      : session_(std::move(session)),
        translator_(devices),
        options_(options),
        described_(std::move(described)) {
    for (auto& bag : bags) {
      bag->useDevices(devices);
      inputs_.push_back({std::move(bag), {}, 0, 0, {}});
    }
  }

  /// `notes`: what is known before it begins.
  Result<ImportReport> run(const CellBundle* bundle, const std::vector<std::string>& notes) {
    for (Input& input : inputs_) {
      if (Status read = advance(input); !read) return read.error();
    }
    Input* const first = earliest();
    if (first == nullptr) return nothing();
    // The earliest moment that any of them is shown from.
    std::optional<LogTime> origin;
    for (const Input& input : inputs_) {
      const std::optional<LogTime> its = input.bag->origin();
      if (its && input.head) origin = std::min(origin.value_or(*its), *its);
    }
    if (origin && first->head->log_time >= *origin) session_.log().setOrigin(*origin);
    if (bundle != nullptr) {
      const LogTime time = std::clamp(first->head->log_time, LogTime{}, kLastLogTime);
      if (Status put = AttachedBundle(*bundle).writeTo(session_.log(), time); !put) {
        return put.error();
      }
    }
    std::uint64_t taken = 0, taken_bytes = 0;
    while (Input* const input = earliest()) {
      taken_bytes += input->head->payload.size();
      if (Status kept = take(*input); !kept) return kept.error();
      if (Status read = advance(*input); !read) return read.error();
      if (++taken < kProgressMessages && taken_bytes < kProgressBytes) continue;
      taken = taken_bytes = 0;
      if (options_.progress) {
        if (Status goes_on = options_.progress(part()); !goes_on) return goes_on.error();
      }
    }
    if (report_.messages == 0) return nothing();
    return finish(notes);
  }

 private:
  /// A topic of an input, in the log.
  struct Outlet {
    std::size_t place = 0;  ///< in the report
    ChannelId channel = 0, decoded_channel = 0;
    std::optional<std::size_t> translation;
    bool decoded = false;  ///< the reader makes its packets
  };
  struct Input {
    std::unique_ptr<BagReader> bag;
    std::optional<BagMessage> head;
    std::uint64_t messages = 0;  ///< that were read
    std::uint64_t packed = 0;    ///< of those, what should be CDR and does not begin as it
    std::vector<std::optional<Outlet>> outlets;  ///< by topic
  };

  Error nothing() const {
    std::string what = "there is no message to import";
    for (const Input& input : inputs_) {
      const std::vector<std::string> damage = input.bag->damage();
      if (!damage.empty()) what += "; " + damage.front();
    }
    return {ErrorKind::not_found, std::move(what), {}};
  }

  static Status advance(Input& input) {
    Result<std::optional<BagMessage>> message = input.bag->next();
    if (!message) return message.error();
    input.head = *message;
    if (!input.head) return {};
    ++input.messages;
    const BagMessage& head = *input.head;
    // A message of CDR begins with a zero.
    input.packed += input.bag->topics()[head.topic].encoding == "cdr" && !head.payload.empty() &&
                    head.payload[0] != std::byte{0};
    return {};
  }

  Input* earliest() {
    Input* found = nullptr;
    for (Input& input : inputs_) {
      if (input.head && (found == nullptr || input.head->log_time < found->head->log_time)) {
        found = &input;
      }
    }
    return found;
  }

  double part() const {
    double sum = 0;
    for (const Input& input : inputs_) sum += input.bag->part();
    return sum / static_cast<double>(inputs_.size());
  }

  Result<Outlet*> outletOf(Input& input, std::size_t number) {
    if (input.outlets.size() <= number) input.outlets.resize(input.bag->topics().size());
    std::optional<Outlet>& known = input.outlets[number];
    if (known) return &*known;
    const BagTopic& topic = input.bag->topics()[number];
    const std::string name = topicInLog(topic.name);
    std::map<std::string, std::string> metadata = topic.metadata;
    metadata.insert_or_assign(std::string(profile::kImportedKey), std::string(input.bag->kind()));
    Outlet outlet;
    const Result<ChannelId> channel =
        session_.addChannel(name, topic.encoding, metadata, topic.schema);
    if (!channel) return channel.error();
    outlet.channel = *channel;
    const std::optional<FieldCursor::Layout> layout = topic.layout();
    outlet.decoded = !topic.decoder.empty();
    if (!outlet.decoded && layout && !isRobotDescription(topic)) {
      outlet.translation = translator_.addTopic(topic.name, topic.type, *layout, topic.metadata);
    }
    if (outlet.decoded || outlet.translation) {
      const std::string decoder = outlet.decoded ? topic.decoder : std::string(kDecoderName);
      metadata.insert_or_assign(std::string(profile::kDecoderKey), decoder);
      if (outlet.translation) {
        metadata.insert_or_assign(std::string(kDecoderVersionKey), std::string(kDecoderVersion));
      }
      metadata.insert_or_assign("source", sourceOf(topic.name, decoder));
      const Result<ChannelId> decoded = session_.addChannel(
          std::string(profile::kDecodedPrefix) + name, "rk1", std::move(metadata));
      if (!decoded) return decoded.error();
      outlet.decoded_channel = *decoded;
    }
    outlet.place = report_.topics.size();
    ImportedTopic& reported = report_.topics.emplace_back();
    reported.name = name;
    reported.type = topic.type;
    reported.encoding = topic.encoding;
    reported.described = !described_.empty() && topic.name == described_;
    reported.translated = outlet.decoded || outlet.translation.has_value();
    known = outlet;
    return &*known;
  }

  Status take(Input& input) {
    const BagMessage& message = *input.head;
    if (message.log_time < LogTime{} || message.log_time > kLastLogTime ||
        message.payload.size() > kMaxPayload) {
      ++report_.dropped;
      return {};
    }
    const Result<Outlet*> outlet = outletOf(input, message.topic);
    if (!outlet) return outlet.error();
    const Outlet& out = **outlet;
    if (Status kept = session_.write(out.channel, message.sequence, message.log_time,
                                     message.publish_time_ns, message.payload, nullptr);
        !kept) {
      return kept;
    }
    if (report_.messages == 0) report_.start = report_.end = message.log_time;
    report_.start = std::min(report_.start, message.log_time);
    report_.end = std::max(report_.end, message.log_time);
    ++report_.messages;
    ImportedTopic& reported = report_.topics[out.place];
    ++reported.messages;
    const Made made = packetOf(message, out);
    if (made.malformed) {
      if (reported.malformed++ == 0) reported.fault = made.fault;
      ++report_.malformed;
    }
    if (made.text.empty()) return {};
    ++reported.packets;
    ++report_.packets;
    if (made.packet == nullptr) {
      return session_.write(out.decoded_channel, message.sequence, message.log_time,
                            message.publish_time_ns, bytesOf(made.text));
    }
    return session_.write(out.decoded_channel, message.sequence, message.log_time,
                          message.publish_time_ns, bytesOf(made.text), made.packet);
  }

  /// What becomes of a message besides its bytes; borrowed until the next one.
  struct Made : Translated {
    bool malformed = false;
    std::string_view fault{};  ///< why, where the reader says it
  };
  Made packetOf(const BagMessage& message, const Outlet& out) {
    if (out.decoded) return {{message.packet, nullptr}, !message.fault.empty(), message.fault};
    Made made;
    if (out.translation) {
      const auto outcome =
          translator_.translate(*out.translation, message.log_time, message.payload, made);
      made.malformed = outcome == RosTranslator::Outcome::malformed;
    }
    return made;
  }

  /// Holds what was read against what something beside the inputs says.
  void compare(const StatedMessages& stated) {
    // A folder may change while it is opened.
    if (stated.first + stated.inputs > inputs_.size()) return;
    std::uint64_t read = 0, packed = 0;
    for (std::size_t i = 0; i < stated.inputs; ++i) {
      read += inputs_[stated.first + i].messages;
      packed += inputs_[stated.first + i].packed;
    }
    if (stated.count && read != *stated.count) {
      report_.damage.push_back(stated.name + " should have " + countText(*stated.count, "message") +
                               ", and " + std::to_string(read) + " were read" + stated.where);
    }
    if (stated.compression.empty()) return;
    if (packed == 0) {
      report_.notes.push_back("the messages should be compressed with " + stated.compression +
                              ", and none is" + stated.where);
      return;
    }
    report_.damage.push_back(countText(packed, "message") + " compressed with " +
                             stated.compression +
                             ", which is not read; `ros2 bag convert` makes a bag without "
                             "compression" +
                             stated.where);
  }

  Result<ImportReport> finish(const std::vector<std::string>& notes) {
    for (Input& input : inputs_) {
      if (Status copied = input.bag->copyExtras(session_.log()); !copied) return copied.error();
      const std::vector<std::string> damage = input.bag->damage();
      report_.damage.insert(report_.damage.end(), damage.begin(), damage.end());
      report_.account.add(input.bag->account());
      for (std::size_t i = 0; i < input.outlets.size(); ++i) {
        const std::optional<Outlet>& outlet = input.outlets[i];
        if (!outlet) continue;
        TranslationNotes& reported = report_.topics[outlet->place].notes;
        if (outlet->decoded) reported = input.bag->notesOf(i);
        if (outlet->translation) reported = translator_.notes(*outlet->translation);
      }
    }
    report_.notes.insert(report_.notes.begin(), notes.begin(), notes.end());
    report_.damage.insert(report_.damage.begin(), options_.damage.begin(), options_.damage.end());
    for (const StatedMessages& stated : options_.stated) compare(stated);
    report_.account.add(topicsWithoutPackets(report_));
    report_.account.add(translator_.account());
    if (Status noted = session_.log().writeMetadata(warningsRecord(report_)); !noted) {
      return noted.error();
    }
    if (Status closed = session_.log().close(std::string(kImportedEnd)); !closed) {
      return closed.error();
    }
    report_.bytes = session_.log().bytesWritten();
    return std::move(report_);
  }

  SessionWriter session_;
  RosTranslator translator_;
  const ImportOptions& options_;
  std::string described_;  ///< the topic of the robot description that is the log's cell
  std::vector<Input> inputs_;
  ImportReport report_;
};

}  // namespace

Result<ImportReport> importBags(std::vector<std::unique_ptr<BagReader>> bags,
                                std::unique_ptr<ByteSink> sink, std::string session_id,
                                const ImportOptions& options) {
  std::optional<DescribedRobot> robot;
  std::vector<std::string> notes;
  const bool describe = options.cell == nullptr || (options.describe && options.bundle == nullptr);
  for (std::size_t i = 0; i < bags.size() && describe && !robot; ++i) {
    Result<std::optional<DescribedRobot>> found = describedRobot(*bags[i], options.search);
    if (found) {
      robot = std::move(*found);
    } else {
      notes.push_back(found.error().text());
    }
  }
  const Cell* cell = options.cell;
  const CellBundle* bundle = options.bundle;
  if (robot) {
    if (cell == nullptr) cell = &robot->cell;
    if (robot->bundle) bundle = &*robot->bundle;
    notes.insert(notes.end(), robot->notes.begin(), robot->notes.end());
  }
  Result<LogWriter> log = LogWriter::createOn(std::move(sink), options.log, std::move(session_id));
  if (!log) return log.error();
  const DeviceFinder devices(cell, options.device);
  Import import(std::move(bags), SessionWriter(std::move(*log), options.keyframes), devices,
                options, robot ? robot->topic : std::string());
  Result<ImportReport> report = import.run(bundle, notes);
  if (!report) return report;
  if (robot) report->robot = robot->cell.devices.front().name;
  return report;
}

Result<std::string> importedSessionId(const std::vector<std::filesystem::path>& inputs) {
  constexpr std::size_t kEndBytes = 65536;
  Sha256 hash;
  for (const std::filesystem::path& path : inputs) {
    const Result<MappedFile> file = MappedFile::open(path);
    if (!file) return file.error();
    const std::size_t size = file->bytes().size();
    Bytes part(std::min(size, kEndBytes));
    hash.addU64(size);
    for (const std::size_t from : {std::size_t{0}, size - part.size()}) {
      if (!file->read(from, part)) {
        return Error{ErrorKind::unreadable, "the file cannot be read", path.string()};
      }
      hash.add(part);
    }
  }
  return hexOf(hash.finish()).substr(0, 32);
}

}  // namespace rocinante::ros
