// The page: everything it tells is in report-data, and the meshes are in view-NAME.
import { legendOf } from "./colours.js";
import { accuracyChart, histogramChart, redrawCharts } from "./charts.js";
import { byId, element } from "./dom.js";
import { unpackMesh } from "./mesh.js";
import { at, bytes, count, percent, short } from "./numbers.js";
import { Scenes } from "./scene.js";
import { sortableTable } from "./table.js";

const report = JSON.parse(byId("report-data").textContent);
const done = report.contestants.filter((c) => c.status === "done");
const titles = Object.fromEntries(report.contestants.map((c) => [c.name, c.title]));
const mostRows = 300;
const ofLabels = report.input.labels !== undefined; // a label map: parts in place of surfaces

// ---- Words ----

function showHeadline() {
  const sentences = report.headline.split(/(?<=\.) (?=[A-Z])/);
  const kept = (text) => text.replace(/(\d) (mm|%)/g, "$1\u00a0$2"); // a number keeps its unit
  byId("headline").textContent = kept(sentences[0]);
  byId("lead").textContent = kept(sentences.slice(1).join(" "));
  const { input } = report;
  byId("scan-name").textContent = ofLabels ? `${input.name}, ${count(input.labels)} labels` : `${input.name}, isovalue ${input.isovalue}`;
  document.title = `${input.name}: Voroprobe and marching cubes`;
  if (!ofLabels) return;
  byId("surfaces-title").textContent = "The parts of the labels";
  byId("mode").querySelector("[value=piece]").textContent = "label";
  byId("how-measured").textContent = "Two voxels of a label that share a face, an edge or a corner belong to one part. A part counts as meshed " +
    "where a closed piece of its label’s mesh has most of its corners next to the part’s voxels. Volumes are compared with those of the " +
    "voxels, label by label. Distances are those to the staircase of the voxels, halfway between those inside and those outside, both ways, at " +
    "the points that were looked at; a label without any mesh is left out of them. To be near the staircase is no merit: labels are smoothed on " +
    "purpose, so equal accuracy is not asked for. Times are those of one processor.";
}

function showFacts() {
  byId("command").textContent = report.command;
  const { input, parameters: p, machine } = report;
  const facts = {
    Scan: `${input.path} (${input.format}, ${input.type}), ${input.size.join(" × ")} voxels of ${input.spacing_mm.map((x) => short(x, 4)).join(" × ")} mm${ofLabels ? "" : `, values ${short(input.min)} to ${short(input.max)}`}`,
    ...(ofLabels ? { Labels: `${count(input.labels)}, smoothing of Voroprobe’s ${p.smoothing}${p.sigma_mm ? `, ${short(p.sigma_mm)} mm` : ""}` }
                 : { Isovalue: `${input.isovalue} (${input.isovalue_source}), inside ${input.inside}` }),
    Criteria: `radius ${short(p.size_mm)} mm, angle ${p.angle_deg}°, distance ${short(p.distance_mm)} mm, floor ${short(p.floor_mm)} mm, reach ${short(p.reach_mm)} mm`,
    Unit: `1 voxel here is ${short(report.voxel_mm, 4)} mm, the side of the cube of a voxel’s volume`,
    Samples: `${count(p.samples)} points of each mesh, half as many of the scan`,
    Machine: `${machine.processor || "unknown processor"}, ${machine.processors} processors, ${bytes(machine.memory_bytes)}; ${p.at_once} contestants at a time, one thread each`,
    Versions: [`Voroprobe ${report.version}`, ...Object.entries(report.libraries).map(([name, version]) => `${name} ${version}`)].join(", "),
    Date: report.date,
  };
  if (input.warnings.length > 0) facts.Warnings = input.warnings.join("; ");
  if (report.pictures_missing) facts.Pictures = `none: ${report.pictures_missing}`;
  for (const [name, text] of Object.entries(facts)) byId("facts").append(element("dt", {}, name), element("dd", {}, text));
}

