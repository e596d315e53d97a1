// The views: several canvases, one camera.
import {
  AmbientLight, BufferAttribute, BufferGeometry, Box3, Box3Helper, Color, DirectionalLight, DoubleSide, Mesh,
  MeshLambertMaterial, PerspectiveCamera, Plane, Scene, Spherical, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { faceColours } from "./colours.js";

const fieldOfView = 30;
const margin = 1.04;
const keySteps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

// Where the camera stands at first: in front (LPS: y runs to the back), to one side, a little above.
const firstDirection = new Vector3(0.5, -1, 0.35).normalize();

// Three corners for every face: colours are those of faces.
function geometryOf(mesh) {
  const places = new Float32Array(9 * mesh.faces);
  for (let i = 0; i < 3 * mesh.faces; ++i) {
    const vertex = 3 * mesh.corners[i];
    places[3 * i] = mesh.places[vertex];
    places[3 * i + 1] = mesh.places[vertex + 1];
    places[3 * i + 2] = mesh.places[vertex + 2];
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(places, 3));
  return geometry;
}

// Flat faces; their edges drawn by how near a pixel is to one; darker from behind, where the clip plane opens the mesh.
function materialOf(shared) {
  const material = new MeshLambertMaterial({
    vertexColors: true, side: DoubleSide, flatShading: true, clippingPlanes: shared.clipping,
  });
  material.onBeforeCompile = (shader) => {
    shader.uniforms.edgeStrength = shared.edgeStrength;
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nvarying vec3 corner;")
      .replace("#include <begin_vertex>", "#include <begin_vertex>\nint k = gl_VertexID % 3;\ncorner = vec3(k == 0, k == 1, k == 2);");
    shader.fragmentShader = shader.fragmentShader
      .replace("#include <common>", "#include <common>\nvarying vec3 corner;\nuniform float edgeStrength;")
      .replace("#include <color_fragment>", `#include <color_fragment>
        diffuseColor.rgb = pow(diffuseColor.rgb, vec3(2.2)); // the colours are those of screens
        vec3 reach = smoothstep(vec3(0.0), 1.2 * fwidth(corner), corner);
        float edge = 1.0 - min(reach.x, min(reach.y, reach.z));
        if (!gl_FrontFacing) diffuseColor.rgb *= 0.45;
        diffuseColor.rgb = mix(diffuseColor.rgb, vec3(0.006, 0.01, 0.018), edge * edgeStrength);`);
  };
  return material;
}

class View {
  constructor(canvas, shared) {
    this.canvas = canvas;
    this.shared = shared;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.localClippingEnabled = true;
    this.scene = new Scene();
    this.scene.add(new AmbientLight(0xffffff, 1.2));
    this.light = new DirectionalLight(0xffffff, 2.2);
    this.scene.add(this.light, this.light.target);
    this.mark = new Box3Helper(new Box3(), new Color("#d6006f"));
    this.mark.visible = false;
    this.scene.add(this.mark);
    this.material = materialOf(shared);
    this.object = null;
    this.data = null;
  }

  show(data) {
    if (this.object) {
      this.scene.remove(this.object);
      this.object.geometry.dispose();
    }
    this.data = data;
    this.object = data ? new Mesh(geometryOf(data), this.material) : null;
    if (this.object) this.scene.add(this.object);
    this.colour();
  }

  colour() {
    if (this.object)
      this.object.geometry.setAttribute("color", new BufferAttribute(faceColours(this.data, this.shared.mode), 3, true));
  }

  resize() {
    const width = Math.max(1, this.canvas.clientWidth);
    const height = Math.max(1, this.canvas.clientHeight);
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setSize(width, height, false);
  }

  draw(camera, background) {
    camera.aspect = this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight);
    camera.updateProjectionMatrix();
    this.light.position.copy(camera.position);
    this.light.target.position.copy(this.shared.target);
    this.renderer.setClearColor(background);
    this.renderer.render(this.scene, camera);
  }
}

function cornersOf({ min, max }) {
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) => new Vector3(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z));
}

// Vertices of a mesh, a few thousand at most.
function somePoints({ places }) {
  const vertices = places.length / 3;
  const step = Math.max(1, Math.floor(vertices / 4000));
  return Array.from({ length: Math.floor(vertices / step) }, (_, i) => new Vector3(...places.subarray(3 * step * i, 3 * step * i + 3)));
}

export class Scenes {
  // box: {min, max} of all surfaces, mm.
  constructor(box, mode) {
    this.box = new Box3(new Vector3(...box.min), new Vector3(...box.max));
    this.shared = { mode, clipping: [], edgeStrength: { value: 0 }, target: this.box.getCenter(new Vector3()) };
    this.plane = new Plane(new Vector3(-1, 0, 0), 0);
    this.camera = new PerspectiveCamera(fieldOfView, 1, 1, 1000);
    this.camera.up.set(0, 0, 1);
    this.background = new Color("#ffffff");
    this.views = [];
    this.waiting = false;
    this.reset();
  }

