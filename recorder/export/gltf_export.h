#pragma once

#include "core/cell/cell.h"
#include "core/foreign/gltf/gltf_recording.h"
#include "core/session/moment_walk.h"
#include "recorder/export/log_table.h"

namespace rocinante {

struct GltfExportOptions {
  LogTime from{}, until{};
  Nanoseconds every{};      ///< 0: at each moment that says anything
  ExportProgress progress;  ///< may be empty
};

/// Gives `recording` the scene at the moments of [from, until). One pass over the log. not_found
/// when there is no moment. Adds to `left_out` what of the log the scene has no place for.
Status recordGltf(MomentWalk& session, const Cell& cell, GltfRecording& recording,
                  const GltfExportOptions& options, Account& left_out);

}  // namespace rocinante
