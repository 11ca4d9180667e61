#include "core/copy/log_split.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <functional>

#include "core/base/pattern.h"
#include "core/base/unfinished_path.h"
#include "core/copy/copy_merge.h"
#include "core/copy/log_preceding.h"
#include "core/recording/record_path.h"
#include "core/recording/seam.h"

namespace rocinante {
namespace {

constexpr const char* kReason = "rocinante log split";

/// Chunks to aim for in a piece, so that pieces come close to their size.
constexpr std::uint64_t kChunksInPiece = 16;
constexpr std::uint64_t kLeastChunkBytes = 4096;

/// A piece may repeat at most 1/kRepeatedPart of its size.
constexpr std::uint64_t kRepeatedPart = 2;
/// For restatements in progress, at most 1/kLeadPart.
constexpr std::uint64_t kLeadPart = 4;
/// Pieces by time or event may repeat restatements up to their own content plus this.
constexpr std::uint64_t kMaxLeadBeyond = std::uint64_t{16} << 20U;

/// Decides for each item whether it begins a piece.
class Boundaries {
 public:
  Boundaries(const SplitOptions& split, LogTime origin, const std::vector<Event>& events)
      : split_(split), origin_(origin) {
    for (const Event& event : events) {
      if (patternMatches(split.event, event.text) &&
          (moments_.empty() || moments_.back() < event.time)) {
        moments_.push_back(event.time);
      }
    }
  }

  bool hasEvents() const { return !moments_.empty(); }

  /// If the item begins a new piece, the start of that piece. `last` is the time of the previous
  /// item.
  std::optional<LogTime> before(const CopyItem& item, LogTime last, const PieceWriter& piece) {
    // A loss counts at the end of its span, which still belongs to the previous piece.
    const bool loss = item.kind == CopyItem::Kind::loss;
    const LogTime time = loss ? item.time - Nanoseconds(1) : item.time;
    if (split_.size_bytes > 0) {
      const bool full = !loss && piece.counts().messages > 0 && time > last &&
                        piece.bytesSoFar() + item.message.payload.size() > split_.size_bytes;
      return full ? std::optional(time) : std::nullopt;
    }
    if (split_.time > Nanoseconds(0)) {
      const LogTime begin = intervalBegin(time, origin_, split_.time);
      const bool first = cell_ == LogTime::max();
      const bool later = !first && begin > cell_;
      if (first || later) cell_ = begin;
      return later ? std::optional(begin) : std::nullopt;
    }
    std::optional<LogTime> begin;
    while (next_moment_ < moments_.size() && moments_[next_moment_] <= time) {
      begin = moments_[next_moment_++];
    }
    return begin;
  }

 private:
  const SplitOptions& split_;
  LogTime origin_;
  LogTime cell_ = LogTime::max();  ///< start of the last item's interval; max: none yet
  std::vector<LogTime> moments_;
  std::size_t next_moment_ = 0;
};

class Split {
 public:
  Split(std::filesystem::path log, const SplitOptions& split, const MakeOptions& make,
        CopySource source, std::string session_id)
      : log_(std::move(log)), split_(split), make_(make) {
    sources_.push_back(std::move(source));
    options_.log = make.log;
    options_.keyframes = make.keyframes;
    options_.session_id = std::move(session_id);
    options_.origin = sources_.front().origin();
    if (split.size_bytes > 0) {
      const std::uint64_t wanted =
          std::max<std::uint64_t>(split.size_bytes / kChunksInPiece, kLeastChunkBytes);
      options_.log.chunk_bytes =
          std::min(options_.log.chunk_bytes, static_cast<std::size_t>(wanted));
    }
    report_.whole.session_id = options_.session_id;
    report_.whole.origin = options_.origin;
  }

  Result<SplitReport> run(const std::vector<Event>& events) {
    Boundaries boundaries(split_, options_.origin.value_or(LogTime{}), events);
    if (!split_.event.empty() && !boundaries.hasEvents()) {
      return Error{ErrorKind::not_found, "no event matches", split_.event};
    }
    if (Status begun = beginPiece(); !begun) return begun.error();
    if (Status bounded = boundRepeated(); !bounded) return bounded.error();
    const CopySpan span(sources_);
    CopyMerge merge(sources_);
    LogTime last = LogTime::min();
    for (std::uint64_t count = 1;; ++count) {
      const Result<const CopyItem*> next = merge.next();
      if (!next) return next.error();
      if (*next == nullptr) break;
      const CopyItem& item = **next;
      if (make_.progress && count % kProgressItems == 0) {
        if (Status on = make_.progress(span.partAt(item.time)); !on) return on.error();
      }
      if (item.kind != CopyItem::Kind::opening) {
        if (const std::optional<LogTime> moment = boundaries.before(item, last, *piece_)) {
          // A boundary before the first item separates nothing.
          if (last != LogTime::min()) {
            if (Status on = nextPiece(*moment); !on) return on.error();
          }
        }
        last = item.time;
      }
      if (Status added = piece_->add(item); !added) return outputs_.back().named(added.error());
      copied_bytes_ += item.message.payload.size();
      open_bytes_ += item.message.payload.size();
      if (!piece_->state().restatementOpen(item.time)) open_bytes_ = 0;
    }
    if (Status ended = endPiece(); !ended) return ended.error();
    addGaps(sources_, report_.whole);
    tellCuts();
    if (Status named = commit(); !named) return named.error();
    return std::move(report_);
  }

