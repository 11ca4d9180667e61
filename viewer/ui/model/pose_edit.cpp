#include "viewer/ui/model/pose_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/bytes.h"
#include "core/document/toml_table.h"
#include "core/math/trigonometry.h"
#include "viewer/ui/model/inspection.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostCellBytes = 64U << 20U;

const TomlNode* valueOfKey(const TomlNode& table, std::string_view key) {
  const auto found = std::ranges::find(table.entries, key, &TomlNode::Entry::key);
  return found == table.entries.end() ? nullptr : &found->value;
}

/// Its name; without one, that of its model.
std::string deviceNameOf(const TomlNode& device) {
  if (const TomlNode* const name = valueOfKey(device, "name")) return name->text;
  const TomlNode* const model = valueOfKey(device, "model");
  return model == nullptr ? std::string() : fs::path(model->text).stem().string();
}

const TomlNode* deviceOf(const TomlNode& document, std::string_view name) {
  const TomlNode* const devices = valueOfKey(document, "device");
  if (devices == nullptr) return nullptr;
  const auto found = std::ranges::find(devices->items, name, deviceNameOf);
  return found == devices->items.end() ? nullptr : &*found;
}

Pose poseOfDevice(const TomlNode& device) {
  Findings findings;
  FaultList faults(findings, "");
  const TomlNode* const pose = valueOfKey(device, "pose");
  return pose == nullptr ? Pose() : TomlTable(*pose, "pose", faults).pose();
}

bool isNear(const Pose& a, const Pose& b) {
  const double turned = std::abs(glm::dot(a.orientation, b.orientation));
  return lengthOf(a.position - b.position) < 1e-6 && turned > 1 - 1e-12;
}

/// Equal but for places, and for the poses of these two devices.
bool isEqual(const TomlNode& a, const TomlNode& b, const TomlNode* of_a, const TomlNode* of_b) {
  if (a.kind != b.kind || a.text != b.text || a.integer != b.integer || a.flag != b.flag) {
    return false;
  }
  const bool same_number = a.number == b.number || (std::isnan(a.number) && std::isnan(b.number));
  if (!same_number || a.items.size() != b.items.size()) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i) {
    if (!isEqual(a.items[i], b.items[i], of_a, of_b)) return false;
  }
  const auto entriesOf = [&](const TomlNode& table) {
    std::vector<const TomlNode::Entry*> entries;
    for (const TomlNode::Entry& entry : table.entries) {
      const bool is_theirs = &table == of_a || &table == of_b;
      if (!is_theirs || entry.key != "pose") entries.push_back(&entry);
    }
    return entries;
  };
  const auto mine = entriesOf(a), others = entriesOf(b);
  return std::ranges::equal(mine, others, [&](const auto* one, const auto* other) {
    return one->key == other->key && isEqual(one->value, other->value, of_a, of_b);
  });
}

/// Places count letters, not bytes.
std::size_t offsetOf(std::string_view text, const Place& place) {
  std::size_t at = 0;
  for (int line = 1; line < place.line && at != std::string_view::npos; ++line) {
    at = text.find('\n', at);
    if (at != std::string_view::npos) ++at;
  }
  if (at == std::string_view::npos) return text.size();
  const auto continues = [&] {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
  };
  for (int column = 1; column < place.column && at < text.size(); ++column) {
    ++at;
    while (continues()) ++at;
  }
  return at;
}

struct Edit {
  std::size_t at = 0, length = 0;
  std::string text;
};

/// `keep`: parts of one that are kept.
std::string numberText(double number, double keep) {
  const double rounded = std::round(number * keep) / keep;
  return fmt::format("{}", rounded == 0 ? 0.0 : rounded);  // never -0
}

/// The numbers of one key of a pose.
struct PoseKey {
  std::string name;
  std::vector<double> numbers;
  double keep = 1e6;

  std::string text() const {
    std::string list;
    for (const double number : numbers) {
      list += (list.empty() ? "" : ", ") + numberText(number, keep);
    }
    return name + " = [" + list + "]";
  }
};

PoseKey positionKey(const Vec3& position) { return {"xyz", {position.x, position.y, position.z}}; }

/// In the words that the pose has already.
PoseKey rotationKey(const TomlNode* pose, const Quat& turn) {
  constexpr double kNanos = 1e9;
  const Vec3 rpy = rpyOf(turn);
  if (pose != nullptr && valueOfKey(*pose, "rpy") != nullptr) {
    return {"rpy", {rpy.x, rpy.y, rpy.z}, kNanos};
  }
  if (pose != nullptr && valueOfKey(*pose, "quaternion") != nullptr) {
    return {"quaternion", {turn.x, turn.y, turn.z, turn.w}, kNanos};
  }
  return {"rpy_deg", {degreesOf(rpy.x), degreesOf(rpy.y), degreesOf(rpy.z)}};
}

/// Replaces the numbers of the list that differ; false when it has more or fewer of them.
bool editList(std::string_view text, const TomlNode& list, const PoseKey& key,
              std::vector<Edit>& edits) {
  if (list.items.size() != key.numbers.size()) return false;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    if (std::abs(list.items[i].number - key.numbers[i]) < 0.5 / key.keep) continue;
    const std::size_t at = offsetOf(text, list.items[i].place);
    const std::size_t end = std::min(text.find_first_of(", ]\t\r\n#", at), text.size());
    edits.push_back({at, end - at, numberText(key.numbers[i], key.keep)});
  }
  return true;
}

