#include "core/foreign/foxglove/foxglove_format.h"

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "core/foreign/bytes/little_endian.h"
#include "core/foreign/foxglove/signal_topics.h"
#include "core/foreign/proto/proto_schema.h"
#include "core/foreign/proto/proto_writer.h"

namespace rocinante {
namespace {

/// Whole, though most primitives are never written: readers expect every field of an entity.
constexpr ProtoMessage kFoxgloveMessages[] = {
    {"Vector3", "double x=1; double y=2; double z=3", ""},
    {"Quaternion", "double x=1; double y=2; double z=3; double w=4", ""},
    {"Pose", "Vector3 position=1; Quaternion orientation=2", ""},
    {"Point3", "double x=1; double y=2; double z=3", ""},
    {"Color", "double r=1; double g=2; double b=3; double a=4", ""},
    {"KeyValuePair", "string key=1; string value=2", ""},
    {"FrameTransform",
     "Timestamp timestamp=1; string parent_frame_id=2; string child_frame_id=3; "
     "Vector3 translation=4; Quaternion rotation=5",
     ""},
    {"FrameTransforms", "repeated FrameTransform transforms=1", ""},
    {"JointState",
     "string name=1; optional double position=2; optional double velocity=3; "
     "optional double acceleration=4; optional double effort=5",
     ""},
    {"JointStates", "Timestamp timestamp=1; repeated JointState joints=2", ""},
    {"Log",
     "Timestamp timestamp=1; Level level=2; string message=3; string name=4; string "
     "file=5; fixed32 line=6",
     "Level UNKNOWN=0 DEBUG=1 INFO=2 WARNING=3 ERROR=4 FATAL=5"},
    {"PackedElementField", "string name=1; fixed32 offset=2; NumericType type=3",
     "NumericType UNKNOWN=0 UINT8=1 INT8=2 UINT16=3 INT16=4 UINT32=5 INT32=6 "
     "FLOAT32=7 FLOAT64=8"},
    {"PointCloud",
     "Timestamp timestamp=1; string frame_id=2; Pose pose=3; fixed32 point_stride=4; "
     "repeated PackedElementField fields=5; bytes data=6",
     ""},
    {"ArrowPrimitive",
     "Pose pose=1; double shaft_length=2; double shaft_diameter=3; double "
     "head_length=4; double head_diameter=5; Color color=6",
     ""},
    {"CubePrimitive", "Pose pose=1; Vector3 size=2; Color color=3", ""},
    {"SpherePrimitive", "Pose pose=1; Vector3 size=2; Color color=3", ""},
    {"CylinderPrimitive",
     "Pose pose=1; Vector3 size=2; double bottom_scale=3; double top_scale=4; Color "
     "color=5",
     ""},
    {"LinePrimitive",
     "Type type=1; Pose pose=2; double thickness=3; bool scale_invariant=4; repeated "
     "Point3 points=5; Color color=6; repeated Color colors=7; repeated fixed32 "
     "indices=8",
     "Type LINE_STRIP=0 LINE_LOOP=1 LINE_LIST=2"},
    {"TriangleListPrimitive",
     "Pose pose=1; repeated Point3 points=2; Color color=3; repeated Color colors=4; "
     "repeated fixed32 indices=5",
     ""},
    {"TextPrimitive",
     "Pose pose=1; bool billboard=2; double font_size=3; bool scale_invariant=4; "
     "Color color=5; string text=6",
     ""},
    {"ModelPrimitive",
     "Pose pose=1; Vector3 scale=2; Color color=3; bool override_color=4; string "
     "url=5; string media_type=6; bytes data=7",
     ""},
    {"SceneEntityDeletion", "Timestamp timestamp=1; Type type=2; string id=3",
     "Type MATCHING_ID=0 ALL=1"},
    {"SceneEntity",
     "Timestamp timestamp=1; string frame_id=2; string id=3; Duration lifetime=4; "
     "bool frame_locked=5; repeated KeyValuePair metadata=6; repeated ArrowPrimitive "
     "arrows=7; repeated CubePrimitive cubes=8; repeated SpherePrimitive spheres=9; "
     "repeated CylinderPrimitive cylinders=10; repeated LinePrimitive lines=11; "
     "repeated TriangleListPrimitive triangles=12; repeated TextPrimitive texts=13; "
     "repeated ModelPrimitive models=14",
     ""},
    {"SceneUpdate", "repeated SceneEntityDeletion deletions=1; repeated SceneEntity entities=2",
     ""},
};

MessageSchema madeSchema(std::string_view name) {
  return {"foxglove." + std::string(name), "protobuf",
          fileDescriptorSet("foxglove", kFoxgloveMessages, name), "protobuf"};
}

// Field numbers are those of the schemas above.

void putTime(ProtoWriter& out, std::uint32_t field, LogTime time) {
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  const std::int64_t all = nanosecondsOf(time);
  // Timestamp wants nanos of 0 to 999,999,999 before 1970, too.
  const std::int64_t nanos = ((all % kNanoseconds) + kNanoseconds) % kNanoseconds;
  out.message(field, [&](ProtoWriter& stamp) {
    stamp.number(1, static_cast<std::uint64_t>((all - nanos) / kNanoseconds));
    stamp.number(2, static_cast<std::uint64_t>(nanos));
  });
}

void putVector(ProtoWriter& out, std::uint32_t field, const Vec3& vector) {
  out.message(field, [&](ProtoWriter& of) {
    of.real(1, vector.x);
    of.real(2, vector.y);
    of.real(3, vector.z);
  });
}

void putRotation(ProtoWriter& out, std::uint32_t field, const Quat& rotation) {
  out.message(field, [&](ProtoWriter& of) {
    of.real(1, rotation.x);
    of.real(2, rotation.y);
    of.real(3, rotation.z);
    of.real(4, rotation.w);
  });
}

void putPose(ProtoWriter& out, std::uint32_t field, const Pose& pose) {
  out.message(field, [&](ProtoWriter& of) {
    putVector(of, 1, pose.position);
    putRotation(of, 2, pose.orientation);
  });
}

void putColor(ProtoWriter& out, std::uint32_t field, std::uint32_t rgba) {
  out.message(field, [&](ProtoWriter& of) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      of.real(i + 1, static_cast<double>(rgba >> (24 - 8 * i) & 0xFFU) / 255);
    }
  });
}