 private:
  Status beginPiece() {
    const std::string name = pieceName(make_.output, log_, outputs_.size() + 1);
    Result<OutputFile> output = OutputFile::create(name, make_.overwrite, {{log_}});
    if (!output) return output.error();
    outputs_.push_back(std::move(*output));
    Result<PieceWriter> piece = PieceWriter::start(outputs_.back().takeSink(), options_);
    if (!piece) return outputs_.back().named(piece.error());
    piece_.emplace(std::move(*piece));
    const bool first = outputs_.size() == 1;
    // Unreadable ones are reported once.
    std::vector<CopyGap> again;
    Status copied =
        copyExtras(sources_, *piece_, make_.attachments && (first || !split_.attach_once),
                   first ? report_.whole.gaps : again);
    if (!copied) return outputs_.back().named(copied.error());
    return {};
  }

  Status nextPiece(LogTime moment) {
    Preceding preceding;
    preceding.state = piece_->state();
    preceding.moment = moment;
    if (preceding.state.restatementOpen(moment)) {
      Result<Preceding> found = precedingWithin(leadRoom(), moment);
      if (!found) return found.error();
      if (found->restatement_cut) {
        cut_pieces_.push_back(outputs_.size() + 1);
      } else {
        preceding = std::move(*found);
      }
    }
    if (Status ended = endPiece(); !ended) return ended;
    if (Status begun = beginPiece(); !begun) return begun;
    Status added = piece_->begin(preceding.state, preceding.moment);
    if (added && preceding.lead) added = addLead(*preceding.lead, moment);
    if (!added) return outputs_.back().named(added.error());
    return boundRepeated();
  }

  /// Payload bytes that a piece may repeat to finish a restatement. Where restatements overlap
  /// without end, each piece would repeat everything before it.
  std::uint64_t leadRoom() const {
    if (split_.size_bytes > 0) return split_.size_bytes / kLeadPart;
    const std::uint64_t most = copied_bytes_ + kMaxLeadBeyond;
    return most > lead_bytes_ ? most - lead_bytes_ : 0;
  }

  Result<Preceding> precedingWithin(std::uint64_t room, LogTime moment) const {
    Preceding cut;
    cut.restatement_cut = true;
    if (open_bytes_ > room) return cut;
    Result<Preceding> found = precedingOf(log_, moment);
    if (!found || !found->lead) return found;
    std::uint64_t bytes = 0;
    Status read = eachOfLead(*found->lead, moment, [&](const LogMessage& message) -> Status {
      bytes += message.payload.size();
      return {};
    });
    if (!read) return read.error();
    if (bytes > room) return cut;
    return found;
  }

  /// Refuses a piece that repeats more than it adds: the pieces would all be nearly the same.
  Status boundRepeated() const {
    const bool carries = make_.attachments && piece_->counts().attachments > 0;
    const std::uint64_t repeated = piece_->bytesSoFar();
    const bool once = split_.attach_once && carries;
    if (split_.size_bytes == 0 || once || repeated <= split_.size_bytes / kRepeatedPart) return {};
    // Rounded up, with room for chunk overhead, which grows with the size.
    const std::uint64_t wanted = repeated * (kRepeatedPart + 1) / 1000 + 1;
    return Error{
        ErrorKind::refused,
        fmt::format("a piece repeats what it needs to stand alone, {} bytes where piece {} begins: "
                    "--size must be at least {}kB{}",
                    repeated, outputs_.size(), wanted,
                    carries ? "; --attach-once puts the attachments into the first only" : ""),
        log_.string()};
  }

  /// Calls back for each folded message after a place and before a time.
  Status eachOfLead(LogPosition behind, LogTime until,
                    const std::function<Status(const LogMessage&)>& take) const {
    Result<LogReader> reader = LogReader::open(log_);
    if (!reader) return reader.error();
    if (Status there = reader->seek(behind.time); !there) return there;
    while (true) {
      const Result<std::optional<LogMessage>> message = reader->next();
      if (!message) return message.error();
      if (!*message || (*message)->log_time >= until) return {};
      if ((*message)->place() <= behind || !(*message)->channel->folded()) continue;
      if (Status taken = take(**message); !taken) return taken;
    }
  }

  Status addLead(LogPosition behind, LogTime until) {
    Status added = eachOfLead(behind, until, [&](const LogMessage& message) {
      CopyItem item;
      item.kind = CopyItem::Kind::lead;
      item.time = message.log_time;
      item.publish_time_ns = message.publish_time_ns;
      item.message = message;
      lead_bytes_ += message.payload.size();
      return piece_->add(item);
    });
    // Its channels went with the reader.
    piece_->forgetInputs();
    return added;
  }

