// A page in Debian's Chromium with WebGL 2 by SwiftShader, and everything that it complains about or
// asks the network for.
import { chromium } from "playwright-core";

const flags = ["--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync"];

export async function openBrowser(size) {
  const browser = await chromium.launch({ executablePath: process.env.ROCINANTE_CHROMIUM || "/usr/bin/chromium", args: flags });
  const context = await browser.newContext({ viewport: size });
  // `own`: the beginning of the addresses that the page may ask.
  async function visit(address, own = "file:") {
    const page = await context.newPage();
    const complaints = [];
    page.on("console", (message) => {
      // SwiftShader says that reading pixels stalls it; the page's own screenshot asks for that.
      if (["error", "warning"].includes(message.type()) && !/GPU stall due to ReadPixels/.test(message.text())) {
        complaints.push(message.text());
      }
    });
    page.on("pageerror", (error) => complaints.push(error.message));
    page.on("request", (request) => {
      if (!request.url().startsWith(own) && !/^(data|blob):/.test(request.url())) {
        complaints.push("asks the network for " + request.url());
      }
    });
    await page.goto(address, { timeout: 120000 });
    return { page, complaints };
  }
  return { browser, visit, open: (path, hash = "") => visit("file://" + path + hash) };
}

// Waits for the first picture; fails with the page's own sentence.
export async function shown(page) {
  await page.waitForFunction(() => window.rocinante ? window.rocinante.stats.firstPictureMs > 0 : document.querySelector("#message.fault"), null,
    { timeout: 120000 });
  const fault = await page.evaluate(() => window.rocinante ? "" : document.querySelector("#message").textContent);
  if (fault) throw new Error("the page says: " + fault);
}
