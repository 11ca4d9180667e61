#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/base/hash.h"
#include "core/copy/log_edits.h"
#include "core/log/log_profile.h"
#include "core/mcap/parse_record.h"
#include "core/mcap/record_stepper.h"
#include "core/session/marks.h"

namespace rocinante {
namespace {

/// A private mapping of a file: writing to the memory does not change the file.
class PrivateFile {
 public:
  static Result<PrivateFile> open(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) return systemError(errno, path);
    struct stat facts {};
    const int looked = ::fstat(file, &facts);
    PrivateFile mapped;
    int failure = looked == 0 ? 0 : errno;
    if (failure == 0 && !S_ISREG(facts.st_mode)) failure = S_ISDIR(facts.st_mode) ? EISDIR : EINVAL;
    if (failure == 0 && facts.st_size > 0) {
      mapped.size_ = static_cast<std::size_t>(facts.st_size);
      void* const start = ::mmap(nullptr, mapped.size_, PROT_READ | PROT_WRITE,
                                 MAP_PRIVATE | MAP_NORESERVE, file, 0);
      if (start == MAP_FAILED) {
        failure = errno;
      } else {
        mapped.start_ = static_cast<std::byte*>(start);
      }
    }
    ::close(file);
    if (failure != 0) return systemError(failure, path);
    return mapped;
  }

  PrivateFile() = default;
  ~PrivateFile() {
    if (start_ != nullptr) ::munmap(start_, size_);
  }
  PrivateFile(PrivateFile&& other) noexcept
      : start_(std::exchange(other.start_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  PrivateFile& operator=(PrivateFile&&) = delete;

  std::span<std::byte> bytes() { return {start_, start_ == nullptr ? 0 : size_}; }

 private:
  static Error systemError(int number, const std::filesystem::path& path) {
    return {number == ENOENT ? ErrorKind::not_found : ErrorKind::unreadable,
            std::string("cannot open the log: ") + std::strerror(number), path.string()};
  }

  std::byte* start_ = nullptr;
  std::size_t size_ = 0;
};

/// The failure of the data section's checksum, for when no other damage explains it.
std::optional<DamageSpan> dataSectionDamage(ByteView file) {
  if (file.size() < mcap::kFileEndBytes) return std::nullopt;
  const std::optional<mcap::Record> last = mcap::recordAt(file, file.size() - mcap::kFileEndBytes);
  mcap::Footer footer;
  if (!last || last->opcode != mcap::Opcode::footer || !mcap::parse(last->content, footer)) {
    return std::nullopt;
  }
  const std::uint64_t end = footer.summary_start == 0 ? last->offset : footer.summary_start;
  constexpr std::uint64_t kDataEndBytes = mcap::kPrefixBytes + mcap::kDataEndContentBytes;
  if (end < kDataEndBytes || end > last->offset) return std::nullopt;
  const std::optional<mcap::Record> record = mcap::recordAt(file, end - kDataEndBytes);
  mcap::DataEnd data_end;
  if (!record || record->opcode != mcap::Opcode::data_end ||
      !mcap::parse(record->content, data_end) || data_end.data_section_crc == 0) {
    return std::nullopt;
  }
  const ByteView data = file.first(static_cast<std::size_t>(record->offset));
  if (crc32(data) == data_end.data_section_crc) return std::nullopt;
  return DamageSpan{0, record->offset,
                    "the data section fails its checksum but no chunk does: something between "
                    "the chunks has changed",
                    std::nullopt};
}

/// rocinante.end repeats the id, should rocinante.session be lost.
Result<std::string> recoveredSessionId(LogReader& reader) {
  if (reader.summary().session_id.empty()) {
    for (const LogMetadata& record : reader.metadata()) {
      const auto id = record.entries.find(std::string(profile::kSessionIdKey));
      if (record.name == profile::kEnd && id != record.entries.end()) return id->second;
    }
  }
  return sessionIdOf(reader);
}

bool hasExtras(const LogReader& reader) {
  return !reader.attachments().empty() || !reader.losses().empty() ||
         std::ranges::any_of(reader.metadata(), [](const LogMetadata& record) {
           return record.name != profile::kSession && record.name != profile::kEnd;
         });
}

}  // namespace

Result<CopyReport> recoverBytes(ByteView bytes, std::string name, std::vector<Event> marks,
                                std::unique_ptr<ByteSink> sink, const LogWriterOptions& log,
                                const KeyframeOptions& keyframes, const CopyProgress& progress) {
  Result<LogReader> reader = LogReader::openBytes(bytes, name);
  if (!reader) return reader.error();
  const bool complete = reader->summary().complete;
  const Status known = knownFormat(*reader);
  const bool extras = hasExtras(*reader);
  const std::string end_reason = reader->summary().end_reason;
  const Result<std::string> session_id = recoveredSessionId(*reader);
  if (!session_id) return session_id.error();
  CopySource::Options options;
  options.marks = std::move(marks);
  Result<CopySource> source =
      CopySource::of(std::move(*reader), std::move(options), std::nullopt, progress);
  if (!source) return source.error();
  std::vector<CopySource> sources;
  sources.push_back(std::move(*source));
  Result<CopyReport> report =
      copyLogs(sources, std::move(sink), {log, keyframes, *session_id, sources.front().origin()},
               end_reason.empty() ? "rocinante log recover" : end_reason, progress);
  if (!report) return report;
  if (!known)
    report->notes.push_back(known.error().what + ": its contents may mean something else");
  if (report->counts.messages == 0 && !extras && !complete) {
    return Error{ErrorKind::damaged, "nothing in the log can be read", name};
  }
  if (report->gaps.empty()) {
    if (std::optional<DamageSpan> damage = dataSectionDamage(bytes)) {
      report->gaps.push_back({name, std::move(*damage), true});
    }
  }
  return report;
}

Result<CopyReport> recoverLog(const std::filesystem::path& log, const MakeOptions& make) {
  if (Status free = checkOutput(make.output, make.overwrite, {{log}}); !free) return free.error();
  Result<PrivateFile> file = PrivateFile::open(log);
  if (!file) return file.error();
  const std::span<std::byte> bytes = file->bytes();
  const ByteView magic = mcap::magic();
  // The first eight bytes are the same in every log, so overwriting them loses nothing.
  const bool begins_wrongly =
      bytes.size() > magic.size() && !std::ranges::equal(bytes.first(magic.size()), magic);
  if (begins_wrongly) std::ranges::copy(magic, bytes.begin());
  Result<std::vector<Event>> marks = readMarks(log);
  std::optional<std::string> marks_lost;
  if (!marks) {
    marks_lost = "the marks beside the log are left out: " + marks.error().text();
    marks = std::vector<Event>{};
  }
  Result<OutputFile> output = OutputFile::create(make.output, make.overwrite, {{log}});
  if (!output) return output.error();
  Result<CopyReport> report =
      recoverBytes(bytes, log.string(), std::move(*marks), output->takeSink(), make.log,
                   make.keyframes, make.progress);
  if (!report) return output->named(report.error());
  if (begins_wrongly) {
    report->gaps.insert(
        report->gaps.begin(),
        {log.string(),
         {0, magic.size(), "the file does not start with the MCAP magic", std::uint64_t{0}},
         false});
  }
  if (marks_lost) report->notes.push_back(*marks_lost);
  if (Status named = output->commit(); !named) return named.error();
  return report;
}

}  // namespace rocinante
