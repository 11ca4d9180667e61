#include "core/report/account.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/report/json_text.h"

namespace rocinante {

std::string LeftOut::text() const {
  std::string text = countText(count, kind);
  if (!name.empty()) text += fmt::format(" `{}`", name);
  if (first.empty() && reason.empty()) return text;
  const bool both = !first.empty() && !reason.empty();
  return text + fmt::format(" ({}{}{}{})", reason, both ? "; " : "",
                            first.empty() ? ""
                            : count > 1   ? "the first at "
                                          : "at ",
                            first);
}

void Account::leaveOut(LeftOut left_out) {
  total_ += left_out.count;
  const auto same = std::ranges::find_if(left_out_, [&](const LeftOut& one) {
    return one.name == left_out.name && one.kind == left_out.kind && one.reason == left_out.reason;
  });
  if (same != left_out_.end()) {
    same->count += left_out.count;
    same->severity = std::max(same->severity, left_out.severity);
  } else if (left_out_.size() < kMaxListed) {
    left_out_.push_back(std::move(left_out));
  } else {
    unlisted_ += left_out.count;
  }
}

void Account::add(const Account& other) {
  for (const LeftOut& one : other.left_out_) leaveOut(one);
  total_ += other.unlisted_;
  unlisted_ += other.unlisted_;
}

std::string sentenceOf(const Finding& finding) {
  if (finding.left_out.empty()) return finding.text;
  if (finding.count == 1) return fmt::format("{} is left out: {}", finding.left_out, finding.text);
  return fmt::format("{} is left out {} times: {}", finding.left_out, finding.count, finding.text);
}

Account accountOf(const Findings& findings) {
  Account account;
  for (const Finding& finding : findings) {
    if (finding.left_out.empty()) continue;
    // "element `pbr`": FaultList::leaveOut writes it.
    const std::size_t quote = finding.left_out.find(" `");
    LeftOut one{.kind = finding.left_out.substr(0, quote),
                .reason = finding.text,
                .first = finding.place(),
                .count = finding.count,
                .severity = finding.severity};
    if (quote != std::string::npos) {
      one.name = finding.left_out.substr(quote + 2, finding.left_out.size() - quote - 3);
    }
    account.leaveOut(std::move(one));
  }
  return account;
}

std::string accountSentence(const Account& account, std::size_t most_listed) {
  if (account.empty()) return {};
  const auto& all = account.leftOut();
  std::string sentence = "left out: ";
  std::uint64_t listed = 0;
  for (std::size_t i = 0; i < std::min(most_listed, all.size()); ++i) {
    if (i > 0) sentence += ", ";
    sentence += all[i].text();
    listed += all[i].count;
  }
  if (listed < account.total()) {
    sentence += fmt::format("{}{} more", listed > 0 ? ", and " : "",
                            countText(account.total() - listed, "thing"));
  }
  return sentence;
}

namespace {

constexpr std::size_t kFieldsOfLine = 6;

std::string oneField(std::string_view text) {
  std::string field(text);
  std::ranges::replace_if(
      field, [](char byte) { return byte == '\t' || byte == '\n'; }, ' ');
  return field;
}

}  // namespace

std::string accountLines(const Account& account) {
  std::string lines;
  for (const LeftOut& one : account.leftOut()) {
    lines +=
        fmt::format("{}\t{}\t{}\t{}\t{}\t{}\n", nameOf(one.severity), one.count, oneField(one.kind),
                    oneField(one.name), oneField(one.reason), oneField(one.first));
  }
  if (account.unlisted() > 0) {
    lines += fmt::format("note\t{}\tthing\t\tof further kinds\t\n", account.unlisted());
  }
  return lines;
}

Account accountOfLines(std::string_view lines) {
  Account account;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    std::string_view line = lines.substr(0, end);
    lines.remove_prefix(std::min(end + 1, lines.size()));
    std::array<std::string, kFieldsOfLine> fields;
    std::size_t count = 0;
    for (; count < fields.size(); ++count) {
      const std::size_t tab = line.find('\t');
      fields[count] = plainText(line.substr(0, tab));
      if (tab == line.npos) break;
      line.remove_prefix(tab + 1);
    }
    LeftOut one;
    const char* const number_end = fields[1].data() + fields[1].size();
    const auto read = std::from_chars(fields[1].data(), number_end, one.count);
    if (count + 1 != fields.size() || read.ptr != number_end || read.ec != std::errc() ||
        one.count == 0 || fields[2].empty()) {
      continue;
    }
    one.severity = fields[0] == nameOf(Severity::note) ? Severity::note : Severity::warning;
    one.kind = std::move(fields[2]);
    one.name = std::move(fields[3]);
    one.reason = std::move(fields[4]);
    one.first = std::move(fields[5]);
    account.leaveOut(std::move(one));
  }
  return account;
}

std::string accountBrief(const Account& account, std::size_t most_listed) {
  if (account.empty()) return {};
  const auto& all = account.leftOut();
  std::string brief;
  std::uint64_t listed = 0;
  for (std::size_t i = 0; i < std::min(most_listed, all.size()); ++i) {
    if (i > 0) brief += ", ";
    brief += all[i].name.empty() ? countText(all[i].count, all[i].kind)
                                 : fmt::format("{} `{}`", all[i].count, all[i].name);
    listed += all[i].count;
  }
  if (listed < account.total()) {
    brief += fmt::format(" and {} more", countText(account.total() - listed, "thing"));
  }
  return brief + (account.total() == 1 ? " is left out" : " are left out");
}

Json leftOutJson(const Account& account) {
  Json items = Json::array();
  for (const LeftOut& one : account.leftOut()) {
    items.push_back({{"kind", one.kind},
                     {"name", orNull(one.name)},
                     {"reason", orNull(one.reason)},
                     {"first", orNull(one.first)},
                     {"count", one.count},
                     {"severity", nameOf(one.severity)}});
  }
  return {
      {"total", account.total()}, {"unlisted", account.unlisted()}, {"items", std::move(items)}};
}

}  // namespace rocinante
