// Size, time to the first picture and memory of pages: in a browser just started, and in one that has
// drawn before; beside each, in the same run, what a page of one triangle takes there (bare.html).
// Medians of three runs.
// usage: node figures.mjs BARE.html PAGE.html...
import fs from "node:fs";
import { openBrowser, shown } from "./browser.mjs";

const kRuns = 3;

// MB of the browser's processes of that type (renderer, gpu-process), shared pages counted in parts.
function memoryOf(type) {
  let kilobytes = 0;
  for (const id of fs.readdirSync("/proc").filter((each) => /^\d+$/.test(each))) {
    try {
      const command = fs.readFileSync(`/proc/${id}/cmdline`, "utf8");
      if (!command.includes("--type=" + type) || !command.includes("chromium")) continue;
      kilobytes += Number(fs.readFileSync(`/proc/${id}/smaps_rollup`, "utf8").match(/^Pss: +(\d+)/m)[1]);
    } catch { /* it has ended */ }
  }
  return Math.round(kilobytes / 1000);
}
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
const load = () => fs.readFileSync("/proc/loadavg", "utf8").split(" ")[0];

const size = { width: 960, height: 640 };
const bareTime = async (page) => (await page.waitForFunction(() => window.firstPictureMs)).jsonValue();
async function openOwn(page) {
  await shown(page);
  const times = await page.evaluate(() => ({ first: window.rocinante.stats.firstPictureMs, whole: window.rocinante.stats.openedMs }));
  await page.waitForFunction(() => window.rocinante.isAtRest(), null, { timeout: 120000 });
  return times;
}
async function inBrowser(path, body) {
  const { browser, open } = await openBrowser(size);
  const { page } = await open(path);
  const answer = await body(page);
  await browser.close();
  return answer;
}

// One run of a page, beside bare ones.
async function run(bare, path) {
  const one = { coldBare: await inBrowser(bare, bareTime) };
  Object.assign(one, await inBrowser(path, async (page) => {
    const { first } = await openOwn(page);
    return { cold: first };
  }));
  Object.assign(one, await inBrowser(bare, async (page) => {
    await bareTime(page);
    await page.reload();
    const warmBare = await bareTime(page);
    await page.goto("file://" + path, { timeout: 120000 });
    const { first, whole } = await openOwn(page);
    // The state of a moment in the middle, which nothing has asked for.
    const [jump, seconds] = await page.evaluate(() => {
      const { about, calls } = window.rocinante;
      const begun = performance.now();
      calls.poses(Math.round(about.start_ns + (about.end_ns - about.start_ns) * 0.618));
      return [performance.now() - begun, (about.end_ns - about.start_ns) / 1e9];
    });
    return { warmBare, warm: first, whole, jump, seconds, renderer: memoryOf("renderer"), gpu: memoryOf("gpu-process") };
  }));
  return one;
}

const [bare, ...pages] = process.argv.slice(2);
const secondsOf = (ms) => (ms / 1000).toFixed(2) + " s";
console.log(`load ${load()} before`);
console.log("| page | log | size | first picture, browser just started (bare) | in a browser that runs (bare) | whole log there | a jump | renderer | GPU process |");
console.log("|---|---|---|---|---|---|---|---|---|");
for (const path of pages) {
  const runs = [];
  for (let i = 0; i < kRuns; ++i) runs.push(await run(bare, path));
  const of = (name) => median(runs.map((each) => each[name]));
  console.log(`| ${path.split("/").pop()} | ${of("seconds").toFixed(0)} s | ${(fs.statSync(path).size / 1e6).toFixed(1)} MB | ` +
    `${secondsOf(of("cold"))} (${secondsOf(of("coldBare"))}) | ${secondsOf(of("warm"))} (${secondsOf(of("warmBare"))}) | ` +
    `${secondsOf(of("whole"))} | ${Math.round(of("jump"))} ms | ${of("renderer")} MB | ${of("gpu")} MB |`);
}
console.log(`load ${load()} after`);
