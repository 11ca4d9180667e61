#include "core/self_test/fact.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/base/json_parse.h"
#include "core/base/plain_text.h"

namespace rocinante {
namespace {

using State = SelfTestFact::State;
using FactJson = nlohmann::ordered_json;
// By State.
constexpr std::array<std::string_view, 3> kStateNames{"ok", "limited", "missing"};

std::string_view nameOf(State state) { return kStateNames[static_cast<std::size_t>(state)]; }

FactJson jsonOf(std::span<const SelfTestFact> facts) {
  FactJson json = FactJson::array();
  for (const SelfTestFact& fact : facts) {
    json.push_back({{"name", fact.name},
                    {"state", nameOf(fact.state)},
                    {"says", fact.found},
                    {"advice", fact.advice}});
  }
  return json;
}

std::string dumped(const FactJson& json, int indent) {
  // It contains file names, which need not be UTF-8.
  return json.dump(indent, ' ', false, FactJson::error_handler_t::replace);
}

}  // namespace

std::string factsText(std::span<const SelfTestFact> facts) {
  std::string text;
  std::array<int, kStateNames.size()> counts{};
  for (const SelfTestFact& fact : facts) {
    const std::string advice = fact.advice.empty() ? "" : "; " + fact.advice;
    text += fmt::format("{:<8} {:<15} {}\n", nameOf(fact.state), fact.name,
                        plainText(fact.found + advice));
    ++counts[static_cast<std::size_t>(fact.state)];
  }
  return text + fmt::format("{} ok, {} limited, {} missing\n", counts[0], counts[1], counts[2]);
}

std::string factsJson(std::span<const SelfTestFact> facts) {
  FactJson json;
  json["format"] = 1;
  json["ok"] =
      std::ranges::all_of(facts, [](const SelfTestFact& fact) { return fact.state == State::ok; });
  json["facts"] = jsonOf(facts);
  return dumped(json, 2) + "\n";
}

std::string factsWire(std::span<const SelfTestFact> facts) { return dumped(jsonOf(facts), -1); }

std::optional<std::vector<SelfTestFact>> factsOfWire(std::string_view line) {
  const FactJson json = parseJsonOrDiscard<FactJson>(line, kSmallJson);
  if (!json.is_array()) return std::nullopt;
  std::vector<SelfTestFact> facts;
  for (const FactJson& each : json) {
    std::vector<std::string> words;
    for (const char* const key : {"name", "state", "says", "advice"}) {
      if (!each.contains(key) || !each[key].is_string()) return std::nullopt;
      words.push_back(each[key].get<std::string>());
    }
    const auto state = std::ranges::find(kStateNames, words[1]);
    if (state == kStateNames.end()) return std::nullopt;
    facts.push_back(
        {words[0], static_cast<State>(state - kStateNames.begin()), words[2], words[3]});
  }
  return facts;
}

}  // namespace rocinante
