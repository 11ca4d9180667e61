#include "golden/why/file_change.h"

#include <algorithm>
#include <string_view>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

/// The kind of a file of a cell, by its extension.
std::string_view roleOf(const std::string& name) {
  std::string ending = std::filesystem::path(name).extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == ".mtl") return "materials";
  if (ending == ".toml") return "cell";
  if (ending == ".urdf" || ending == ".sdf") return "model";
  for (const char* picture :
       {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".tga", ".bmp", ".hdr"}) {
    if (ending == picture) return "texture";
  }
  for (const char* mesh : {".obj", ".stl", ".dae", ".gltf", ".glb", ".ply", ".bin"}) {
    if (ending == mesh) return "mesh";
  }
  return "file";
}

/// A text without its comments, each run of white space outside quotes as one space.
std::string meaningOf(std::string_view text, bool is_xml) {
  std::string meaning;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote == 0 && is_xml && text.substr(i).starts_with("<!--")) {
      const std::size_t end = text.find("-->", i);
      if (end == text.npos) return std::string(text);
      i = end + 2;
      continue;
    }
    if (quote == 0 && !is_xml && c == '#') {
      i = std::min(text.find('\n', i), text.size()) - 1;
      continue;
    }
    if (!is_xml && (c == '"' || c == '\'')) quote = quote == 0 ? c : quote == c ? '\0' : quote;
    const bool is_space = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (quote != 0 || !is_space) {
      meaning += c;
    } else if (!meaning.empty() && meaning.back() != ' ') {
      meaning += ' ';
    }
  }
  if (meaning.ends_with(' ')) meaning.pop_back();
  return meaning;
}

bool haveSameMeaning(const std::string& name, const std::string& golden, const std::string& frame,
                     const FileTexts& texts) {
  const auto before = texts.find(golden), now = texts.find(frame);
  if (before == texts.end() || now == texts.end()) return false;
  const bool is_xml = roleOf(name) == "model";
  return meaningOf(before->second, is_xml) == meaningOf(now->second, is_xml);
}

/// Whether `text` names the file: its name without folders, as a whole word.
bool names(std::string_view text, const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  const auto isOfName = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  };
  for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool begins = at == 0 || !isOfName(text[at - 1]);
    if (begins && (end == text.size() || !isOfName(text[end]))) return true;
  }
  return false;
}

/// A text of both cells that names the file: then it is the file that was or is missing. Empty:
/// none that is known.
std::string namedByBoth(const std::string& file, const FileHashes& golden, const FileHashes& frame,
                        const FileTexts& texts) {
  for (const auto& [name, hash] : golden) {
    const auto now = frame.find(name);
    if (now == frame.end()) continue;
    const auto before_text = texts.find(hash), now_text = texts.find(now->second);
    if (before_text == texts.end() || now_text == texts.end()) continue;
    if (names(before_text->second, file) && names(now_text->second, file)) return plainText(name);
  }
  return {};
}

}  // namespace

FileHashes hashesOf(const CellBundle& bundle) {
  FileHashes hashes;
  for (const auto& file : bundle.manifest.files) hashes[file.name] = file.sha256;
  return hashes;
}

bool isRecordedText(const std::string& name) {
  const std::string_view role = roleOf(name);
  return role == "cell" || role == "model" || role == "materials";
}

FileTexts recordedTexts(const CellBundle& bundle) {
  constexpr std::size_t kMaxBytes = std::size_t{1} << 20U;
  FileTexts texts;
  for (std::size_t i = 0; i < bundle.contents.size(); ++i) {
    const auto& file = bundle.manifest.files[i];
    const Bytes& content = bundle.contents[i];
    if (!isRecordedText(file.name) || content.size() > kMaxBytes || !isUtf8(content)) continue;
    texts[file.sha256] = textOf(content);
  }
  return texts;
}

std::vector<FileChange> fileChanges(const FileHashes& golden, const FileHashes& frame,
                                    const FileTexts& texts) {
  // A file that only has another name now has not changed.
  const auto isElsewhere = [](const FileHashes& there, const FileHashes& here,
                              const FileHashes::value_type& its) {
    return std::ranges::any_of(there, [&](const auto& file) {
      return file.second == its.second && roleOf(file.first) == roleOf(its.first) &&
             !here.contains(file.first);
    });
  };
  FileHashes all = golden;
  all.insert(frame.begin(), frame.end());
  std::vector<FileChange> changes;
  for (const auto& [file, ignored] : all) {
    const auto before = golden.find(file);
    const auto now = frame.find(file);
    const std::string role(roleOf(file));
    // The manifest's text is untrusted.
    const std::string name = plainText(file);
    const bool is_recorded = isRecordedText(file);
    const auto add = [&](const std::string& what) {
      changes.push_back({name + ": the " + role + what, is_recorded});
    };
    if (before == golden.end()) {
      if (isElsewhere(golden, frame, *now)) continue;
      const std::string by = namedByBoth(file, golden, frame, texts);
      add(by.empty() ? " is new" : " is there now; it was missing, though " + by + " named it");
    } else if (now == frame.end()) {
      if (isElsewhere(frame, golden, *before)) continue;
      const std::string by = namedByBoth(file, golden, frame, texts);
      add(by.empty() ? " is no longer part of the cell"
                     : " is missing, though " + by + " names it");
    } else if (before->second != now->second &&
               !haveSameMeaning(file, before->second, now->second, texts)) {
      add(role.ends_with('s') ? " have changed" : " has changed");
    }
  }
  return changes;
}

}  // namespace rocinante