// ---- Table of contestants ----

const mark = (yes) => element("span", { class: yes ? "yes" : "no" }, yes ? "yes" : "no");

const plain = (x) => short(x);

function column(title, path, show, hint) {
  return { title, path, hint, value: (c) => at(c, path) ?? null, show: (c) => show(at(c, path), c) };
}

function surfacesShown(_, c) {
  const { meshed, expected } = c.surfaces;
  return element("span", { class: meshed === expected ? "yes" : "no" }, `${count(meshed)} of ${count(expected)}`);
}

const stages = (c) => c.time.stages.map((s) => `${s.name} ${short(s.cpu_seconds, 2)} s`).join(", ") || "made elsewhere";
const degrees = (x) => `${short(x)}°`;

function labelColumns() {
  return [
    column("largest volume change", "labels.largest_volume_change", percent, "Of any label, from the volume of its voxels"),
    column("mean volume change", "labels.mean_volume_change", percent, "Over the labels, from the volume of their voxels"),
    column("labels beyond 2 %", "labels.beyond_2_percent", count, "Labels whose volume changes by more"),
    column("labels not closed or manifold", "labels.not_closed_manifold", count),
  ];
}

function contestantColumns() {
  return [
    { title: "Mesh", value: (c) => c.title, show: (c) => c.title },
    ofLabels ? column("parts", "surfaces.meshed", surfacesShown, "Parts of the labels that have a closed piece of the mesh")
             : column("surfaces", "surfaces.meshed", surfacesShown, "Surfaces of the scan that have a closed piece of the mesh"),
    ...(ofLabels ? labelColumns() : []),
    column("vertices", "vertices", count),
    column("under 30°", "angles.share_below_30", percent, "Share of the triangles"),
    column("smallest angle", "angles.min_deg", degrees),
    column("RMS mm", "distance.mm.rms", plain, "Distance between mesh and scan, both ways"),
    column("max mm", "distance.mm.max", plain, "Distance between mesh and scan, both ways"),
    column("closed", "topology.closed", mark),
    column("manifold", "topology.manifold", mark),
    column("crossings", "topology.self_intersections", count, "Pairs of triangles that cross or overlap"),
    column("seconds", "time.cpu_seconds", (x, c) => element("span", { title: stages(c) }, short(x)), "Processor time"),
    column("memory", "peak_memory_bytes", bytes, "Peak, beside what was there before"),
    column("faces", "faces", count),
    column("mean smallest", "angles.mean_min_deg", degrees, "Mean over the triangles of their smallest angle"),
    column("under 10°", "angles.share_below_10", percent, "Share of the triangles"),
    column("under 20°", "angles.share_below_20", percent, "Share of the triangles"),
    column("largest angle", "angles.max_deg", degrees),
    column("mean mm", "distance.mm.mean", plain, "Distance between mesh and scan, both ways"),
    column("95 % mm", "distance.mm.p95", plain, "Distance between mesh and scan, both ways"),
    column("RMS voxels", "distance.voxels.rms", plain),
    column("max voxels", "distance.voxels.max", plain),
    column("oriented", "topology.oriented", mark),
    column("pieces", "topology.pieces", count),
    column("genus", "topology.genus", count, "Handles of all closed pieces"),
    column("STL file", "file_size_stl_bytes", bytes, "Binary STL"),
    column("radius-edge", "shape.mean_radius_edge_ratio", plain, "Mean circumradius to shortest edge; 0.58 at best"),
    column("largest radius-edge", "shape.max_radius_edge_ratio", plain),
    column("aspect", "shape.mean_aspect_ratio", plain, "Mean longest edge to inradius; 1 at best"),
    column("largest aspect", "shape.max_aspect_ratio", plain),
    { title: "valence 5 to 7", hint: "Share of the vertices with 5, 6 or 7 triangles",
      value: (c) => [5, 6, 7].reduce((sum, k) => sum + c.shape.vertices_by_valence[k], 0) / c.vertices,
      show: (c) => percent([5, 6, 7].reduce((sum, k) => sum + c.shape.vertices_by_valence[k], 0) / c.vertices) },
    column("area mm²", "area_mm2", plain),
    column("volume mm³", "volume_mm3", plain),
  ];
}

