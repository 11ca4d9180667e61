#include "core/log/log_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/base/version.h"
#include "core/log/log_profile.h"
#include "core/log/loss_message.h"
#include "core/log/new_log_file.h"
#include "core/mcap/chunk_expander.h"
#include "core/mcap/writer.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxChannels = 65536;
constexpr std::size_t kMaxSchemas = 65535;  // 0 means none

Error badArgument(std::string what, const std::string& where) {
  return Error{ErrorKind::bad_argument, std::move(what), where};
}

/// The size of rocinante.end and its entry in the summary, without session id and reason.
constexpr std::uint64_t kEndRecordBytes = 1024;

mcap::WriterOptions writerOptions(const LogWriterOptions& options, std::size_t session_id_bytes) {
  mcap::WriterOptions mcap_options;
  mcap_options.closing_room_bytes = options.closing_room_bytes + kEndRecordBytes + session_id_bytes;
  mcap_options.chunk_bytes = options.chunk_bytes;
  if (options.compression == LogWriterOptions::Compression::none) {
    mcap_options.zstd_level.reset();
  } else {
    mcap_options.zstd_level = options.zstd_level;
  }
  return mcap_options;
}

}  // namespace

struct LogWriter::Impl {
  Impl(mcap::Writer mcap_writer, std::string log_name, std::string session, Nanoseconds sync_span)
      : writer(std::move(mcap_writer)),
        name(std::move(log_name)),
        session_id(std::move(session)),
        sync(sync_span) {}

  mcap::Writer writer;
  std::string name;
  std::string session_id;
  Nanoseconds sync;

  std::vector<bool> captured;                             ///< by channel id
  std::vector<std::shared_ptr<const LogSchema>> schemas;  ///< by schema id, from 1
  std::optional<ChannelId> loss_channel;
  std::uint32_t losses = 0;

  std::optional<LogTime> origin;
  bool session_written = false;
  LogTime last_time{};  ///< the latest of any message

  SteadyTime last_look{};        ///< the last `now` that flushIfDue() was given
  SteadyTime waiting_since{};    ///< not later than the first message that is not in the file
  std::optional<Error> failure;  ///< the first refused write
  std::map<ChannelId, std::uint64_t> refused_after;  ///< never given to `writer`
  std::map<ChannelId, std::uint64_t> refused;        ///< the former and those lost by `writer`
  bool closed = false;
  bool locked = true;

  /// Keeps the first failure: later ones only follow from it.
  Status keep(Status status) {
    if (!status) {
      if (!failure) failure = status.error();
      refused = refused_after;
      for (const auto& [channel, count] : writer.lost()) refused[channel] += count;
    }
    return status;
  }

  Status refuse(ChannelId channel) {
    ++refused_after[channel];
    ++refused[channel];
    return *failure;
  }

  /// 0 for none.
  Result<std::uint16_t> schemaId(std::shared_ptr<const LogSchema> schema) {
    if (schema == nullptr) return std::uint16_t{0};
    const auto same = [&](const auto& known) { return *known == *schema; };
    const auto found = std::ranges::find_if(schemas, same);
    const auto id = static_cast<std::size_t>(found - schemas.begin()) + 1;
    if (found == schemas.end()) {
      if (id > kMaxSchemas) {
        return Error{ErrorKind::refused, "a log has at most 65535 schemas", name};
      }
      writer.addSchema(
          {static_cast<std::uint16_t>(id), schema->name, schema->encoding, schema->data});
      schemas.push_back(std::move(schema));
    }
    return static_cast<std::uint16_t>(id);
  }

  Status writeSession() {
    mcap::Metadata session;
    session.name = profile::kSession;
    session.metadata.emplace(profile::kFormatKey, profile::kFormat);
    session.metadata.emplace(profile::kSessionIdKey, session_id);
    if (origin) {
      session.metadata.emplace(profile::kOriginKey,
                               std::to_string(origin->time_since_epoch().count()));
    }
    session_written = true;
    return keep(writer.writeMetadata(session));
  }

  Status putMessage(ChannelId channel, std::uint32_t sequence, LogTime log_time,
                    std::int64_t publish_time_ns, ByteView payload) {
    if (!writer.unflushed()) waiting_since = last_look;
    mcap::Message message;
    message.channel_id = channel;
    message.sequence = sequence;
    message.log_time = static_cast<std::uint64_t>(log_time.time_since_epoch().count());
    message.publish_time = static_cast<std::uint64_t>(publish_time_ns);
    message.data = payload;
    return keep(writer.write(message));
  }
};

Result<LogWriter> LogWriter::create(const std::filesystem::path& path,
                                    const LogWriterOptions& options, std::string session_id) {
  Result<NewLogFile> file = NewLogFile::make(path, options.overwrite);
  if (!file) return file.error();
  Result<LogWriter> writer = createOn(file->takeSink(), options, std::move(session_id));
  if (!writer) return writer;
  if (Status published = file->publish(); !published) return published.error();
  writer->impl_->locked = file->locked();
  return writer;
}

Result<LogWriter> LogWriter::createOn(std::unique_ptr<ByteSink> sink,
                                      const LogWriterOptions& options, std::string session_id) {
  if (options.chunk_bytes == 0 || options.chunk_bytes > mcap::kMaxChunkBytes / 2) {
    return badArgument(fmt::format("chunk size must be 1 to {} bytes, not {}",
                                   mcap::kMaxChunkBytes / 2, options.chunk_bytes),
                       sink->name());
  }
  std::string name = sink->name();
  Result<mcap::Writer> writer =
      mcap::Writer::start(std::move(sink), writerOptions(options, session_id.size()),
                          mcap::Header{std::string(profile::kName), std::string(version())});
  if (!writer) return writer.error();
  return LogWriter(std::make_unique<Impl>(std::move(*writer), std::move(name),
                                          std::move(session_id), options.sync));
}