  // Throws where there is no WebGL.
  add(canvas) {
    const view = new View(canvas, this.shared);
    const controls = new OrbitControls(this.camera, canvas);
    controls.target = this.shared.target;
    controls.update(); // made, it looked at the origin
    controls.addEventListener("change", () => this.draw());
    view.controls = controls;
    canvas.addEventListener("keydown", (event) => this.#key(event));
    this.views.push(view);
    new ResizeObserver(() => {
      view.resize();
      this.draw();
    }).observe(canvas);
    return view;
  }

  reset() {
    const meshes = this.views.filter(({ data }) => data).flatMap(({ data }) => somePoints(data));
    this.#look(this.box, firstDirection, meshes.length > 0 ? meshes : undefined);
    this.views.forEach((view) => view.mark && (view.mark.visible = false));
    this.draw();
  }

  // Moves the camera next to a place, and marks a box there.
  jumpTo(center, size) {
    const middle = new Vector3(...center);
    const box = new Box3().setFromCenterAndSize(middle, new Vector3(...size));
    const least = 0.02 * this.box.getSize(new Vector3()).length();
    const seen = new Box3().setFromCenterAndSize(middle, new Vector3(...size).multiplyScalar(3).addScalar(least));
    this.#look(seen, this.camera.position.clone().sub(this.shared.target).normalize());
    for (const view of this.views) {
      view.mark.box.copy(box);
      view.mark.visible = true;
    }
    this.draw();
  }

  setMode(mode) {
    this.shared.mode = mode;
    this.views.forEach((view) => view.colour());
    this.draw();
  }

  setEdges(shown) {
    this.shared.edgeStrength.value = shown ? 0.85 : 0;
    this.draw();
  }

  // axis: "x", "y", "z", or "" for no plane; part: 0 to 1 of the box. What lies beyond is cut away.
  setClip(axis, part) {
    this.shared.clipping.length = 0;
    if (axis) {
      const normal = { x: [-1, 0, 0], y: [0, 1, 0], z: [0, 0, -1] }[axis];
      const from = axis === "y" ? 1 - part : part; // from the front, from the left, from the top
      const at = this.box.min[axis] + from * (this.box.max[axis] - this.box.min[axis]);
      this.plane.normal.set(...normal);
      this.plane.constant = axis === "y" ? -at : at;
      this.shared.clipping.push(this.plane);
    }
    this.views.forEach((view) => (view.material.needsUpdate = true));
    this.draw();
  }

  setBackground(colour) {
    this.background.set(colour);
    this.draw();
  }

  draw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.views.forEach((view) => view.draw(this.camera, this.background));
    });
  }

  // `points`: what has to be seen.
  #look(box, direction, points = cornersOf(box)) {
    box.getCenter(this.shared.target);
    const distance = margin * this.#distanceThatShows(points, direction);
    this.camera.position.copy(this.shared.target).addScaledVector(direction, distance);
    this.camera.near = Math.max(distance / 1000, distance - 2 * this.box.getSize(new Vector3()).length());
    this.camera.far = distance + 2 * this.box.getSize(new Vector3()).length();
    this.views.forEach((view) => view.controls.update());
  }

  // How far from its target the camera has to stand to see all points.
  #distanceThatShows(points, direction) {
    const { clientWidth: width = 1, clientHeight: height = 1 } = this.views[0]?.canvas ?? {};
    const tangent = Math.tan((0.5 * fieldOfView * Math.PI) / 180);
    const right = new Vector3().crossVectors(this.camera.up, direction).normalize();
    const up = new Vector3().crossVectors(direction, right);
    let distance = 0;
    for (const point of points) {
      const offset = point.clone().sub(this.shared.target);
      const away = Math.max(Math.abs(offset.dot(up)), Math.abs(offset.dot(right)) * (height / width)) / tangent;
      distance = Math.max(distance, offset.dot(direction) + away);
    }
    return distance;
  }

  #key(event) {
    const step = keySteps[event.key];
    const zoom = { "+": 0.85, "=": 0.85, "-": 1 / 0.85 }[event.key];
    if (!step && !zoom && event.key !== "Home") return;
    event.preventDefault();
    if (event.key === "Home") return this.reset();
    const offset = this.camera.position.clone().sub(this.shared.target);
    if (zoom) offset.multiplyScalar(zoom);
    else {
      // three's spherical coordinates have y up, these have z.
      const around = new Spherical().setFromVector3(new Vector3(offset.x, offset.z, -offset.y));
      around.theta += 0.12 * step[0];
      around.phi += 0.12 * step[1];
      around.makeSafe();
      const moved = new Vector3().setFromSpherical(around);
      offset.set(moved.x, -moved.z, moved.y);
    }
    this.camera.position.copy(this.shared.target).add(offset);
    this.views.forEach((view) => view.controls.update());
    this.draw();
  }
}
