#include <fmt/format.h>

#include <set>

#include "core/base/plain_text.h"
#include "core/log/log_profile.h"
#include "recorder/contents/attachments.h"

namespace rocinante {
namespace {

constexpr std::string_view kReason = "rocinante log attach";

/// Attachments of the log that are not copied because new ones replace them.
class Replaced {
 public:
  explicit Replaced(const AttachOptions& attach) : new_cell_(attach.cell != nullptr) {
    for (const NewAttachment& each : attach.files) names_.insert(each.name);
  }

  bool has(const LogAttachment& attachment) const {
    const bool of_cell = attachment.name == profile::kCellManifest ||
                         attachment.name.starts_with(profile::kCellFolder);
    return names_.contains(attachment.name) || (new_cell_ && of_cell);
  }
  bool has(const LogMetadata& record) const { return new_cell_ && record.name == profile::kCell; }

 private:
  std::set<std::string, std::less<>> names_;
  bool new_cell_;
};

Status checkNames(const LogReader& reader, const AttachOptions& attach) {
  std::set<std::string_view> names;
  for (const NewAttachment& each : attach.files) {
    if (each.name == profile::kCellManifest || each.name.starts_with(profile::kCellFolder)) {
      return Error{ErrorKind::bad_argument,
                   "this name is reserved for the log's cell; choose another with --name",
                   each.name};
    }
    if (!names.insert(each.name).second) {
      return Error{ErrorKind::bad_argument, "two files would be attached with the same name",
                   each.name};
    }
  }
  if (attach.replace) return {};
  const Replaced replaced(attach);
  for (const LogAttachment& each : reader.attachments()) {
    if (!replaced.has(each)) continue;
    const bool is_file = names.contains(each.name);
    return Error{
        ErrorKind::refused,
        is_file ? fmt::format("the log already has an attachment \"{}\"; --replace replaces it",
                              plainText(each.name))
                : std::string("the log already carries a cell; --replace replaces it"),
        reader.name()};
  }
  return {};
}

Status addOld(const LogReader& reader, const Replaced& replaced, PieceWriter& piece,
              CopyReport& report) {
  for (const LogMetadata& record : reader.metadata()) {
    if (record.name == profile::kSession || record.name == profile::kEnd || replaced.has(record)) {
      continue;
    }
    if (Status added = piece.addMetadata(record); !added) return added;
  }
  for (std::size_t i = 0; i < reader.attachments().size(); ++i) {
    if (replaced.has(reader.attachments()[i])) continue;
    const auto data = reader.readAttachment(i);
    if (!data.ok()) {
      report.gaps.push_back({reader.name(), {0, 0, data.error().text(), std::uint64_t{0}}, true});
      continue;
    }
    if (Status added = piece.addAttachment(reader.attachments()[i], *data); !added) return added;
  }
  return {};
}

Status addNew(const AttachOptions& attach, PieceWriter& piece) {
  const auto add = [&](const std::string& name, const std::string& media_type, ByteView data) {
    return piece.addAttachment({name, media_type, LogTime{}, data.size()}, data);
  };
  for (const NewAttachment& each : attach.files) {
    if (Status added = add(each.name, each.media_type, each.data); !added) return added;
  }
  if (attach.cell == nullptr) return {};
  const AttachedBundle cell(*attach.cell);
  for (const BundleAttachment& each : cell.attachments()) {
    if (Status added = add(each.name, each.media_type, each.data); !added) return added;
  }
  return piece.addMetadata(cell.metadata());
}

Status copyItems(CopySource& source, PieceWriter& piece, const CopySpan& span,
                 const CopyProgress& progress) {
  for (std::uint64_t count = 1;; ++count) {
    const auto item = source.peek();
    if (!item.ok()) return item.error();
    if (*item == nullptr) return {};
    if (progress && count % kProgressItems == 0) {
      if (Status on = progress(span.partAt((*item)->time)); !on) return on;
    }
    if (Status added = piece.add(**item); !added) return added;
    source.pop();
  }
}

}  // namespace

Result<CopyReport> attachToLog(const std::filesystem::path& log, const AttachOptions& attach,
                               const MakeOptions& make) {
  if (Status free = checkOutput(make.output, make.overwrite, {{log}}); !free) return free.error();
  Result<OpenedLog> opened = openForCopy(log);
  if (!opened) return opened.error();
  if (Status sound = checkNames(opened->reader, attach); !sound) return sound.error();
  const Result<std::string> session_id = sessionIdOf(opened->reader);
  if (!session_id) return session_id.error();

  std::vector<CopySource> sources;
  Result<CopySource> source =
      CopySource::of(std::move(opened->reader), std::move(opened->options), std::nullopt, {});
  if (!source) return source.error();
  sources.push_back(std::move(*source));
  Result<OutputFile> output = OutputFile::create(make.output, make.overwrite, {{log}});
  if (!output) return output.error();
  CopyReport report;
  report.session_id = *session_id;
  report.origin = sources.front().origin();
  Result<PieceWriter> piece = PieceWriter::start(
      output->takeSink(), {make.log, make.keyframes, report.session_id, report.origin});
  if (!piece) return output->named(piece.error());
  Status done = addOld(sources.front().reader(), Replaced(attach), *piece, report);
  if (done) done = addNew(attach, *piece);
  if (done) done = copyItems(sources.front(), *piece, CopySpan(sources), make.progress);
  if (done) done = piece->finish(std::string(kReason));
  if (done) done = output->commit();
  if (!done) return output->named(done.error());
  report.counts = piece->counts();
  addGaps(sources, report);
  return report;
}

}  // namespace rocinante
