#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace rocinante {

/// A picture accepted for a case and one renderer, size and sample count.
struct AcceptedPicture {
  std::string key;      ///< renderer, size and samples: "llvmpipe-...-sse4.1 640x480 4x"
  std::string picture;  ///< file name in the manifest's folder
  std::string pixels;   ///< its pictureXxh3
  std::string inputs;   ///< FrameMaker::inputsHash when it was drawn
  std::string session;  ///< content_sha256 of the log; empty without one
  std::string accepted_by, accepted_at, reason;
  /// The areasPicture of the case's masks: file and pixel hash; empty without masks.
  std::string areas{}, areas_pixels{};
  std::string cell{};  ///< key into Manifest::cells; empty: unknown files
  /// decoded_sha256 of the log; empty without decoded packets.
  std::string decoded{};
  /// Devices and joints that the picture judges (frameCoverage), sorted; empty: unknown, or no log.
  std::optional<std::vector<std::string>> coverage{};
  bool operator==(const AcceptedPicture&) const = default;
};

/// A log accepted for a run of a suite.
struct AcceptedRun {
  std::string log;      ///< file name in the manifest's folder, or SESSION.mcap in the store
  std::string bytes;    ///< XXH3-128 of the file: what was accepted is what is there
  std::string session;  ///< content_sha256 of the log
  std::string decoded;  ///< its decoded_sha256; empty without decoded packets
  std::string accepted_by, accepted_at, reason;
  std::string cell{};  ///< key into Manifest::cells; empty: unknown files
  /// trackCellHash() of the cell; empty when an older version accepted it.
  std::string kinematics{};
  std::vector<std::string> masks{};  ///< of the run in the suite then, as maskText() writes them
  bool operator==(const AcceptedRun&) const = default;
};

/// The files of a cell: path relative to the cell's folder to SHA-256.
using FileHashes = std::map<std::string, std::string>;
/// Contents of text files by SHA-256.
using FileTexts = std::map<std::string, std::string>;

/// goldens/manifest.json: accepted pictures by case and key (docs/golden-suites.md). Only `approve`
/// writes it.
struct Manifest {
  std::map<std::string, std::vector<AcceptedPicture>> cases;
  /// Accepted logs by run, oldest first.
  std::map<std::string, std::vector<AcceptedRun>> runs;
  /// The cell files that accepted pictures were drawn from, by a hash of the list, so that a
  /// failure can name the mesh, material or texture that changed.
  std::map<std::string, FileHashes> cells;
  /// Contents of those files that define kinematics and materials, so that a failure can describe
  /// the change. Goldens accepted by older versions have none.
  FileTexts texts;

  /// Empty when the folder has no manifest. Refuses picture names that leave the folder or do not
  /// end in .png, and pictures shared by two cases. Removes the package revisions that older
  /// versions kept in keys.
  static Result<Manifest> read(const std::filesystem::path& folder);
  /// The same from the text of manifest.json; `file` is used in messages.
  static Result<Manifest> parse(std::string_view text, const std::filesystem::path& file);
  Status write(const std::filesystem::path& folder) const;

  /// The accepted pictures of a case for one key; several when alternatives were approved.
  std::vector<const AcceptedPicture*> find(std::string_view case_name, std::string_view key) const;
  /// The accepted pictures of every key, in file order.
  std::vector<const AcceptedPicture*> findAll(std::string_view case_name) const;
  /// The accepted pictures with these pixels, of any key; those of `key` first.
  std::vector<const AcceptedPicture*> findPixels(std::string_view case_name,
                                                 std::string_view pixels,
                                                 std::string_view key) const;
  /// The files of the cell that an accepted picture was drawn from; null when unknown.
  const FileHashes* cellOf(const AcceptedPicture& accepted) const {
    return cellNamed(accepted.cell);
  }
  const FileHashes* cellNamed(const std::string& key) const;
  const std::vector<AcceptedRun>& runsOf(const std::string& run_name) const;
  /// Replaces the pictures of the same case and key with `accepted`, or adds it to them.
  void accept(const std::string& case_name, AcceptedPicture accepted, bool beside = false);
  /// Names of all files used: pictures and areas.
  std::set<std::string> files() const;
  /// Names of pictures, areas and logs that lie in a store: named by their hash.
  std::set<std::string> storeNames() const;
  /// Names of the logs of all runs.
  std::set<std::string> runFiles() const;
  /// Removes cells that no picture or run uses and texts that no cell uses.
  void dropUnusedCells();
};

/// True for a temporary file left by an interrupted write of a manifest.
bool isManifestPart(const std::filesystem::path& file);

/// SHA-256 in lower-case hexadecimal, as in FileHashes.
std::string fileSha256(ByteView content);

/// The key of a list of files in Manifest::cells.
std::string cellKey(const FileHashes& files);

/// The parts of a key: "llvmpipe-mesa22.3.6-llvm15.0.6-x86_64-sse4.1" and "640x480 4x".
std::string_view rendererOf(std::string_view key);
std::string_view shapeOf(std::string_view key);
/// "640x480 4x": the end of a key.
std::string shapeText(int width, int height, int samples);
/// Eight digits of the key's hash, used in file names.
std::string keyDigits(std::string_view key);
/// The golden's file name: the case and eight digits of the key's hash, so that keys do not clash.
/// `turn` numbers several pictures of one key; the first has no number.
std::string goldenFileName(std::string_view case_name, std::string_view key, int turn = 1);

}  // namespace rocinante
