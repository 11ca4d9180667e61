#include "golden/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <set>

#include "core/atomic_file.h"
#include "core/duration_text.h"
#include "core/model/toml_node.h"

namespace rocinante {
namespace {

constexpr std::uint64_t kMaxSuiteBytes = 16U << 20U;
constexpr int kMaxPictureSide = 8192;

/// Reads one table of the file and remembers the first fault.
class TableReader {
 public:
  TableReader(const TomlNode& table, const std::string& file, std::optional<Error>& fault)
      : table_(table), file_(file), fault_(fault) {}

  void complain(const TomlNode& node, const std::string& what) {
    if (fault_) return;
    fault_ = Error{ErrorKind::bad_argument, what,
                   fmt::format("{}:{}:{}", file_, node.place.line, node.place.column)};
  }
  void complainHere(const std::string& what) { complain(table_, what); }

  void onlyKeys(std::initializer_list<std::string_view> allowed) {
    for (const TomlNode::Entry& entry : table_.entries) {
      if (entry.key.starts_with("x-")) continue;
      if (std::ranges::find(allowed, entry.key) == allowed.end()) {
        complain(entry.value, fmt::format("unknown key `{}`", entry.key));
      }
    }
  }

  /// Null when the table has no such key.
  const TomlNode* node(std::string_view key) {
    const auto found = std::ranges::find(table_.entries, key, &TomlNode::Entry::key);
    return found == table_.entries.end() ? nullptr : &found->value;
  }

  std::optional<std::string> text(std::string_view key) {
    const TomlNode* found = ofKind(key, TomlNode::Kind::text, "a string");
    return found != nullptr ? std::optional(found->text) : std::nullopt;
  }

  std::optional<std::int64_t> integer(std::string_view key) {
    const TomlNode* found = ofKind(key, TomlNode::Kind::integer, "a whole number");
    return found != nullptr ? std::optional(found->integer) : std::nullopt;
  }

  std::optional<double> number(std::string_view key) {
    const TomlNode* found = node(key);
    if (found != nullptr && found->kind == TomlNode::Kind::integer) return found->number;
    found = ofKind(key, TomlNode::Kind::number, "a number");
    return found != nullptr ? std::optional(found->number) : std::nullopt;
  }

  std::vector<std::string> texts(std::string_view key) {
    const TomlNode* found = ofKind(key, TomlNode::Kind::array, "a list of strings");
    std::vector<std::string> texts;
    if (found == nullptr) return texts;
    for (const TomlNode& item : found->items) {
      if (item.kind == TomlNode::Kind::text) {
        texts.push_back(item.text);
      } else {
        complain(item, fmt::format("`{}` is a list of strings", key));
      }
    }
    return texts;
  }

 private:
  const TomlNode* ofKind(std::string_view key, TomlNode::Kind kind, std::string_view what) {
    const TomlNode* found = node(key);
    if (found == nullptr || found->kind == kind) return found;
    complain(*found, fmt::format("`{}` is {}", key, what));
    return nullptr;
  }

  const TomlNode& table_;
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
  const TomlNode* node = reader.node("tolerance");
  if (node == nullptr) return;
  if (node->kind == TomlNode::Kind::table) {
    TableReader inner(*node, file, fault);
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

SuiteCase readCase(const TomlNode& table, const std::string& file, std::optional<Error>& fault) {
  TableReader reader(table, file, fault);
  reader.onlyKeys({"name", "at", "event", "after", "every", "camera", "size", "samples", "hide",
                   "show", "tolerance", "tags"});
  SuiteCase made;
  made.line = table.place.line;
  made.name = reader.text("name").value_or("");
  if (!isCaseName(made.name)) {
    reader.complainHere("a case has a `name` of letters, digits, `_`, `-` and `.`");
  }
  readMoment(reader, made);
  made.camera = reader.text("camera").value_or("");
  if (const TomlNode* size = reader.node("size")) {
    std::array<std::int64_t, 2> sides{};
    bool sound = size->kind == TomlNode::Kind::array && size->items.size() == 2;
    for (std::size_t i = 0; sound && i < 2; ++i) {
      sides[i] = size->items[i].integer;  // zero when it is no whole number
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
  const auto root = parseToml(text, file);
  if (!root.ok()) return root.error();

  std::optional<Error> fault;
  TableReader reader(*root, file, fault);
  reader.onlyKeys({"format", "cell", "log", "goldens", "case"});
  if (reader.integer("format").value_or(0) != 1) {
    reader.complainHere("a suite begins with `format = 1`");
  }
  Suite suite;
  suite.file = path;
  const std::filesystem::path folder = path.parent_path();
  if (const auto cell = reader.text("cell")) suite.cell = folder / *cell;
  if (const auto log = reader.text("log")) suite.log = folder / *log;
  if (suite.cell.empty() && !suite.log) {
    reader.complainHere("a suite names its `cell`, or a `log` that carries one");
  }
  suite.goldens = folder / reader.text("goldens").value_or("goldens");

  std::set<std::string> names;
  if (const TomlNode* cases = reader.node("case")) {
    const bool are_tables = cases->kind == TomlNode::Kind::array &&
                            std::ranges::all_of(cases->items, [](const TomlNode& item) {
                              return item.kind == TomlNode::Kind::table;
                            });
    if (!are_tables) reader.complain(*cases, "cases are written as [[case]]");
    for (const TomlNode& item : cases->items) {
      suite.cases.push_back(readCase(item, file, fault));
      if (!names.insert(suite.cases.back().name).second) {
        reader.complain(item, fmt::format("two cases are named `{}`", suite.cases.back().name));
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

}  // namespace rocinante
