// What tests/build_cost/run counts in: a piece that does not change with the project, of the
// headers and instances that most of our pieces have.
#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

std::map<std::string, std::vector<double>> read(const std::string& text) {
  std::map<std::string, std::vector<double>> rows;
  const auto json = nlohmann::ordered_json::parse(text, nullptr, false);
  for (const auto& [name, values] : json.items()) {
    if (values.is_array()) rows[name] = values.get<std::vector<double>>();
  }
  return rows;
}

std::string sorted(const std::string& text) {
  static const std::regex kName("[a-z]+");
  std::vector<std::unique_ptr<std::string>> names;
  for (std::sregex_iterator each(text.begin(), text.end(), kName), end; each != end; ++each) {
    names.push_back(std::make_unique<std::string>(each->str()));
  }
  std::sort(names.begin(), names.end(), [](const auto& a, const auto& b) { return *a < *b; });
  nlohmann::ordered_json json;
  for (const auto& name : names) json[*name] = name->size();
  return json.dump(2);
}
