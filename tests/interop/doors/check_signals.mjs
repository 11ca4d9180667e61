// What `log export` made of signals, compared with `log table --signals` of the same log.
// usage: node check_signals.mjs foxglove|ros2 FILE.mcap TABLE.csv
import { readFileSync } from "node:fs";
import { decodedMcap, demand } from "./decoded_mcap.mjs";

const [kind, path, table] = process.argv.slice(2);
const file = await decodedMcap(path);
const [header, ...rows] = readFileSync(table, "utf8").trim().split("\n").map((row) => row.split(","));

// As Foxglove reads a message path: fields behind points, quoted where they have other letters.
function valueAt(message, fields) {
  let at = message;
  for (const [, quoted, plain] of fields.matchAll(/\.(?:"([^"]*)"|([\w-]+))/g)) at = at?.[quoted ?? plain];
  return at;
}

const nested = { "signal arm j1.velocity": ".j1.velocity", "signal arm mode.n": '."mode.n"' };
const ros = {
  "signal - n%20%2F": "/signals/n__", "signal - n_%2F": "/signals/n___2", "signal arm mode.n": "/signals/arm/mode_n",
};
let values = 0;
header.forEach((column, i) => {
  const [word, owner, name] = column.split(" ");
  if (word !== "signal") return;
  const said = rows.map((row) => row[i]).filter((field, at, all) => field !== "" && field !== all[at - 1]).map(Number);
  demand(said.length > 0, `${column} has no value in the table`);
  let came;
  if (kind === "foxglove") {
    const fields = nested[column] ?? `."${decodeURIComponent(name)}"`;
    came = file.topics.get(`/signals/${owner}`).messages.map(({ value }) => valueAt(value, fields));
    // Plots draw numbers and booleans only.
    demand(came.every((each) => ["number", "boolean", "undefined"].includes(typeof each)), `${column} has no numbers`);
    came = came.filter((each) => each !== undefined);
  } else if (column === "signal arm j1.velocity") {
    came = file.topics.get("/arm/joint_states").messages.map(({ value }) => value.velocity[value.name.indexOf("j1")]);
    came = came.filter((each) => each !== undefined);
  } else {
    came = file.topics.get(ros[column] ?? `/signals/${owner.replace("-", "")}/${name}`.replace("//", "/"))
      .messages.map(({ value }) => value.data);
  }
  const changes = came.map(Number).filter((each, at, all) => each !== all[at - 1]);
  demand(JSON.stringify(changes) === JSON.stringify(said), `${column}: ${changes}, not ${said}`);
  values += said.length;
});
demand(values > 100, `only ${values} values were compared`);

if (kind === "foxglove") {
  const modes = file.topics.get("/signals/arm").messages.map(({ value }) => value.mode).filter(Boolean);
  demand(modes.includes("auto") && modes.includes("fault"), `mode: ${modes}`);
  const { schema } = file.topics.get("/signals/arm");
  const { load, mode } = JSON.parse(new TextDecoder().decode(schema.data)).properties;
  demand(load.type === "number" && mode.type === "string", "the types of load and mode");
} else {
  const texts = file.topics.get("/signals/arm/mode").messages.map(({ value }) => value.data)
    .filter((each, at, all) => each !== all[at - 1]);
  demand(JSON.stringify(texts) === '["auto","fault"]', `mode: ${texts}`);
  const { velocity, effort, name } = file.topics.get("/arm/joint_states").messages.at(-1).value;
  demand(velocity.length === name.length && Number.isNaN(velocity[name.indexOf("j2")]), "j2 has no velocity");
  demand(effort.length === 0, "nothing states an effort");
}
console.log(`${kind}: signals have the values of the table`);
