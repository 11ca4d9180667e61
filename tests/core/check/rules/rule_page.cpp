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

/// Adds a fenced block to an example. `info` is the text after the opening fence.
Status addBlock(RuleExample& example, const std::string& info, const std::string& text) {
  std::istringstream words(info);
  std::string kind, name, role;
  words >> kind >> name >> role;
  if (kind == "text") return {};
  const Result<std::string> plain = expanded(text);
  if (!plain) return plain.error();
  if (kind == "session") {
    example.session = *plain;
    example.has_session = true;
    return {};
  }
  if (name.empty()) return Error{ErrorKind::damaged, "the block names no file", ""};
  const Result<std::string> bytes = kind == "hex" ? bytesOfHex(*plain) : plain;
  if (!bytes) return bytes.error();
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

/// Walks over a page's lines: blocks go to the example of their section.
struct PageReader {
  RulePage page;
  RuleExample preamble;  ///< blocks before the first section
  std::string section;
  std::string block, info;
  bool in_block = false;

  RuleExample* example() {
    if (section == "Fires") return &page.fires;
    if (section == "Does not fire") return &page.silent;
    return section.empty() ? &preamble : nullptr;
  }

  Status take(const std::string& line) {
    if (line.starts_with("```")) {
      in_block = !in_block;
      if (in_block) {
        info = line.substr(3);
        block.clear();
        return {};
      }
      RuleExample* const to = example();
      return to != nullptr ? addBlock(*to, info, block) : Status{};
    }
    if (in_block) {
      block += line + "\n";
    } else if (line.starts_with("# ")) {
      page.rule = line.substr(2);
    } else if (line.starts_with("## ")) {
      section = line.substr(3);
      // Blocks that the second example lacks are those of the first.
      if (section == "Does not fire") {
        page.silent = page.fires;
        page.silent.also.clear();
      }
    } else if (line.starts_with("**") && page.severity.empty()) {
      page.severity = line.substr(2, line.find("**", 2) - 2);
    } else if (line.starts_with("Fires too: ") && example() != nullptr) {
      example()->also = quotedWords(line);
    } else if (line.starts_with("Not shown: ") && example() != nullptr) {
      example()->cannot_show = line;
    }
    return {};
  }
};

Result<PageReader> readLines(const std::filesystem::path& path, const RuleExample& defaults) {
  const Result<std::string> text = readFile(path);
  if (!text) return text.error();
  PageReader reader;
  reader.page.text = *text;
  reader.page.fires = defaults;
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

Result<RulePage> readRulePage(const std::filesystem::path& path, const RuleExample& defaults) {
  Result<PageReader> reader = readLines(path, defaults);
  if (!reader) return reader.error();
  return std::move(reader->page);
}

Result<RuleExample> readRuleDefaults(const std::filesystem::path& readme) {
  Result<PageReader> reader = readLines(readme, {});
  if (!reader) return reader.error();
  return std::move(reader->preamble);
}

}  // namespace rocinante::test