void putLine(ProtoWriter& entity, const Drawing& drawing) {
  for (const std::vector<double>& run : connectedRuns(drawing)) {
    entity.message(11, [&](ProtoWriter& line) {
      putPose(line, 2, {});
      line.real(3, drawing.size_px);
      line.number(4, 1);  // the thickness is in pixels
      for (std::size_t i = 0; i + 2 < run.size(); i += 3) {
        putVector(line, 5, {run[i], run[i + 1], run[i + 2]});
      }
      putColor(line, 6, drawing.rgba);
    });
  }
}

void putLabel(ProtoWriter& entity, const Drawing& drawing) {
  constexpr double kTextPixels = 14;
  const std::vector<std::vector<double>> runs = connectedRuns(drawing);
  if (runs.empty() || runs[0].size() < 3) return;
  entity.message(13, [&](ProtoWriter& label) {
    putPose(label, 1, {{runs[0][0], runs[0][1], runs[0][2]}, Quat(1, 0, 0, 0)});
    label.number(2, 1);  // faces the reader
    label.real(3, kTextPixels);
    label.number(4, 1);  // in pixels
    putColor(label, 5, drawing.rgba);
    label.text(6, drawing.text);
  });
}

/// Of all entities of the topic that are not in this message.
void putDeletion(ProtoWriter& update, LogTime time) {
  update.message(1, [&](ProtoWriter& deletion) {
    putTime(deletion, 1, time);
    deletion.number(2, 1);  // ALL
  });
}

std::string frameOf(const Drawing& drawing) {
  return frameName(drawing.carrier.first, drawing.carrier.second);
}