LogWriter::LogWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LogWriter::LogWriter(LogWriter&&) noexcept = default;
LogWriter& LogWriter::operator=(LogWriter&&) noexcept = default;

LogWriter::~LogWriter() {
  // Without a reason given, the log keeps its contents and says that it was not closed.
  if (impl_ && !impl_->closed) (void)close("abandoned");
}

Result<ChannelId> LogWriter::addChannel(std::string topic, std::string encoding,
                                        std::map<std::string, std::string> metadata,
                                        std::shared_ptr<const LogSchema> schema) {
  if (impl_->captured.size() >= kMaxChannels) {
    return Error{ErrorKind::refused, "a log has at most 65536 channels", impl_->name};
  }
  const Result<std::uint16_t> schema_id = impl_->schemaId(std::move(schema));
  if (!schema_id) return schema_id.error();
  const auto id = static_cast<ChannelId>(impl_->captured.size());
  LogChannel as_read{id, std::move(topic), std::move(encoding), std::move(metadata)};
  impl_->captured.push_back(as_read.captured());
  mcap::Channel channel;
  channel.id = id;
  channel.schema_id = *schema_id;
  channel.topic = std::move(as_read.topic);
  channel.message_encoding = std::move(as_read.encoding);
  channel.metadata = std::move(as_read.metadata);
  impl_->writer.addChannel(std::move(channel));
  return id;
}

Status LogWriter::write(ChannelId channel, std::uint32_t sequence, LogTime log_time,
                        std::int64_t publish_time_ns, ByteView payload) {
  Impl& log = *impl_;
  if (channel >= log.captured.size()) {
    return badArgument(fmt::format("channel {} was never added to the log", channel), log.name);
  }
  if (log.failure) return log.refuse(channel);
  if (log_time.time_since_epoch().count() < 0) {
    return badArgument("a log time is before 1970", log.name);
  }
  if (log_time > kLastLogTime) {
    return badArgument("a log time is beyond the last, 2^63 - 2 ns", log.name);
  }
  if (payload.size() > mcap::kMaxChunkBytes / 2) {
    return badArgument(fmt::format("a message of {} bytes is too large", payload.size()), log.name);
  }
  log.last_time = std::max(log.last_time, log_time);
  if (log.captured[channel] && !log.session_written) {
    if (!log.origin) log.origin = log_time;
    if (Status written = log.writeSession(); !written) return log.refuse(channel);
  }
  return log.putMessage(channel, sequence, log_time, publish_time_ns, payload);
}

Status LogWriter::writeLoss(const LossSpan& span) {
  Impl& log = *impl_;
  if (!log.loss_channel) {
    Result<ChannelId> added =
        addChannel(std::string(profile::kLossTopic), std::string(profile::kLossEncoding), {});
    if (!added) return added.error();
    log.loss_channel = *added;
  }
  // Losses are written when they become known, which may be later than their time; order is kept.
  log.last_time = std::max({log.last_time, span.until, LogTime{}});
  const std::string text = lossText(span);
  return log.putMessage(*log.loss_channel, log.losses++, log.last_time,
                        log.last_time.time_since_epoch().count(), bytesOf(text));
}

Status LogWriter::writeAttachment(std::string name, std::string media_type, LogTime time,
                                  ByteView data) {
  mcap::Attachment attachment;
  attachment.log_time = static_cast<std::uint64_t>(time.time_since_epoch().count());
  attachment.name = std::move(name);
  attachment.media_type = std::move(media_type);
  attachment.data = data;
  return impl_->keep(impl_->writer.writeAttachment(attachment));
}

Status LogWriter::writeMetadata(const LogMetadata& metadata) {
  return impl_->keep(impl_->writer.writeMetadata({metadata.name, metadata.entries}));
}

void LogWriter::setOrigin(LogTime origin) { impl_->origin = origin; }

Status LogWriter::flushIfDue(SteadyTime now) {
  Impl& log = *impl_;
  log.last_look = now;
  if (!log.writer.unflushed() || now - log.waiting_since < log.sync / 2) return {};
  return log.keep(log.writer.flush());
}

Status LogWriter::flush() { return impl_->keep(impl_->writer.flush()); }

Status LogWriter::check() {
  if (impl_->closed) return {};
  return impl_->writer.check();
}

bool LogWriter::locked() const { return impl_->locked; }

Status LogWriter::close(std::string reason) {
  Impl& log = *impl_;
  if (log.closed) return {};
  log.closed = true;
  if (!log.session_written) (void)log.writeSession();
  // The last chunk first: the rest is small and may still fit when the chunk does not.
  (void)log.keep(log.writer.closeChunk());
  mcap::Metadata end;
  end.name = profile::kEnd;
  end.metadata.emplace(profile::kReasonKey, std::move(reason));
  end.metadata.emplace(profile::kSessionIdKey, log.session_id);
  if (log.origin) {
    end.metadata.emplace(profile::kOriginKey,
                         std::to_string(log.origin->time_since_epoch().count()));
  }
  (void)log.keep(log.writer.writeMetadata(end));
  (void)log.keep(log.writer.finish());
  if (log.failure) return *log.failure;
  return {};
}

std::uint64_t LogWriter::bytesWritten() const { return impl_->writer.bytesWritten(); }

const std::map<ChannelId, std::uint64_t>& LogWriter::refusedByDisk() const {
  return impl_->refused;
}

}  // namespace rocinante
