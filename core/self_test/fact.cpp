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
constexpr std::array kStates{State::ok, State::limited, State::missing};

nlohmann::ordered_json jsonOf(std::span<const SelfTestFact> facts) {
  auto json = nlohmann::ordered_json::array();
  for (const SelfTestFact& fact : facts) {
    json.push_back({{"name", fact.name},
                    {"state", nameOf(fact.state)},
                    {"says", fact.says},
                    {"advice", fact.advice}});
  }
  return json;
}

std::string dumped(const nlohmann::ordered_json& json, int indent) {
  // It contains file names, which need not be UTF-8.
  return json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::optional<State> stateNamed(std::string_view name) {
  for (const State state : kStates) {
    if (nameOf(state) == name) return state;
  }
  return std::nullopt;
}

std::optional<SelfTestFact> factOf(const nlohmann::json& json) {
  if (!json.is_object()) return std::nullopt;
  for (const char* key : {"name", "state", "says", "advice"}) {
    if (!json.contains(key) || !json[key].is_string()) return std::nullopt;
  }
  const std::optional<State> state = stateNamed(json["state"].get<std::string>());
  if (!state) return std::nullopt;
  return SelfTestFact{json["name"].get<std::string>(), *state, json["says"].get<std::string>(),
                      json["advice"].get<std::string>()};
}

}  // namespace

std::string_view nameOf(SelfTestFact::State state) {
  switch (state) {
    case State::ok:
      return "ok";
    case State::limited:
      return "limited";
    case State::missing:
      return "missing";
  }
  return "missing";
}

std::string factsText(std::span<const SelfTestFact> facts) {
  std::string text;
  for (const SelfTestFact& fact : facts) {
    const std::string advice = fact.advice.empty() ? "" : "; " + fact.advice;
    text += fmt::format("{:<8} {:<15} {}\n", nameOf(fact.state), fact.name,
                        plainText(fact.says + advice));
  }
  std::string counts;
  for (const State state : kStates) {
    const auto count = std::count_if(facts.begin(), facts.end(), [state](const SelfTestFact& fact) {
      return fact.state == state;
    });
    counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count, nameOf(state));
  }
  return text + counts + "\n";
}

std::string factsJson(std::span<const SelfTestFact> facts) {
  nlohmann::ordered_json json;
  json["format"] = 1;
  json["ok"] = std::all_of(facts.begin(), facts.end(),
                           [](const SelfTestFact& fact) { return fact.state == State::ok; });
  json["facts"] = jsonOf(facts);
  return dumped(json, 2) + "\n";
}

std::string factsWire(std::span<const SelfTestFact> facts) { return dumped(jsonOf(facts), -1); }

std::optional<std::vector<SelfTestFact>> factsOfWire(std::string_view line) {
  const auto json = parseJsonOrDiscard<nlohmann::json>(line);
  if (!json.is_array()) return std::nullopt;
  std::vector<SelfTestFact> facts;
  for (const auto& each : json) {
    std::optional<SelfTestFact> fact = factOf(each);
    if (!fact) return std::nullopt;
    facts.push_back(std::move(*fact));
  }
  return facts;
}

}  // namespace rocinante