function showContestants() {
  const table = sortableTable({
    caption: "The meshes side by side", columns: contestantColumns(), rows: report.contestants,
    fails: (c) => (c.status === "done" ? null : `failed: ${c.reason}`),
  });
  byId("contestant-table").append(table.node);
  for (const c of report.contestants) {
    const time = c.status === "done" ? ` Time: ${stages(c)}.` : "";
    byId("descriptions").append(element("div", {}, element("dt", {}, c.title), element("dd", {}, c.description + time)));
  }
}

// ---- Equal accuracy ----

function showEqualAccuracy() {
  const equal = report.equal_accuracy;
  if (!equal || equal.contestants.length === 0) return byId("equal").remove();
  byId("equal-text").textContent = `How many vertices each needs to be as near to the scan as marching cubes is with ${count(equal.reference.vertices)}. ` +
    "Each point is a mesh that was made and measured; nothing is extrapolated.";
  byId("equal-charts").append(
    element("div", {}, element("h3", {}, "RMS distance"), accuracyChart("Vertices against RMS distance", equal, titles, "rms_mm", "RMS distance")),
    element("div", {}, element("h3", {}, "Largest distance"), accuracyChart("Vertices against largest distance", equal, titles, "max_mm", "largest distance")));
  const cell = (title, path) => column(title, path, (x) => (x === undefined || x === null ? "not reached" : path.endsWith("vertices") ? count(x) : short(x, 2)));
  const table = sortableTable({
    caption: "Vertices needed at equal accuracy",
    columns: [
      { title: "Mesh", value: (c) => titles[c.name] ?? c.name },
      cell("vertices at equal RMS", "at_equal_rms.vertices"), cell("of marching cubes’", "at_equal_rms.of_reference"),
      cell("vertices at equal maximum", "at_equal_max.vertices"), cell("of marching cubes’", "at_equal_max.of_reference"),
      { title: "meshes tried", value: (c) => c.trials.length },
      { title: "ended early", wide: true, value: (c) => c.ended_by ?? null, show: (c) => c.ended_by ?? "" },
    ],
    rows: equal.contestants,
  });
  byId("equal-table").append(table.node);
}

// ---- Histograms ----

function showHistograms() {
  if (done.length === 0) return;
  for (const [title, key, label] of [
    ["Smallest angle of each triangle", "smallest_angles_deg", "degrees"],
    ["All angles", "angles_deg", "degrees"],
    [`Distance from the ${ofLabels ? "staircase of the voxels" : "scan’s surface"}, both ways`, "distance_voxels", "voxels"],
  ])
    byId("histograms").append(element("div", {}, element("h3", {}, title), histogramChart(title, done, key, label)));
}

// ---- Surfaces of the scan ----

const lostBy = new Map(); // id: [{ contestant, reason }]
for (const contestant of done)
  for (const surface of contestant.surfaces.missing) {
    if (!lostBy.has(surface.id)) lostBy.set(surface.id, []);
    lostBy.get(surface.id).push({ contestant, reason: surface.reason });
  }

function lostText(surface) {
  const lost = lostBy.get(surface.id) ?? [];
  if (lost.length === 0) return element("span", { class: "yes" }, "all");
  const all = lost.length === done.length;
  const node = element("span", { class: "no" }, all ? "none" : `${done.length - lost.length} of ${done.length}`);
  node.title = lost.map(({ contestant, reason }) => `${contestant.title}: ${reason}`).join("\n");
  return element("span", {}, node, element("small", {}, ` lost by ${lost.map(({ contestant }) => contestant.title).join("; ")}`));
}

