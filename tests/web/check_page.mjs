// The demo's page: nothing leaves it, its poses are those of `rocinante model fk`, it is moved by real
// input, and its pictures lie by those of `rocinante render`.
// usage: node check_page.mjs session.html broken.html POSES.json PICTURES_FOLDER
// POSES.json: [{"ns": 1, "text": "what fk --json printed"}, ...]; into the folder: T.png of the canvas
import assert from "node:assert/strict";
import fs from "node:fs";
import { openBrowser, shown } from "./browser.mjs";

const [, , path, broken, poses_file, folder] = process.argv;
const { browser, open } = await openBrowser({ width: 960, height: 640 });
const { page, complaints } = await open(path, "#t=2&camera=overview");
await shown(page);
let checks = 0;
async function check(what, body) {
  const detail = await body();
  ++checks;
  console.log("ok: " + what + (detail ? ": " + detail : ""));
}
const now = () => page.evaluate(() => window.rocinante.now() / 1e9);
const camera = () => page.evaluate(() => window.rocinante.calls.camera());
const pixels = () => page.evaluate(() => document.querySelector("#rocinante-canvas").toDataURL());

await check("a link opens its moment and its camera", async () => {
  assert.equal(await now(), 2);
  assert.equal(await camera(), "overview");
  assert.equal(await page.locator("#time").innerText(), "2.000 s");
  assert.equal(await page.locator("#camera").inputValue(), "overview");
});
await check("first picture", async () =>
  Math.round(await page.evaluate(() => window.rocinante.stats.firstPictureMs)) + " ms after opening");
await check("poses equal `model fk --json` as text", async () => {
  const poses = JSON.parse(fs.readFileSync(poses_file, "utf8"));
  const ours = await page.evaluate((times) => times.map((ns) => window.rocinante.calls.poses(ns)), poses.map((each) => each.ns));
  poses.forEach((each, i) => assert.equal(ours[i], each.text, "at " + each.ns + " ns"));
  return poses.length + " moments";
});
await check("devices are listed with their joints", async () => {
  const text = await page.locator("#devices").innerText();
  assert.match(text, /arm/);
  assert.match(text, /\d\u00b0/);
});
await check("dragging the time line scrubs", async () => {
  const before = await pixels();
  const box = await page.locator("#scrub").boundingBox();
  await page.mouse.move(box.x + box.width * 0.2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.5, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  await page.waitForFunction((t) => Math.abs(window.rocinante.now() / 1e9 - t) > 1, 2);
  const { start_ns, end_ns } = await page.evaluate(() => window.rocinante.about);
  const part = (await page.evaluate(() => window.rocinante.now()) - start_ns) / (end_ns - start_ns);
  assert.ok(Math.abs(part - 0.5) < 0.03, "at " + part);
  await page.waitForFunction((old) => document.querySelector("#rocinante-canvas").toDataURL() !== old, before);
  assert.match(page.url(), /#t=/);
});
await check("the left button turns, the wheel zooms, the right button moves", async () => {
  const box = await page.locator("#rocinante-canvas").boundingBox();
  let last = await camera();
  const changed = async (what) => {
    const next = await camera();
    assert.notEqual(next, last, what);
    assert.ok(next.startsWith("@"), next);
    last = next;
  };
  const drag = async (button) => {
    await page.mouse.move(box.x + 300, box.y + 200);
    await page.mouse.down({ button });
    await page.mouse.move(box.x + 360, box.y + 220, { steps: 3 });
    await page.mouse.up({ button });
  };
  await drag("left");
  await changed("turned");
  await page.mouse.wheel(0, -200);
  await page.waitForFunction((old) => window.rocinante.calls.camera() !== old, last);
  await changed("zoomed");
  await drag("right");
  await changed("moved");
  await page.locator("#camera").selectOption("fit");
  assert.equal(await camera(), "fit");
});
await check("plays at 4x, and pauses, by keys", async () => {
  await page.locator("#speed").selectOption("4");
  await page.locator("#rocinante-canvas").focus();
  await page.keyboard.press("Home");
  const begun = await now();
  const [frames, at] = await page.evaluate(() => [window.rocinante.stats.frames, performance.now()]);
  await page.keyboard.press(" ");
  await page.waitForFunction((from) => window.rocinante.now() / 1e9 > from + 8, begun, { timeout: 120000 });
  const [later, then] = await page.evaluate(() => [window.rocinante.stats.frames, performance.now()]);
  await page.keyboard.press(" ");
  const paused = await now();
  // However slow the frames are, time runs as the clock does, from the frame that was begun.
  const stopped = await page.evaluate(() => performance.now());
  assert.ok(paused - begun <= 4 * (stopped - at) / 1000 + 0.1, "played " + (paused - begun) + " s");
  assert.equal(await page.evaluate(() => window.rocinante.isPlaying()), false);
  await page.waitForTimeout(200);
  assert.equal(await now(), paused);
  return ((later - frames) * 1000 / (then - at)).toFixed(1) + " frames/s";
});
await check("pictures of ten moments", async () => {
  await page.evaluate(() => { document.querySelector("#panel").click(); });
  const { start_ns, end_ns } = await page.evaluate(() => window.rocinante.about);
  await page.locator("#camera").selectOption("overview");
  for (let i = 0; i < 10; ++i) {
    const ns = Math.round((start_ns + (end_ns - start_ns) * i / 9) / 1e6) * 1e6;
    const url = await page.evaluate((at) => {
      const canvas = document.querySelector("#rocinante-canvas");
      canvas.width = 640;
      canvas.height = 480;
      const fault = window.rocinante.calls.draw(at, 640, 480, 1);
      return fault || canvas.toDataURL("image/png");
    }, ns);
    assert.match(url, /^data:image\/png;base64,/);
    fs.writeFileSync(`${folder}/${(ns / 1e9).toFixed(3)}.png`, Buffer.from(url.split(",")[1], "base64"));
  }
});
await check("nothing was asked of a network, nothing complained", async () => assert.deepEqual(complaints, []));
await check("a page whose log was changed says so in a sentence", async () => {
  const other = await open(broken);
  await other.page.waitForSelector("#message.fault", { timeout: 60000 });
  assert.match(await other.page.locator("#message").innerText(), /log/);
});
await check("a link to a camera that there is not is answered with those there are", async () => {
  const other = await open(path, "#t=1&camera=nowhere");
  await shown(other.page);
  assert.match(await other.page.locator("#message").innerText(), /nowhere.*overview/);
});
console.log(`web: ${checks} checks`);
await browser.close();
