#include "viewer/bake/bake_cell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "core/base/hash.h"
#include "core/cell/posed_scene.h"
#include "tests/viewer/bake/full_cell.h"
#include "viewer/bake/baked_guard.h"
#include "viewer/picture/picture.h"

namespace rocinante {
namespace {

using test::fullCell;
using test::fullModel;

Result<Cell> readBytes(const Bytes& bytes) {
  const auto keeps = std::make_shared<const Bytes>(bytes);
  const auto file = BakedFile::parse(*keeps, "baked");
  if (!file.ok()) return file.error();
  return readBakedCell(*file, keeps);
}

Bytes withoutPictures(const Cell& cell) {
  BakeOptions options;
  options.pictures = false;
  return bakeCell(cell, options);
}

TEST(BakeCellTest, GivesBackEveryField) {
  const Cell cell = fullCell();
  const Bytes bytes = withoutPictures(cell);
  const auto read = readBytes(bytes);
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(withoutPictures(*read), bytes);

  EXPECT_EQ(read->models.size(), 3U);
  const Model& model = *read->models.at("arm");
  EXPECT_EQ(read->models.at("arm.urdf").get(), &model) << "shared as before";
  EXPECT_EQ(read->models.at("unusable"), nullptr);
  EXPECT_EQ(model.links[0].visuals[0].mesh, model.links[1].collisions[0].mesh);
  EXPECT_EQ(model.joints[0].origin.position.x, 1.0 / 3);
  EXPECT_EQ(model.joints[1].mimic->multiplier, -2);
  const Mesh& mesh = *model.links[0].visuals[0].mesh;
  EXPECT_TRUE(std::signbit(mesh.vertices[2].position.z)) << "the bits of a vertex";
  EXPECT_EQ(mesh.parts[1].group, "back");
  EXPECT_EQ(*mesh.materials[0].diffuse_bytes, (Bytes{std::byte{1}, std::byte{2}}));
  EXPECT_EQ(mesh.materials[0].diffuse_bytes, model.links[0].visuals[0].material->diffuse_bytes);
  EXPECT_EQ(mesh.shape, (ShapeSize{ShapeSize::Kind::capsule, {0.1, 0.1, 0.3}}));
  EXPECT_EQ(read->insets, cell.insets);
  EXPECT_EQ(read->layers[0].members, cell.layers[0].members);
  EXPECT_EQ(read->devices[0].pose, cell.devices[0].pose);
  EXPECT_EQ(read->findDevice("left"), &read->devices[0]);
  EXPECT_EQ(read->faults[0].print(), cell.faults[0].print());
  EXPECT_EQ(read->files, cell.files);
}

/// Each change of one field of the full cell must change the baked bytes: no field is forgotten. A
/// field that is added to a struct does not compile until it is baked (cell_fields.h); add it here.
TEST(BakeCellTest, EveryFieldIsBaked) {
  using Change = std::function<void(Cell&)>;
  const auto model = [](auto change) -> Change {
    return [change](Cell& cell) {
      Model changed = fullModel();
      change(changed);
      cell.models["arm"] = std::make_shared<const Model>(changed);
    };
  };
  const auto mesh = [&](auto change) {
    return model([change](Model& changed) {
      Mesh other = *changed.links[0].visuals[0].mesh;
      change(other);
      changed.links[0].visuals[0].mesh = std::make_shared<const Mesh>(other);
    });
  };
  const auto painted = [&](auto change) {
    return mesh([change](Mesh& changed) { change(changed.materials[0]); });
  };
  const auto joint = [&](auto change) {
    return model([change](Model& changed) { change(changed.joints[0]); });
  };
  const auto visual = [&](auto change) {
    return model([change](Model& changed) { change(changed.links[0].visuals[0]); });
  };
  const std::vector<Change> changes{
      painted([](Material& m) { m.name = "x"; }),
      painted([](Material& m) { m.diffuse.w = 0; }),
      painted([](Material& m) { m.specular.y = 0; }),
      painted([](Material& m) { m.emission.z = 0; }),
      painted([](Material& m) { m.shininess = 0; }),
      painted([](Material& m) { m.diffuse_map = "x"; }),
      painted([](Material& m) { m.missing_map = "x"; }),
      painted([](Material& m) { m.diffuse_bytes = nullptr; }),
      painted([](Material& m) { m.map_scale.y = 0; }),
      painted([](Material& m) { m.map_offset.x = 0; }),
      painted([](Material& m) { m.map_rotation = 0; }),
      painted([](Material& m) { m.wrap_u = TextureWrap::repeat; }),
      painted([](Material& m) { m.wrap_v = TextureWrap::repeat; }),
      painted([](Material& m) { m.alpha_mode = AlphaMode::opaque; }),
      painted([](Material& m) { m.alpha_cutoff = 0; }),
      mesh([](Mesh& m) { m.vertices[0].normal.x = 1; }),
      mesh([](Mesh& m) { m.vertices[0].texture.y = 1; }),
      mesh([](Mesh& m) { m.indices[0] = 1; }),
      mesh([](Mesh& m) { m.colors[0] = 1; }),
      mesh([](Mesh& m) { m.parts[0].group = "x"; }),
      mesh([](Mesh& m) { m.parts[0].material = 1; }),
      mesh([](Mesh& m) { m.parts[0].first_index = 3; }),
      mesh([](Mesh& m) { m.parts[0].index_count = 6; }),
      mesh([](Mesh& m) { m.materials.emplace_back(); }),
      mesh([](Mesh& m) { m.bounds.min.z = -1; }),
      mesh([](Mesh& m) { m.bounds.max.z = 1; }),
      mesh([](Mesh& m) { m.shape->kind = ShapeSize::Kind::box; }),
      mesh([](Mesh& m) { m.shape->size[2] = 1; }),
      joint([](Joint& j) { j.name = "x"; }),
      joint([](Joint& j) { j.type = JointType::prismatic; }),
      joint([](Joint& j) { j.origin.position.y = 1; }),
      joint([](Joint& j) { j.origin.orientation.w = 1; }),
      joint([](Joint& j) { j.axis.z = 1; }),
      joint([](Joint& j) { j.limits->lower = 0; }),
      joint([](Joint& j) { j.limits->upper = 0; }),
      joint([](Joint& j) { j.limits->velocity.reset(); }),
      joint([](Joint& j) { j.limits->effort = 0; }),
      model([](Model& m) { m.joints[1].mimic->multiplier = 0; }),
      model([](Model& m) { m.joints[1].mimic->offset = 0; }),
      model([](Model& m) { m.joints[1].mimic->joint = 1; }),
      model([](Model& m) { m.joints[1].parent = 0; }),
      model([](Model& m) { m.joints[1].child = 0; }),
      visual([](Visual& v) { v.name = "x"; }),
      visual([](Visual& v) { v.origin.position.x = 0; }),
      visual([](Visual& v) { v.scale.x = 2; }),
      visual([](Visual& v) { v.mesh = nullptr; }),
      visual([](Visual& v) { v.mesh_parts = {}; }),
      visual([](Visual& v) { v.material.reset(); }),
      model([](Model& m) { m.name = "x"; }),
      model([](Model& m) { m.file = "x"; }),
      model([](Model& m) { m.links[0].name = "x"; }),
      model([](Model& m) { m.links[1].parent_joint = 1; }),
      model([](Model& m) { m.links[1].collisions.clear(); }),
      model([](Model& m) { m.root = 1; }),
      model([](Model& m) {
        m.update_order = {1, 0};
      }),
      model([](Model& m) { m.link_by_name.clear(); }),
      model([](Model& m) { m.joint_by_name.clear(); }),
      [](Cell& c) { c.file = "x"; },
      [](Cell& c) { c.devices[0].name = "x"; },
      [](Cell& c) { c.devices[0].model = "x"; },
      [](Cell& c) { c.devices[0].pose.position.x = 0; },
      [](Cell& c) { c.devices[0].layer = "x"; },
      [](Cell& c) { c.devices[0].tags = {}; },
      [](Cell& c) { c.devices[0].optional = false; },
      [](Cell& c) { c.devices[0].on_device = "x"; },
      [](Cell& c) { c.devices[0].on_link = "x"; },
      [](Cell& c) { c.devices[0].color.reset(); },
      [](Cell& c) { c.devices[0].dressed = nullptr; },
      [](Cell& c) { c.device_by_name.clear(); },
      [](Cell& c) { c.models.erase("unusable"); },
      [](Cell& c) { c.cameras[0].name = "x"; },
      [](Cell& c) { c.cameras[0].eye.x = 0; },
      [](Cell& c) { c.cameras[0].target.x = 0; },
      [](Cell& c) { c.cameras[0].up.x = 1; },
      [](Cell& c) { c.cameras[0].fov_deg = 1; },
      [](Cell& c) { c.cameras[0].ortho_height_m.reset(); },
      [](Cell& c) { c.cameras[0].on_device = "x"; },
      [](Cell& c) { c.cameras[0].on_link = "x"; },
      [](Cell& c) { c.cameras[0].follow_device = "x"; },
      [](Cell& c) { c.cameras[0].follow_link = "x"; },
      [](Cell& c) { c.cameras[0].look_device = "x"; },
      [](Cell& c) { c.cameras[0].look_link = "x"; },
      [](Cell& c) { c.cameras[0].intrinsics.reset(); },
      [](Cell& c) { c.cameras[0].intrinsics->fx = 1; },
      [](Cell& c) { c.cameras[0].intrinsics->fy = 1; },
      [](Cell& c) { c.cameras[0].intrinsics->cx = 1; },
      [](Cell& c) { c.cameras[0].intrinsics->cy = 1; },
      [](Cell& c) { c.cameras[0].intrinsics->width = 1; },
      [](Cell& c) { c.cameras[0].intrinsics->height = 1; },
      [](Cell& c) { c.cameras[0].distortion.k1 = 1; },
      [](Cell& c) { c.cameras[0].distortion.k2 = 1; },
      [](Cell& c) { c.cameras[0].distortion.p1 = 1; },
      [](Cell& c) { c.cameras[0].distortion.p2 = 1; },
      [](Cell& c) { c.cameras[0].distortion.k3 = 1; },
      [](Cell& c) { c.insets[0].camera = "x"; },
      [](Cell& c) { c.insets[0].corner = InsetCorner::top_left; },
      [](Cell& c) { c.insets[0].width = 1; },
      [](Cell& c) { c.insets[0].height = 1; },
      [](Cell& c) { c.insets[0].in_pixels = false; },
      [](Cell& c) { c.insets[0].margin_px = 1; },
      [](Cell& c) { c.insets[0].title.reset(); },
      [](Cell& c) { c.insets[0].border_px = 1; },
      [](Cell& c) { c.insets[0].border_rgba = 1; },
      [](Cell& c) { c.layers[0].name = "x"; },
      [](Cell& c) { c.layers[0].visible = true; },
      [](Cell& c) { c.layers[0].members[0].device = "x"; },
      [](Cell& c) { c.layers[0].members[0].link = "x"; },
      [](Cell& c) { c.layers[0].members[0].group = "x"; },
      [](Cell& c) { c.layers[0].look.wireframe = false; },
      [](Cell& c) { c.layers[0].look.opacity.reset(); },
      [](Cell& c) { c.layers[0].look.collision = CollisionLook::off; },
      [](Cell& c) { c.sources[0].name = "x"; },
      [](Cell& c) { c.sources[0].rate_hz->second = 0; },
      [](Cell& c) { c.sources[0].limits.silence_s.reset(); },
      [](Cell& c) { c.sources[0].limits.restate_s = 0; },
      [](Cell& c) { c.sources[0].limits.clock_skew_s = 0; },
      [](Cell& c) { c.sources[0].limits.jitter_ms = 0; },
      [](Cell& c) { c.sources[0].devices = {}; },
      [](Cell& c) { c.sources[0].ghost_of = {}; },
      [](Cell& c) { c.rules[0].id = "x"; },
      [](Cell& c) { c.rules[0].is_off = false; },
      [](Cell& c) { c.rules[0].severity.reset(); },
      [](Cell& c) { c.rules[0].threshold_key = "x"; },
      [](Cell& c) { c.rules[0].threshold = 0; },
      [](Cell& c) { c.rules[0].own_thresholds = {}; },
      [](Cell& c) { c.rules[0].own_thresholds["arm"].key = "x"; },
      [](Cell& c) { c.rules[0].own_thresholds["arm"].value = 0; },
      [](Cell& c) { c.rules[0].file = "x"; },
      [](Cell& c) { c.rules[0].line = 0; },
      [](Cell& c) { c.rules[0].column = 0; },
      [](Cell& c) { c.clearances[0].name = "x"; },
      [](Cell& c) { c.clearances[0].between.second = "x"; },
      [](Cell& c) { c.clearances[0].is_self = false; },
      [](Cell& c) { c.clearances[0].min_m = 0; },
      [](Cell& c) { c.clearances[0].except = {}; },
      [](Cell& c) { c.scene.background_top.x = 0; },
      [](Cell& c) { c.scene.background_bottom.x = 0; },
      [](Cell& c) { c.scene.light_direction.x = 0; },
      [](Cell& c) { c.scene.lights[0].direction.x = 0; },
      [](Cell& c) { c.scene.lights[0].color.x = 0; },
      [](Cell& c) { c.scene.lights[0].strength = 0; },
      [](Cell& c) { c.scene.grid = true; },
      [](Cell& c) { c.scene.grid_size_m = 1; },
      [](Cell& c) { c.scene.grid_step_m = 1; },
      [](Cell& c) { c.decoders = "x"; },
      [](Cell& c) { c.faults[0].rule = "x"; },
      [](Cell& c) { c.faults[0].severity = Severity::note; },
      [](Cell& c) { c.faults[0].text = "x"; },
      [](Cell& c) { c.faults[0].hint = "x"; },
      [](Cell& c) { c.faults[0].file = "x"; },
      [](Cell& c) { c.faults[0].line = 0; },
      [](Cell& c) { c.faults[0].column = 0; },
      [](Cell& c) { c.faults[0].byte.reset(); },
      [](Cell& c) { c.faults[0].count = 1; },
      [](Cell& c) { c.faults[0].subject = "x"; },
      [](Cell& c) { c.faults[0].example = "x"; },
      [](Cell& c) { c.faults[0].accepted = false; },
      [](Cell& c) { c.files.pop_back(); },
      [](Cell& c) { c.files_below = "x"; },
      [](Cell& c) { c.files_shown_as = "x"; },
  };
  const Bytes whole = withoutPictures(fullCell());
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Cell changed = fullCell();
    changes[i](changed);
    EXPECT_NE(withoutPictures(changed), whole) << "change " << i << " is not baked";
  }
}

TEST(BakeCellTest, PicturesAreAtHandWithoutTheirFiles) {
  const Picture picture{2, 1, {1, 2, 3, 255, 4, 5, 6, 255}};
  Model model = fullModel();
  Mesh mesh = *model.links[0].visuals[0].mesh;
  mesh.materials[0].diffuse_bytes = std::make_shared<const Bytes>(encodePng(picture));
  mesh.materials[1].diffuse_map = "is/not/there.png";
  for (Link& link : model.links) {
    for (Visual& visual : link.visuals) {
      visual.material.reset();
      if (visual.mesh) visual.mesh = std::make_shared<const Mesh>(mesh);
    }
  }
  Cell cell;
  cell.models["arm"] = std::make_shared<const Model>(model);
  for (const bool compressed : {false, true}) {
    BakeOptions options;
    options.compressed = compressed;
    const auto read = readBytes(bakeCell(cell, options));
    ASSERT_TRUE(read.ok()) << read.error().text();
    ASSERT_EQ(read->pictures.size(), 1U) << "what cannot be decoded is left to the renderer";
    const auto decoded = decodePng(read->pictures.at("arm.glb#2"), "p");
    ASSERT_TRUE(decoded.ok());
    EXPECT_EQ(*decoded, picture);
    BakeOptions again;
    const auto twice = readBytes(bakeCell(*read, again));
    ASSERT_TRUE(twice.ok());
    EXPECT_EQ(twice->pictures.size(), 1U) << "a baked cell can be baked";
  }
}

TEST(BakeCellTest, AnyFlippedByteAndAnyCutIsSeen) {
  const Bytes whole = bakeCell(fullCell(), {});
  ASSERT_TRUE(readBytes(whole).ok());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    Bytes damaged = whole;
    damaged[i] ^= std::byte{16};
    ASSERT_FALSE(readBytes(damaged).ok()) << "byte " << i;
    ASSERT_FALSE(
        readBytes(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(i))).ok())
        << "cut at " << i;
  }
}