function showSurfaces(jumpTo) {
  const place = (surface) => surface.center_mm.map((x) => short(x, 4)).join(", ");
  const size = (surface) => surface.size_mm.map((x) => short(x, 2)).join(" × ");
  const columns = [
    { title: ofLabels ? "Part" : "Surface", value: (s) => s.id },
    ...(ofLabels ? [{ title: "label", value: (s) => s.label }] : []),
    { title: "voxels", value: (s) => s.voxels, show: (s) => count(s.voxels), hint: "Samples it encloses" },
    ...(ofLabels ? [] : [{ title: "kind", value: (s) => (s.cavity ? "cavity" : "part") }]),
    { title: "size mm", value: (s) => Math.hypot(...s.size_mm), show: size },
    { title: "place mm (LPS)", value: place },
    ...(ofLabels ? [] : [{ title: "genus", value: (s) => s.genus, show: (s) => count(s.genus) }]),
    { title: "at the border", value: (s) => (s.touches_border ? "yes" : "no") },
    { title: "meshed by", wide: true, value: (s) => done.length - (lostBy.get(s.id)?.length ?? 0), show: lostText },
    { title: "view", value: (s) => s.id, show: (s) => element("button", { type: "button", "aria-label": `Show ${ofLabels ? "part" : "surface"} ${s.id}`, onclick: () => jumpTo(s) }, "show") },
  ];
  const largestFirst = [...report.surfaces].sort((a, b) => b.voxels - a.voxels);
  const table = sortableTable({
    caption: byId("surfaces-title").textContent, columns, rows: largestFirst, most: mostRows,
    more: (shown, all) => `${count(shown)} of ${count(all)} are shown; all are in the report.json beside this page.`,
  });
  byId("surface-table").append(table.node);
  const only = byId("only-lost");
  only.addEventListener("change", () => table.setRows(only.checked ? largestFirst.filter((s) => lostBy.has(s.id)) : largestFirst));
}

// ---- Views ----

const meshes = new Map();

function meshOf(name) {
  if (!meshes.has(name)) meshes.set(name, unpackMesh(byId(`view-${name}`).textContent));
  return meshes.get(name);
}

function captionOf(c) {
  const { faces, faces_of_whole: whole, decimated } = c.view;
  return decimated ? `${count(c.vertices)} vertices; shown decimated to ${count(faces)} of ${count(whole)} triangles`
                   : `${count(c.vertices)} vertices, ${count(faces)} triangles`;
}

function boxOfSurfaces() {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (const { center_mm: center, size_mm: size } of report.surfaces)
    for (let k = 0; k < 3; ++k) {
      min[k] = Math.min(min[k], center[k] - size[k] / 2);
      max[k] = Math.max(max[k], center[k] + size[k] / 2);
    }
  return { min, max };
}

function addView(scenes, shown, first, onChange) {
  const select = element("select", { "aria-label": "Mesh in this view" },
    ...shown.map((c) => element("option", { value: c.name, selected: c === first }, c.title)));
  const caption = element("p", { class: "caption" });
  const canvas = element("canvas", { tabindex: "0" });
  const node = element("div", { class: "view" }, element("div", { class: "bar" }, select, caption), canvas);
  byId("views").append(node);
  const view = scenes.add(canvas);
  const show = () => {
    const contestant = shown.find((c) => c.name === select.value);
    caption.textContent = captionOf(contestant);
    canvas.setAttribute("aria-label", `${contestant.title} in 3D; arrows turn, plus and minus zoom, Home shows the whole`);
    view.show(meshOf(contestant.name));
    scenes.draw();
    onChange();
  };
  select.addEventListener("change", show);
  return { select, show };
}

