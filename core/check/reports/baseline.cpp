#include "core/check/reports/baseline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "core/base/atomic_file.h"
#include "core/base/figure_text.h"
#include "core/base/json_parse.h"
#include "core/base/plain_text.h"

namespace rocinante {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kStale = "baseline.stale";
constexpr std::string_view kUnvalued = "baseline.unvalued";
constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20U;

/// Characters of names: a digit beside one of these is part of a name such as joint_1 or arm/7.
bool isNamePart(char c) {
  return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '/' ||
         (static_cast<unsigned char>(c) & 0x80U) != 0;
}

/// The end of a number that begins at `at`, or `at` if there is none.
std::size_t endOfNumber(std::string_view text, std::size_t at) {
  std::size_t end = at;
  if (end < text.size() && (text[end] == '-' || text[end] == '+')) ++end;
  const std::size_t digits = end;
  const auto skipDigits = [&] {
    while (end < text.size() && isDigit(text[end])) ++end;
  };
  skipDigits();
  if (end == digits) return at;
  if (end + 1 < text.size() && text[end] == '.' && isDigit(text[end + 1])) {
    ++end;
    skipDigits();
  }
  if (end < text.size() && text[end] == 'e') {
    const std::size_t exponent = end + 1;
    const bool has_sign =
        exponent < text.size() && (text[exponent] == '-' || text[exponent] == '+');
    const std::size_t first = exponent + (has_sign ? 1 : 0);
    if (first < text.size() && isDigit(text[first])) {
      end = first;
      skipDigits();
    }
  }
  if (text.substr(std::min(end, text.size())).starts_with("°")) return end;
  return end < text.size() && isNamePart(text[end]) ? at : end;
}

/// Skips the angle unit after a number: earlier messages gave radians, and baselines from then stay
/// valid.
std::string withoutAngleUnits(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    const bool is_behind_number = !plain.empty() && (plain.back() == '#' || plain.back() == ']');
    std::size_t unit = 0;
    for (const std::string_view each :
         {std::string_view("°"), std::string_view(" rad"), std::string_view(" degrees")}) {
      if (is_behind_number && text.substr(i).starts_with(each)) unit = each.size();
    }
    const std::size_t end = i + unit;
    if (unit > 0 && (end == text.size() || !isNamePart(text[end]) || text[end] == '/')) {
      i = end;
    } else {
      plain += text[i++];
    }
  }
  return plain;
}

std::string withoutNumbers(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    const char before = i > 0 ? text[i - 1] : ' ';
    const bool may_begin = !isNamePart(before) && before != '.' && before != '-' && before != ':';
    const std::size_t end = may_begin ? endOfNumber(text, i) : i;
    if (end > i) {
      plain += '#';
      i = end;
    } else {
      plain += text[i++];
    }
  }
  return plain;
}

/// A file's name that is the same on every machine.
std::string fileOf(const CheckReport& report, const std::string& file) {
  if (file.empty()) return "";
  // For a cell inside a log: LOG:cell/NAME.
  if (const std::size_t inside = file.find(":cell/"); inside != file.npos) {
    return file.substr(inside + 6);
  }
  const std::filesystem::path folder = std::filesystem::path(report.cell).parent_path();
  const std::filesystem::path path(file);
  const std::filesystem::path below =
      path.lexically_normal().lexically_relative(folder.empty() ? "." : folder.lexically_normal());
  const bool is_below = !below.empty() && *below.begin() != "..";
  return (is_below ? below : path.filename()).generic_string();
}

/// What a rule says today, and what its first versions said: a key keeps the words of then, so that
/// a reworded finding is the same one in every baseline and for every reader of SARIF.
struct Rewording {
  std::string_view rule, now, then;
};
constexpr std::array<Rewording, 1> kRewordings = {
    {{"source.unrestated",
      " did not send its static state (add, order, colours, drawings) again for ",
      " restated nothing for "}}};

std::string asFirstWorded(std::string_view rule, std::string text) {
  for (const Rewording& each : kRewordings) {
    // The last: before it stand names, which may say anything.
    const std::size_t at = each.rule == rule ? text.rfind(each.now) : text.npos;
    if (at != text.npos) text.replace(at, each.now.size(), each.then);
  }
  return text;
}

Error damaged(const std::string& name, std::string what) {
  return {ErrorKind::damaged, std::move(what), name};
}

}  // namespace

std::string BaselineKey::text() const {
  return rule + '\n' + subject + '\n' + file + '\n' + sentence;
}

BaselineKey baselineKeyOf(const CheckReport& report, const Finding& finding) {
  // As JSON can hold it: names are a sender's bytes.
  return {finding.rule, plainText(finding.subject), plainText(fileOf(report, finding.file)),
          withoutAngleUnits(withoutNumbers(asFirstWorded(
              finding.rule,
              plainText(finding.left_out.empty() ? finding.text
                                                 : finding.left_out + ": " + finding.text))))};
}

Result<Baseline> Baseline::read(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path, kMaxBytes);
  if (!text) return text.error();
  return parse(bytesOf(*text), path.string());
}

