// Histograms and the curves of equal accuracy, by uPlot.
import uPlot from "uplot";
import { element } from "./dom.js";
import { short } from "./numbers.js";

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

// Ours and the reference stand out; the others have quiet colours of their own.
export function colourOf(name, i) {
  if (name === "voroprobe") return css("--ours");
  if (name === "marching_cubes") return css("--reference");
  return ["#7a9e7e", "#9b7fb5", "#c08457", "#5f8ea8", "#a0607a", "#8a8a55", "#6f7f8f"][i % 7];
}

const charts = [];

function axis(label, values) {
  return {
    label, values, labelSize: 24, size: 56, labelFont: "13px system-ui, sans-serif", font: "12px system-ui, sans-serif",
    stroke: () => css("--soft"), grid: { stroke: () => css("--line"), width: 1 }, ticks: { stroke: () => css("--line"), width: 1 },
  };
}

function series(contestant, i, more) {
  const strong = contestant.name === "voroprobe" || contestant.name === "marching_cubes";
  return {
    label: contestant.title, stroke: () => colourOf(contestant.name, i), width: strong ? 2.5 : 1.25, points: { show: false },
    show: strong || more.all, value: (_, v) => (v === null || v === undefined ? "–" : short(v)), ...more.options,
  };
}

// A chart that follows the width of its place and the colours of the page.
function chart(label, options, data) {
  const node = element("figure", { class: "chart", role: "img", "aria-label": label });
  const plot = new uPlot({ width: 480, height: 300, cursor: { points: { size: 6 } }, legend: { live: true }, ...options }, data, node);
  plot.root.querySelectorAll(".u-series").forEach((row) => {
    const head = row.querySelector("th");
    head.tabIndex = 0;
    head.setAttribute("role", "button");
    head.addEventListener("keydown", (event) => event.key === "Enter" && head.click());
  });
  new ResizeObserver(([entry]) => plot.setSize({ width: Math.max(260, entry.contentRect.width), height: 300 })).observe(node);
  charts.push(plot);
  return node;
}

export const redrawCharts = () => charts.forEach((plot) => plot.redraw(false));

// Shares of a histogram's bins, in percent.
export function histogramChart(label, contestants, key, xLabel) {
  const first = contestants[0].histograms[key];
  const bins = first.counts.length;
  const width = (first.high - first.low) / bins;
  const xs = Array.from({ length: bins }, (_, i) => first.low + (i + 0.5) * width);
  const shares = contestants.map(({ histograms }) => {
    const { counts } = histograms[key];
    const sum = counts.reduce((a, b) => a + b, 0) || 1;
    return counts.map((n) => (100 * n) / sum);
  });
  const step = uPlot.paths.stepped({ align: 0 });
  return chart(label, {
    scales: { x: { time: false, range: [first.low, first.high] }, y: { range: (_, low, high) => [0, 1.05 * high] } },
    axes: [axis(xLabel), axis("percent")],
    series: [{ label: xLabel, value: (_, v) => (v === null ? "–" : short(v)) }, ...contestants.map((c, i) => series(c, i, { options: { paths: step } }))],
  }, [xs, ...shares]);
}

// 1, 2 or 5 times a power of ten, below or above: whole powers alone would press the data into a corner.
function roundNumber(x, side) {
  const power = 10 ** Math.floor(Math.log10(x));
  const rounds = [1, 2, 5, 10].map((k) => k * power);
  return side === "below" ? rounds.filter((r) => r <= x * 1.000001).at(-1) : rounds.find((r) => r >= x * 0.999999);
}

const aroundAll = (_, low, high) => [roundNumber(low / 1.05, "below"), roundNumber(high * 1.05, "above")];

// Of the ticks between powers of ten those at 1, 2 and 5 are told.
const isTold = (x) => [1, 2, 5].some((k) => Math.abs(x / 10 ** Math.floor(Math.log10(x * 1.000001)) - k) < 1e-6);
const toldTicks = { filter: (_, splits) => splits.map((x) => (isTold(x) ? x : null)), values: (_, ticks) => ticks.map((t) => (t === null ? "" : short(t))) };

// Vertices against distance, both logarithmic: every trial is a point.
export function accuracyChart(label, equal, titles, key, goal) {
  const contestants = [{ name: equal.reference.name, trials: [equal.reference] }, ...equal.contestants]
    .map((c) => ({ name: c.name, title: titles[c.name] ?? c.name, trials: c.trials.filter((t) => t[key] > 0) }));
  const points = contestants.flatMap((c, i) => c.trials.map((t) => ({ x: t[key], y: t.vertices, i }))).sort((a, b) => a.x - b.x);
  const data = [points.map((p) => p.x), ...contestants.map((_, i) => points.map((p) => (p.i === i ? p.y : null)))];
  return chart(label, {
    scales: { x: { time: false, distr: 3, range: aroundAll }, y: { distr: 3, range: aroundAll } },
    axes: [{ ...axis(`${goal}, mm`), ...toldTicks }, { ...axis("vertices"), size: 76, ...toldTicks }],
    series: [{ label: `${goal}, mm`, value: (_, v) => (v === null ? "–" : short(v)) },
      ...contestants.map((c, i) => series(c, i, { all: true, options: { spanGaps: true, points: { show: true, size: c.name === "marching_cubes" ? 11 : 7 } } }))],
  }, data);
}
