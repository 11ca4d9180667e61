// What `log export --foxglove --model --findings` adds: every model by Khronos' validator, the
// findings against `check --json`.
// usage: check_models.mjs FILE.mcap CHECK.json DEVICE...
import { readFileSync } from "node:fs";
import validator from "gltf-validator";
import { decodedMcap, demand } from "./decoded_mcap.mjs";

const [path, checked, ...devices] = process.argv.slice(2);
const file = await decodedMcap(path);
let models = 0;
for (const device of devices) {
  const [{ value }] = file.topics.get(`/model/${device}`).messages;
  demand(value.deletions.length === 1, `${device}: one deletion`);
  demand(value.entities.length > 0, `${device} shows nothing`);
  for (const entity of value.entities) {
    demand(entity.frame_id.startsWith(`${device}/`) && entity.frame_locked, `frame ${entity.frame_id}`);
    const [model] = entity.models;
    demand(model.media_type === "model/gltf-binary", model.media_type);
    const report = await validator.validateBytes(new Uint8Array(model.data));
    const { numErrors, numWarnings } = report.issues;
    demand(numErrors === 0 && numWarnings === 0, `${entity.id}: ${JSON.stringify(report.issues.messages[0])}`);
    demand(report.info.totalTriangleCount > 0, `${entity.id} has no triangle`);
    ++models;
  }
}
demand(models > 10, `only ${models} models`);
const { findings } = JSON.parse(readFileSync(checked, "utf8"));
const rules = new Set(findings.map(({ rule }) => rule));
const noted = file.topics.get("/events").messages.filter(({ value }) => rules.has(value.name));
demand(noted.length === findings.length, `${noted.length} findings, not ${findings.length}`);
demand(findings.length > 0, "check found nothing: choose another cell");
console.log(`foxglove: ${models} models are valid, ${noted.length > 0 ? "the findings are those of check" : ""}`);