class FoxgloveFormat final : public SessionFormat {
 public:
  explicit FoxgloveFormat(SignalMessages messages) : signal_messages_(messages) {}

  std::string profile() const override { return ""; }
  Nanoseconds framesLast() const override { return {}; }

  Status frames(MessageSink& out, LogTime time, const std::string& device,
                std::span<const FramePose> frames) override {
    message_.clear();
    ProtoWriter writer(message_);
    for (const FramePose& frame : frames) {
      writer.message(1, [&](ProtoWriter& of) {
        putTime(of, 1, time);
        of.text(2, frame.parent);
        of.text(3, frame.child);
        putVector(of, 4, frame.pose.position);
        putRotation(of, 5, frame.pose.orientation);
      });
    }
    return out.write(topicOf("/tf", device), foxgloveSchema("FrameTransforms"), time, message_);
  }

  Status joints(MessageSink& out, LogTime time, const std::string& device,
                std::span<const NamedValue> values) override {
    message_.clear();
    ProtoWriter writer(message_);
    putTime(writer, 1, time);
    for (const NamedValue& value : values) {
      writer.message(2, [&](ProtoWriter& of) {
        of.text(1, value.name);
        of.presentReal(2, value.value);
        if (!std::isnan(value.velocity)) of.presentReal(3, value.velocity);
        if (!std::isnan(value.effort)) of.presentReal(5, value.effort);
      });
    }
    return out.write(topicOf("/joints", device), foxgloveSchema("JointStates"), time, message_);
  }

  Status drawings(MessageSink& out, LogTime time, const std::string& source,
                  const Drawings& drawings) override {
    message_.clear();
    ProtoWriter writer(message_);
    putDeletion(writer, time);
    std::set<std::string> clouds;
    for (const auto& named : drawings) {
      const auto& id = named.first;
      const auto& drawing = named.second;
      if (drawing->kind == StatementKind::points) {
        clouds.insert(id);
        continue;
      }
      writer.message(2, [&](ProtoWriter& entity) {
        putTime(entity, 1, time);
        entity.text(2, frameOf(*drawing));
        entity.text(3, id);
        entity.number(5, 1);  // moves with its space
        drawing->kind == StatementKind::label ? putLabel(entity, *drawing)
                                              : putLine(entity, *drawing);
      });
    }
    // A source of clouds alone has no scene.
    if (drawings.size() > clouds.size() || scenes_.contains(source)) {
      scenes_.insert(source);
      Status written =
          out.write(topicOf("/drawings", source), foxgloveSchema("SceneUpdate"), time, message_);
      if (!written) return written;
    }
    for (const auto& [id, drawing] : drawings) {
      if (drawing->kind != StatementKind::points) continue;
      if (Status written = cloud(out, time, source, id, drawing); !written) return written;
    }
    // What is gone becomes an empty cloud: points have no other way to end.
    std::set<std::string>& former = clouds_[source];
    for (const std::string& id : former) {
      if (clouds.contains(id)) continue;
      if (Status written = cloud(out, time, source, id, nullptr); !written) return written;
    }
    former = std::move(clouds);
    return {};
  }

  bool knowSignals(const KnownSignals& known) override {
    signals_.know(known);
    return true;
  }

  bool requestsAllSignals() const override { return signal_messages_ == SignalMessages::whole; }

  Status signals(MessageSink& out, LogTime time, const SignalOwner& owner,
                 std::span<const StatedSignal> signals, bool all_requested) override {
    return signals_.write(out, time, owner, signals, all_requested || requestsAllSignals());
  }

  void addLeftOut(Account& account) const override { account.add(signals_.leftOut()); }

  Status event(MessageSink& out, LogTime time, EventLevel level, std::string_view name,
               std::string_view text) override {
    constexpr std::uint64_t kInfo = 2;
    constexpr std::uint64_t kWarning = 3;
    constexpr std::uint64_t kError = 4;
    message_.clear();
    ProtoWriter writer(message_);
    putTime(writer, 1, time);
    writer.number(2, level == EventLevel::error     ? kError
                     : level == EventLevel::warning ? kWarning
                                                    : kInfo);
    writer.text(3, text);
    writer.text(4, name);
    return out.write("/events", foxgloveSchema("Log"), time, message_);
  }

