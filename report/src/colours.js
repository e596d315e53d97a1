// What the colours of faces mean: angle and distance from pale to strong, pieces by hue.

function hex(text) {
  return [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16));
}

// Stops of [value, colour]; between them straight lines.
const ramps = {
  angle: { stops: [[0, "#8f1023"], [10, "#d0482f"], [20, "#f0a35e"], [30, "#f3ead6"], [45, "#9ecae0"], [60, "#2b7bba"]], unit: "°" },
  distance: { stops: [[0, "#f3efe3"], [0.1, "#f2cf9a"], [0.25, "#e08a5b"], [0.5, "#b3446c"], [1, "#3d1a5b"]], unit: " voxels" },
};

function colourAt(ramp, value) {
  const stops = ramp.stops;
  let i = 1;
  while (i < stops.length - 1 && value > stops[i][0]) ++i;
  const [low, from] = stops[i - 1];
  const [high, to] = stops[i];
  const part = Math.min(1, Math.max(0, (value - low) / (high - low)));
  const [a, b] = [hex(from), hex(to)];
  return a.map((x, k) => Math.round(x + (b[k] - x) * part));
}

function table(ramp, valueOfByte) {
  return Array.from({ length: 256 }, (_, byte) => colourAt(ramp, valueOfByte(byte)));
}

const angleColours = table(ramps.angle, (byte) => byte / 4);
const distanceColours = table(ramps.distance, (byte) => byte / 255);
const bone = hex("#d8d2c4");

// Hues a golden angle apart: neighbours in number are far apart in colour. The largest piece is the colour of bone.
function pieceColour(piece, largest) {
  if (piece === largest) return bone;
  const hue = (piece * 137.508) % 360;
  const part = (k) => {
    const x = (k + hue / 30) % 12;
    return Math.round(255 * (0.58 - 0.3 * Math.max(-1, Math.min(x - 3, 9 - x, 1))));
  };
  return [part(0), part(8), part(4)];
}

function largestPiece(pieces) {
  const count = new Map();
  for (const piece of pieces) count.set(piece, (count.get(piece) ?? 0) + 1);
  return [...count].reduce((best, entry) => (entry[1] > best[1] ? entry : best), [0, -1])[0];
}

// Colours of the three corners of every face, RGB bytes.
export function faceColours(mesh, mode) {
  const largest = mode === "piece" ? largestPiece(mesh.pieces) : 0;
  const colourOf = {
    angle: (face) => angleColours[mesh.angles[face]],
    distance: (face) => distanceColours[mesh.distances[face]],
    piece: (face) => pieceColour(mesh.pieces[face], largest),
    plain: () => bone,
  }[mode];
  const colours = new Uint8Array(9 * mesh.faces);
  for (let face = 0; face < mesh.faces; ++face) {
    const colour = colourOf(face);
    for (let corner = 0; corner < 3; ++corner) colours.set(colour, 9 * face + 3 * corner);
  }
  return colours;
}

// A CSS gradient and its marks, for the legend; null where the mode has none.
export function legendOf(mode, surface) {
  const ramp = ramps[mode];
  if (!ramp) return null;
  const longest = ramp.stops.at(-1)[0];
  const gradient = ramp.stops.map(([value, colour]) => `${colour} ${(100 * value) / longest}%`).join(", ");
  return {
    gradient: `linear-gradient(to right, ${gradient})`,
    marks: ramp.stops.map(([value]) => ({ at: value / longest, text: `${value}${ramp.unit === "°" ? "°" : ""}` })),
    unit: mode === "angle" ? "smallest angle of the triangle" : `distance from the ${surface}, voxels`,
  };
}
