// The demo's page: nothing leaves it, its poses are those of `rocinante model fk`, it is moved by real
// input, and its pictures lie by those of `rocinante render`.
// usage: node check_page.mjs session.html HOSTILE_FOLDER POSES.json PICTURES_FOLDER
// POSES.json: [{"ns": 1, "text": "what fk --json printed"}, ...]; into the folder: T.png of the canvas
import assert from "node:assert/strict";
import fs from "node:fs";
import { openBrowser, shown } from "./browser.mjs";

const [, , path, hostile, poses_file, folder] = process.argv;
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
// Nothing moves and everything is drawn.
const rest = () => page.waitForFunction(() => window.rocinante.isAtRest(), null, { timeout: 60000 });
const pixels = () => page.evaluate(() => document.querySelector("#rocinante-canvas").toDataURL());

await check("a link opens its moment and its camera", async () => {
  assert.equal(await now(), 2);
  assert.equal(await camera(), "overview");
  assert.equal(await page.locator("#time").innerText(), "2.000 s");
  assert.equal(await page.locator("#camera").inputValue(), "overview");
});
await check("first picture", async () =>
  Math.round(await page.evaluate(() => window.rocinante.stats.firstPictureMs)) + " ms after opening");
await check("nothing is left of the first, coarse picture", async () => {
  await page.waitForFunction(() => window.rocinante.stats.frames > 1);
  await rest();
  const [shown, whole] = await page.evaluate(async () => {
    const canvas = document.querySelector("#rocinante-canvas");
    await new Promise((done) => setTimeout(done, 0));
    const before = canvas.toDataURL();
    window.rocinante.calls.draw(window.rocinante.now(), canvas.width, canvas.height, 1, 0);
    return [before, canvas.toDataURL()];
  });
  assert.equal(shown, whole);
});
await check("poses equal `model fk --json` as text", async () => {
  const poses = JSON.parse(fs.readFileSync(poses_file, "utf8"));
  const ours = await page.evaluate((times) => times.map((ns) => window.rocinante.calls.poses(ns)), poses.map((each) => each.ns));
  poses.forEach((each, i) => assert.equal(ours[i], each.text, "at " + each.ns + " ns"));
  return poses.length + " moments";
});
await check("devices are listed with their joints", async () => {
  const text = await page.locator("#devices").innerText();
  assert.match(text, /arm/);
  assert.match(text, /\d\.\d\d\u00b0/);  // as a window has it
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
await check("a click selects what is there: list, outline, link and place; Escape forgets it", async () => {
  await page.locator("#camera").selectOption("overview");
  await rest();
  const before = await pixels();
  // Where the arm is, by the viewer's own pixels.
  const at = await page.evaluate(() => {
    const canvas = document.querySelector("#rocinante-canvas");
    const { calls, now } = window.rocinante;
    for (let y = 20; y < canvas.height; y += 15) {
      for (let x = 20; x < canvas.width; x += 15) {
        const picked = calls.pick(now(), x, y, canvas.width, canvas.height);
        if (picked && picked.device === "arm") return { x, y, link: picked.link };
      }
    }
    return null;
  });
  assert.ok(at, "no pixel of the arm");
  const box = await page.locator("#rocinante-canvas").boundingBox();
  await page.mouse.click(box.x + at.x, box.y + at.y);
  assert.equal(await page.locator("#devices h2.selected").innerText(), "arm");
  assert.equal(await page.locator("#devices dt.link").innerText(), at.link);
  assert.match(page.url(), new RegExp("select=arm%2F" + at.link));
  const fk = JSON.parse(await page.evaluate(() => window.rocinante.calls.poses(window.rocinante.now())));
  const place = await page.locator("#devices dd.link").innerText();
  assert.match(place, /^at( -?\d+\.\d){3} mm$/);
  const metres = place.split(" ").slice(1, 4).map((each) => each / 1000);
  const name = Object.keys(fk).find((key) => key.endsWith("arm/" + at.link));
  assert.ok(name, "fk has " + Object.keys(fk).join(", "));
  const text = JSON.stringify(fk[name]);
  const numbers = (text.match(/-?[0-9.]+(e-?[0-9]+)?/g) || []).map(Number);
  metres.forEach((each) => assert.ok(numbers.some((number) => Math.abs(number - each) < 6e-5), each + " in " + text));
  await page.waitForFunction((old) => document.querySelector("#rocinante-canvas").toDataURL() !== old, before);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("#devices h2.selected").count(), 0);
  await page.waitForFunction((old) => document.querySelector("#rocinante-canvas").toDataURL() === old, before);
  return "arm/" + at.link;
});
await check("curves of the selected device, with its limits; a click on one scrubs", async () => {
  await page.locator("#devices h2", { hasText: "arm" }).first().click();
  await page.keyboard.press("p");
  await page.waitForFunction(() => window.rocinante.plots.part() === 1);
  const lanes = page.locator("#lanes .lane");
  const joints = await page.evaluate(() =>
    window.rocinante.calls.devices(window.rocinante.now()).find((device) => device.name === "arm").joints.map((joint) => joint.name));
  assert.deepEqual(await page.locator("#lanes .joint").allInnerTexts(), joints);
  const moving = await page.locator("#lanes path.curve").evaluateAll((all) => all.filter((each) => each.getAttribute("d").length > 100).length);
  assert.ok(moving > 0, "no curve moves");
  const box = await lanes.first().locator("svg").boundingBox();
  await page.mouse.click(box.x + box.width * 0.25, box.y + 20);
  const { start_ns, end_ns } = await page.evaluate(() => window.rocinante.about);
  const part = (await page.evaluate(() => window.rocinante.now()) - start_ns) / (end_ns - start_ns);
  assert.ok(Math.abs(part - 0.25) < 0.01, "at " + part);
  await rest();
  const listed = await page.locator("#devices section:has(h2.selected) dl").innerText();
  assert.ok(listed.includes(await page.locator("#lanes .value").first().innerText()));
  await page.screenshot({ path: folder + "/../plots.png" });
  await page.keyboard.press("p");
  await page.keyboard.press("Escape");
  return joints.length + " lanes, " + moving + " of them move";
});
await check("findings and events are listed and marked, and a click goes to one", async () => {
  await page.keyboard.press("l");
  const rows = page.locator("#list .row");
  assert.ok(await rows.count() > 0);
  assert.equal(await page.locator("#list .row.event").count(), await page.locator("#marks .event").count());
  const row = page.locator("#list .row.event").first();
  const when = parseFloat(await row.locator(".when").innerText());
  await row.click();
  assert.ok(Math.abs(await now() - when) < 1e-3, (await now()) + " in place of " + when);
  await page.screenshot({ path: folder + "/../list.png" });
  await page.keyboard.press("l");
  return await page.locator("#list h2").allTextContents().then((all) => all.join(", "));
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
  await page.waitForFunction(() => window.rocinante.stats.restMs > 0);
  assert.equal(await now(), paused);
  const [rest, rung] = await page.evaluate(() => [window.rocinante.stats.restMs, window.rocinante.calls.rung()]);
  return ((later - frames) * 1000 / (then - at)).toFixed(1) + " frames/s on rung " + rung +
    ", whole " + Math.round(rest) + " ms after rest";
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
await check("signals are listed and plotted, also those of no device and of none of the cell's", async () => {
  const other = await open(path.replace(/[^/]*$/, "signals.html"), "#t=3.5&select=arm");
  await shown(other.page);
  const listed = (of) => other.page.evaluate((name) => {
    const device = window.rocinante.calls.devices(window.rocinante.now()).find((each) => each.name === name);
    return device.signals.map((each) => [each.series, each.text, each.kind]);
  }, of);
  assert.deepEqual(await listed("arm"), [["signal arm load", "17.5 kg", "number"], ["signal arm mode", "fault <b>", "text"],
    ["signal arm/tool0 closed", "true", "boolean"]]);
  assert.deepEqual(await listed(""), [["signal - speed", "0", "number"]]);
  assert.deepEqual(await listed("oven"), [["signal oven heat", "235 degC", "number"]]);
  const text = await other.page.locator("#devices").innerText();
  for (const each of ["load", "17.5 kg", "tool0 closed", "fault <b>", "oven", "235 degC", "Signals of no device"]) {
    assert.ok(text.includes(each), each + " in " + text);
  }
  await other.page.keyboard.press("p");
  await other.page.waitForFunction(() => window.rocinante.plots.part() === 1);
  const lanes = () => other.page.locator("#lanes .joint").allInnerTexts();
  assert.deepEqual((await lanes()).slice(-2), ["signal arm load", "signal arm/tool0 closed"]);
  const lane = other.page.locator("#lanes .lane", { hasText: "signal arm load" });
  assert.match(await lane.locator(".range").innerText(), /^0.* to 20.* kg$/);
  assert.ok((await lane.locator("path.curve").getAttribute("d")).length > 100);
  await other.page.waitForFunction(() => [...document.querySelectorAll("#lanes .value")].some((each) => each.textContent === "17.5 kg"));
  await other.page.screenshot({ path: folder + "/../signals.png" });
  await other.page.locator("#devices h2", { hasText: "oven" }).click();
  assert.deepEqual(await lanes(), ["signal oven heat"]);
  await other.page.keyboard.press("Escape");
  assert.deepEqual(await lanes(), ["signal - speed"]);
  assert.deepEqual(other.complaints, []);
  await other.page.close();
});
await check("a page begins with its layout: camera, theme, insets and curves, which a selection covers", async () => {
  const other = await open(path.replace(/[^/]*$/, "layout.html"), "");
  await shown(other.page);
  assert.equal(await other.page.evaluate(() => window.rocinante.calls.camera()), "fit");
  assert.equal(await other.page.locator("#camera").inputValue(), "fit");
  assert.equal(await other.page.evaluate(() => getComputedStyle(document.documentElement).colorScheme), "light");
  await other.page.waitForFunction(() => window.rocinante.plots.part() === 1);
  const lanes = () => other.page.locator("#lanes .joint").allInnerTexts();
  assert.deepEqual(await lanes(), ["arm.joint2", "d/dt arm.joint2"]);
  for (const at of [0, 1]) {
    assert.ok((await other.page.locator("#lanes path.curve").nth(at).getAttribute("d")).length > 100);
  }
  await other.page.waitForFunction(() => document.querySelectorAll("#lanes .value")[0].textContent.endsWith("\u00b0"));
  assert.ok((await other.page.locator("#plots").boundingBox()).height <= 170);
  await other.page.locator("#devices h2", { hasText: "arm" }).first().click();
  assert.ok(!(await lanes()).includes("arm.joint2"));
  await other.page.keyboard.press("Escape");
  assert.deepEqual(await lanes(), ["arm.joint2", "d/dt arm.joint2"]);
  await other.page.keyboard.press("p");
  assert.equal(await other.page.locator("#plots").isHidden(), true);
  await other.page.screenshot({ path: folder + "/../layout.png" });
  assert.deepEqual(other.complaints, []);
  await other.page.close();
  const linked = await open(path.replace(/[^/]*$/, "layout.html"), "#t=2&camera=overview");
  await shown(linked.page);
  assert.equal(await linked.page.evaluate(() => window.rocinante.calls.camera()), "overview");
  await linked.page.close();
  // A camera that is not in the list is shown there by its name.
  const fitted = await open(path.replace(/[^/]*$/, "layout.html"), "#t=2&camera=fit:arm");
  await shown(fitted.page);
  assert.equal(await fitted.page.evaluate(() => window.rocinante.calls.camera()), "fit:arm");
  assert.equal(await fitted.page.locator("#camera").inputValue(), "fit:arm");
  await fitted.page.close();
});
await check("what is not listed and not plotted is counted", async () => {
  const other = await open(path.replace(/[^/]*$/, "many.html"), "#t=0.027");
  await shown(other.page);
  const devices = await other.page.evaluate(() => window.rocinante.calls.devices(window.rocinante.now()));
  assert.equal(devices.filter((each) => /^x[0-9]+$/.test(each.name)).length, 1024);
  assert.deepEqual(devices.filter((each) => each.more), [{ more: 1100 - 1024 }]);
  assert.equal(devices[devices.length - 1].signals.length, 256);
  assert.equal(devices[devices.length - 1].unlisted, 300 - 256);
  const list = await other.page.locator("#devices").innerText();
  assert.ok(list.includes("and 76 more devices"), list.slice(-200));
  const plots = await other.page.evaluate(() => {
    for (let part = 0; part >= 0 && part < 1;) part = window.rocinante.calls.readPlots(1000);
    return window.rocinante.calls.plots("", window.rocinante.now(), 100, 40);
  });
  assert.equal(plots.lanes.length, 256);
  assert.equal(plots.more, 300 - 256);
  await other.page.close();
});
await check("nothing was asked of a network, nothing complained", async () => assert.deepEqual(complaints, []));
for (const { name, file, says } of JSON.parse(fs.readFileSync(hostile + "/expected.json", "utf8"))) {
  await check("a page that was cut or changed says so in a sentence: " + name, async () => {
    const other = await open(file);
    await other.page.waitForSelector("#message.fault", { timeout: 60000 });
    const said = await other.page.locator("#message").innerText();
    assert.ok(said.includes(says), said);
    await other.page.close();
    return said;
  });
}
await check("a page whose log is damaged shows the rest, and says where something may lack", async () => {
  const other = await open(hostile + "/damaged.html", "#t=0.5&camera=overview");
  await shown(other.page);
  await other.page.waitForFunction(() => window.rocinante.isAtRest(), null, { timeout: 60000 });
  await other.page.evaluate(() => window.rocinante.seek(window.rocinante.about.end_ns));
  await other.page.waitForFunction(() => document.querySelector("#message").textContent !== "", null, { timeout: 60000 });
  const [said, isFault] = await other.page.evaluate(() => {
    const message = document.querySelector("#message");
    return [message.textContent, message.classList.contains("fault")];
  });
  assert.ok(!isFault, said);
  await other.page.close();
  return said;
});
await check("a link to a camera that there is not is answered with those there are", async () => {
  const other = await open(path, "#t=1&camera=nowhere");
  await shown(other.page);
  assert.match(await other.page.locator("#message").innerText(), /nowhere.*overview/);
});
await check("a link selects; one to a device that there is not says so", async () => {
  const other = await open(path, "#t=1&select=arm");
  await shown(other.page);
  assert.equal(await other.page.locator("#devices h2.selected").innerText(), "arm");
  const wrong = await open(path, "#t=1&select=nobody");
  await shown(wrong.page);
  assert.match(await wrong.page.locator("#message").innerText(), /nobody/);
});
console.log(`web: ${checks} checks`);
await browser.close();