/// The ways to write keys that a pose does not have yet: into it, else below or behind the device's
/// name. The first that makes a cell that means it is taken.
std::vector<Edit> waysToAdd(std::string_view text, const TomlNode& device, const TomlNode* pose,
                            const std::string& keys) {
  if (pose != nullptr) {
    const std::size_t at = offsetOf(text, pose->place);
    const bool is_empty = pose->entries.empty();
    return {{at + 1, 0, " " + keys + (is_empty ? " " : ",")}};
  }
  const TomlNode* const name = valueOfKey(device, "name") != nullptr ? valueOfKey(device, "name")
                                                                     : valueOfKey(device, "model");
  const std::size_t at = offsetOf(text, name->place);
  const std::size_t line = text.rfind('\n', at) + 1;  // of none: 0
  const std::size_t indent = text.find_first_not_of(" \t", line) - line;
  const std::size_t end = std::min(text.find('\n', at), text.size());
  const bool windows = end > 0 && end < text.size() && text[end - 1] == '\r';
  const std::string written = "pose = { " + keys + " }";
  const std::string below = (end == text.size() ? "\n" : "") +
                            std::string(text.substr(line, indent)) + written +
                            (windows ? "\r\n" : "\n");
  // Its own quotes cannot be in a name on one line without being escaped.
  const std::size_t quote = text.find(text[at], at + 1);
  std::vector<Edit> ways{{std::min(end + 1, text.size()), 0, below}};
  if (quote < end) ways.push_back({quote + 1, 0, ", " + written});
  return ways;
}

std::string edited(std::string text, std::vector<Edit> edits) {
  std::ranges::sort(edits, std::greater(), &Edit::at);
  for (const Edit& edit : edits) text.replace(edit.at, edit.length, edit.text);
  return text;
}

}  // namespace

bool definesDevice(const std::string& cell, std::string_view device) {
  const auto document = parseToml(cell, "");
  return document.ok() && deviceOf(*document, device) != nullptr;
}

Result<std::string> withDevicePose(const std::string& cell, std::string_view device,
                                   const Pose& before, const Pose& after, const std::string& file) {
  const auto document = parseToml(cell, file);
  if (!document.ok()) return document.error();
  const auto refused = [&](std::string what) {
    return Error{ErrorKind::bad_argument, std::move(what), file};
  };
  const TomlNode* const node = deviceOf(*document, device);
  if (node == nullptr) return refused(fmt::format("the file has no device {}", device));
  if (!isNear(poseOfDevice(*node), before)) {
    return refused(fmt::format("the file has {} elsewhere than when it was opened", device));
  }
  const TomlNode* const pose = valueOfKey(*node, "pose");
  std::vector<PoseKey> keys;
  if (after.position != before.position) keys.push_back(positionKey(after.position));
  if (after.orientation != before.orientation) {
    keys.push_back(rotationKey(pose, after.orientation));
  }
  std::vector<Edit> edits;
  std::string added;
  bool sound = true;
  for (const PoseKey& key : keys) {
    const TomlNode* const list = pose == nullptr ? nullptr : valueOfKey(*pose, key.name);
    if (list == nullptr) {
      added += (added.empty() ? "" : ", ") + key.text();
    } else {
      sound = sound && editList(cell, *list, key, edits);
    }
  }
  std::vector<std::vector<Edit>> ways{edits};
  if (!added.empty()) {
    ways.clear();
    for (const Edit& one : waysToAdd(cell, *node, pose, added)) {
      ways.push_back(edits);
      ways.back().push_back(one);
    }
  }
  for (std::vector<Edit>& way : ways) {
    const std::string text = edited(cell, std::move(way));
    const auto whole = parseToml(text, file);
    const TomlNode* const moved = whole.ok() ? deviceOf(*whole, device) : nullptr;
    const bool means_it = sound && moved != nullptr && isEqual(*document, *whole, node, moved) &&
                          isNear(poseOfDevice(*moved), after);
    if (means_it) return text;
  }
  return refused(fmt::format(
      "the pose of {} is written in a form that cannot be changed in place; "
      "write pose = {{ {}, {} }}",
      device, positionKey(after.position).text(), rotationKey(nullptr, after.orientation).text()));
}

Result<fs::path> fileOfDevice(const fs::path& main, std::span<const fs::path> files,
                              std::string_view device) {
  const auto refused = [&](std::string what) {
    return Error{ErrorKind::bad_argument, std::move(what), main.string()};
  };
  if (main.extension() != ".toml") {
    return refused("only a cell (*.cell.toml) can keep a pose");
  }
  const auto defines = [&](const fs::path& file) {
    if (file.extension() != ".toml") return false;
    const auto text = readFile(file, kMostCellBytes);
    return text.ok() && definesDevice(*text, device);
  };
  if (defines(main)) return main;
  std::vector<fs::path> found;
  std::ranges::copy_if(files, std::back_inserter(found), defines);
  if (found.size() == 1) return found.front();
  return refused(found.empty()
                     ? fmt::format("no file of the cell has a device {}", device)
                     : fmt::format("{} and {} both have a device {}", found[0].filename().string(),
                                   found[1].filename().string(), device));
}

Status savePose(const fs::path& file, std::string_view device, const Pose& before,
                const Pose& after) {
  std::error_code fault;
  const fs::path real = fs::canonical(file, fault);
  const auto text = readFile(fault ? file : real, kMostCellBytes);
  if (!text.ok()) return text.error();
  const auto changed = withDevicePose(*text, device, before, after, file.string());
  if (!changed.ok()) return changed.error();
  if (*changed == *text) return {};
  return writeFileWhole(real, bytesOf(*changed), true);
}

}  // namespace rocinante
