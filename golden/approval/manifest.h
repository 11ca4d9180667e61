#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// A picture that somebody accepted for a case, on one kind of renderer.
struct AcceptedPicture {
  std::string key;      ///< renderer, size and samples: "llvmpipe-...-sse4.1 640x480 4x"
  std::string picture;  ///< file name in the manifest's folder
  std::string pixels;   ///< pictureXxh3 of it
  std::string inputs;   ///< FrameMaker::inputsHash when it was drawn
  std::string session;  ///< content_sha256 of the log; empty without one
  std::string accepted_by, accepted_at, reason;
  /// Where the case's masks lay (areasPicture): its file and pixel hash; empty without masks.
  std::string areas{}, areas_pixels{};
  std::string cell{};  ///< key into Manifest::cells; empty: its files are not known
  bool operator==(const AcceptedPicture&) const = default;
};

/// The files that a cell is made of: name below the cell's folder to SHA-256.
using FileHashes = std::map<std::string, std::string>;
/// What files say, by their SHA-256.
using FileTexts = std::map<std::string, std::string>;

/// goldens/manifest.json: what was accepted, for which case and key (docs/golden-suites.md).
/// Only `approve` writes it.
struct Manifest {
  std::map<std::string, std::vector<AcceptedPicture>> cases;
  /// What accepted pictures were drawn of, by a hash of the list: a failure then names the mesh,
  /// material or texture that changed.
  std::map<std::string, FileHashes> cells;
  /// Of those files the ones that say kinematics and materials: a failure then tells what changed
  /// in them. Files of goldens that were accepted before this was kept have none.
  FileTexts texts;

  /// Empty when the folder has none. Names of pictures that lead out of the folder, or are no
  /// plain PNG's, and pictures that two cases name, are refused. Keys lose the package revisions
  /// that older versions kept in them.
  static Result<Manifest> read(const std::filesystem::path& folder);
  /// The same from the text of manifest.json; `file` is for the sentences.
  static Result<Manifest> parse(std::string_view text, const std::filesystem::path& file);
  Status write(const std::filesystem::path& folder) const;

  /// The accepted pictures of a case for one key; several when alternatives were approved.
  std::vector<const AcceptedPicture*> find(std::string_view case_name, std::string_view key) const;
  /// Those of every key, in the order of the file.
  std::vector<const AcceptedPicture*> findAll(std::string_view case_name) const;
  /// Those with these pixels, whatever their key; of `key` first.
  std::vector<const AcceptedPicture*> findPixels(std::string_view case_name,
                                                 std::string_view pixels,
                                                 std::string_view key) const;
  /// The files of the cell that a picture was accepted of; null when they are not known.
  const FileHashes* cellOf(const AcceptedPicture& accepted) const;
  /// Puts `accepted` in place of the pictures of its case and key, or beside them.
  void accept(const std::string& case_name, AcceptedPicture accepted, bool beside = false);
  /// The names of all files that it uses: pictures and areas.
  std::set<std::string> files() const;
  /// Forgets cells that no picture names, and texts that no cell has.
  void dropUnusedCells();
};

/// True for what writing a manifest leaves when it is killed.
bool isManifestPart(const std::filesystem::path& file);

/// SHA-256 in lower-case hexadecimal, as FileHashes has it.
std::string fileSha256(ByteView content);

/// The key of a list of files in Manifest::cells.
std::string cellKey(const FileHashes& files);

/// "llvmpipe-mesa22.3.6-llvm15.0.6-x86_64-sse4.1" of a key, and what follows: "640x480 4x".
std::string_view rendererOf(std::string_view key);
std::string_view shapeOf(std::string_view key);
/// "640x480 4x": the end of a key.
std::string shapeText(int width, int height, int samples);
/// Eight digits of a key's hash: what stands for it in names of files.
std::string keyDigits(std::string_view key);
/// The golden's file name: the case and eight digits of the key's hash, so that keys never clash.
/// `turn` tells several pictures of one key apart: the first has none.
std::string goldenFileName(std::string_view case_name, std::string_view key, int turn = 1);

}  // namespace rocinante
