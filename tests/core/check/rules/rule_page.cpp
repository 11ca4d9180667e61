#include "tests/core/check/rules/rule_page.h"

#include <fmt/format.h>

#include <charconv>
#include <sstream>

#include "core/base/atomic_file.h"

namespace rocinante::test {
namespace {

/// Lines between `%repeat N` and `%end` are repeated N times, with `%i` as 0, 1, 2 ...; within a
/// line `%times N WORD` is WORD N times, and `%numbers N` is 1 to N.
Result<std::string> expanded(const std::string& text) {
  std::istringstream lines(text);
  std::string all, repeated;
  std::size_t times = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("%repeat ")) {
      times = std::stoul(line.substr(8));
    } else if (line == "%end") {
      for (std::size_t i = 0; i < times; ++i) {
        std::string once = repeated;
        const std::string number = std::to_string(i);
        for (std::size_t at = 0; (at = once.find("%i", at)) != once.npos;) {
          once.replace(at, 2, number);
        }
        all += once;
      }
      repeated.clear();
      times = 0;
    } else {
      if (const std::size_t at = line.find("%times "); at != line.npos) {
        std::istringstream words(line.substr(at + 7));
        std::size_t count = 0;
        std::string word;
        words >> count >> word;
        line.resize(at);
        for (std::size_t i = 0; i < count; ++i) line += word;
      } else if (const std::size_t list = line.find("%numbers "); list != line.npos) {
        const std::size_t count = std::stoul(line.substr(list + 9));
        line.resize(list);
        for (std::size_t i = 1; i <= count; ++i) line += " " + std::to_string(i);
      }
      (times > 0 ? repeated : all) += line + "\n";
    }
  }
  if (times > 0) return Error{ErrorKind::damaged, "%repeat without %end", ""};
  return all;
}

Result<std::string> bytesOfHex(const std::string& text) {
  std::string bytes;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    unsigned value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value, 16);
    if (error != std::errc{} || end != word.data() + word.size() || word.size() != 2) {
      return Error{ErrorKind::damaged, "a byte is two hexadecimal digits, not " + word, ""};
    }
    bytes += static_cast<char>(value);
  }
  return bytes;
}

/// `base` with the changes of a diff: lines of "+" come in at the place that lines of "-" and " "
/// give.
Result<std::string> changed(const std::string& base, const std::string& diff) {
  std::istringstream from(base), changes(diff);
  std::string all;
  for (std::string change, line; std::getline(changes, change);) {
    if (change == "@@") continue;
    const std::string text = change.substr(change.empty() ? 0 : 1);
    if (change.starts_with('+')) {
      all += text + "\n";
      continue;
    }
    if (!change.starts_with('-') && !change.starts_with(' ')) {
      return Error{ErrorKind::damaged, "a line of a diff begins with +, - or a blank: " + change,
                   ""};
    }
    bool is_found = false;
    while (!is_found && std::getline(from, line)) {
      is_found = line == text;
      if (!is_found || change[0] == ' ') all += line + "\n";
    }
    if (!is_found) return Error{ErrorKind::damaged, "nothing to change has this line: " + text, ""};
  }
  for (std::string line; std::getline(from, line);) all += line + "\n";
  return all;
}

/// Adds a fenced block to an example. `info` is the text after the opening fence; `shared` is what
/// every example of the page has.
Status addBlock(RuleExample& example, const RuleExample& shared, const std::string& info,
                const std::string& text) {
  std::istringstream words(info);
  std::string kind, name, role;
  words >> kind >> name >> role;
  if (kind == "text") return {};
  const bool is_session = kind == "session" || (kind == "diff" && name == "session");
  if (!is_session && name.empty()) {
    return Error{ErrorKind::damaged, "the block names no file", ""};
  }
  Result<std::string> bytes = expanded(text);
  if (!bytes) return bytes.error();
  if (kind == "hex") bytes = bytesOfHex(*bytes);
  if (kind == "diff") bytes = changed(is_session ? example.session : example.files[name], *bytes);
  if (!bytes) return bytes.error();
  if (is_session) {
    example.session = *bytes;
    example.has_session = true;
    return {};
  }
  if (role == "added") {
    const auto begin = shared.files.find(name);
    if (begin == shared.files.end()) {
      return Error{ErrorKind::damaged, "the examples share no file of this name: " + name, ""};
    }
    *bytes = begin->second + "\n" + *bytes;
  }
  example.files[name] = *bytes;
  if (role == "cell") example.cell = name;
  return {};
}

