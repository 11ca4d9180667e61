// What `rocinante serve` gives, in a browser: a recorded log by range requests, its poses those of
// `rocinante model fk`; a live session that follows what is sent, and says when its server is gone.
// usage: node check_served.mjs PROGRAM CELL LOG VIEWER_FOLDER POSES.json PICTURES_FOLDER
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import dgram from "node:dgram";
import fs from "node:fs";
import { openBrowser, shown } from "./browser.mjs";

const [, , program, cell, log, viewer, poses_file, folder] = process.argv;
const { browser, visit } = await openBrowser({ width: 960, height: 640 });
let checks = 0;
async function check(what, body) {
  const detail = await body();
  ++checks;
  console.log("ok: " + what + (detail ? ": " + detail : ""));
}

// A server on a free port, once it says that it serves.
const servers = [];
process.on("exit", () => servers.forEach((each) => each.kill("SIGKILL")));
async function serve(...given) {
  const server = spawn(program, [cell, ...given, "--listen", "127.0.0.1:0", "--viewer", viewer]);
  servers.push(server);
  let said = "";
  await new Promise((done, fail) => {
    server.stderr.on("data", (data) => { said += data; if (/^serving .*\n/m.test(said)) done(); });
    server.on("exit", (code) => fail(new Error(`serve ended with ${code}: ${said}`)));
  });
  return {
    address: said.match(/http:\/\/127\.0\.0\.1:\d+\//)[0],
    udp: Number((said.match(/udp:\/\/127\.0\.0\.1:(\d+)/) || [])[1]),
    stop: () => new Promise((done) => { server.removeAllListeners("exit"); server.on("exit", done); server.kill("SIGINT"); }),
  };
}
const selectedDevice = (page) => page.locator("#devices h2.selected").innerText();

await check("a served log is read by ranges and is the one that `model fk` reads", async () => {
  const server = await serve(log);
  const asked = [];
  const { page, complaints } = await visit("about:blank", server.address);
  page.on("response", (answer) => { if (answer.url().endsWith("/log")) asked.push(answer.status()); });
  await page.goto(server.address + "#t=2&camera=overview");
  await shown(page);
  assert.deepEqual(asked, asked.map(() => 206));
  assert.ok(asked.length > 0);
  const poses = JSON.parse(fs.readFileSync(poses_file, "utf8")).slice(0, 20);
  const ours = await page.evaluate((times) => times.map((ns) => window.rocinante.calls.poses(ns)), poses.map((each) => each.ns));
  poses.forEach((each, i) => assert.equal(ours[i], each.text, "at " + each.ns + " ns"));
  await page.locator("#devices h2", { hasText: "arm" }).first().click();
  assert.equal(await selectedDevice(page), "arm");
  await page.keyboard.press("p");
  await page.waitForFunction(() => window.rocinante.plots.part() === 1);
  assert.ok(await page.locator("#lanes .lane").count() > 0);
  await page.locator("#lists").click();
  assert.doesNotMatch(await page.locator("#list").innerText(), /Findings/);  // nobody has looked
  assert.deepEqual(complaints.filter((each) => !each.includes("about:blank")), []);
  await page.close();
  await server.stop();
  return `${poses.length} moments, ${asked.length} range${asked.length === 1 ? "" : "s"}`;
});

const server = await serve("--live", "127.0.0.1:0");
const sender = dgram.createSocket("udp4");
let sequence = 0;
const send = (text) => new Promise((done) =>
  sender.send(`RK1 test ${sequence++} -\n${text}\n`, server.udp, "127.0.0.1", done));
const live = await visit(server.address, server.address);
const joint = (name) => live.page.waitForFunction(
  ([device, wanted]) => window.rocinante && window.rocinante.calls.devices(window.rocinante.now())
    .find((each) => each.name === device).joints.some((each) => Math.abs(each.value - wanted) < 1e-9), name, { timeout: 60000 });

await check("a live page follows what is sent", async () => {
  await shown(live.page);
  await live.page.waitForSelector("#live");
  for (const value of [0.25, -0.5, 0.75]) {
    await send(`joints arm ${value} 0 0 0 0 0`);
    await joint(["arm", value]);
  }
  await live.page.waitForFunction(() => /42\.97\u00b0/.test(document.querySelector("#devices").innerText));
});
await check("its signals are those of now", async () => {
  await send('signal arm load 5 kg\nsignal arm mode "auto"\nsignal - estop true');
  await live.page.waitForFunction(() => /load\s+5 kg\s+mode\s+auto[^]*estop\s+true/.test(document.querySelector("#devices").innerText));
  await send("signals arm load=6\nsignal arm mode default");
  await live.page.waitForFunction(() => /load\s+6 kg/.test(document.querySelector("#devices").innerText) &&
    !/mode/.test(document.querySelector("#devices").innerText));
});
await check("it has no time line, no curves and no events, and a device is selected in it", async () => {
  for (const id of ["#play", "#track", "#curves", "#lists"]) assert.equal(await live.page.locator(id).isVisible(), false, id);
  for (const key of ["p", "l", " "]) await live.page.keyboard.press(key);
  assert.equal(await live.page.locator("#plots").isVisible(), false);
  assert.equal(await live.page.locator("#list").isVisible(), false);
  await live.page.locator("#devices h2", { hasText: "arm" }).first().click();
  assert.equal(await selectedDevice(live.page), "arm");
  await live.page.screenshot({ path: folder + "/../live.png" });
  assert.equal(await live.page.locator("#message").innerText(), "");
});
await check("a stream of 60 packets a second is in the page soon", async () => {
  // When each value is first in the page's state, and when a frame of it was drawn.
  await live.page.evaluate(() => {
    const now = () => performance.timeOrigin + performance.now();
    const seen = window.seen = { state: {}, picture: {} };
    const take = window.rocinanteServed.take;
    let newest = 0, frames = window.rocinante.stats.frames;
    window.rocinanteServed.take = (bytes) => {
      const fault = take(bytes);
      for (const [, value] of new TextDecoder().decode(bytes).matchAll(/joints arm (0\.[0-9]+)/g)) {
        seen.state[value] ??= now();
        newest = value;
      }
      return fault;
    };
    const look = () => {
      if (window.rocinante.stats.frames !== frames && newest) seen.picture[newest] ??= now();
      frames = window.rocinante.stats.frames;
      requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
  const sent = {};
  for (let i = 1; i <= 300; ++i) {
    const value = "0." + String(100000 + i);
    sent[value] = performance.timeOrigin + performance.now();
    await send(`joints arm ${value} 0 0 0 0 0`);
    await new Promise((done) => setTimeout(done, 16));
  }
  await joint(["arm", 0.1003]);
  const seen = await live.page.evaluate(() => window.seen);
  const lags = (of) => Object.entries(of).filter(([value]) => value in sent).map(([value, at]) => at - sent[value])
    .sort((one, other) => one - other);
  const text = (all) => `median ${Math.round(all[all.length >> 1])} ms, most ${Math.round(all[all.length - 1])} ms`;
  assert.ok(Object.keys(seen.state).length > 50 && Object.keys(seen.picture).length > 2);
  return `to its state: ${text(lags(seen.state))}; to a picture: ${text(lags(seen.picture))}`;
});
await check("nothing complained, nothing else was asked", async () => assert.deepEqual(live.complaints, []));
await check("a server that is gone is said", async () => {
  await server.stop();
  await live.page.waitForFunction(() => /connection to the server is lost/.test(document.querySelector("#message").textContent));
});
console.log(`served: ${checks} checks`);
sender.close();
await browser.close();