  Status shapes(MessageSink& out, LogTime time, const std::string& device,
                std::span<const LinkShape> shapes) override {
    message_.clear();
    ProtoWriter writer(message_);
    putDeletion(writer, time);
    for (const LinkShape& shape : shapes) {
      writer.message(2, [&](ProtoWriter& entity) {
        putTime(entity, 1, time);
        entity.text(2, shape.frame);
        entity.text(3, shape.frame);
        entity.number(5, 1);  // moves with its space
        entity.message(14, [&](ProtoWriter& model) {
          putPose(model, 1, {});
          putVector(model, 2, {1, 1, 1});
          model.text(6, "model/gltf-binary");
          model.bytes(7, *shape.glb);
        });
      });
    }
    return out.write(topicOf("/model", device), foxgloveSchema("SceneUpdate"), time, message_);
  }

  Status description(MessageSink&, LogTime, const std::string&, std::string_view) override {
    return {};  // it is an attachment
  }

 private:
  Status cloud(MessageSink& out, LogTime time, const std::string& source, const std::string& id,
               const Drawing* drawing) {
    constexpr std::uint32_t kStride = 28;  // x y z as doubles, then four bytes of colour
    constexpr std::uint32_t kUint8 = 1;
    constexpr std::uint32_t kFloat64 = 8;
    Bytes points;
    if (drawing != nullptr) {
      for (const std::vector<double>& run : connectedRuns(*drawing)) {
        for (std::size_t i = 0; i + 2 < run.size(); i += 3) {
          for (std::size_t axis = 0; axis < 3; ++axis) appendLittle(points, run[i + axis]);
          for (std::uint32_t byte = 0; byte < 4; ++byte) {
            points.push_back(static_cast<std::byte>(drawing->rgba >> (24 - 8 * byte)));
          }
        }
      }
    }
    message_.clear();
    ProtoWriter writer(message_);
    putTime(writer, 1, time);
    writer.text(2, drawing == nullptr ? std::string(kWorldFrame) : frameOf(*drawing));
    putPose(writer, 3, {});
    writer.fixed32(4, kStride);
    const auto field = [&](std::string_view name, std::uint32_t offset, std::uint32_t type) {
      writer.message(5, [&](ProtoWriter& of) {
        of.text(1, name);
        of.fixed32(2, offset);
        of.number(3, type);
      });
    };
    field("x", 0, kFloat64);
    field("y", 8, kFloat64);
    field("z", 16, kFloat64);
    field("red", 24, kUint8);
    field("green", 25, kUint8);
    field("blue", 26, kUint8);
    field("alpha", 27, kUint8);
    writer.bytes(6, points);
    return out.write(topicOf(topicOf("/points", source), id), foxgloveSchema("PointCloud"), time,
                     message_);
  }

  Bytes message_;
  SignalMessages signal_messages_;
  SignalTopics signals_;
  std::set<std::string> scenes_;                         ///< sources with /drawings
  std::map<std::string, std::set<std::string>> clouds_;  ///< by source: ids of the last message
};

}  // namespace

const MessageSchema& foxgloveSchema(std::string_view name) {
  static const std::map<std::string, MessageSchema, std::less<>> kSchemas = [] {
    std::map<std::string, MessageSchema, std::less<>> schemas;
    for (const std::string_view each :
         {"FrameTransforms", "JointStates", "SceneUpdate", "PointCloud", "Log"}) {
      schemas.emplace(each, madeSchema(each));
    }
    return schemas;
  }();
  return kSchemas.find(name)->second;
}

std::unique_ptr<SessionFormat> makeFoxgloveFormat(SignalMessages signals) {
  return std::make_unique<FoxgloveFormat>(signals);
}

}  // namespace rocinante
