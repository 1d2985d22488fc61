// The interactive view: three.js draws, this file decodes the points, colours them and switches layers.
'use strict';

const FATES = [
  { key: 'static', name: 'Static, kept', light: [108, 122, 140], dark: [150, 162, 178] },
  { key: 'removed', name: 'Moving, removed', light: [20, 140, 74], dark: [72, 214, 128] },
  { key: 'left', name: 'Moving, left in', light: [214, 32, 40], dark: [255, 82, 82] },
  { key: 'lost', name: 'Static, lost', light: [32, 98, 232], dark: [92, 158, 255] },
  { key: 'unscored', name: 'Not scored', light: [190, 150, 60], dark: [190, 156, 84] }
];
const CLASS_COLOURS = {
  road: [150, 118, 150], parking: [176, 120, 150], sidewalk: [112, 72, 120], 'lane-marking': [190, 170, 120],
  'other-ground': [140, 100, 90], terrain: [130, 170, 80], vegetation: [42, 150, 70], trunk: [130, 88, 50],
  building: [226, 168, 40], fence: [220, 110, 60], 'other-structure': [200, 140, 90], pole: [240, 214, 120],
  'traffic-sign': [235, 70, 60], 'other-object': [90, 200, 200], car: [70, 130, 240], truck: [60, 70, 190],
  bus: [90, 60, 220], 'other-vehicle': [80, 100, 200], 'on-rails': [60, 60, 160], bicycle: [80, 200, 230],
  motorcycle: [40, 140, 160], person: [240, 60, 150], bicyclist: [240, 50, 220], motorcyclist: [170, 40, 120]
};
const OTHER = [140, 146, 156];

