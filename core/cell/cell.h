#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/model_search.h"
#include "core/base/parallel_for.h"
#include "core/base/result.h"
#include "core/cell/camera_lens.h"
#include "core/cell/cell_rules.h"
#include "core/kinematics/model.h"
#include "core/report/finding.h"
#include "core/search/found_file.h"

namespace rocinante {

class SearchFacts;

/// A device that the cell names.
struct CellDevice {
  std::string name;
  std::string model;  ///< key into Cell::models
  Pose pose;
  std::string layer;              ///< empty: none
  std::vector<std::string> tags;  ///< further layers that it is in
  bool optional = false;          ///< waits for `add`
  /// Carried from the start: `pose` is in the space of this device's link (empty: its root).
  std::string on_device, on_link;
  std::optional<glm::vec4> color;  ///< replaces its materials' colours
  /// The model with this device's [[material]] changes; null: no changes.
  std::shared_ptr<const Model> dressed;
};

struct CellCamera {
  std::string name;
  Vec3 eye{}, target{}, up{0, 0, 1};
  double fov_deg = 45;                     ///< vertical
  std::optional<double> ortho_height_m;    ///< orthographic: metres from top to bottom
  std::string on_device, on_link;          ///< rides on it: eye and target in its space
  std::string follow_device, follow_link;  ///< follows its position without turning
  /// Looks at it: `target` is an offset from its position, in the world's directions.
  std::string look_device, look_link;
  std::optional<CameraIntrinsics> intrinsics;  ///< calibrated; `fov_deg` is then about its height
  LensDistortion distortion;                   ///< of its real pictures
};

enum class InsetCorner : std::uint8_t { top_right, top_left, bottom_right, bottom_left };

/// A window with a camera of its own, drawn over the main view (docs/cell-format.md, "Insets").
struct CellInset {
  std::string camera;  ///< of the cell, a `view` of the session, or built in: "map", "fit",
                       ///< "fit:DEVICE"
  InsetCorner corner = InsetCorner::top_right;
  double width = 0.3, height = 0.3;  ///< fractions of the picture's; pixels when `in_pixels`
  bool in_pixels = false;
  int margin_px = 12;                ///< from the picture's edges, and between insets
  std::optional<std::string> title;  ///< without: the camera's name; empty: none
  int border_px = 1;
  std::uint32_t border_rgba = 0x14181CFF;
  bool operator==(const CellInset&) const = default;
};

/// Which geometry of a link is drawn.
enum class CollisionLook : std::uint8_t {
  off,   ///< its visuals
  only,  ///< its collision geometry
  over,  ///< both, the collision geometry translucent
};

/// How the cell draws a layer. Empty values change nothing.
struct LayerLook {
  std::optional<bool> wireframe;
  std::optional<float> opacity;            ///< 0 to 1, times the surfaces' own
  std::optional<CollisionLook> collision;  ///< ignored for parts
  bool operator==(const LayerLook&) const = default;

