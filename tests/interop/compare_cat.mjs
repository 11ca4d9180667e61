// Compares what `rocinante log cat --format json` says of a log with what was noted: every message,
// in the order (log_time, place in the file).
// usage: node compare_cat.mjs NOTES.jsonl CAT.jsonl
import { readFileSync } from "node:fs";
import { demandEqual, notedMessages } from "./messages.mjs";

const [noted, said] = process.argv.slice(2);
const wanted = notedMessages(noted)
  .map((message, place) => ({ message, place, time: BigInt(message.log_time) }))
  .sort((a, b) => (a.time < b.time ? -1 : a.time > b.time ? 1 : a.place - b.place))
  .map(({ message }) => [message.log_time, message.topic, message.sequence, message.payload]);
// Numbers of 64 bits are taken as text before JSON.parse rounds them.
const exact = (line) => JSON.parse(line.replace(/"log_time_ns":(\d+)/, '"log_time_ns":"$1"'));
const lines = readFileSync(said, "utf8").split("\n").filter((line) => line !== "");
const came = lines.map((line) => {
  const { log_time_ns, channel, sequence, text, payload_base64 } = exact(line);
  return [log_time_ns, channel, sequence,
    payload_base64 ?? Buffer.from(text, "utf8").toString("base64")];
});
demandEqual(came, wanted, said);
console.log(`${noted.split("/").at(-1).replace(".jsonl", "")}: ${came.length} messages`);