/// The same sections with one of them changed, and every checksum right.
Bytes forged(const Bytes& whole, std::size_t section, const std::function<void(Bytes&)>& change) {
  const auto file = BakedFile::parse(whole, "w");
  std::vector<BakedFile::Section> sections = file->sections();
  Bytes changed(sections[section].content.begin(), sections[section].content.end());
  change(changed);
  sections[section].content = changed;
  return bakedFile(file->key(), sections);
}

TEST(BakeCellTest, ForgedBytesNeverHarmWhoUsesTheCell) {
  const Bytes whole = bakeCell(fullCell(), {});
  const auto file = BakedFile::parse(whole, "w");
  ASSERT_TRUE(file.ok());
  std::size_t read_anyway = 0;
  for (std::size_t s = 0; s < file->sections().size(); ++s) {
    for (std::size_t i = 0; i < file->sections()[s].content.size(); ++i) {
      for (const std::byte value : {std::byte{0xFF}, std::byte{0}, std::byte{2}}) {
        const auto cell = readBytes(forged(whole, s, [&](Bytes& bytes) { bytes[i] = value; }));
        if (!cell.ok()) continue;
        ++read_anyway;
        poseScene(*cell, SessionState{});
        for (const auto& [name, model] : cell->models) {
          ASSERT_TRUE(!model || faultOfModel(*model) == nullptr);
        }
      }
      const auto cut = readBytes(forged(whole, s, [&](Bytes& bytes) { bytes.resize(i); }));
      ASSERT_FALSE(cut.ok()) << "section " << s << " cut at " << i;
    }
    ASSERT_FALSE(readBytes(forged(whole, s, [](Bytes& bytes) { bytes.emplace_back(); })).ok());
  }
  EXPECT_GT(read_anyway, 0U) << "a changed letter of a name is no fault";
}

