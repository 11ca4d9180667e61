#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/cell/cell.h"
#include "core/kinematics/kinematics.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// A layer's membership of a device, a link or parts of it, besides PosedDevice::layer, in this
/// state.
struct PosedShare {
  std::string_view layer;           ///< borrowed from the cell
  std::optional<std::size_t> link;  ///< empty: all links
  std::string_view group;           ///< a pattern of MeshPart::group; empty: whole links
  bool visible = true;              ///< the layer is shown
  bool has_color = false;           ///< packets set a colour: `color` is valid
  bool recolors = false;            ///< and it is not `default`
  std::optional<std::uint32_t> color;
  LayerLook look;

  bool ofParts() const { return !group.empty(); }
  /// Whether it holds the whole link.
  bool holds(std::size_t of_link) const { return !ofParts() && (!link || *link == of_link); }
  /// Whether it holds parts, including that one.
  bool holdsPart(std::size_t of_link, std::string_view part_group) const;
};

/// A device of the cell, or one that `add` brought, with every link where the state puts it.
struct PosedDevice {
  std::string name;
  const Model* model = nullptr;
  Mat4 base{1.0};  ///< of the device's own space in the world
  Pose pose;       ///< of that space in its carrier's link; without one in the world
  std::string carrier, carrier_link;  ///< a device of the scene; empty: none, and its root link
  std::vector<Mat4> link_world;       ///< by link of the model
  /// By link: what is drawn. False for all links of a hidden device or layer.
  std::vector<bool> link_visible;
  std::vector<std::optional<std::uint32_t>> link_color;  ///< 0xRRGGBBAA; empty: materials' own
  std::string layer;
  bool visible = true;  ///< the device and its layer are shown; single links may still be hidden
  bool ghost = false;   ///< another source's device, drawn as a ghost (CellSource::ghost_of)
  bool bare = false;    ///< no cell describes it: Cell::bare_model
  bool placed = true;   ///< of a bare one: a pose of it in the world was stated
  std::vector<PosedShare> shares;    ///< further layers: its tags, then as the cell lists them
  bool has_parts = false;            ///< some of them hold parts, which are judged one by one
  std::vector<LayerLook> link_look;  ///< by link; empty: none has any
  /// By link, where layers have looks: whether packets set its colour, which overrides layer
  /// opacity.
  std::vector<bool> link_recolored;

  /// Whether the layer holds the link, be it with all of the device.
  bool inLayer(std::string_view wanted, std::size_t link) const;
  /// For a part of a link, by its group: the link's values, unless a layer holds the part.
  bool partVisible(std::size_t link, std::string_view group) const;
  std::optional<std::uint32_t> partColor(std::size_t link, std::string_view group) const;
  LayerLook partLook(std::size_t link, std::string_view group) const;
};

/// A drawing with its carrier resolved.
struct PosedDrawing {
  std::string source, id;
  const Drawing* drawing = nullptr;  ///< of the state; valid while the state is unchanged
  Mat4 to_world{1.0};
};

/// A camera of the cell or a `view` of the session where it is now: in the world.
struct PosedCamera {
  std::string name;
  Vec3 eye{}, target{}, up{0, 0, 1};
  double fov_deg = 45;                           ///< vertical
  std::optional<double> ortho_height_m;          ///< orthographic: metres from top to bottom
  bool of_session = false;                       ///< a `view`
  std::optional<CameraIntrinsics> intrinsics{};  ///< calibrated
};

/// The cell in one state: what the app stage hands to cull and draw. A plain value (but for the
/// borrowed model and drawing pointers).
struct PosedScene {
  std::vector<PosedDevice> devices;  ///< the cell's order, then added and bare ones, then ghosts
  std::vector<PosedDrawing> drawings;
  std::vector<PosedCamera> cameras;  ///< the cell's order, then the session's by name
  const PosedDevice* findDevice(std::string_view name) const;
  /// The session's outranks the cell's of the same name.
  const PosedCamera* findCamera(std::string_view name) const;
  /// World transform of DEVICE or DEVICE/LINK; empty when there is none.
  std::optional<Mat4> find(std::string_view device, std::string_view link) const;

  std::map<std::string, std::size_t, std::less<>> device_by_name;  ///< into devices
  bool has_looks = false;      ///< a layer has a look of its own for one of the devices
  bool has_collision = false;  ///< which is, that its collision geometry is drawn
};

/// Puts the cell into the state. World space is right-handed, z up, in metres. Pure. Unknown
/// devices and joints are left out (check reports them); a device with the wrong number of
/// positional values is drawn as if it had none; limits are not enforced, since a picture is
/// evidence. A carried device whose carrier is missing, or carries it in turn, is placed in the
/// world. Removed devices and optional ones that were not added are absent. Defined by
/// docs/cell-format.md, section "What is drawn".
PosedScene poseScene(const Cell& cell, const SessionState& state);

/// All joint values of a device in a state: positional ones, named ones over them, mimics last.
JointVector jointsOf(const Model& model, const DeviceState* state);

}  // namespace rocinante
