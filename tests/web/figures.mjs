// Size, time to the first picture and memory of pages, each in a browser of its own.
// usage: node figures.mjs PAGE.html...
import fs from "node:fs";
import { openBrowser, shown } from "./browser.mjs";

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

console.log("| page | size | log | first picture | a jump | renderer | GPU process |");
console.log("|---|---|---|---|---|---|---|");
for (const path of process.argv.slice(2)) {
  const { browser, open } = await openBrowser({ width: 960, height: 640 });
  const { page } = await open(path);
  await shown(page);
  const first = await page.evaluate(() => window.rocinante.stats.firstPictureMs);
  await page.waitForFunction(() => window.rocinante.isAtRest(), null, { timeout: 120000 });
  // The state of a moment in the middle, which nothing has asked for.
  const jump = await page.evaluate(() => {
    const { about, calls } = window.rocinante;
    const begun = performance.now();
    calls.poses(Math.round(about.start_ns + (about.end_ns - about.start_ns) * 0.618));
    return performance.now() - begun;
  });
  const seconds = await page.evaluate(() => (window.rocinante.about.end_ns - window.rocinante.about.start_ns) / 1e9);
  console.log(`| ${path.split("/").pop()} | ${(fs.statSync(path).size / 1e6).toFixed(1)} MB | ${seconds.toFixed(0)} s | ` +
    `${(first / 1000).toFixed(1)} s | ${Math.round(jump)} ms | ${memoryOf("renderer")} MB | ${memoryOf("gpu-process")} MB |`);
  await browser.close();
}
