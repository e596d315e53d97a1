// Makes a report with the program and looks at it in Chromium, as a user would: node page_test.mjs PROGRAM SCAN FOLDER
// Screenshots are left in FOLDER.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [program, scan, folder] = process.argv.slice(2);
const page_file = join(folder, "head.html");
const label_page_file = join(folder, "labels.html");

const absent = { name: "absent", title: "Absent", description: "One that fails.", status: "failed", reason: "it is <not> installed" };

// Puts one that failed into the report of a page.
function addFailure(report) {
  const page = readFileSync(page_file, "utf8");
  const [whole, start, , end] = page.match(/(<script type="application\/json" id="report-data">)(.*)(<\/script>)/);
  report.contestants.push(absent);
  writeFileSync(page_file, page.replace(whole, () => start + JSON.stringify(report).replaceAll("<", "\\u003c") + end));
  return report;
}

// A mesh with nothing but the largest parts, so that something is lost; and one that could not be made.
function makeReport() {
  mkdirSync(folder, { recursive: true });
  const objects = join(folder, "largest.ply");
  execFileSync(program, ["mesh", scan, "--isovalue", "1150.5", "-o", objects, "--keep-largest", "3", "-q"]);
  execFileSync(program, ["compare", scan, "--isovalue", "1150.5", "-o", page_file, "--with", `largest_only=${objects}`,
    "--contestants", "voroprobe,marching_cubes,openvdb,mesh_3", "--samples", "4000", "--contestant-seconds", "100"], { stdio: "pipe" });
  return addFailure(JSON.parse(readFileSync(join(folder, "head.json"), "utf8")));
}

// Two blocks that touch, labels 1 and 2, and a speck of label 2 apart.
function makeLabelReport() {
  const map = join(folder, "labels.nrrd");
  const samples = [];
  for (let k = 0; k < 14; ++k)
    for (let j = 0; j < 14; ++j)
      for (let i = 0; i < 28; ++i) {
        const within = [j, k].every((x) => x >= 3 && x < 11);
        samples.push(within && i >= 3 && i < 19 ? (i < 11 ? 1 : 2) : i === 24 && j === 5 && k === 5 ? 2 : 0);
      }
  writeFileSync(map, `NRRD0004\ntype: uint8\ndimension: 3\nsizes: 28 14 14\nspacings: 1 1 1\nencoding: ascii\n\n${samples.join(" ")}\n`);
  execFileSync(program, ["compare", map, "--labels", "all", "-o", label_page_file, "--pictures", "off", "--samples", "2000"], { stdio: "pipe" });
  return JSON.parse(readFileSync(label_page_file.replace(/html$/, "json"), "utf8"));
}

const tests = [];
const test = (name, run) => tests.push([name, run]);

async function open(browser, options = {}, file = page_file) {
  const context = await browser.newContext({ viewport: { width: 1360, height: 900 }, colorScheme: "light", ...options });
  const page = await context.newPage();
  page.seen = { requests: [], errors: [] };
  page.on("request", (request) => page.seen.requests.push(request.url()));
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && page.seen.errors.push(message.text()));
  page.on("pageerror", (error) => page.seen.errors.push(String(error)));
  await page.goto(pathToFileURL(file).href);
  await page.waitForFunction(() => document.documentElement.dataset.ready === "yes");
  await settle(page);
  return page;
}

const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

// Pixels of each canvas of the views, as the page sees them.
const pixels = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll(".view canvas")].map((canvas) => {
      const copy = document.createElement("canvas");
      copy.width = 160;
      copy.height = 120;
      const context = copy.getContext("2d");
      context.drawImage(canvas, 0, 0, 160, 120);
      return [...context.getImageData(0, 0, 160, 120).data];
    }));

const colours = (image) => new Set(Array.from({ length: image.length / 4 }, (_, i) => image.slice(4 * i, 4 * i + 3).join())).size;
const changed = (a, b) => a.filter((x, i) => Math.abs(x - b[i]) > 8).length;

test("it asks nothing of the network and tells no error", async ({ page }) => {
  assert.deepEqual(page.seen.requests.filter((url) => !url.startsWith("file:") && !url.startsWith("data:")), []);
  assert.equal(page.seen.requests.filter((url) => url.startsWith("file:")).length, 1);
  assert.deepEqual(page.seen.errors.filter((text) => !text.includes("GPU stall due to ReadPixels")), []);
});

test("the views are not blank", async ({ page }) => {
  const images = await pixels(page);
  assert.equal(images.length, 2);
  for (const image of images) assert.ok(colours(image) > 100, `${colours(image)} colours`);
});

