#include "golden/suite/suite_append.h"

#include <fmt/format.h>

#include "golden/suite/suite.h"

namespace rocinante {

void NewCase::add(const std::string& key, std::string value) {
  keys.emplace_back(key, std::move(value));
}

void NewCase::addText(const std::string& key, const std::string& text) {
  if (!text.empty()) add(key, tomlText(text));
}

void NewCase::addTexts(const std::string& key, const std::vector<std::string>& texts) {
  if (texts.empty()) return;
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + tomlText(text);
  add(key, "[" + list + "]");
}

Result<std::string> withCase(const std::string& suite, const NewCase& added,
                             const std::filesystem::path& path) {
  // Report faults of the existing suite as such, not as faults of the new case.
  const bool has_cases = suite.find("[[case]]") != std::string::npos;
  if (has_cases) {
    if (const auto before = parseSuite(suite, path); !before.ok()) return before.error();
  }
  const bool windows = suite.find("\r\n") != std::string::npos;
  const std::string end_of_line = windows ? "\r\n" : "\n";
  std::string text = suite;
  if (!text.empty() && text.back() != '\n') text += end_of_line;
  text += end_of_line + "[[case]]" + end_of_line;
  text += "name = " + tomlText(added.name) + end_of_line;
  for (const auto& [key, value] : added.keys) text += key + " = " + value + end_of_line;
  const auto after = parseSuite(text, path);
  if (!after.ok()) return after.error();
  return text;
}

}  // namespace rocinante
