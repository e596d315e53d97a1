// Numbers for people.

export const count = (n) => n.toLocaleString("en-US");

export function short(n, digits = 3) {
  if (n === null || n === undefined) return "infinite";
  if (n === 0) return "0";
  if (Math.abs(n) >= 1000) return Math.round(n).toLocaleString("en-US");
  return String(Number(n.toPrecision(digits)));
}

export const percent = (share) => `${short(100 * share, 2)} %`;

export function bytes(n) {
  for (const [unit, size] of [["GB", 1e9], ["MB", 1e6], ["kB", 1e3]]) if (n >= size) return `${short(n / size)} ${unit}`;
  return `${n} B`;
}

// The value at "angles.min_deg" of a contestant.
export const at = (object, path) => path.split(".").reduce((value, key) => value?.[key], object);
