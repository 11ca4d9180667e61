#include "golden/suite.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <set>

#include "core/atomic_file.h"
#include "core/duration_text.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMaxSuiteBytes = 16U << 20U;
constexpr int kMaxPictureSide = 8192;

/// Reads one table of the file and remembers the first fault.
class TableReader {
 public:
  TableReader(const toml::table& table, const std::string& file, std::optional<Error>& fault)
      : table_(table), file_(file), fault_(fault) {}

  void complain(const toml::node& node, const std::string& what) {
    if (fault_) return;
    const auto place = node.source().begin;
    fault_ = Error{ErrorKind::bad_argument, what,
                   fmt::format("{}:{}:{}", file_, place.line, place.column)};
  }
  void complainHere(const std::string& what) { complain(table_, what); }

  void onlyKeys(std::initializer_list<std::string_view> allowed) {
    for (const auto& [key, node] : table_) {
      if (key.str().starts_with("x-")) continue;
      if (std::ranges::find(allowed, key.str()) == allowed.end()) {
        complain(node, fmt::format("unknown key `{}`", key.str()));
      }
    }
  }

  std::optional<std::string> text(std::string_view key) {
    const toml::node* node = table_.get(key);
    if (node == nullptr) return std::nullopt;
    if (const auto value = node->value_exact<std::string>()) return *value;
    complain(*node, fmt::format("`{}` is a string", key));
    return std::nullopt;
  }

  std::optional<std::int64_t> integer(std::string_view key) {
    const toml::node* node = table_.get(key);
    if (node == nullptr) return std::nullopt;
    if (const auto value = node->value_exact<std::int64_t>()) return *value;
    complain(*node, fmt::format("`{}` is a whole number", key));
    return std::nullopt;
  }

  std::optional<double> number(std::string_view key) {
    const toml::node* node = table_.get(key);
    if (node == nullptr) return std::nullopt;
    if (node->is_number()) return node->value<double>();
    complain(*node, fmt::format("`{}` is a number", key));
    return std::nullopt;
  }

  std::vector<std::string> texts(std::string_view key) {
    const toml::node* node = table_.get(key);
    if (node == nullptr) return {};
    std::vector<std::string> found;
    const toml::array* list = node->as_array();
    if (list == nullptr) {
      complain(*node, fmt::format("`{}` is a list of strings", key));
      return {};
    }
    for (const toml::node& element : *list) {
      if (const auto value = element.value_exact<std::string>()) {
        found.push_back(*value);
      } else {
        complain(element, fmt::format("`{}` is a list of strings", key));
      }
    }
    return found;
  }

  const toml::node* node(std::string_view key) { return table_.get(key); }

 private:
  const toml::table& table_;
  const std::string& file_;
  std::optional<Error>& fault_;
};

bool isCaseName(std::string_view name) {
  return !name.empty() && name.size() <= 100 && name.front() != '.' && name.front() != '-' &&
         std::ranges::all_of(name, [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '_' || c == '-' || c == '.';
         });
}

void readMoment(TableReader& reader, SuiteCase& made) {
  made.moment.at = reader.text("at");
  made.moment.event = reader.text("event");
  if (const auto every = reader.text("every")) {
    const auto period = parseDuration(*every);
    if (!period.ok() || *period <= Nanoseconds(0)) {
      reader.complain(*reader.node("every"), "`every` is a duration above zero, such as \"0.5s\"");
    } else {
      made.moment.every = *period;
    }
  }
  if (const auto after = reader.text("after")) {
    const auto shift = parseDuration(*after);
    if (!shift.ok() || !made.moment.event) {
      reader.complain(*reader.node("after"), "`after` is a duration, and goes with `event`");
    } else {
      made.moment.after = *shift;
    }
  }
  const int given = (made.moment.at ? 1 : 0) + (made.moment.event ? 1 : 0) +
                    (made.moment.every || reader.node("every") != nullptr ? 1 : 0);
  if (given > 1) reader.complainHere("a case has one of `at`, `event` and `every`");
}

void readTolerance(TableReader& reader, const std::string& file, std::optional<Error>& fault,
                   SuiteCase& made) {
  const toml::node* node = reader.node("tolerance");
  if (node == nullptr) return;
  if (const toml::table* limits = node->as_table()) {
    TableReader inner(*limits, file, fault);
    inner.onlyKeys({"tile_mean", "tile_over"});
    made.tolerance = {"this case's own", false, inner.number("tile_mean").value_or(0),
                      inner.integer("tile_over").value_or(0)};
    if (!(made.tolerance.tile_mean >= 0 && made.tolerance.tile_mean <= 255) ||
        made.tolerance.tile_over < 0 || made.tolerance.tile_over > 256) {
      inner.complainHere("tile_mean lies in 0 to 255, tile_over in 0 to 256");
    }
    return;
  }
  const auto name = reader.text("tolerance");
  if (!name) return;
  const auto tolerance = Tolerance::named(*name);
  if (!tolerance.ok()) {
    reader.complain(*node,
                    "`tolerance` is \"exact\", \"cpu\", \"loose\" or { tile_mean = ..., "
                    "tile_over = ... }");
  } else {
    made.tolerance = *tolerance;
  }
}

