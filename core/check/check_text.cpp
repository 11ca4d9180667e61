#include <fmt/format.h>

#include "core/check/finding.h"
#include "core/duration_text.h"

namespace rocinante {
namespace {

std::string plural(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// To the millisecond: finer digits only make a report hard to read.
std::string rounded(Nanoseconds duration) {
  return secondsText(std::chrono::round<std::chrono::milliseconds>(duration), 3);
}

std::string whenOf(const CheckReport& report, const Finding& finding) {
  const auto seconds = [&](LogTime time) { return rounded(time - report.origin) + " s"; };
  std::string text = plural(finding.count, "time");
  if (finding.count == 1) {
    text += " at " + seconds(*finding.first);
    if (finding.packet) text += fmt::format(" (packet {})", *finding.packet);
    return text;
  }
  text += ", first at " + seconds(*finding.first);
  if (finding.packet) text += fmt::format(" (packet {})", *finding.packet);
  return text + ", last at " + seconds(*finding.last);
}

void append(std::string& text, const CheckReport& report, const Finding& finding) {
  text += "  ";
  if (!finding.file.empty()) {
    text += finding.file;
    if (finding.line > 0) text += fmt::format(":{}", finding.line);
    if (finding.column > 0) text += fmt::format(":{}", finding.column);
    text += ": ";
  }
  text += fmt::format("{} [{}]\n", finding.text, finding.rule);
  if (finding.first) text += fmt::format("    {}\n", whenOf(report, finding));
  if (!finding.example.empty()) text += fmt::format("    such as: {}\n", finding.example);
  if (!finding.hint.empty()) text += fmt::format("    hint: {}\n", finding.hint);
}

}  // namespace

std::string checkText(const CheckReport& report) {
  std::string text = report.cell;
  if (!report.session.empty()) {
    text += fmt::format(" and {}: {} of {}, over {} s", report.session,
                        plural(report.packets, "packet"), plural(report.sources.size(), "source"),
                        rounded(report.duration));
    if (report.datagrams > report.packets) {
      text +=
          fmt::format("; {} not decoded", plural(report.datagrams - report.packets, "datagram"));
    }
  }
  text += "\n";
  for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
    const std::size_t count = report.countOf(severity);
    if (count == 0) continue;
    text += fmt::format("\n{}\n", plural(count, nameOf(severity)));
    for (const Finding& finding : report.findings) {
      if (finding.severity == severity) append(text, report, finding);
    }
  }
  text += "\n";
  switch (report.verdict) {
    case Verdict::compatible:
      return text + "compatible\n";
    case Verdict::incompatible:
      return text + "incompatible\n";
    case Verdict::nothing_judged:
      return text + "nothing judged: no packet could be decoded\n";
  }
  return text;
}

}  // namespace rocinante
