// Pictures of pages for docs/gallery.md: node gallery.mjs FOLDER PAGE.html... writes FOLDER/PAGE.jpg, the two views of each.
import { basename, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [folder, ...pages] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: "/usr/bin/chromium",
  args: ["--headless", "--no-sandbox", "--disable-gpu", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
});
for (const file of pages) {
  const page = await browser.newPage({ viewport: { width: 1240, height: 860 }, colorScheme: "light" });
  page.setDefaultTimeout(300000); // without a GPU a large mesh takes minutes
  await page.goto(pathToFileURL(resolve(file)).href, { waitUntil: "commit" });
  await page.waitForFunction(() => document.documentElement.dataset.ready === "yes");
  await page.evaluate(() => {
    document.querySelector(".views").scrollIntoView({ behavior: "instant", block: "start" });
    return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  });
  const clip = await page.evaluate(() => {
    const { x, y, width, height } = document.querySelector(".views").getBoundingClientRect();
    return { x, y, width, height };
  });
  const path = join(folder, basename(file).replace(/\.html$/, ".jpg"));
  await page.screenshot({ path, clip, type: "jpeg", quality: 82 });
  await page.close();
}
await browser.close();
