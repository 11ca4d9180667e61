#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/check/reports/report_formats.h"
#include "core/check/reports/time_strip.h"
#include "core/check/rules/without_cell.h"
#include "core/report/account.h"

namespace rocinante {
namespace {

constexpr std::size_t kWidestStrip = 64;

std::string plural(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// To the millisecond: more digits only make a report hard to read.
std::string rounded(Nanoseconds duration) {
  return secondsText(std::chrono::round<std::chrono::milliseconds>(duration), 3);
}

bool beginsCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

/// Writes paragraphs wrapped at the style's width.
class TextWriter {
 public:
  explicit TextWriter(const TextStyle& style) : style_(style) {}

  /// `color`: an SGR parameter, empty for none.
  void line(std::size_t indent, std::string_view what, std::string_view color = "") {
    // Names and examples are a sender's bytes: none of them may move the cursor.
    const std::string safe = plainText(what);
    std::string_view text = safe;
    const std::string start = paint(color), end = color.empty() ? "" : paint("0");
    for (const std::size_t next = indent + 2;; indent = next) {
      const std::size_t bytes = fitting(text, indent);
      text_ += std::string(indent, ' ') + start + std::string(text.substr(0, bytes)) + end + "\n";
      text.remove_prefix(bytes);
      while (text.starts_with(' ')) text.remove_prefix(1);
      if (text.empty()) return;
    }
  }
  void emptyLine() { text_ += "\n"; }
  std::string take() { return std::move(text_); }

 private:
  std::string paint(std::string_view color) const {
    return style_.color && !color.empty() ? fmt::format("\033[{}m", color) : "";
  }

  /// Bytes of `text` that fit on a line: up to a space where there is one.
  std::size_t fitting(std::string_view text, std::size_t indent) const {
    if (style_.columns <= indent + 20) return text.size();
    const std::size_t most = style_.columns - indent;
    std::size_t places = 0, space = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (!beginsCharacter(text[i])) continue;
      if (places == most) return space > 0 ? space : i;
      if (text[i] == ' ') space = i;
      ++places;
    }
    return text.size();
  }

  const TextStyle& style_;
  std::string text_;
};

std::string_view colorOf(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "1;31";
    case Severity::warning:
      return "1;33";
    case Severity::note:
      return "1;36";
  }
  return "";
}

/// The findings of one severity, those of one subject together, in the order of the first of each.
std::vector<std::vector<const Finding*>> groupsOf(const CheckReport& report, Severity severity,
                                                  bool accepted) {
  std::vector<std::vector<const Finding*>> groups;
  std::map<std::string_view, std::size_t> group_of;
  for (const Finding& finding : report.findings) {
    if (finding.severity != severity || finding.accepted != accepted) continue;
    const auto [group, is_new] = finding.subject.empty()
                                     ? std::pair(group_of.end(), true)
                                     : group_of.try_emplace(finding.subject, groups.size());
    if (is_new) groups.emplace_back();
    (is_new ? groups.back() : groups[group->second]).push_back(&finding);
  }
  return groups;
}

class ReportText {
 public:
  ReportText(const CheckReport& report, const TextStyle& style)
      : report_(report), style_(style), out_(style) {}

  std::string text() {
    writeSentence();
    writeHead();
    if (style_.quiet) {
      writeCounts();
    } else {
      for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
        writeSeverity(severity);
      }
      writeClearances();
      writeAccepted();
      writeBaselineHint();
    }
    out_.emptyLine();
    out_.line(0, verdictText(report_.verdict), verdictColor());
    return out_.take();
  }

 private:
  std::string_view verdictColor() const {
    return report_.verdict == CheckVerdict::compatible ? "1;32" : "1;31";
  }

  /// On a terminal the verdict stands above what it is about, too: below, a long report has it
  /// beside the prompt.
  void writeSentence() {
    if (style_.columns == 0 || style_.quiet || report_.findings.empty()) return;
    const std::string counts = countsText();
    out_.line(0, verdictText(report_.verdict) + (counts.empty() ? "" : " (" + counts + ")"),
              verdictColor());
  }

  void writeHead() {
    std::string head = report_.cell;
    if (!report_.session.empty()) {
      head += fmt::format("{}{}: {} of {}, over {} s", report_.has_cell ? " and " : "",
                          report_.session, plural(report_.packets, "packet"),
                          plural(report_.sources.size(), "source"), rounded(report_.duration));
      if (report_.datagrams > report_.packets) {
        head += fmt::format("; {} not decoded",
                            plural(report_.datagrams - report_.packets, "datagram"));
      }
    }
    out_.line(0, head, "1");
    if (!report_.has_cell) out_.line(0, withoutCellSentence());
  }

  void writeCounts() {
    if (const std::string counts = countsText(); !counts.empty()) out_.line(0, counts);
  }

  std::string countsText() const {
    std::string counts;
    for (const Severity severity : {Severity::error, Severity::warning, Severity::note}) {
      const std::size_t count = report_.countOf(severity);
      if (count > 0) counts += (counts.empty() ? "" : ", ") + plural(count, nameOf(severity));
    }
    if (const std::size_t accepted = report_.countOfAccepted(); accepted > 0) {
      counts += fmt::format("{}{} accepted", counts.empty() ? "" : ", ", accepted);
    }
    return counts;
  }