  /// Notes the cut restatements: the first ones one by one, the rest as a count.
  void tellCuts() {
    constexpr std::size_t kNamed = 10;
    for (std::size_t i = 0; i < std::min(cut_pieces_.size(), kNamed); ++i) {
      report_.whole.notes.push_back(fmt::format(
          "a restatement in progress at the start of piece {} was cut off", cut_pieces_[i]));
    }
    if (cut_pieces_.size() > kNamed) {
      report_.whole.notes.push_back(
          fmt::format("and so were those at the start of {} further pieces, up to piece {}",
                      cut_pieces_.size() - kNamed, cut_pieces_.back()));
    }
  }

  Status endPiece() {
    if (Status closed = piece_->finish(kReason); !closed) {
      return outputs_.back().named(closed.error());
    }
    const PieceCounts& counts = piece_->counts();
    report_.pieces.push_back({outputs_.back().path(), counts});
    PieceCounts& sum = report_.whole.counts;
    if (sum.messages == 0) sum.start = counts.start;
    if (counts.messages > 0) sum.end = counts.end;
    sum.messages += counts.messages;
    sum.bytes += counts.bytes;
    return {};
  }

  Status commit() {
    const EndingHeld held;
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      Status named = outputs_[i].commit();
      if (named) continue;
      for (std::size_t j = 0; j < i; ++j) ::unlink(outputs_[j].path().c_str());
      return named;
    }
    return {};
  }

  std::filesystem::path log_;
  const SplitOptions& split_;
  const MakeOptions& make_;
  PieceOptions options_;
  std::vector<CopySource> sources_;
  std::vector<OutputFile> outputs_;
  std::optional<PieceWriter> piece_;
  SplitReport report_;
  std::uint64_t copied_bytes_ = 0;       ///< payload bytes that a piece holds as its own
  std::uint64_t lead_bytes_ = 0;         ///< payload bytes repeated to finish a restatement
  std::uint64_t open_bytes_ = 0;         ///< payload bytes since no restatement was open, at least
  std::vector<std::size_t> cut_pieces_;  ///< from 1; a restatement was cut off at their beginning
};

/// True if the pattern names a folder: an existing one, or a name that no file would have.
bool namesFolder(const std::string& pattern) {
  std::error_code ignored;
  return pattern.ends_with('/') || std::filesystem::is_directory(pattern, ignored) ||
         (pattern.find("%n") == std::string::npos &&
          !std::filesystem::path(pattern).has_extension());
}

/// Creates the pieces' folder if it is missing. It is removed again if it is empty and was not
/// kept.
Result<UnfinishedPath> makeFolder(const std::filesystem::path& path) {
  std::error_code fault;
  if (std::filesystem::create_directory(path, fault)) return UnfinishedPath(path);
  if (!fault) return UnfinishedPath();
  return Error{ErrorKind::unreadable, "cannot make the folder: " + fault.message(), path.string()};
}

}  // namespace

std::string pieceName(const std::string& pattern, const std::filesystem::path& log,
                      std::uint64_t number) {
  if (namesFolder(pattern)) {
    return numberedPath(std::filesystem::path(pattern) / (log.stem().string() + ".mcap"), number)
        .string();
  }
  std::string name;
  bool numbered = false;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] != '%' || i + 1 == pattern.size()) {
      name += pattern[i];
    } else if (pattern[i + 1] == 'n' || pattern[i + 1] == '%') {
      numbered = numbered || pattern[i + 1] == 'n';
      name += pattern[++i] == 'n' ? fmt::format("{:03}", number) : "%";
    } else {
      name += '%';
    }
  }
  return numbered ? name : numberedPath(name, number).string();
}

Result<SplitReport> splitLog(const std::filesystem::path& log, const SplitOptions& split,
                             const MakeOptions& make) {
  const std::filesystem::path first = pieceName(make.output, log, 1);
  if (Status free = checkOutput(first, make.overwrite, {{log}}); !free) return free.error();
  Result<OpenedLog> opened = openForCopy(log);
  if (!opened) return opened.error();
  StateDamage hiding;
  const Result<std::vector<Event>> events = eventsOf(log, !split.event.empty(), hiding);
  if (!events) return events.error();
  Result<std::string> session_id = sessionIdOf(opened->reader);
  if (!session_id) return session_id.error();
  Result<CopySource> source = CopySource::of(std::move(opened->reader), std::move(opened->options),
                                             std::nullopt, make.progress);
  if (!source) return source.error();
  UnfinishedPath folder;
  if (namesFolder(make.output.string())) {
    Result<UnfinishedPath> made = makeFolder(first.parent_path());
    if (!made) return made.error();
    folder = std::move(*made);
  }
  Result<SplitReport> report =
      Split(log, split, make, std::move(*source), std::move(*session_id)).run(*events);
  if (report) folder.keep();
  if (report && !hiding.empty()) {
    report->whole.notes.push_back("another matching event may be missing: " + hiding.text());
  }
  return report;
}

}  // namespace rocinante