test("turning one view turns both", async ({ page }) => {
  const before = await pixels(page);
  const box = await page.locator(".view canvas").first().boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 120, box.y + box.height / 2 + 30, { steps: 4 });
  await page.mouse.up();
  await settle(page);
  const after = await pixels(page);
  before.forEach((image, i) => assert.ok(changed(image, after[i]) > 1000, `view ${i}`));
});

test("the keyboard turns, zooms and goes back", async ({ page }) => {
  await page.click("#reset");
  await settle(page);
  const whole = await pixels(page);
  await page.locator(".view canvas").nth(1).focus();
  for (const key of ["ArrowLeft", "ArrowUp", "+"]) {
    const before = await pixels(page);
    await page.keyboard.press(key);
    await settle(page);
    const after = await pixels(page);
    before.forEach((image, i) => assert.ok(changed(image, after[i]) > 300, `${key}, view ${i}`));
  }
  await page.keyboard.press("Home");
  await settle(page);
  const back = await pixels(page);
  whole.forEach((image, i) => assert.equal(changed(image, back[i]), 0));
});

test("colours, triangles and the cut change what is seen", async ({ page }) => {
  let before = await pixels(page);
  const step = async (name, act) => {
    await act();
    await settle(page);
    const after = await pixels(page);
    before.forEach((image, i) => assert.ok(changed(image, after[i]) > 200, `${name}, view ${i}`));
    before = after;
  };
  for (const mode of ["distance", "piece", "angle", "plain", "angle"]) await step(mode, () => page.selectOption("#mode", mode));
  await step("triangles", () => page.check("#edges"));
  for (const axis of ["x", "y", "z"]) await step(`cut ${axis}`, () => page.selectOption("#clip-axis", axis));
  await step("cut place", () => page.fill("#clip-place", "0.25"));
  await step("no cut", () => page.selectOption("#clip-axis", ""));
  await page.uncheck("#edges");
});

test("another mesh can be chosen, and a surface that it lost be jumped to", async ({ page, report }) => {
  const other = report.contestants.find((c) => c.name === "largest_only");
  assert.ok(other.surfaces.missing.length >= 20);
  const before = await pixels(page);
  await page.locator(".view select").nth(1).selectOption("largest_only");
  await settle(page);
  const chosen = await pixels(page);
  assert.ok(changed(before[1], chosen[1]) > 20);
  await page.selectOption("#lost", String(other.surfaces.missing[0].id));
  await settle(page);
  const jumped = await pixels(page);
  jumped.forEach((image, i) => assert.ok(changed(image, chosen[i]) > 500, `view ${i}`));
  await page.click("#reset");
});

test("the table has the numbers of report.json", async ({ page, report }) => {
  const cells = await page.$$eval("#contestant-table tbody tr[data-name]", (rows) =>
    rows.flatMap((row) => [...row.querySelectorAll("[data-path]")].map((cell) => [row.dataset.name, cell.dataset.path, cell.dataset.value])));
  let compared = 0;
  for (const [name, path, value] of cells) {
    const contestant = report.contestants.find((c) => c.name === name);
    const expected = path.split(".").reduce((inner, key) => inner[key], contestant);
    assert.equal(value ?? null, expected === null ? null : String(expected), `${name} ${path}`);
    ++compared;
  }
  assert.ok(compared > 100);
  const words = `${await page.textContent("#headline")} ${await page.textContent("#lead")}`;
  assert.equal(words.trim().replaceAll("\u00a0", " "), report.headline);
});

test("a mesh that could not be made is told of with the reason", async ({ page }) => {
  assert.match(await page.locator("#contestant-table tr.failed").innerText(), /Absent\s+failed: it is <not> installed/);
});

test("the table sorts both ways, by number", async ({ page }) => {
  const column = page.locator("#contestant-table thead button", { hasText: /^vertices$/ });
  const values = () => page.$$eval("#contestant-table tbody tr[data-name] td[data-path=vertices]", (cells) => cells.map((c) => Number(c.dataset.value)));
  await column.click();
  const up = await values();
  assert.deepEqual(up, [...up].sort((a, b) => a - b));
  await column.click();
  assert.deepEqual(await values(), [...up].reverse());
});

test("the surfaces are listed, and those that are lost can be picked out", async ({ page, report }) => {
  assert.equal(await page.locator("#surface-table tbody tr").count(), Math.min(300, report.surfaces.length));
  await page.check("#only-lost");
  const lost = new Set(report.contestants.flatMap((c) => c.surfaces?.missing.map((s) => s.id) ?? []));
  assert.equal(await page.locator("#surface-table tbody tr").count(), Math.min(300, lost.size));
  const before = await pixels(page);
  await page.locator("#surface-table button", { hasText: "show" }).first().click();
  await settle(page);
  assert.ok(changed(before[0], (await pixels(page))[0]) > 500);
});

