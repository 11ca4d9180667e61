// A page in Debian's Chromium, and everything that it complains about.
import { chromium } from "playwright-core";

const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync"];

export async function openPage(options = {}) {
  const browser = await chromium.launch({ executablePath: process.env.ROCINANTE_CHROMIUM, args: flags });
  const context = await browser.newContext({ viewport: { width: 1400, height: 900 }, ...options });
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) complaints.push("asks the network for " + request.url());
  });
  return { browser, page, complaints };
}

export async function openReport(path, options) {
  const opened = await openPage(options);
  await opened.page.goto("file://" + path);
  await opened.page.waitForFunction(() => document.body.dataset.shown);
  return opened;
}
