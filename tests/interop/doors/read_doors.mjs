// Reads what `log export` made of the demo session, and compares it with what Rocinante says.
// usage: node read_doors.mjs foxglove|ros2 FILE.mcap FOLDER
// FOLDER: state.json of `log info --json`; DEVICE.SECONDS.fk.json of `model fk --json`; table.csv of
// `log table --cell`.
import { readFileSync, readdirSync } from "node:fs";
import foxglove from "@foxglove/schemas/internal.js";
import { decodedMcap, demand, differenceTo, inWorld, lastAt } from "./decoded_mcap.mjs";

const [kind, path, folder] = process.argv.slice(2);
const file = await decodedMcap(path);
// Nanoseconds since the epoch are more than a number of JavaScript holds.
const info = JSON.parse(
  readFileSync(`${folder}/info.json`, "utf8").replace(/("\w+_ns": )(\d+)/g, '$1"$2"'));
const origin = BigInt(info.origin_ns);
demand(file.profile === (kind === "ros2" ? "ros2" : ""), `profile ${file.profile}`);

// Every field of the published definitions is in the schema, under its number.
if (kind === "foxglove") {
  let fields = 0;
  for (const { reader } of new Set([...file.topics.values()])) {
    for (const [name, published] of Object.entries(foxglove.foxgloveMessageSchemas)) {
      let type;
      try { type = reader.root.lookupType(`foxglove.${name}`); } catch { continue; }
      const enums = Object.values(foxglove.foxgloveEnumSchemas).filter((each) => each.parentSchemaName === name);
      const text = foxglove.generateProto(published, enums).replace(/\/\/.*$/gm, "").replace(/enum[^}]*}/g, "");
      const wanted = [...text.matchAll(/([\w.]+) (\w+) = (\d+);/g)];
      for (const [, typeName, field, number] of wanted) {
        const ours = type.fields[field];
        demand(ours?.id === Number(number) && ours.type.endsWith(typeName.split(".").at(-1)),
          `${name}.${field} is ${ours?.type} ${ours?.id}, published is ${typeName} ${number}`);
        ++fields;
      }
    }
  }
  demand(fields > 100, `only ${fields} fields were compared`);
}

// Spaces: child -> parent and pose, of the last messages at a moment.
function framesAt(moment) {
  const frames = new Map();
  for (const [topic, each] of file.topics) {
    if (kind === "foxglove" && topic.startsWith("/tf/")) {
      for (const frame of lastAt(each, moment)?.value.transforms ?? []) {
        frames.set(frame.child_frame_id, {
          parent: frame.parent_frame_id, translation: frame.translation, rotation: frame.rotation });
      }
    }
    if (kind === "ros2" && topic === "/tf") {
      for (const message of each.messages) {
        if (message.logTime > moment) break;
        for (const frame of message.value.transforms) {
          frames.set(frame.child_frame_id, { parent: frame.header.frame_id, ...frame.transform });
        }
      }
    }
  }
  return frames;
}

let links = 0;
let worst = 0;
for (const name of readdirSync(folder)) {
  const [, device, seconds] = name.match(/^(\w+)\.(\d+)\.fk\.json$/) ?? [];
  if (device === undefined) continue;
  const frames = framesAt(origin + BigInt(seconds) * 1000000000n);
  for (const [link, fk] of Object.entries(JSON.parse(readFileSync(`${folder}/${name}`, "utf8")))) {
    if (link === "format") continue;
    worst = Math.max(worst, differenceTo(inWorld(frames, `${device}/${link}`), fk));
    ++links;
  }
}
demand(links > 20, `only ${links} links were compared`);
demand(worst < 1e-9, `links differ by ${worst} from model fk`);

// Joints: every message is a row of the table, and every row's values are those of the last message.
const [header, ...rows] = readFileSync(`${folder}/table.csv`, "utf8").trim().split("\n").map((row) => row.split(","));
const nanoseconds = (text) => {
  const [whole, part = ""] = text.split(".");
  return origin + BigInt(whole) * 1000000000n + BigInt(part.padEnd(9, "0"));
};
let values = 0;
for (const device of ["arm", "gantry"]) {
  const topic = file.topics.get(kind === "ros2" ? `/${device}/joint_states` : `/joints/${device}`);
  const jointsOf = ({ value }) => kind === "ros2"
    ? new Map(value.name.map((name, i) => [name, value.position[i]]))
    : new Map(value.joints.map((joint) => [joint.name, joint.position]));
  let next = 0;
  for (const row of rows) {
    const moment = nanoseconds(row[0]);
    while (next < topic.messages.length && topic.messages[next].logTime <= moment) ++next;
    header.forEach((column, i) => {
      if (!column.startsWith(`${device}.`) || row[i] === "") return;
      const came = jointsOf(topic.messages[next - 1]).get(column.slice(device.length + 1));
      demand(came === Number(row[i]), `${column} at ${row[0]} is ${came}, not ${row[i]}`);
      ++values;
    });
  }
}
demand(values > 10000, `only ${values} joint values were compared`);

// Events, in order, with their times and their text.
const events = file.topics.get(kind === "ros2" ? "/rosout" : "/events").messages
  .filter(({ value }) => value.level === (kind === "ros2" ? 20 : "INFO"));
demand(events.length === info.event_list.length, `${events.length} events, not ${info.event_list.length}`);
info.event_list.forEach((event, i) => {
  demand(events[i].logTime === BigInt(event.log_time_ns) && events[i].value.name === event.source &&
    (kind === "ros2" ? events[i].value.msg : events[i].value.message) === event.text, `event ${i}`);
});

// Drawings: the planner's, in its last state.
const drawn = file.topics.get(kind === "ros2" ? "/planner/markers" : "/drawings/planner").messages;
const lines = drawn.flatMap(({ value }) => kind === "ros2"
  ? value.markers.filter((marker) => marker.type === 4 && marker.action === 0)
  : value.entities.flatMap((entity) => entity.lines));
demand(lines.length > 0 && lines.every((line) => line.points.length > 1), "no line was drawn");

// The models.
const urdf = readFileSync(`${folder}/arm.urdf`, "utf8");
const attached = file.attachments.find(({ name }) => name === "arm.urdf");
demand(new TextDecoder().decode(attached.data) === urdf, "arm.urdf is not the model's file");
if (kind === "ros2") {
  demand(file.topics.get("/arm/robot_description").messages[0].value.data === urdf, "robot_description");
}
if (process.argv.includes("--raw")) {
  demand(file.raw.length === info.messages, `${file.raw.length} datagrams, not ${info.messages}`);
} else {
  demand(file.raw.length === 0, "there are raw channels");
}
console.log(`${kind}: every channel decodes; links, joints, events and drawings are those of the log`);