  void writeSeverity(Severity severity) {
    const std::size_t count = report_.countOf(severity);
    if (count == 0) return;
    out_.emptyLine();
    out_.line(0, plural(count, nameOf(severity)), colorOf(severity));
    std::map<std::string_view, std::size_t> listed, left_out;
    std::map<std::string, Findings> accounts;  // by file: one sentence each
    for (const auto& group : groupsOf(report_, severity, false)) {
      std::vector<const Finding*> shown;
      for (const Finding* finding : group) {
        if (severity == Severity::note && finding->rule == "model.left-out") {
          accounts[finding->file].push_back(*finding);
          continue;
        }
        const bool is_room = style_.most_a_rule == 0 || listed[finding->rule] < style_.most_a_rule;
        ++(is_room ? listed : left_out)[finding->rule];
        if (is_room) shown.push_back(finding);
      }
      const bool has_heading = shown.size() > 1 && !shown.front()->subject.empty();
      if (has_heading) out_.line(2, shown.front()->subject + ":", "1");
      for (const Finding* finding : shown) write(*finding, has_heading ? 4 : 2);
    }
    for (const auto& [file, findings] : accounts) {
      out_.line(2,
                fmt::format("{}: {} [model.left-out]", file, accountSentence(accountOf(findings))));
    }
    for (const auto& [rule, more] : left_out) {
      out_.line(2, fmt::format("and {} more [{}]", more, rule));
    }
  }

  void write(const Finding& finding, std::size_t indent) {
    const std::string place = finding.place();
    out_.line(indent, fmt::format("{}{}{} [{}]", place, place.empty() ? "" : ": ",
                                  sentenceOf(finding), finding.rule));
    indent += 2;
    if (finding.first) out_.line(indent, whenText(report_, finding), "2");
    const std::size_t width = stripWidth(indent);
    const std::string strip = finding.count > 1 ? timeStrip(finding.when, report_.origin,
                                                            report_.duration, width, style_.unicode)
                                                : "";
    if (!strip.empty()) out_.line(indent, "|" + strip + "|", colorOf(finding.severity));
    if (!finding.example.empty()) out_.line(indent, "such as: " + finding.example);
    if (!finding.hint.empty()) out_.line(indent, "hint: " + finding.hint);
  }

  std::size_t stripWidth(std::size_t indent) const {
    if (style_.columns == 0) return kWidestStrip;
    return style_.columns <= indent + 22 ? 20 : std::min(kWidestStrip, style_.columns - indent - 2);
  }

  void writeClearances() {
    if (report_.clearances.empty()) return;
    out_.emptyLine();
    out_.line(0, "least distances", "1");
    std::size_t listed = 0;
    for (const CheckedClearance& checked : report_.clearances) {
      if (style_.most_a_rule > 0 && ++listed > style_.most_a_rule) {
        out_.line(2, fmt::format("and {} more", report_.clearances.size() - style_.most_a_rule));
        break;
      }
      const std::string figure = checked.least_m > 0
                                     ? fmt::format("{:.2f} mm", checked.least_m * 1e3)
                                     : std::string("penetrating");
      out_.line(2,
                fmt::format("{}: {} at {} s, {} to {}", checked.name, figure,
                            rounded(checked.at - report_.origin), checked.link_a, checked.link_b));
    }
  }

  void writeAccepted() {
    const std::size_t count = report_.countOfAccepted();
    if (count == 0) return;
    out_.emptyLine();
    out_.line(0, fmt::format("{} accepted by the baseline", count), "2");
    std::size_t listed = 0;
    for (const Finding& finding : report_.findings) {
      if (!finding.accepted) continue;
      if (style_.most_a_rule > 0 && ++listed > style_.most_a_rule) {
        out_.line(2, fmt::format("and {} more", count - style_.most_a_rule), "2");
        break;
      }
      out_.line(2, fmt::format("{} [{}]", sentenceOf(finding), finding.rule), "2");
    }
  }

  void writeBaselineHint() {
    if (!report_.has_baseline || report_.verdict != CheckVerdict::incompatible) return;
    out_.emptyLine();
    out_.line(0, "not in the baseline; --update-baseline accepts what is found now", "2");
  }

  const CheckReport& report_;
  const TextStyle& style_;
  TextWriter out_;
};

}  // namespace

std::string whenText(const CheckReport& report, const Finding& finding) {
  if (!finding.first) return "";
  const auto seconds = [&](LogTime time) { return rounded(time - report.origin) + " s"; };
  std::string text = plural(finding.count, "time");
  text += (finding.count == 1 ? " at " : ", first at ") + seconds(*finding.first);
  if (finding.packet) text += fmt::format(" (packet {})", *finding.packet);
  if (finding.count > 1 && finding.last) text += ", last at " + seconds(*finding.last);
  return text;
}

std::string verdictText(CheckVerdict verdict) {
  switch (verdict) {
    case CheckVerdict::compatible:
      return "compatible";
    case CheckVerdict::incompatible:
      return "incompatible";
    case CheckVerdict::nothing_judged:
      return "nothing judged: no packet could be decoded";
    case CheckVerdict::interrupted:
      return "interrupted: what was found so far is not all";
  }
  return "";
}

std::string checkText(const CheckReport& report, const TextStyle& style) {
  return ReportText(report, style).text();
}

}  // namespace rocinante
