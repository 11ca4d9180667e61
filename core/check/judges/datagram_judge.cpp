#include "core/check/judges/datagram_judge.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/name_hint.h"
#include "core/base/plain_text.h"
#include "core/check/judges/fault_rules.h"
#include "core/packet/packet_text.h"
#include "core/report/traffic_findings.h"

namespace rocinante {
namespace {

/// Most encodings that are counted separately.
constexpr std::size_t kMaxEncodings = 200;
/// Longer words are cut.
constexpr std::size_t kMaxWord = 64;

const std::vector<std::string_view> kStatementWords = [] {
  std::vector<std::string_view> words;
  for (int kind = 0; kind <= static_cast<int>(StatementKind::seen); ++kind) {
    words.push_back(nameOf(static_cast<StatementKind>(kind)));
  }
  return words;
}();

/// The bytes of a datagram from the place of a fault.
std::string_view textAt(ByteView datagram, const FaultAt& at) {
  std::string_view text = textOf(datagram);
  for (std::uint32_t line = 1; line < at.line; ++line) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  if (at.column == 0 || at.column > text.size()) return {};
  return text.substr(at.column - 1);
}

/// Whether the fault is in the unit of `signal PATH NAME NUMBER UNIT`.
bool isInUnit(ByteView datagram, const FaultAt& at) {
  std::string_view before = textAt(datagram, {at.fault, at.line, 1});
  before = before.substr(0, at.column == 0 ? 0 : at.column - 1);
  std::size_t fields = 0;
  bool is_signal = false;
  while (true) {
    before.remove_prefix(std::min(before.find_first_not_of(" \t"), before.size()));
    if (before.empty()) return is_signal && fields == 4;
    const std::string_view field = before.substr(0, before.find_first_of(" \t"));
    if (fields++ == 0) is_signal = field == nameOf(StatementKind::signal);
    before.remove_prefix(field.size());
  }
}

/// Whether a number begins like nan, inf or Infinity, as C's printf writes them.
bool isNotFinite(std::string_view text) {
  // A named value: `joint arm elbow=nan`.
  const std::size_t word = std::min(text.find_first_of(" \t\r\n"), text.size());
  text = text.substr(0, word);
  if (const std::size_t equals = text.rfind('='); equals != text.npos) {
    text.remove_prefix(equals + 1);
  }
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  if (text.size() < 3) return false;
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  const std::array<char, 3> begin = {lower(text[0]), lower(text[1]), lower(text[2])};
  return std::string_view(begin.data(), 3) == "nan" || std::string_view(begin.data(), 3) == "inf";
}

}  // namespace

void DatagramJudge::takeUndecoded(std::string_view encoding, const PacketPlace& place) {
  auto found = undecoded_.find(encoding);
  if (found == undecoded_.end()) {
    if (undecoded_.size() == kMaxEncodings) return;
    found = undecoded_.emplace(std::string(encoding), Tally()).first;
  }
  found->second.hit(place);
}

void DatagramJudge::takeFaults(std::span<const FaultAt> faults, PacketPlace place) {
  for (const FaultAt& fault : faults) {
    place.line = std::max<std::uint32_t>(fault.line, 1);
    if (fault.fault == PacketFault::bad_number && isNotFinite(textAt(place.datagram, fault))) {
      if (not_finite_.hit(place)) not_finite_column_ = fault.column;
      continue;
    }
    if (fault.fault == PacketFault::unknown_statement && isMisspelt(place.datagram, fault)) {
      if (misspelt_.hit(place)) {
        misspelt_word_ = last_word_;
        misspelt_hint_ = meant_hint_;
      }
      continue;
    }
    if (fault.fault == PacketFault::bad_string && isInUnit(place.datagram, fault)) {
      if (no_unit_.hit(place)) {
        const std::string_view text = textAt(place.datagram, fault);
        unit_hint_ = unitHint(text.substr(0, std::min(text.find_first_of("\r\n"), kMaxWord)));
        unit_column_ = fault.column;
      }
      continue;
    }
    const auto kind = static_cast<std::size_t>(fault.fault);
    if (faults_[kind].hit(place)) columns_[kind] = fault.column;
  }
}

bool DatagramJudge::isMisspelt(ByteView datagram, const FaultAt& at) {
  std::string_view word = textAt(datagram, at);
  word = word.substr(0, std::min(word.find_first_of(" \t\r\n"), kMaxWord));
  if (word != last_word_) {
    last_word_ = word;
    meant_hint_ = didYouMean(word, kStatementWords);
  }
  return !meant_hint_.empty();
}

void DatagramJudge::takeNotFinite(const NotFiniteField& field, const PacketPlace& place) {
  auto source = no_values_.find(field.source);
  if (source == no_values_.end()) source = no_values_.try_emplace(std::string(field.source)).first;
  auto tally = source->second.find(field.field);
  if (tally == source->second.end()) {
    tally = source->second.try_emplace(std::string(field.field)).first;
  }
  tally->second.hit(place);
}

void DatagramJudge::dropFindings() { *this = {}; }

void DatagramJudge::report(Findings& findings) const {
  const auto add = [&](const Tally& tally, std::string_view rule, std::string text,
                       std::string_view hint, std::uint32_t column) {
    if (tally.count == 0) return;
    if (column > 0) text += fmt::format("; the first at column {}", column);
    findings.push_back(tally.finding(rule, "", std::move(text)));
    findings.back().hint = hint;
  };
  for (std::size_t kind = 0; kind < kPacketFaultCount; ++kind) {
    const FaultRule& rule = ruleOf(static_cast<PacketFault>(kind));
    add(faults_[kind], rule.rule, std::string(rule.text), rule.hint, columns_[kind]);
  }
  add(not_finite_, "packet.not-finite", "lines with a number that is nan or infinite",
      ruleOf(PacketFault::bad_number).hint, not_finite_column_);
  add(no_unit_, "packet.bad-string", "lines with a malformed unit", unit_hint_, unit_column_);
  add(misspelt_, "packet.misspelt-statement",
      fmt::format("lines with the unknown statement `{}`", plainText(misspelt_word_)),
      misspelt_hint_, 0);
  for (const auto& [encoding, tally] : undecoded_) {
    findings.push_back(
        tally.finding("packet.unknown-protocol", encoding, "datagrams in an unknown protocol"));
    findings.back().hint = kPacketTextHint;
  }
  for (const auto& [source, fields] : no_values_) {
    for (const auto& [field, tally] : fields) {
      findings.push_back(tally.finding(
          "source.not-finite", source,
          fmt::format("field {} of {} is NaN or infinite: it says nothing, and what was said "
                      "before holds",
                      plainText(field), plainText(source))));
    }
  }
}

}  // namespace rocinante