TEST(BakeCellTest, FaultsAreNamed) {
  const auto faultAfter = [](const std::function<void(Model&)>& change) {
    Model model = fullModel();
    change(model);
    Cell cell;
    cell.models["arm"] = std::make_shared<const Model>(model);
    const auto read = readBytes(withoutPictures(cell));
    return read.ok() ? std::string() : read.error().text();
  };
  const std::string models = "in the baked cell's models: ";
  EXPECT_EQ(faultAfter([](Model&) {}), "");
  EXPECT_EQ(faultAfter([](Model& m) { m.root = 3; }),
            models + "the root is not a link of the model (baked)");
  EXPECT_EQ(faultAfter([](Model& m) { m.joints[0].parent = 7; }),
            models + "a joint without links (baked)");
  EXPECT_EQ(faultAfter([](Model& m) { m.joints[1].mimic->joint = 1; }),
            models + "joints that mimic each other (baked)");
  EXPECT_EQ(faultAfter([](Model& m) {
              m.update_order = {1, 0};
            }),
            models + "a joint that is updated before the one above it (baked)");
  EXPECT_EQ(faultAfter([](Model& m) { m.update_order = {0}; }),
            models + "joints that are not updated (baked)");
  EXPECT_EQ(faultAfter([](Model& m) { m.links[0].visuals[0].mesh_parts = {9}; }),
            models + "a part of no mesh (baked)");
  EXPECT_EQ(faultAfter([](Model& m) {
              Mesh mesh = *m.links[0].visuals[0].mesh;
              mesh.indices[4] = 3;
              m.links[0].visuals[0].mesh = std::make_shared<const Mesh>(mesh);
            }),
            "in the baked cell's meshes: an index past the vertices (baked)");
  EXPECT_EQ(faultAfter([](Model& m) {
              Mesh mesh = *m.links[0].visuals[0].mesh;
              mesh.vertices[1].position.y = std::numeric_limits<float>::quiet_NaN();
              m.links[0].visuals[0].mesh = std::make_shared<const Mesh>(mesh);
            }),
            "in the baked cell's meshes: a vertex that is not finite (baked)");
  EXPECT_EQ(faultAfter([](Model& m) { m.joints[0].axis.x = std::nan(""); }),
            "the baked cell's models break its format (baked)");
}

}  // namespace
}  // namespace rocinante