Result<Baseline> Baseline::parse(ByteView bytes, const std::string& name) {
  const std::string_view text = textOf(bytes);
  if (Status fits = checkJsonSize(text); !fits) return damaged(name, fits.error().what);
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& fault) {
    return damaged(name + placeIn(text, fault.byte), "the baseline is not JSON");
  }
  if (!json.is_object() || !json.contains("format") || !json["format"].is_number_integer()) {
    return damaged(name, "this is not a baseline: it states no format");
  }
  if (json["format"] != 1) {
    return Error{ErrorKind::unsupported, "the baseline does not have format 1", name};
  }
  if (!json.contains("accepted") || !json["accepted"].is_array()) {
    return damaged(name, "the baseline has no array `accepted`");
  }
  Baseline baseline;
  baseline.name_ = name;
  std::size_t number = 0;
  for (const Json& entry : json["accepted"]) {
    ++number;
    const auto member = [&](const char* key) -> std::optional<std::string> {
      if (!entry.is_object()) return std::nullopt;
      const auto found = entry.find(key);
      if (found == entry.end()) return "";
      return found->is_string() ? std::optional(found->get<std::string>()) : std::nullopt;
    };
    const auto rule = member("rule"), subject = member("subject"), file = member("file"),
               sentence = member("text");
    if (!rule || rule->empty() || !subject || !file || !sentence || sentence->empty()) {
      return damaged(name, fmt::format("entry {} of the baseline is not {{rule, subject, file, "
                                       "text}} with a rule and a text",
                                       number));
    }
    std::optional<double> worst;
    if (const auto found = entry.find("worst"); found != entry.end()) {
      if (!found->is_number()) {
        return damaged(name,
                       fmt::format("`worst` of entry {} of the baseline is not a number", number));
      }
      worst = found->get<double>();
    }
    baseline.accepted_.insert_or_assign(
        BaselineKey{*rule, *subject, *file, withoutAngleUnits(*sentence)}, worst);
  }
  return baseline;
}

Baseline Baseline::of(const CheckReport& report) {
  Baseline baseline;
  for (const Finding& finding : report.findings) {
    const bool counts =
        finding.accepted || report.isFailure(finding) || finding.severity >= Severity::warning;
    if (counts && finding.rule != kStale && finding.rule != kUnvalued) {
      auto& kept = baseline.accepted_.try_emplace(baselineKeyOf(report, finding), finding.worst)
                       .first->second;
      if (kept && finding.worst) kept = std::max(*kept, *finding.worst);
    }
  }
  return baseline;
}

void Baseline::applyTo(CheckReport& report) const {
  report.has_baseline = true;
  report.unjudged.erase("baseline");
  std::set<BaselineKey> met;
  std::size_t unvalued = 0;
  for (Finding& finding : report.findings) {
    const BaselineKey key = baselineKeyOf(report, finding);
    const auto entry = accepted_.find(key);
    finding.accepted = entry != accepted_.end() && accepts(key, finding);
    if (entry == accepted_.end()) continue;
    met.insert(key);
    if (!finding.accepted) finding.hint = "worse than what the baseline accepts";
    unvalued += !entry->second && finding.worst;
  }
  if (unvalued > 0) {
    Finding finding;
    finding.rule = kUnvalued;
    finding.severity = Severity::note;
    finding.text = fmt::format("the baseline accepts {} however large: it has no worst value",
                               countText(unvalued, "finding"));
    finding.hint = "--update-baseline writes them";
    finding.file = name_;
    report.findings.push_back(std::move(finding));
  }
  for (const auto& [key, worst] : accepted_) {
    if (met.contains(key)) continue;
    Finding finding;
    finding.rule = kStale;
    finding.severity = Severity::note;
    finding.subject = key.subject;
    finding.text = fmt::format("the baseline accepts a finding that no longer occurs: {} [{}]",
                               key.sentence, key.rule);
    finding.hint = "--update-baseline removes it";
    finding.file = name_;
    report.findings.push_back(std::move(finding));
  }
}

bool Baseline::accepts(const BaselineKey& key, const Finding& finding) const {
  const auto entry = accepted_.find(key);
  if (entry == accepted_.end()) return false;
  // Sentences give six digits.
  return !entry->second || !finding.worst ||
         *finding.worst <= *entry->second + 1e-5 * std::abs(*entry->second);
}

std::string Baseline::text() const {
  std::string text = "{\n  \"format\": 1,\n  \"accepted\": [";
  bool is_first = true;
  for (const auto& [key, worst] : accepted_) {
    Json entry;
    entry["rule"] = key.rule;
    if (!key.subject.empty()) entry["subject"] = key.subject;
    if (!key.file.empty()) entry["file"] = key.file;
    entry["text"] = key.sentence;
    if (worst) entry["worst"] = *worst;
    text += is_first ? "\n    " : ",\n    ";
    text += entry.dump(-1, ' ', false, Json::error_handler_t::replace);
    is_first = false;
  }
  return text + (is_first ? "]\n}\n" : "\n  ]\n}\n");
}

}  // namespace rocinante