function fillLost(selects) {
  const names = [...new Set(selects.map((select) => select.value))];
  const options = [];
  for (const c of done.filter(({ name }) => names.includes(name)))
    for (const surface of c.surfaces.missing)
      options.push(element("option", { value: surface.id }, `${c.title}: ${surface.id}, ${count(surface.voxels)} voxels`));
  byId("lost").replaceChildren(element("option", { value: "" }, options.length ? `${count(options.length)}: choose one` : "none by these two"), ...options);
  byId("lost").disabled = options.length === 0;
}

function showLegend(mode) {
  const legend = legendOf(mode, ofLabels ? "staircase of the voxels" : "scan’s surface");
  if (!legend) return byId("legend").replaceChildren(mode !== "piece" ? "" : `Each ${ofLabels ? "label" : "closed component"} has a colour; the largest that of bone.`);
  const marks = element("div", { class: "marks" }, ...legend.marks.map(({ at: place, text }) => element("span", { style: `left: ${100 * place}%` }, text)));
  byId("legend").replaceChildren(element("div", { class: "ramp", style: `background: ${legend.gradient}` }), marks, element("div", {}, legend.unit));
}

function connectTools(scenes) {
  byId("mode").addEventListener("change", ({ target }) => (scenes.setMode(target.value), showLegend(target.value)));
  byId("edges").addEventListener("change", ({ target }) => scenes.setEdges(target.checked));
  const clip = () => {
    byId("clip-place").disabled = !byId("clip-axis").value;
    scenes.setClip(byId("clip-axis").value, Number(byId("clip-place").value));
  };
  byId("clip-axis").addEventListener("change", clip);
  byId("clip-place").addEventListener("input", clip);
  byId("reset").addEventListener("click", () => scenes.reset());
}

function showViews() {
  const shown = done.filter((c) => byId(`view-${c.name}`));
  if (shown.length === 0) throw new Error("no mesh can be shown");
  const scenes = new Scenes(boxOfSurfaces(), byId("mode").value);
  const firsts = [shown[0], shown.find((c) => c.name === "marching_cubes") ?? shown.at(-1)];
  const views = [];
  const selects = () => views.map(({ select }) => select);
  for (const first of new Set(firsts)) views.push(addView(scenes, shown, first, () => fillLost(selects())));
  views.forEach(({ show }) => show());
  const jumpTo = (surface) => {
    scenes.jumpTo(surface.center_mm, surface.size_mm);
    byId("views").scrollIntoView({ block: "center" });
  };
  byId("lost").addEventListener("change", ({ target }) => target.value && jumpTo(report.surfaces.find(({ id }) => id === Number(target.value))));
  connectTools(scenes);
  scenes.reset(); // now that the views have a shape
  return { scenes, jumpTo };
}

function tryToShowViews() {
  try {
    return showViews();
  } catch (error) {
    byId("views").replaceChildren(element("p", { class: "none" }, `There is no 3D view: ${error.message}. The figures below do not need it.`));
    document.querySelector(".tools").remove();
    return { scenes: null, jumpTo: () => {} };
  }
}

// ---- Dark and light ----

function followTheme(scenes) {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  let chosen = null;
  const apply = () => {
    document.documentElement.dataset.theme = chosen ?? (dark.matches ? "dark" : "light");
    scenes?.setBackground(getComputedStyle(document.documentElement).getPropertyValue("--view").trim());
    redrawCharts();
  };
  dark.addEventListener("change", apply);
  byId("theme").addEventListener("click", () => {
    chosen = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
    apply();
  });
  window.addEventListener("beforeprint", () => scenes?.setBackground("#ffffff"));
  window.addEventListener("afterprint", apply);
  apply();
}

document.documentElement.dataset.theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
showHeadline();
showLegend(byId("mode").value);
const { scenes, jumpTo } = tryToShowViews();
showContestants();
showEqualAccuracy();
showHistograms();
showSurfaces(jumpTo);
showFacts();
followTheme(scenes);
document.documentElement.dataset.ready = "yes";
