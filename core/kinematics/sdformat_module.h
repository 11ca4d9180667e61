#pragma once

#include <stddef.h>
#include <stdint.h>

// The C interface of librocinante_sdformat.so: the module is loaded with dlopen and shares no C++
// with the program. Metres and radians; texts are borrowed for the call.

#define ROCINANTE_SDF_ABI 2

extern "C" {

struct RocinanteSdfPose {
  double position[3];
  double quaternion[4];  ///< x y z w
};

struct RocinanteSdfJoint {
  const char *name, *parent, *child;  ///< a parent "world" is not a link
  /// SDF's word: "revolute", "ball" ...
  const char* type;
  struct RocinanteSdfPose in_model;
  double axis[3];  ///< in the joint's space
  double lower, upper, velocity, effort;
};

/// Display values from 0 to 1 with opacity; `has_` says which the file has.
struct RocinanteSdfMaterial {
  int32_t has_ambient, has_diffuse, has_emissive;
  float ambient[4], diffuse[4], emissive[4];
  const char* script;  ///< name; empty: none
};

struct RocinanteSdfShape {
  int32_t is_collision;
  const char* name;
  struct RocinanteSdfPose in_link;
  /// "box" (size: its sides), "sphere" (radius), "cylinder" and "capsule" (radius, length), "mesh"
  /// (size: its scale), or another kind that is not drawn.
  const char* kind;
  double size[3];
  const char *uri, *submesh;  ///< of a mesh; empty: the whole mesh
  int32_t center_submesh;
  int32_t line;  ///< 0: unknown
  double transparency;
  const struct RocinanteSdfMaterial* material;  ///< null: none
};

/// Callbacks for the contents of the file, in its order; shapes follow their link. What is in a
/// model inside the first one has a name with the inner model's in front, "hand::palm", and is
/// placed in the outer model.
struct RocinanteSdfSink {
  void* to;
  void (*fault)(void* to, int32_t line, const char* sentence);
  void (*model)(void* to, const char* name);  ///< each; links and joints of the first only
  void (*link)(void* to, const char* name, const struct RocinanteSdfPose* in_model);
  void (*shape)(void* to, const struct RocinanteSdfShape* shape);
  void (*joint)(void* to, const struct RocinanteSdfJoint* joint);
};

/// rocinante_sdf_abi: ROCINANTE_SDF_ABI of the module's build; others are not used.
typedef int (*RocinanteSdfAbi)(void);
/// rocinante_sdf_version: the newest version of the format that it reads, "1.9".
typedef const char* (*RocinanteSdfVersion)(void);
/// rocinante_sdf_read: `text` ends in a zero. Opens no file. One thread at a time.
typedef void (*RocinanteSdfRead)(const char* text, const struct RocinanteSdfSink* sink);

}  // extern "C"
