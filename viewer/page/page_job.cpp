#include "viewer/page/page_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/figure_text.h"
#include "core/bundle/cell_or_log.h"
#include "core/cell/cell.h"
#include "core/check/check.h"
#include "core/log/log_reader.h"
#include "core/report/account.h"
#include "core/session/timeline.h"
#include "viewer/page/page_file.h"
#include "viewer/page/page_layout.h"
#include "viewer/page/page_parts.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

/// Reads every message once, so that damage is known before the page is given away.
Status readWhole(const Bytes& bytes, const std::string& name, PageReport& report) {
  auto reader = LogReader::openBytes(bytes, name);
  if (!reader) return reader.error();
  if (reader->summary().messages == 0) {
    return Error{ErrorKind::unsupported, "the log has no messages: a page would show nothing",
                 name};
  }
  while (true) {
    const auto message = reader->next();
    if (!message) return message.error();
    if (!*message) break;
  }
  if (reader->damage().empty()) return {};
  report.is_whole = false;
  report.warnings.push_back(
      fmt::format("the log is damaged in {} place{}; the page says so where it matters ({})",
                  reader->damage().size(), reader->damage().size() == 1 ? "" : "s", name));
  return {};
}

/// What of a log no span makes smaller.
std::string attachedText(const Bytes& bytes) {
  const auto reader = LogReader::openBytes(bytes, "the page's log");
  std::uint64_t attached = 0;
  if (reader) {
    for (const LogAttachment& each : reader->attachments()) attached += each.data_bytes;
  }
  if (attached < bytes.size() / 10) return {};
  return fmt::format(
      ", of them {} attachments, which `rocinante log cut --no-attachments` leaves "
      "out",
      sizeText(attached));
}

void noteFaults(const Cell& cell, PageReport& report) {
  for (const Finding& fault : cell.faults) {
    report.warnings.push_back(sentenceOf(fault) +
                              (fault.file.empty() ? "" : " (" + fault.file + ")"));
    if (fault.severity == Severity::error) report.is_whole = false;
  }
}

/// What `check` says about the session, by the rules of the cell.
Result<std::string> judged(const Cell& cell, const Bytes& bytes, const std::string& name,
                           PageReport& report) {
  auto reader = LogReader::openBytes(bytes, name);
  if (!reader) return reader.error();
  const auto found = checkLog(cell, *reader);
  if (!found) return found.error();
  for (const Finding& finding : found->findings) {
    if (finding.accepted) continue;
    ++report.findings;
    if (finding.severity == Severity::error) ++report.errors;
  }
  return pageFindings(*found);
}

/// So that a page need not read all of a long log for them. Marks beside the file stay there.
Result<std::string> eventsOf(const Bytes& bytes) {
  auto reader = LogReader::openBytes(bytes, "the page's log");
  if (!reader) return reader.error();
  Timeline session = Timeline::of(std::move(*reader));
  StateDamage damage;
  const auto events = session.events(&damage);
  if (!events) return events.error();
  return pageEvents(**events, session.origin());
}

/// What the page begins with.
Status takeLayout(const ViewLayout& layout, const Cell& cell, PageParts& parts,
                  PageReport& report) {
  auto reader = LogReader::openBytes(parts.log, "the page's log");
  if (!reader) return reader.error();
  auto made = pageLayout(layout, cell, std::move(*reader));
  if (!made) return made.error();
  parts.layout = std::move(made->json);
  parts.is_light = layout.is_light;
  report.layout_left_out = std::move(made->left_out);
  return {};
}

}  // namespace

Result<MadePage> pageFor(const PageJob& job) {
  MadePage made;
  PageReport& report = made.report;
  PageParts parts;
  std::optional<ViewLayout> layout;
  if (!job.layout.empty()) {
    auto loaded = ViewLayout::load(job.layout);
    if (!loaded) return loaded.error();
    layout = std::move(*loaded);
  }
  auto log = carriedLog(job, report);
  if (!log) return log.error();
  if (!isLog(job.log)) {
    return Error{ErrorKind::unsupported,
                 "is not a log; `rocinante log import` makes one of a bag, capture or table",
                 job.log.string()};
  }
  parts.log = std::move(*log);
  if (Status read = readWhole(parts.log, job.log.string(), report); !read) return read.error();
  if (Status has = readPageViewer(job.viewer, parts); !has) return has.error();
  CellOptions options;
  static_cast<ModelSearch&>(options) = job;
  options.parallel = job.parallel;
  auto cell = loadCellOrLog(job.cell.empty() ? job.log : job.cell, options);
  if (!cell && job.cell.empty() && cell.error().kind == ErrorKind::not_found) {
    return Error{ErrorKind::not_found, "the log carries no cell: name one before it",
                 job.log.string()};
  }
  if (!cell) return cell.error();
  auto held = LogReader::openBytes(parts.log, job.log.string());
  if (!held) return held.error();
  Timeline session = Timeline::of(std::move(*held));
  report.account = logAccount(session, &*cell);
  noteFaults(*cell, report);
  auto findings = judged(*cell, parts.log, job.log.string(), report);
  if (!findings) return findings.error();
  parts.findings = std::move(*findings);
  auto events = eventsOf(parts.log);
  if (!events) return events.error();
  parts.events = std::move(*events);
  if (layout) {
    if (Status taken = takeLayout(*layout, *cell, parts, report); !taken) return taken.error();
  }
  parts.cell = pageCell(*cell, {}, job.parallel);
  parts.title = job.log.filename().string();
  std::string& page = made.html;
  page = pageOf(parts);
  if (page.size() > job.most_bytes && job.thin) page = thinPage(*cell, job, page.size(), parts);
  report.left_out = parts.left_out;
  report.page_bytes = page.size();
  report.log_bytes = parts.log.size();
  report.cell_bytes = parts.cell.size();
  report.viewer_bytes = parts.viewer.size();
  if (page.size() > job.most_bytes) {
    return Error{
        ErrorKind::unsupported,
        fmt::format("the page would have {}, more than --size {}; the log alone has {}{}: "
                    "make a page of a part with --from and --until{}, or allow more",
                    sizeText(page.size()), sizeText(job.most_bytes), sizeText(parts.log.size()),
                    attachedText(parts.log), job.thin ? "" : ", of a smaller cell with --thin"),
        job.output.string()};
  }
  return made;
}

Result<PageReport> makePage(const PageJob& job) {
  if (Status may = mayWriteFile(job.output, job.overwrite); !may) return may.error();
  auto made = pageFor(job);
  if (!made) return made.error();
  Status written = writeFileWhole(job.output, bytesOf(made->html), job.overwrite);
  if (!written) return written.error();
  return std::move(made->report);
}

Result<std::uint64_t> extractLog(const fs::path& page, const fs::path& output, bool overwrite) {
  if (Status may = mayWriteFile(output, overwrite); !may) return may.error();
  const auto text = readFile(page, kMostPageBytes);
  if (!text) return text.error();
  const auto log = logOfPage(*text, page.string());
  if (!log) return log.error();
  if (Status written = writeFileWhole(output, *log, overwrite); !written) return written.error();
  return log->size();
}

}  // namespace rocinante