class MapViewer {
  constructor(canvas, message) {
    this.canvas = canvas;
    this.message = message;
    this.hidden = new Set(['unscored']);
    this.colour = 'fate';
    this.size = 2;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(50, 1, 0.5, 5000);
    this.camera.up.set(0, 0, 1);
    this.orbit = new THREE.OrbitControls(this.camera, canvas);
    this.orbit.screenSpacePanning = false;
    this.orbit.maxPolarAngle = Math.PI * 0.495;
    this.orbit.zoomSpeed = 1.4;
    this.orbit.addEventListener('change', () => this.redraw());
    // Arrow keys move the map only while the view has the focus; the page keeps its own scrolling.
    this.orbit.enableKeys = false;
    canvas.addEventListener('keydown', (event) => this.onKey(event));
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  // meta: {count, origin, step, classes}; bytes: layout of PackedCloud
  show(meta, bytes, trajectory) {
    if (this.points) { this.scene.remove(this.points); this.points.geometry.dispose(); }
    if (this.way) { this.scene.remove(this.way); this.way.geometry.dispose(); }
    const n = meta.count;
    this.meta = meta;
    this.position = new Int16Array(bytes.buffer, 0, 3 * n);
    this.instance = new Uint16Array(bytes.buffer, 6 * n, n);
    this.intensity = bytes.subarray(8 * n, 9 * n);
    this.classes = bytes.subarray(9 * n, 10 * n);
    this.fate = bytes.subarray(10 * n, 11 * n);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(this.position, 3));
    geometry.setAttribute('color', new THREE.BufferAttribute(new Uint8Array(3 * n), 3, true));
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(n), 1));
    const material = new THREE.PointsMaterial({ vertexColors: THREE.VertexColors || true, sizeAttenuation: false });
    this.points = new THREE.Points(geometry, material);
    this.points.frustumCulled = false;
    this.points.scale.setScalar(meta.step);
    this.scene.add(this.points);
    this.addWay(trajectory);
    this.counts = this.countFates();
    this.paint();
    this.filter();
    this.look('oblique');
    this.message.textContent = '';
  }

  addWay(trajectory) {
    const o = this.meta.origin;
    this.path = trajectory.map((p) => new THREE.Vector3(p[0] - o[0], p[1] - o[1], p[2] - o[2]));
    this.way = new THREE.Line(new THREE.BufferGeometry().setFromPoints(this.path), new THREE.LineBasicMaterial({ color: 0xf0b429 }));
    this.way.frustumCulled = false;
    this.scene.add(this.way);
  }

  countFates() {
    const counts = { ground: 0 };
    FATES.forEach((f) => { counts[f.key] = 0; });
    for (let i = 0; i < this.fate.length; ++i) {
      ++counts[FATES[this.fate[i]].key];
      if (this.meta.classes[this.classes[i]].ground) ++counts.ground;
    }
    return counts;
  }

  // Which points are drawn: an index of those whose layers are on.
  filter() {
    if (!this.points) return;
    const shown = FATES.map((f) => !this.hidden.has(f.key));
    const ground = this.meta.classes.map((c) => c.ground && this.hidden.has('ground'));
    const index = this.points.geometry.index;
    let count = 0;
    for (let i = 0; i < this.fate.length; ++i) {
      // What moves stays in sight when the ground is switched off.
      if (shown[this.fate[i]] && !ground[this.classes[i]]) index.array[count++] = i;
    }
    index.needsUpdate = true;
    this.points.geometry.setDrawRange(0, count);
    this.way.visible = !this.hidden.has('way');
    this.drawn = count;
    this.redraw();
  }

  paint() {
    if (!this.points) return;
    const dark = document.documentElement.dataset.theme === 'dark';
    this.renderer.setClearColor(dark ? 0x0b0d10 : 0xeef1f5);
    const attribute = this.points.geometry.attributes.color;
    const colourOf = this.painter(dark);
    for (let i = 0; i < this.fate.length; ++i) {
      const c = colourOf(i);
      attribute.array[3 * i] = c[0];
      attribute.array[3 * i + 1] = c[1];
      attribute.array[3 * i + 2] = c[2];
    }
    attribute.needsUpdate = true;
    this.points.material.size = this.size * this.renderer.getPixelRatio();
    this.redraw();
  }

  painter(dark) {
    const fates = FATES.map((f) => (dark ? f.dark : f.light));
    if (this.colour === 'class') {
      const colours = this.meta.classes.map((c) => CLASS_COLOURS[c.name] || OTHER);
      return (i) => colours[this.classes[i]];
    }
    if (this.colour === 'instance') return (i) => (this.instance[i] ? hashColour(this.instance[i], dark) : (dark ? [72, 80, 92] : [190, 198, 208]));
    if (this.colour === 'intensity') {
      const ramp = intensityRamp(this.intensity, dark);
      return (i) => ramp[this.intensity[i]];
    }
    if (this.colour === 'height') {
      const [low, high] = this.heights();
      const ramp = Array.from({ length: 256 }, (_, k) => heightColour(k / 255, dark));
      return (i) => ramp[Math.max(0, Math.min(255, Math.round(255 * (this.position[3 * i + 2] - low) / (high - low))))];
    }
    // What is right and static is shaded by its intensity, so that it has shape and mistakes stand out.
    const shades = shadesOf(this.intensity, fates[0], dark);
    return (i) => (this.fate[i] === 0 ? shades[this.intensity[i]] : fates[this.fate[i]]);
  }

  // 2 % and 98 % of the heights, in steps.
  heights() {
    const sample = [];
    for (let i = 0; i < this.fate.length; i += 37) sample.push(this.position[3 * i + 2]);
    sample.sort((a, b) => a - b);
    const at = (share) => sample[Math.floor(share * (sample.length - 1))] || 0;
    return [at(0.02), Math.max(at(0.98), at(0.02) + 1)];
  }

  setHidden(key, hidden) {
    if (hidden) this.hidden.add(key); else this.hidden.delete(key);
    this.filter();
  }
  setColour(colour) { this.colour = colour; this.paint(); }
  setSize(size) { this.size = size; this.paint(); }

  look(from) {
    if (!this.path) return;
    const box = new THREE.Box3().setFromPoints(this.path.length ? this.path : [new THREE.Vector3()]);
    const center = box.getCenter(new THREE.Vector3());
    const heading = this.path.length > 1 ? this.path[this.path.length - 1].clone().sub(this.path[0]).setZ(0) : new THREE.Vector3(1, 0, 0);
    if (heading.length() < 1) heading.set(1, 0, 0);
    heading.normalize();
    if (from === 'road') {
      const start = this.path[0] || center;
      this.orbit.target.copy(start).addScaledVector(heading, 15);
      this.camera.position.copy(start).addScaledVector(heading, -9);
      this.camera.position.z += 4.5;
    } else {
      // From above is not quite that: the controls need a direction that is up. Drives lie along the longer side.
      const side = new THREE.Vector3(-heading.y, heading.x, 0);
      const up = this.camera.aspect < 1 ? heading : side;
      const back = from === 'above' ? up.multiplyScalar(-0.01) : heading.multiplyScalar(-0.55).addScaledVector(side, -0.6);
      this.orbit.target.copy(center);
      this.camera.position.copy(center).add(this.fit(center, back.setZ(from === 'above' ? 1 : 0.62).normalize()));
    }
    this.orbit.update();
    this.redraw();
  }

  // How far along `back` the camera must stand to see all of the way and what lies beside it.
  fit(center, back) {
    const beside = 15;
    const right = new THREE.Vector3(0, 0, 1).cross(back).normalize();
    const up = back.clone().cross(right);
    const tall = Math.tan((this.camera.fov * Math.PI) / 360);
    const wide = tall * this.camera.aspect;
    let away = 30;
    for (const place of this.path) {
      const p = place.clone().sub(center);
      const half = Math.max((Math.abs(p.dot(right)) + beside) / wide, (Math.abs(p.dot(up)) + beside) / tall);
      away = Math.max(away, p.dot(back) + half);
    }
    return back.clone().multiplyScalar(away);
  }

  onKey(event) {
    const moves = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const zooms = { '+': 0.85, '=': 0.85, '-': 1.18 };
    const away = this.camera.position.clone().sub(this.orbit.target);
    if (moves[event.key]) {
      const forward = away.clone().setZ(0).normalize().negate();
      const right = new THREE.Vector3(forward.y, -forward.x, 0);
      const shift = right.multiplyScalar(moves[event.key][0]).addScaledVector(forward, moves[event.key][1]).multiplyScalar(0.06 * away.length());
      this.camera.position.add(shift);
      this.orbit.target.add(shift);
    } else if (zooms[event.key]) {
      this.camera.position.copy(this.orbit.target).addScaledVector(away, zooms[event.key]);
    } else {
      return;
    }
    event.preventDefault();
    this.orbit.update();
    this.redraw();
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    if (!clientWidth || !clientHeight) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  // Draws once, with the next picture of the screen: nothing runs while nothing changes.
  redraw() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      this.renderer.render(this.scene, this.camera);
      document.documentElement.dataset.drawn = String(this.drawn || 0);
    });
  }
}