  /// Values of `nearer` override these.
  void add(const LayerLook& nearer) {
    if (nearer.wireframe) wireframe = nearer.wireframe;
    if (nearer.opacity) opacity = nearer.opacity;
    if (nearer.collision) collision = nearer.collision;
  }
};

/// A member of a layer, besides devices that name it: a device, a link, or parts of their meshes.
struct LayerMember {
  std::string device;  ///< empty: every device
  std::string link;    ///< empty: all links
  std::string group;   ///< a pattern (`*`, `?`) of MeshPart::group; empty: whole links
  bool operator==(const LayerMember&) const = default;
};

struct CellLayer {
  std::string name;
  bool visible = true;
  std::vector<LayerMember> members{};
  LayerLook look{};
};

/// What `check` expects of a source.
struct CellSource {
  std::string name;
  std::optional<std::pair<double, double>> rate_hz;
  SourceLimits limits;
  std::vector<std::string> devices;
  std::map<std::string, std::string> ghost_of;  ///< device drawn as a ghost of another
};

/// Two patterns (docs/patterns.md), each of devices "DEVICE", links "DEVICE/LINK" or layers
/// "layer/NAME".
using ClearancePatterns = std::pair<std::string, std::string>;

/// Links whose distance `check` judges (docs/cell-format.md, "Clearances").
struct CellClearance {
  std::string name;           ///< never empty
  ClearancePatterns between;  ///< links of different devices; equal when `is_self`
  bool is_self = false;       ///< links of one device, but for adjacent ones
  double min_m = 0;
  std::vector<ClearancePatterns> except;  ///< may touch, whichever way round
};

/// What `check` expects of signals (docs/cell-format.md, "Signals").
struct CellSignal {
  std::string device;                                ///< empty: those of no device
  std::string link;                                  ///< empty: those of the device itself
  std::string name;                                  ///< a pattern (docs/patterns.md)
  std::string unit;                                  ///< of numbers; empty: any
  std::string label;                                 ///< what people call it; empty: its name
  std::optional<std::pair<double, double>> range;    ///< in the unit, like the next
  std::optional<double> jump;                        ///< largest change from one value to the next
  std::optional<double> stuck_s;                     ///< longest time without a change in motion
  std::optional<std::pair<double, double>> rate_hz;  ///< of statements that are not restated
  std::vector<std::string> values;                   ///< allowed texts, "true", "false"; empty: any
  std::vector<std::pair<std::string, std::string>> transitions;  ///< allowed; empty: any
  bool optional = false;                                         ///< a session may lack it
};

/// A light at infinity: it has only a direction.
struct CellLight {
  Vec3 direction{0, 0, 1};            ///< towards it, of any length but zero; world space
  glm::vec3 color{1.0F, 1.0F, 1.0F};  ///< display values
  double strength = 1;                ///< 1: as bright as the default light
};

struct CellScene {
  glm::vec3 background_top{0.60F, 0.68F, 0.76F};
  glm::vec3 background_bottom{0.86F, 0.88F, 0.90F};
  /// Towards the key light, the one that casts shadows; world space. That of the first of `lights`
  /// where there are some.
  glm::vec3 light_direction{0.4F, -0.5F, 0.8F};
  std::vector<CellLight> lights;  ///< in place of key light and fill; empty: those two
  bool grid = true;
  double grid_size_m = 10;  ///< half its width
  double grid_step_m = 1;
};

/// Geometry mapped to kinematics (docs/cell-format.md). Immutable once loaded.
struct Cell {
  std::string file;
  std::vector<CellDevice> devices;  ///< as the file has them
  /// Names to places in `devices`; loading fills it, a cell made by hand may leave it empty.
  std::map<std::string, std::size_t, std::less<>> device_by_name;
  /// By the names that `add DEVICE MODEL` may use: the name of each [[model]]; for each file that a
  /// device uses, the text as written, the file's name, and that without `.urdf`. A short name that
  /// fits two models means neither.
  std::map<std::string, std::shared_ptr<const Model>> models;
  std::vector<CellCamera> cameras;
  std::vector<CellInset> insets;  ///< as the files have them
  std::vector<CellLayer> layers;
  std::vector<CellSource> sources;
  std::vector<CellRule> rules;            ///< as the file has them
  std::vector<CellClearance> clearances;  ///< as the files have them
  std::vector<CellSignal> signals;        ///< as the files have them
  CellScene scene;
  /// The file that declares decoders of what its machines send (docs/decoders.md); empty: none.
  std::filesystem::path decoders;
  Findings faults;  ///< of the cell and all files that it names
  /// Every file that was read, for attaching and hashing; sorted.
  std::vector<std::filesystem::path> files;
  /// For a cell from a log: keeps the folder of `files` while they are needed, and the name that
  /// users know it by, each with a trailing `/`.
  std::shared_ptr<const void> keeps_files;
  std::string files_below, files_shown_as;
  /// Pictures at hand without their files, by Material::diffuse_map: PNGs in `keeps_pictures`. Of a
  /// baked cell (docs/baked-cell.md); otherwise empty.
  std::map<std::filesystem::path, ByteView> pictures;
  std::shared_ptr<const void> keeps_pictures;
  /// Key into `models`: of devices that packets alone tell of. Empty: such devices are not shown.
  std::string bare_model;

  /// The model of a device with its appearance; null when it could not be read.
  const Model* modelOf(const CellDevice& device) const;
  const CellDevice* findDevice(std::string_view name) const;
  const CellCamera* findCamera(std::string_view name) const;
  /// `text` with files named as users know them: they may be in a temporary folder.
  std::string shown(std::string text) const;
};

struct CellOptions : ModelSearch {
  bool geometry = true;  ///< false: kinematics only, no mesh is opened (check without GL is fast)
  /// Reads meshes on several threads; empty: one after the other. The result and the order of
  /// faults do not depend on it. Any of the threads may call `answers`.
  ParallelFor parallel;
  TellLoadProgress progress;       ///< of the meshes; may be empty
  bool strict = false;             ///< an error when any fault is one
  FileLookups* lookups = nullptr;  ///< borrowed: receives every root and name that is looked for
  SearchFacts* facts = nullptr;    ///< borrowed: receives what the search asked the file system
  FileAnswers answers;             ///< resolves names instead of searching; roots are then ignored
};

/// Loads a *.cell.toml, or a bare .urdf, .obj or .stl as a cell of one device named after the file.
/// Faults are listed in the cell, and everything valid is loaded; an error only when nothing is
/// valid (the file is missing or not a cell).
Result<Cell> loadCell(const std::filesystem::path& path, const CellOptions& options);

/// A cell from the bytes of a *.cell.toml; `path` names them, and names in them are looked for in
/// its folder. Does not open `path` itself.
Result<Cell> readCell(ByteView bytes, const std::filesystem::path& path,
                      const CellOptions& options);

}  // namespace rocinante