std::vector<std::string> quotedWords(const std::string& line) {
  std::vector<std::string> words;
  for (std::size_t at = line.find('`'); at != line.npos; at = line.find('`', at + 1)) {
    const std::size_t end = line.find('`', at + 1);
    if (end == line.npos) break;
    words.push_back(line.substr(at + 1, end - at - 1));
    at = end;
  }
  return words;
}

/// Walks over a page's lines: blocks go to the example that the last bold words name.
struct PageReader {
  std::vector<RuleText> rules;
  RuleExample shared;              ///< blocks before the first rule
  RuleExample* example = &shared;  ///< null: blocks are for the reader only
  bool in_summary = false;
  std::string block, info;
  bool in_block = false;

  Status take(const std::string& line) {
    if (!in_block && line.starts_with("## ")) {
      rules.emplace_back().rule = line.substr(3);
      rules.back().fires = shared;
      example = nullptr;
    }
    if (!rules.empty()) rules.back().text += line + "\n";
    if (line.starts_with("```")) {
      in_block = !in_block;
      if (in_block) {
        info = line.substr(3);
        block.clear();
        return {};
      }
      return example != nullptr ? addBlock(*example, shared, info, block) : Status{};
    }
    if (in_block) {
      block += line + "\n";
    } else if (line.starts_with("**Not shown:** ")) {
      (rules.empty() ? shared : rules.back().fires).cannot_show = line;
    } else if (!rules.empty()) {
      takeWords(line);
    }
    return {};
  }

  void takeWords(const std::string& line) {
    RuleText& rule = rules.back();
    if (line.starts_with("**Fires")) {
      rule.fires.also = quotedWords(line.substr(0, line.find(":**")));
      example = &rule.fires;
    } else if (line.starts_with("**Does not fire:**")) {
      rule.silent = line.ends_with(" the shared files as they are.") ? shared : rule.fires;
      rule.silent.also.clear();
      example = &rule.silent;
    } else if (line.starts_with("**") && rule.severity.empty()) {
      const std::size_t end = line.find("**: ");
      if (end == line.npos) return;
      rule.severity = line.substr(2, end - 2);
      rule.summary = line.substr(end + 4);
      in_summary = !rule.summary.ends_with('.');
    } else if (in_summary) {
      rule.summary += " " + line;
      in_summary = !line.ends_with('.') && !line.empty();
    }
    if (!in_summary && rule.summary.ends_with('.')) rule.summary.pop_back();
  }
};

Result<PageReader> readLines(const std::filesystem::path& path, const RuleExample& defaults) {
  const Result<std::string> text = readFile(path);
  if (!text) return text.error();
  PageReader reader;
  reader.shared = defaults;
  std::istringstream lines(*text);
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (Status taken = reader.take(line); !taken) {
      Error error = taken.error();
      error.where = fmt::format("{}:{}", path.string(), number);
      return error;
    }
  }
  if (reader.in_block) return Error{ErrorKind::damaged, "a block has no end", path.string()};
  return reader;
}

}  // namespace

Result<std::vector<RuleText>> readRulePage(const std::filesystem::path& path,
                                           const RuleExample& defaults) {
  Result<PageReader> reader = readLines(path, defaults);
  if (!reader) return reader.error();
  return std::move(reader->rules);
}

Result<RuleExample> readRuleDefaults(const std::filesystem::path& readme) {
  Result<PageReader> reader = readLines(readme, {});
  if (!reader) return reader.error();
  return std::move(reader->shared);
}

}  // namespace rocinante::test