function hashColour(id, dark) {
  let h = Math.imul(id, 2654435761) >>> 0;
  const hue = (h & 1023) / 1024;
  h >>>= 10;
  const light = (dark ? 0.56 : 0.4) + ((h & 255) / 255) * 0.14;
  const c = new THREE.Color().setHSL(hue, 0.72, light);
  return [c.r * 255, c.g * 255, c.b * 255];
}

const intensityRamp = (intensity, dark) => equalised(intensity).map((share) => heightColour(share, dark));
const shadesOf = (intensity, colour, dark) => equalised(intensity).map((share) => colour.map((c) => Math.min(255, c * (dark ? 0.5 + 0.7 * share : 0.7 + 0.75 * (1 - share)))));

// Share of points below each intensity, so that any sensor's unit shows its contrast.
function equalised(intensity) {
  const histogram = new Float64Array(256);
  for (let i = 0; i < intensity.length; i += 7) ++histogram[intensity[i]];
  let sum = 0;
  const total = histogram.reduce((a, b) => a + b, 0) || 1;
  return Array.from(histogram, (count) => {
    sum += count;
    return (sum - count / 2) / total;
  });
}

function heightColour(share, dark) {
  const c = new THREE.Color().setHSL(0.68 - 0.6 * share, 0.75, (dark ? 0.5 : 0.38) + 0.12 * share);
  return [c.r * 255, c.g * 255, c.b * 255];
}

function decodeBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}
