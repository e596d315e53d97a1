// Makes page.html: src/page.html with the style and the bundled scripts put in. `npm ci && npm run build`
//
//   node build.mjs [OUTPUT]
import { build } from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const folder = dirname(fileURLToPath(import.meta.url));
const output = process.argv[2] ?? join(folder, "page.html");

async function bundled(entry) {
  const result = await build({
    entryPoints: [join(folder, "src", entry)],
    absWorkingDir: folder,
    bundle: true,
    minify: true,
    write: false,
    legalComments: "none", // NOTICES below has them
    charset: "utf8",
    target: ["chrome110", "firefox110", "safari16.4"],
    format: "iife",
    loader: { ".css": "css" },
  });
  return result.outputFiles[0].text.trim();
}

function licence(name) {
  const { version, license } = JSON.parse(readFileSync(join(folder, "node_modules", name, "package.json")));
  return `${name} ${version} (${license})`;
}

const script = (await bundled("main.js")).replaceAll("</script", "<\\/script");
const style = await bundled("style.css");
const notices = `<!-- Holds ${["three", "uplot", "fflate"].map(licence).join(", ")}; their notices are in report/NOTICES. -->`;
const page = readFileSync(join(folder, "src", "page.html"), "utf8")
  .replace("<!-- notices -->", () => notices)
  .replace("/* style */", () => style)
  .replace("/* script */", () => script);
writeFileSync(output, page);
