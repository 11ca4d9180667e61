#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/bundle/bundle_manifest.h"
#include "core/cell/cell.h"
#include "core/log/log_writer.h"

namespace rocinante {

/// A cell with all files that it names, transitively, in memory. A log carries it so that it can be
/// viewed alone (docs/log-format.md, section "The cell").
struct CellBundle {
  BundleManifest manifest;
  std::vector<Bytes> contents;  ///< as manifest.files
  Findings warnings;            ///< missing parts that the cell can be drawn without
};

/// Whether a cell whose meshes are not found is collected. It is loaded, and drawn, without them.
enum class MissingMeshes : std::uint8_t { refused, left_out };

/// Where the files of a cell that is collected may lie, after all links.
enum class BundleRoots : std::uint8_t {
  /// In the cell's folder, or in a root that the user named (`options`): what the cell itself names
  /// as a root may be a stranger's choice, and hold what nobody wants to give away. Meshes and
  /// textures may also lie in the package of a bare model, and where FileSearch finds only those.
  of_user,
  all,  ///< for what stays here, such as comparing
};

/// Loads the cell with `options` and collects every file that was read and the meaning of every
/// name. Names hold no folder of this machine above the one that the files have in common. An error
/// when the cell does not load without errors, when a file of it lies elsewhere than `roots`
/// allows, when it is too large (bundle_manifest.h), or when the collected files do not load like
/// the cell. options.lookups and options.answers are not used.
Result<CellBundle> collectCell(const std::filesystem::path& path, CellOptions options,
                               MissingMeshes missing = MissingMeshes::refused,
                               BundleRoots roots = BundleRoots::of_user);

/// The first warnings as text, one per line, and the number of the rest.
std::vector<std::string> bundleWarnings(const CellBundle& bundle);

/// A file as it is attached.
struct BundleAttachment {
  std::string name;
  std::string media_type;
  ByteView data;  ///< borrowed from the bundle, or from `manifest_text`
};

/// The bundle as a log holds it: the manifest and every file as attachments, and one metadata
/// record. Views into the bundle, which must outlive it.
class AttachedBundle {
 public:
  explicit AttachedBundle(const CellBundle& bundle);
  AttachedBundle(const AttachedBundle&) = delete;
  AttachedBundle& operator=(const AttachedBundle&) = delete;

  const std::vector<BundleAttachment>& attachments() const { return attachments_; }
  const LogMetadata& metadata() const { return metadata_; }

  /// Writes all of it, the metadata last: a log that was cut off before it has no cell.
  Status writeTo(LogWriter& log, LogTime time) const;

 private:
  std::string manifest_text_;
  std::vector<BundleAttachment> attachments_;
  LogMetadata metadata_;
};

}  // namespace rocinante
