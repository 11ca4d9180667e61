#include "golden/approval/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "core/base/atomic_file.h"
#include "core/base/hash.h"
#include "core/base/json_parse.h"
#include "core/base/json_read.h"
#include "core/base/plain_text.h"
#include "core/report/json_text.h"
#include "golden/suite/merge_conflict.h"
#include "golden/suite/suite_case.h"
#include "viewer/gl/renderer_key.h"

namespace rocinante {
namespace {

constexpr char kFileName[] = "manifest.json";
constexpr std::uint64_t kMaxGoldenManifestBytes = 64U << 20U;

Error broken(const std::filesystem::path& file, std::string what) {
  return {ErrorKind::damaged, "the manifest of goldens is broken: " + std::move(what),
          file.string()};
}

/// A picture that is read or replaced must be a PNG inside the folder.
bool isPictureName(const std::string& name) {
  return name.size() > 4 && name.size() <= 255 && name.ends_with(".png") && name.front() != '.' &&
         isFileText(name);
}

Result<AcceptedPicture> acceptedOf(const Json& entry, const std::string& name,
                                   const std::filesystem::path& file) {
  AcceptedPicture accepted{withoutPackageRevisions(textIn(entry, "key")),
                           textIn(entry, "picture"),
                           textIn(entry, "pixels"),
                           textIn(entry, "inputs"),
                           textIn(entry, "session"),
                           textIn(entry, "accepted_by"),
                           textIn(entry, "accepted_at"),
                           textIn(entry, "reason"),
                           textIn(entry, "areas"),
                           textIn(entry, "areas_pixels"),
                           textIn(entry, "cell"),
                           textIn(entry, "decoded")};
  if (accepted.key.empty() || accepted.pixels.empty() || !isPictureName(accepted.picture) ||
      (!accepted.areas.empty() && !isPictureName(accepted.areas))) {
    return broken(file, fmt::format("a picture of case `{}` lacks its key, its pixel hash or a "
                                    "plain file name",
                                    plainText(name)));
  }
  if (const auto coverage = entry.find("coverage"); coverage != entry.end()) {
    accepted.coverage = textsIn(entry, "coverage");
    // It decides verdicts.
    if (!coverage->is_array() || accepted.coverage->size() != coverage->size()) {
      return broken(
          file, fmt::format("`coverage` of case `{}` is not a list of devices", plainText(name)));
    }
  }
  return accepted;
}

bool isLogName(const std::string& name) {
  return name.size() > 5 && name.size() <= 255 && name.ends_with(".mcap") && name.front() != '.' &&
         isFileText(name);
}

Result<std::map<std::string, std::vector<AcceptedRun>>> runsIn(const Json& root,
                                                               const std::filesystem::path& file) {
  std::map<std::string, std::vector<AcceptedRun>> runs;
  const auto found = root.find("runs");
  if (found == root.end()) return runs;
  if (!found->is_object()) return broken(file, "`runs` is not an object");
  for (const auto& [name, logs] : found->items()) {
    if (!logs.is_array()) {
      return broken(file, fmt::format("run `{}` is not a list", plainText(name)));
    }
    for (const Json& entry : logs) {
      AcceptedRun accepted{textIn(entry, "log"),         textIn(entry, "bytes"),
                           textIn(entry, "session"),     textIn(entry, "decoded"),
                           textIn(entry, "accepted_by"), textIn(entry, "accepted_at"),
                           textIn(entry, "reason"),      textIn(entry, "cell"),
                           textIn(entry, "kinematics"),  textsIn(entry, "masks")};
      if (!isLogName(accepted.log) || accepted.session.empty() || accepted.bytes.empty()) {
        return broken(file, fmt::format("a log of run `{}` lacks its session, its bytes' hash or a "
                                        "plain file name",
                                        plainText(name)));
      }
      runs[name].push_back(std::move(accepted));
    }
  }
  return runs;
}

/// Skips invalid entries: hashes only explain failures and decide no verdict.
std::map<std::string, FileHashes> cellsOf(const Json& root) {
  std::map<std::string, FileHashes> cells;
  const auto found = root.find("cells");
  if (found == root.end() || !found->is_object()) return cells;
  for (const auto& [key, files] : found->items()) {
    if (!files.is_object()) continue;
    FileHashes& hashes = cells[key];
    for (const auto& [name, hash] : files.items()) {
      if (hash.is_string()) hashes[name] = hash.get<std::string>();
    }
  }
  return cells;
}

/// Skips a text that does not match its hash: it was edited.
FileTexts keptTexts(const Json& root) {
  FileTexts texts;
  const auto found = root.find("texts");
  if (found == root.end() || !found->is_object()) return texts;
  for (const auto& [hash, text] : found->items()) {
    if (!text.is_string()) continue;
    const auto& content = text.get_ref<const std::string&>();
    if (fileSha256(bytesOf(content)) == hash) texts[hash] = content;
  }
  return texts;
}

/// Parses JSON and refuses duplicate cases: the parser would keep only one of them.
Result<Json> parseOnce(std::string_view text, const std::filesystem::path& file) {
  std::string of_root;
  std::string twice;
  std::set<std::string> names;
  const auto look = [&](int depth, Json::parse_event_t event, Json& key) {
    if (event != Json::parse_event_t::key) return true;
    const auto name = key.get<std::string>();
    if (depth == 1) of_root = name;
    if (depth == 2 && of_root == "cases" && !names.insert(name).second) twice = name;
    return true;
  };
  if (Status fits = checkJsonSize(text); !fits) return broken(file, fits.error().what);
  Json root;
  try {
    root = Json::parse(text, look);
  } catch (const Json::parse_error& fault) {
    return mergeConflictIn(text, file.string(), "the manifest of goldens",
                           "take one side of the folder (`git checkout --ours` or `--theirs`, "
                           "pictures too), then approve what is drawn")
        .value_or(broken(file.string() + placeIn(text, fault.byte), "it is not JSON"));
  }
  if (!twice.empty()) {
    return broken(file, fmt::format("it has case `{}` twice", plainText(twice)));
  }
  return root;
}

}  // namespace

Result<Manifest> Manifest::read(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kFileName;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return Manifest{};
  const auto text = readFile(file, kMaxGoldenManifestBytes);
  if (!text.ok()) return text.error();
  return parse(*text, file);
}

Result<Manifest> Manifest::parse(std::string_view text, const std::filesystem::path& file) {
  const auto parsed = parseOnce(text, file);
  if (!parsed.ok()) return parsed.error();
  const Json& root = *parsed;
  if (!root.is_object()) return broken(file, "it is not a JSON object");
  if (root.value("format", Json()) != 1) {
    return Error{ErrorKind::unsupported, "the manifest of goldens has a format other than 1",
                 file.string()};
  }
  const auto cases = root.find("cases");
  if (cases == root.end() || !cases->is_object()) return broken(file, "it has no `cases`");

  Manifest manifest;
  manifest.cells = cellsOf(root);
  manifest.texts = keptTexts(root);
  auto runs = runsIn(root, file);
  if (!runs.ok()) return runs.error();
  manifest.runs = std::move(*runs);
  std::set<std::string> files;
  for (const auto& [name, pictures] : cases->items()) {
    if (!pictures.is_array()) {
      return broken(file, fmt::format("case `{}` is not a list", plainText(name)));
    }
    for (const Json& entry : pictures) {
      auto accepted = acceptedOf(entry, name, file);
      if (!accepted.ok()) return accepted.error();
      // Replacing one golden must not remove another's picture. In a store equal pictures share a
      // file named by their hash.
      if (!files.insert(accepted->picture).second &&
          accepted->picture != accepted->pixels + ".png") {
        return broken(file,
                      fmt::format("two goldens share the file {}", plainText(accepted->picture)));
      }
      manifest.cases[name].push_back(std::move(*accepted));
    }
  }
  return manifest;
}

Status Manifest::write(const std::filesystem::path& folder) const {
  Json root;
  root["format"] = 1;
  root["cases"] = Json::object();
  for (const auto& [name, pictures] : cases) {
    Json& list = root["cases"][name] = Json::array();
    for (const AcceptedPicture& accepted : pictures) {
      Json& entry = list.emplace_back();
      entry = {{"key", accepted.key},
               {"picture", accepted.picture},
               {"pixels", accepted.pixels},
               {"inputs", accepted.inputs},
               {"session", accepted.session},
               {"accepted_by", accepted.accepted_by},
               {"accepted_at", accepted.accepted_at},
               {"reason", accepted.reason}};
      if (!accepted.cell.empty()) entry["cell"] = accepted.cell;
      if (!accepted.decoded.empty()) entry["decoded"] = accepted.decoded;
      if (accepted.coverage) entry["coverage"] = *accepted.coverage;
      if (accepted.areas.empty()) continue;
      entry["areas"] = accepted.areas;
      entry["areas_pixels"] = accepted.areas_pixels;
    }
  }
  for (const auto& [name, logs] : runs) {
    Json& list = root["runs"][name] = Json::array();
    for (const AcceptedRun& accepted : logs) {
      Json entry = {{"log", accepted.log},
                    {"bytes", accepted.bytes},
                    {"session", accepted.session},
                    {"accepted_by", accepted.accepted_by},
                    {"accepted_at", accepted.accepted_at},
                    {"reason", accepted.reason}};
      if (!accepted.decoded.empty()) entry["decoded"] = accepted.decoded;
      if (!accepted.cell.empty()) entry["cell"] = accepted.cell;
      if (!accepted.kinematics.empty()) entry["kinematics"] = accepted.kinematics;
      if (!accepted.masks.empty()) entry["masks"] = accepted.masks;
      list.push_back(std::move(entry));
    }
  }
  for (const auto& [key, hashes] : cells) root["cells"][key] = hashes;
  for (const auto& [hash, content] : texts) root["texts"][hash] = content;
  const std::string text = jsonText(root);
  return writeFileWhole(folder / kFileName, bytesOf(text), true);
}

std::vector<const AcceptedPicture*> Manifest::find(std::string_view case_name,
                                                   std::string_view key) const {
  std::vector<const AcceptedPicture*> found = findAll(case_name);
  std::erase_if(found, [&](const AcceptedPicture* one) { return one->key != key; });
  return found;
}

std::vector<const AcceptedPicture*> Manifest::findAll(std::string_view case_name) const {
  std::vector<const AcceptedPicture*> found;
  const auto pictures = cases.find(std::string(case_name));
  if (pictures == cases.end()) return found;
  for (const AcceptedPicture& accepted : pictures->second) found.push_back(&accepted);
  return found;
}

std::vector<const AcceptedPicture*> Manifest::findPixels(std::string_view case_name,
                                                         std::string_view pixels,
                                                         std::string_view key) const {
  std::vector<const AcceptedPicture*> found = findAll(case_name);
  std::erase_if(found, [&](const AcceptedPicture* one) { return one->pixels != pixels; });
  std::stable_partition(found.begin(), found.end(),
                        [&](const AcceptedPicture* one) { return one->key == key; });
  return found;
}

void Manifest::accept(const std::string& case_name, AcceptedPicture accepted, bool beside) {
  std::vector<AcceptedPicture>& pictures = cases[case_name];
  std::erase_if(pictures, [&](const AcceptedPicture& old) {
    return old.key == accepted.key && (!beside || old.pixels == accepted.pixels);
  });
  pictures.push_back(std::move(accepted));
  // Sorted, so that the order of approval does not change the file.
  std::ranges::sort(pictures, [](const AcceptedPicture& a, const AcceptedPicture& b) {
    return std::tie(a.key, a.picture) < std::tie(b.key, b.picture);
  });
}

std::set<std::string> Manifest::files() const {
  std::set<std::string> files;
  for (const auto& [name, pictures] : cases) {
    for (const AcceptedPicture& accepted : pictures) {
      files.insert(accepted.picture);
      if (!accepted.areas.empty()) files.insert(accepted.areas);
    }
  }
  return files;
}

std::set<std::string> Manifest::storeNames() const {
  std::set<std::string> names;
  for (const auto& [case_name, pictures] : cases) {
    for (const AcceptedPicture& one : pictures) {
      if (one.picture == one.pixels + ".png") names.insert(one.picture);
      if (!one.areas.empty() && one.areas == one.areas_pixels + ".png") names.insert(one.areas);
    }
  }
  for (const auto& [run_name, logs] : runs) {
    for (const AcceptedRun& one : logs) {
      if (one.log == one.session + ".mcap") names.insert(one.log);
    }
  }
  return names;
}

const FileHashes* Manifest::cellNamed(const std::string& key) const {
  const auto found = cells.find(key);
  return found == cells.end() ? nullptr : &found->second;
}

const std::vector<AcceptedRun>& Manifest::runsOf(const std::string& run_name) const {
  static const std::vector<AcceptedRun> kNone;
  const auto found = runs.find(run_name);
  return found == runs.end() ? kNone : found->second;
}

std::set<std::string> Manifest::runFiles() const {
  std::set<std::string> names;
  for (const auto& [name, logs] : runs) {
    for (const AcceptedRun& accepted : logs) names.insert(accepted.log);
  }
  return names;
}

void Manifest::dropUnusedCells() {
  std::set<std::string> used;
  for (const auto& [name, pictures] : cases) {
    for (const AcceptedPicture& accepted : pictures) used.insert(accepted.cell);
  }
  for (const auto& [name, logs] : runs) {
    for (const AcceptedRun& accepted : logs) used.insert(accepted.cell);
  }
  std::erase_if(cells, [&](const auto& cell) { return !used.contains(cell.first); });
  std::set<std::string> hashes;
  for (const auto& [key, files] : cells) {
    for (const auto& [name, hash] : files) hashes.insert(hash);
  }
  std::erase_if(texts, [&](const auto& text) { return !hashes.contains(text.first); });
}

bool isManifestPart(const std::filesystem::path& file) {
  return file.filename().string().starts_with(std::string(kFileName) + ".part");
}

std::string fileSha256(ByteView content) {
  Sha256 hash;
  hash.add(content);
  return hexOf(hash.finish());
}

std::string cellKey(const FileHashes& files) {
  std::string text;
  for (const auto& [name, hash] : files) text += name + "\n" + hash + "\n";
  return hexOf(xxh3(bytesOf(text)));
}

std::string_view rendererOf(std::string_view key) { return key.substr(0, key.find(' ')); }

std::string_view shapeOf(std::string_view key) {
  return key.substr(std::min(key.size(), rendererOf(key).size() + 1));
}

std::string shapeText(int width, int height, int samples) {
  return fmt::format("{}x{} {}x", width, height, samples);
}

std::string keyDigits(std::string_view key) { return hexOf(xxh3(bytesOf(key))).substr(0, 8); }

std::string goldenFileName(std::string_view case_name, std::string_view key, int turn) {
  return turn == 1 ? fmt::format("{}.{}.png", case_name, keyDigits(key))
                   : fmt::format("{}.{}.{}.png", case_name, keyDigits(key), turn);
}

}  // namespace rocinante