SuiteCase readCase(const toml::table& table, const std::string& file, std::optional<Error>& fault) {
  TableReader reader(table, file, fault);
  reader.onlyKeys({"name", "at", "event", "after", "every", "camera", "size", "samples", "hide",
                   "show", "tolerance", "tags"});
  SuiteCase made;
  made.line = static_cast<int>(table.source().begin.line);
  made.name = reader.text("name").value_or("");
  if (!isCaseName(made.name)) {
    reader.complainHere("a case has a `name` of letters, digits, `_`, `-` and `.`");
  }
  readMoment(reader, made);
  made.camera = reader.text("camera").value_or("");
  if (const toml::node* size = reader.node("size")) {
    const toml::array* list = size->as_array();
    std::array<std::int64_t, 2> sides{};
    bool sound = list != nullptr && list->size() == 2;
    for (std::size_t i = 0; sound && i < 2; ++i) {
      sides[i] = list->get(i)->value_exact<std::int64_t>().value_or(0);
      sound = sides[i] >= 1 && sides[i] <= kMaxPictureSide;
    }
    if (sound) {
      made.width = static_cast<int>(sides[0]);
      made.height = static_cast<int>(sides[1]);
    } else {
      reader.complain(*size, "`size` is [width, height], each from 1 to 8192");
    }
  }
  if (const auto samples = reader.integer("samples")) {
    if (*samples != 1 && *samples != 2 && *samples != 4 && *samples != 8) {
      reader.complain(*reader.node("samples"), "`samples` is 1, 2, 4 or 8");
    }
    made.samples = static_cast<int>(*samples);
  }
  made.hide = reader.texts("hide");
  made.show = reader.texts("show");
  made.tags = reader.texts("tags");
  readTolerance(reader, file, fault, made);
  return made;
}

}  // namespace

Result<Suite> parseSuite(std::string_view text, const std::filesystem::path& path) {
  const std::string file = path.string();
  toml::table root;
  try {
    root = toml::parse(text, file);
  } catch (const toml::parse_error& fault) {
    const auto place = fault.source().begin;
    return Error{ErrorKind::bad_argument, std::string(fault.description()),
                 fmt::format("{}:{}:{}", file, place.line, place.column)};
  }

  std::optional<Error> fault;
  TableReader reader(root, file, fault);
  reader.onlyKeys({"format", "cell", "log", "goldens", "case"});
  if (reader.integer("format").value_or(0) != 1) {
    reader.complainHere("a suite begins with `format = 1`");
  }
  Suite suite;
  suite.file = path;
  const std::filesystem::path folder = path.parent_path();
  const auto cell = reader.text("cell");
  if (!cell) reader.complainHere("a suite names its `cell`");
  suite.cell = folder / cell.value_or("");
  if (const auto log = reader.text("log")) suite.log = folder / *log;
  suite.goldens = folder / reader.text("goldens").value_or("goldens");

  std::set<std::string> names;
  if (const toml::node* cases = root.get("case")) {
    const toml::array* list = cases->as_array();
    if (list == nullptr || !list->is_array_of_tables()) {
      reader.complain(*cases, "cases are written as [[case]]");
    } else {
      for (const toml::node& element : *list) {
        suite.cases.push_back(readCase(*element.as_table(), file, fault));
        if (!names.insert(suite.cases.back().name).second) {
          reader.complain(element,
                          fmt::format("two cases are named `{}`", suite.cases.back().name));
        }
      }
    }
  }
  if (suite.cases.empty()) reader.complainHere("a suite has at least one [[case]]");
  if (fault) return *fault;
  return suite;
}

Result<Suite> readSuite(const std::filesystem::path& path) {
  const auto text = readFile(path, kMaxSuiteBytes);
  if (!text.ok()) return text.error();
  return parseSuite(*text, path);
}

bool matchesGlob(std::string_view pattern, std::string_view text) {
  std::size_t p = 0, t = 0;
  std::size_t star = std::string_view::npos, resume = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resume = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++resume;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

}  // namespace rocinante
