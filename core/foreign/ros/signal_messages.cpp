#include "core/foreign/ros/signal_messages.h"

#include <algorithm>

namespace rocinante::ros {
namespace {

using Field = SignalField;

constexpr Field kHeader{Wire::header, "header"};
constexpr Field kLinear{Wire::f64, "linear", "m/s", "xyz"};
constexpr Field kAngular{Wire::f64, "angular", "rad/s", "xyz"};
constexpr Field kLinearAcceleration{Wire::f64, "linear", "m/s2", "xyz"};
constexpr Field kAngularAcceleration{Wire::f64, "angular", "rad/s2", "xyz"};
constexpr Field kForce{Wire::f64, "force", "N", "xyz"};
constexpr Field kTorque{Wire::f64, "torque", "N.m", "xyz"};
constexpr Field kVector{Wire::f64, kWhole, "", "xyz"};
constexpr Field kPoint{Wire::f64, "point", "m", "xyz"};
constexpr Field kVariance{Wire::f64, "variance", "", "", FieldUse::covariance};
constexpr Field kLayout{Wire::layout, "layout"};

constexpr Field covariance(std::string_view name, std::uint32_t count) {
  return {Wire::f64, name, "", "", FieldUse::covariance, count};
}
constexpr Field confidence(std::string_view name) {
  return {Wire::f64, name, "", "", FieldUse::confidence, 9};
}
constexpr Field sequence(Wire wire, std::string_view name, std::string_view unit = "") {
  return {wire, name, unit, "", FieldUse::signal, kSequence};
}
constexpr Field oneOf(std::string_view name, std::string_view words) {
  return {Wire::u8, name, "", "", FieldUse::signal, 1, words};
}

constexpr Field kCharging =
    oneOf("power_supply_status", "unknown charging discharging not_charging full");
constexpr Field kHealth = oneOf("power_supply_health",
                                "unknown good overheat dead overvoltage unspecified_failure cold "
                                "watchdog_timer_expire safety_timer_expire");
constexpr Field kTechnology =
    oneOf("power_supply_technology", "unknown nimh lion lipo life nicd limn");
constexpr Field kRadiation = oneOf("radiation_type", "ultrasound infrared");

const std::vector<SignalMessage>& signalTable() {
  using enum Wire;
  static const std::vector<SignalMessage> kRows = {
      {"nav_msgs/Odometry",
       {kHeader,
        {text, "child_frame_id", "", "", FieldUse::frame},
        {f64, "position", "m", "xyz", FieldUse::elsewhere},
        {f64, "orientation", "", "xyzw", FieldUse::elsewhere},
        covariance("pose.covariance", 36),
        kLinear,
        kAngular,
        covariance("twist.covariance", 36)}},
      {"sensor_msgs/Imu",
       {kHeader,
        {f64, "orientation", "", "xyzw"},
        confidence("orientation_covariance"),
        {f64, "angular_velocity", "rad/s", "xyz"},
        confidence("angular_velocity_covariance"),
        {f64, "linear_acceleration", "m/s2", "xyz"},
        confidence("linear_acceleration_covariance")}},
      {"sensor_msgs/BatteryState",
       {kHeader,
        {f32, "voltage", "V"},
        {f32, "temperature", "degC"},
        {f32, "current", "A"},
        {f32, "charge", "Ah"},
        {f32, "capacity", "Ah"},
        {f32, "design_capacity", "Ah"},
        {f32, "percentage"},
        kCharging,
        kHealth,
        kTechnology,
        {boolean, "present"},
        sequence(f32, "cell_voltage", "V"),
        sequence(f32, "cell_temperature", "degC"),
        {text, "location"},
        {text, "serial_number"}}},
      {"sensor_msgs/BatteryState",
       {kHeader,
        {f32, "voltage", "V"},
        {f32, "current", "A"},
        {f32, "charge", "Ah"},
        {f32, "capacity", "Ah"},
        {f32, "design_capacity", "Ah"},
        {f32, "percentage"},
        kCharging,
        kHealth,
        kTechnology,
        {boolean, "present"},
        sequence(f32, "cell_voltage", "V"),
        {text, "location"},
        {text, "serial_number"}}},
      {"sensor_msgs/Temperature", {kHeader, {f64, "temperature", "degC"}, kVariance}},
      {"sensor_msgs/FluidPressure", {kHeader, {f64, "fluid_pressure", "Pa"}, kVariance}},
      {"sensor_msgs/RelativeHumidity", {kHeader, {f64, "relative_humidity"}, kVariance}},
      {"sensor_msgs/Illuminance", {kHeader, {f64, "illuminance", "lx"}, kVariance}},
      {"sensor_msgs/MagneticField",
       {kHeader, {f64, "magnetic_field", "T", "xyz"}, covariance("magnetic_field_covariance", 9)}},
      {"sensor_msgs/Range",
       {kHeader,
        kRadiation,
        {f32, "field_of_view", "rad"},
        {f32, "min_range", "m"},
        {f32, "max_range", "m"},
        {f32, "range", "m"},
        {f32, "variance", "", "", FieldUse::covariance}}},
      {"sensor_msgs/Range",
       {kHeader,
        kRadiation,
        {f32, "field_of_view", "rad"},
        {f32, "min_range", "m"},
        {f32, "max_range", "m"},
        {f32, "range", "m"}}},
      {"sensor_msgs/NavSatFix",
       {kHeader,
        {i8, "status"},
        {u16, "service"},
        {f64, "latitude", "deg"},
        {f64, "longitude", "deg"},
        {f64, "altitude", "m"},
        covariance("position_covariance", 9),
        {u8, "position_covariance_type", "", "", FieldUse::covariance}}},
      {"sensor_msgs/Joy",
       {kHeader, sequence(f32, "axes"), {i32, "buttons", "", "", FieldUse::boolean, kSequence}}},
      {"geometry_msgs/Wrench", {kForce, kTorque}},
      {"geometry_msgs/WrenchStamped", {kHeader, kForce, kTorque}},
      {"geometry_msgs/Twist", {kLinear, kAngular}},
      {"geometry_msgs/TwistStamped", {kHeader, kLinear, kAngular}},
      {"geometry_msgs/TwistWithCovarianceStamped",
       {kHeader, kLinear, kAngular, covariance("twist.covariance", 36)}},
      {"geometry_msgs/Accel", {kLinearAcceleration, kAngularAcceleration}},
      {"geometry_msgs/AccelStamped", {kHeader, kLinearAcceleration, kAngularAcceleration}},
      {"geometry_msgs/AccelWithCovarianceStamped",
       {kHeader, kLinearAcceleration, kAngularAcceleration, covariance("accel.covariance", 36)}},
      {"geometry_msgs/Vector3", {kVector}},
      {"geometry_msgs/Vector3Stamped", {kHeader, kVector}},
      {"geometry_msgs/PointStamped", {kHeader, kPoint}},
      {"std_msgs/Bool", {{boolean, kWhole}}},
      {"std_msgs/String", {{text, kWhole}}},
      {"std_msgs/Float32", {{f32, kWhole}}},
      {"std_msgs/Float64", {{f64, kWhole}}},
      {"std_msgs/Int8", {{i8, kWhole}}},
      {"std_msgs/Int16", {{i16, kWhole}}},
      {"std_msgs/Int32", {{i32, kWhole}}},
      {"std_msgs/Int64", {{i64, kWhole}}},
      {"std_msgs/UInt8", {{u8, kWhole}}},
      {"std_msgs/UInt16", {{u16, kWhole}}},
      {"std_msgs/UInt32", {{u32, kWhole}}},
      {"std_msgs/UInt64", {{u64, kWhole}}},
      {"std_msgs/Float32MultiArray", {kLayout, sequence(f32, kWhole)}},
      {"std_msgs/Float64MultiArray", {kLayout, sequence(f64, kWhole)}},
      {"std_msgs/Int32MultiArray", {kLayout, sequence(i32, kWhole)}},
      {"diagnostic_msgs/DiagnosticArray", {kHeader, {statuses, "status"}}},
      {"diagnostic_msgs/DiagnosticStatus", {{status, "status"}}},
  };
  return kRows;
}

}  // namespace

std::span<const SignalMessage> allSignalMessages() { return signalTable(); }

std::span<const SignalMessage> signalMessages(std::string_view type) {
  const std::span<const SignalMessage> all = signalTable();
  const auto first = std::ranges::find(all, type, &SignalMessage::type);
  const auto last =
      std::find_if(first, all.end(), [&](const auto& row) { return row.type != type; });
  return {first, last};
}

}  // namespace rocinante::ros