test("every control and every view has a name, and headings come in order", async ({ page }) => {
  const nameless = await page.$$eval("button, select, input, .view canvas, [role=img]", (nodes) =>
    nodes.filter((n) => !(n.getAttribute("aria-label") || n.textContent.trim() || n.labels?.[0]?.textContent.trim())).map((n) => n.outerHTML.slice(0, 80)));
  assert.deepEqual(nameless, []);
  const levels = await page.$$eval("h1, h2, h3", (heads) => heads.map((h) => Number(h.tagName[1])));
  levels.reduce((before, level) => (assert.ok(level <= before + 1), level), 0);
  assert.equal(levels.filter((level) => level === 1).length, 1);
});

test("a phone shows it without scrolling sideways, dark and light differ", async ({ browser }) => {
  const phone = await open(browser, { viewport: { width: 390, height: 844 }, colorScheme: "dark", isMobile: true, hasTouch: true });
  const wide = await phone.evaluate(() => [...document.querySelectorAll("main *")]
    .filter((n) => !n.closest(".scroll") && n.getBoundingClientRect().right > 391).map((n) => `${n.tagName}.${n.className} ${n.getBoundingClientRect().right}`));
  assert.deepEqual(wide.slice(0, 5), []);
  assert.ok((await phone.evaluate(() => document.documentElement.scrollWidth)) <= 390);
  const dark = await phone.evaluate(() => getComputedStyle(document.body).backgroundColor);
  await phone.screenshot({ path: join(folder, "phone-dark.png"), fullPage: true });
  await phone.click("#theme");
  const light = await phone.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.notEqual(dark, light);
  assert.deepEqual(phone.seen.errors.filter((text) => !text.includes("GPU stall")), []);
  await phone.context().close();
});

test("of a label map the parts are listed, by label", async ({ browser }) => {
  const labels = makeLabelReport();
  const page = await open(browser, {}, label_page_file);
  assert.deepEqual(page.seen.errors.filter((text) => !text.includes("GPU stall")), []);
  for (const image of await pixels(page)) assert.ok(colours(image) > 20);
  assert.match(await page.textContent("#headline"), /^Voroprobe has 3 of 3 parts of 2 labels /);
  assert.equal(await page.locator("#surface-table tbody tr").count(), 3);
  const heads = await page.$$eval("#surface-table thead button", (buttons) => buttons.map((b) => b.textContent));
  assert.deepEqual(heads.slice(0, 3), ["Part", "label", "voxels"]);
  const changes = await page.$$eval("[data-path='labels.largest_volume_change']", (cells) => cells.map((c) => Number(c.dataset.value)));
  assert.deepEqual(changes, labels.contestants.map((c) => c.labels.largest_volume_change));
  assert.equal(await page.locator("#equal").count(), 0);
  await page.locator("#surface-table button", { hasText: "show" }).last().click();
  await page.selectOption("#mode", "piece");
  await settle(page);
  await page.screenshot({ path: join(folder, "labels.png"), fullPage: true });
  await page.context().close();
});

test("without WebGL the figures are still there", async ({ browser }) => {
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = new Proxy(HTMLCanvasElement.prototype.getContext, {
      apply: (target, self, [kind, ...rest]) => (String(kind).startsWith("webgl") ? null : Reflect.apply(target, self, [kind, ...rest])),
    });
  });
  await page.goto(pathToFileURL(page_file).href);
  await page.waitForFunction(() => document.documentElement.dataset.ready === "yes");
  assert.match(await page.textContent("#views"), /no 3D view/);
  assert.ok((await page.locator("#contestant-table tbody tr").count()) >= 5);
  await context.close();
});

async function takeScreenshots(browser) {
  for (const scheme of ["light", "dark"]) {
    const page = await open(browser, { colorScheme: scheme });
    await page.screenshot({ path: join(folder, `${scheme}.png`), fullPage: true });
    if (scheme === "light") writeFileSync(join(folder, "print.pdf"), await page.pdf({ format: "A4" }));
    await page.context().close();
  }
}

const report = makeReport();
const profile = mkdtempSync(join(tmpdir(), "voroprobe-page-"));
const browser = await chromium.launch({
  executablePath: "/usr/bin/chromium",
  args: ["--headless", "--no-sandbox", "--disable-gpu", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
});
let failures = 0;
try {
  const page = await open(browser);
  for (const [name, run] of tests) {
    try {
      await run({ browser, page, report });
      console.log(`ok      ${name}`);
    } catch (error) {
      ++failures;
      console.log(`FAILED  ${name}\n${error.stack}`);
    }
  }
  await takeScreenshots(browser);
} finally {
  await browser.close();
  rmSync(profile, { recursive: true, force: true });
}
console.log(`${tests.length - failures} of ${tests.length} hold; screenshots are in ${folder}`);
process.exit(failures === 0 ? 0 : 1);
