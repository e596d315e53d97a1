// Reads the meshes that src/compare/view_packing.cpp packs; the byte order is told there.
import { unzlibSync } from "fflate";

function bytesOfBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

class Reader {
  constructor(bytes) {
    this.bytes = bytes;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    this.at = 0;
  }

  uint32() {
    this.at += 4;
    return this.view.getUint32(this.at - 4, true);
  }

  float64() {
    this.at += 8;
    return this.view.getFloat64(this.at - 8, true);
  }

  take(count) {
    this.at += count;
    return this.bytes.subarray(this.at - count, this.at);
  }

  varint() {
    let number = 0;
    for (let factor = 1; ; factor *= 128) {
      const byte = this.bytes[this.at++];
      number += (byte & 127) * factor;
      if (byte < 128) return number;
    }
  }
}

function readPlaces(reader, count, lowest, extent) {
  const places = new Float32Array(3 * count);
  for (let axis = 0; axis < 3; ++axis) {
    const low = reader.take(count);
    const high = reader.take(count);
    let place = 0;
    for (let i = 0; i < count; ++i) {
      place = (place + low[i] + 256 * high[i]) & 65535;
      places[3 * i + axis] = lowest[axis] + (extent[axis] * place) / 65535;
    }
  }
  return places;
}

function readCorners(reader, count) {
  const corners = new Uint32Array(3 * count);
  let used = 0;
  for (let i = 0; i < corners.length; ++i) {
    const back = reader.varint();
    corners[i] = back === 0 ? used++ : used - back;
  }
  return corners;
}

function readPieces(reader, count) {
  const pieces = new Uint32Array(count);
  let piece = 0;
  for (let i = 0; i < count; ++i) {
    const step = reader.varint();
    piece += step % 2 === 1 ? -(step + 1) / 2 : step / 2;
    pieces[i] = piece;
  }
  return pieces;
}

// {places: 3 numbers a vertex, corners: 3 a face, angles: quarter degrees, distances: 0 to 255, pieces} by face.
export function unpackMesh(text) {
  const reader = new Reader(unzlibSync(bytesOfBase64(text.trim())));
  const vertices = reader.uint32();
  const faces = reader.uint32();
  const lowest = [reader.float64(), reader.float64(), reader.float64()];
  const extent = [reader.float64(), reader.float64(), reader.float64()];
  return {
    places: readPlaces(reader, vertices, lowest, extent),
    corners: readCorners(reader, faces),
    angles: reader.take(faces),
    distances: reader.take(faces),
    pieces: readPieces(reader, faces),
    faces,
    vertices,
  };
}
