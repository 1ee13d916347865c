// The view of space: translucent surfaces, curves, and marks that are drawn as SVG on top.

const meshCells = 44;

/** The piece with every triangle turned so that its corners go round the normal at the first one counterclockwise. */
function oriented(piece) {
  const {positions, normals, triangles} = piece;
  const corner = (list, i) => list.slice(3 * i, 3 * i + 3);
  for (let t = 0; t < triangles.length; t += 3) {
    const [p, q, r] = [0, 1, 2].map((k) => corner(positions, triangles[t + k]));
    if (dot(cross(minus(q, p), minus(r, p)), corner(normals, triangles[t])) < 0) [triangles[t + 1], triangles[t + 2]] = [triangles[t + 2], triangles[t + 1]];
  }
  return piece;
}

/** Triangles of a grid of points with normals, for the translucent surfaces. */
function gridPiece(rows, columns, pointAt, property, opacity) {
  const piece = {positions: [], normals: [], triangles: [], property, opacity};
  for (let i = 0; i <= rows; ++i)
    for (let j = 0; j <= columns; ++j) {
      const {at, normal} = pointAt(i / rows, j / columns);
      piece.positions.push(...at);
      piece.normals.push(...normal);
    }
  for (let i = 0; i < rows; ++i)
    for (let j = 0; j < columns; ++j) {
      const a = i * (columns + 1) + j;
      const b = a + columns + 1;
      piece.triangles.push(a, b, a + 1, b, b + 1, a + 1);
    }
  return oriented(piece);
}

function patchPiece(points, which) {
  return gridPiece(meshCells, meshCells, (u, v) => {
    const {at, first, second} = patchAt(points, u, v);
    return {at, normal: unit(cross(first, second))};
  }, `--patch${which}`, 0.62);
}

/** All translucent triangles in one mesh, sorted from back to front whenever the camera moves. */
class Translucent {
  constructor() {
    this.geometry = new THREE.BufferGeometry();
    const material = new THREE.MeshPhongMaterial({vertexColors: true, transparent: true, side: THREE.DoubleSide, depthWrite: false,
      shininess: 18, specular: 0x202020, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2});
    material.forceSinglePass = true;
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 2;
  }

  show(pieces) {
    const count = pieces.reduce((n, piece) => n + piece.positions.length / 3, 0);
    const positions = new Float32Array(3 * count);
    const normals = new Float32Array(3 * count);
    const colours = new Float32Array(4 * count);
    const triangles = [];
    let offset = 0;
    for (const piece of pieces) {
      positions.set(piece.positions, 3 * offset);
      normals.set(piece.normals, 3 * offset);
      const tint = new THREE.Color(colour(piece.property));
      const size = piece.positions.length / 3;
      for (let i = 0; i < size; ++i) colours.set([tint.r, tint.g, tint.b, piece.opacity], 4 * (offset + i));
      for (const corner of piece.triangles) triangles.push(corner + offset);
      offset += size;
    }
    this.geometry.dispose();
    this.geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
    this.geometry.setAttribute('normal', new THREE.BufferAttribute(normals, 3));
    this.geometry.setAttribute('color', new THREE.BufferAttribute(colours, 4));
    this.triangles = Uint32Array.from(triangles);
    this.centres = new Float32Array(triangles.length);
    for (let t = 0; t < triangles.length; t += 3)
      for (let k = 0; k < 3; ++k)
        this.centres[t + k] = (positions[3 * triangles[t] + k] + positions[3 * triangles[t + 1] + k] + positions[3 * triangles[t + 2] + k]) / 3;
    this.geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(triangles.length), 1));
  }

  sort(camera) {
    const [x, y, z] = camera.position.toArray();
    const number = this.triangles.length / 3;
    const depth = new Float32Array(number);
    for (let t = 0; t < number; ++t)
      depth[t] = (this.centres[3 * t] - x) ** 2 + (this.centres[3 * t + 1] - y) ** 2 + (this.centres[3 * t + 2] - z) ** 2;
    const order = Uint32Array.from(depth.keys()).sort((a, b) => depth[b] - depth[a]);
    const index = this.geometry.index;
    for (let i = 0; i < number; ++i)
      for (let k = 0; k < 3; ++k) index.array[3 * i + k] = this.triangles[3 * order[i] + k];
    index.needsUpdate = true;
  }
}

/** The box around points, and the ball around the box. */
function ballAround(points) {
  const low = [0, 1, 2].map((k) => Math.min(...points.map((p) => p[k])));
  const high = [0, 1, 2].map((k) => Math.max(...points.map((p) => p[k])));
  return {low, high, centre: low.map((a, k) => (a + high[k]) / 2), radius: Math.max(Math.hypot(...minus(high, low)) / 2, 1e-300)};
}

/** Area of the ellipse of inertia of points, seen along right and up. */
function spread(points, right, up) {
  let [a, b, c, x, y] = [0, 0, 0, 0, 0];
  for (const p of points) {
    x += dot(p, right) / points.length;
    y += dot(p, up) / points.length;
  }
  for (const p of points) {
    const [s, t] = [dot(p, right) - x, dot(p, up) - y];
    a += s * s / points.length;
    b += s * t / points.length;
    c += t * t / points.length;
  }
  return Math.sqrt(Math.max(a * c - b * b, 0));
}

/**
 * The view of space. All of `seen` is in the picture at first, from a side where the points `aim` spread most.
 * Coordinates are scaled to a ball of radius 1, so that any model fits into single precision.
 */
class SpaceView {
  constructor(box, seen, aim) {
    this.seen = seen;
    this.aim = aim;
    this.ball = ballAround(seen);
    this.canvas = element('canvas', {tabindex: 0, role: 'img', 'aria-label': 'View of space. Arrow keys turn it, plus and minus zoom, 0 goes back.'});
    this.overlay = drawing('svg', {'aria-hidden': 'true'});
    box.append(this.canvas, this.overlay);
    this.box = box;
    this.renderer = new THREE.WebGLRenderer({canvas: this.canvas, antialias: true, preserveDrawingBuffer: true});
    this.renderer.setPixelRatio(Math.min(devicePixelRatio || 1, 2));
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(26, 1, 0.05, 60);
    this.camera.up.set(0, 0, 1);
    this.headlight = new THREE.DirectionalLight(0xffffff, 2.1);
    this.scene.add(new THREE.AmbientLight(0xffffff, 1.35), this.headlight);
    this.translucent = new Translucent();
    this.wireGroup = new THREE.Group();
    this.extraGroup = new THREE.Group();
    this.scene.add(this.translucent.mesh, this.wireGroup, this.extraGroup);
    this.controls = new THREE.OrbitControls(this.camera, this.canvas);
    this.controls.enablePan = false;
    this.controls.enableZoom = false;
    this.controls.minDistance = 1.2;
    this.controls.maxDistance = 14;
    this.canvas.style.touchAction = 'pan-y';
    this.controls.addEventListener('change', () => this.render());
    this.marks = [];
    this.extraMarks = [];
    this.surfaces = [];
    this.extraSurfaces = [];
    this.home();
    this.listen();
  }

  /** The first view: from above, where the area that the points of the curve cover is largest, as near as can be. */
  home() {
    let best = {area: -1};
    for (let i = 0; i < 24; ++i)
      for (const height of [0.35, 0.6, 0.85]) {
        const angle = -2.1 + i * Math.PI / 12;
        const direction = unit([Math.cos(angle), Math.sin(angle), height]);
        const right = unit([-direction[1], direction[0], 0]);
        const up = cross(direction, right);
        const area = spread(this.aim.map((p) => this.scaled(p)), right, up) * (height === 0.85 ? 0.8 : 1) * (i === 0 ? 1.15 : 1);
        if (area > best.area) best = {area, direction};
      }
    this.camera.position.set(...best.direction.map((t) => 5 * t));
    this.controls.target.set(0, 0, 0);
    this.controls.update();
    this.fit();
  }

  /** As near as all of `seen` is in the picture. */
  fit() {
    for (let step = 0; step < 6; ++step) {
      this.camera.updateMatrixWorld();
      let most = 0;
      for (const p of this.seen) {
        const q = new THREE.Vector3(...this.scaled(p)).project(this.camera);
        most = Math.max(most, Math.abs(q.x) * 1.12, Math.abs(q.y) * 1.16);
      }
      if (!(most > 0)) return;
      this.zoom(Math.max(most, 0.3));
    }
  }

  listen() {
    this.canvas.addEventListener('keydown', (event) => {
      const turn = {ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, -0.12], ArrowDown: [0, 0.12]}[event.key];
      const zoom = {'+': 0.88, '=': 0.88, '-': 1 / 0.88}[event.key];
      if (turn) this.turn(...turn);
      else if (zoom) this.zoom(zoom);
      else if (event.key === '0') this.home();
      else return;
      event.preventDefault();
    });
    this.canvas.addEventListener('wheel', (event) => {
      if (document.activeElement !== this.canvas) return;
      event.preventDefault();
      this.zoom(Math.exp(Math.sign(event.deltaY) * 0.08));
    }, {passive: false});
    new ResizeObserver(() => this.resize()).observe(this.box);
    onColoursChanged(() => this.repaint());
  }

  turn(around, down) {
    const at = new THREE.Spherical().setFromCartesianCoords(this.camera.position.x, this.camera.position.z, -this.camera.position.y);
    at.theta += around;
    at.phi = Math.min(Math.PI - 0.02, Math.max(0.02, at.phi + down));
    const p = new THREE.Vector3().setFromSpherical(at);
    this.camera.position.set(p.x, -p.z, p.y);
    this.controls.update();
    this.render();
  }

  zoom(factor) {
    this.camera.position.multiplyScalar(Math.min(14, Math.max(1.2, this.camera.position.length() * factor)) / this.camera.position.length());
    this.controls.update();
    this.render();
  }

  resize() {
    const {width, height} = this.box.getBoundingClientRect();
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.overlay.setAttribute('viewBox', `0 0 ${width} ${height}`);
    const first = !this.size;
    this.size = [width, height];
    if (first) this.fit();
    this.render();
  }

  scaled(p) {
    return minus(p, this.ball.centre).map((t) => t / this.ball.radius);
  }

  /** Fat lines through points of space; the group remembers how to paint them. */
  wire(points, property, width, options = {}) {
    const corners = [];
    for (let i = 0; i + 1 < points.length; ++i) corners.push(...this.scaled(points[i]), ...this.scaled(points[i + 1]));
    const geometry = new THREE.LineSegmentsGeometry();
    geometry.setPositions(corners);
    const dashes = options.dashes;
    const material = new THREE.LineMaterial({linewidth: width, dashed: Boolean(dashes), transparent: Boolean(options.opacity), opacity: options.opacity || 1});
    if (dashes) [material.dashSize, material.gapSize] = dashes;
    const line = new THREE.LineSegments2(geometry, material);
    if (dashes) line.computeLineDistances();
    line.renderOrder = options.order || 1;
    line.frustumCulled = false;
    line.userData = {property, width, arc: options.arc};
    return line;
  }

  /** Replaces what belongs to the shown line: surfaces, lines, points. */
  showExtra(surfaces, wires, marks) {
    this.extraSurfaces = surfaces;
    this.extraMarks = marks;
    for (const line of [...this.extraGroup.children]) {
      line.geometry.dispose();
      line.material.dispose();
      this.extraGroup.remove(line);
    }
    for (const line of wires) this.extraGroup.add(line);
    this.repaint();
  }

  /** Colours anew, after light and dark have changed or pieces were exchanged. */
  repaint() {
    this.scene.background = new THREE.Color(colour('--panel'));
    const scale = (piece) => {
      const positions = new Array(piece.positions.length);
      for (let i = 0; i < positions.length; ++i) positions[i] = (piece.positions[i] - this.ball.centre[i % 3]) / this.ball.radius;
      return {...piece, positions};
    };
    this.translucent.show([...this.surfaces, ...this.extraSurfaces].map(scale));
    for (const line of [...this.wireGroup.children, ...this.extraGroup.children]) line.material.color.set(colour(line.userData.property));
    this.render();
  }

  /** Draws at most once in a frame. */
  render() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  draw() {
    if (!this.size || !this.translucent.triangles) return;
    this.headlight.position.copy(this.camera.position).add(new THREE.Vector3(0.6, 0.2, 1.2));
    this.translucent.sort(this.camera);
    this.renderer.render(this.scene, this.camera);
    for (const mark of [...this.marks, ...this.extraMarks]) {
      const [x, y] = this.onScreen(mark.at);
      mark.node.setAttribute('transform', `translate(${x.toFixed(1)},${y.toFixed(1)})`);
    }
    this.drawAxes();
  }

  /** Where a point of space is seen, in units of the overlay. */
  onScreen(p) {
    const q = new THREE.Vector3(...this.scaled(p)).project(this.camera);
    return [(q.x + 1) / 2 * this.size[0], (1 - q.y) / 2 * this.size[1]];
  }

  /** Directions of the coordinates, in the lower left corner. */
  drawAxes() {
    if (!this.axes) {
      this.axes = ['x', 'y', 'z'].map((name) => ({line: drawing('path', {stroke: 'var(--soft)', 'stroke-width': 1.4, fill: 'none'}),
        text: drawing('text', {class: 'soft', 'font-size': 12, 'font-style': 'italic', 'text-anchor': 'middle'}, name)}));
      for (const axis of this.axes) this.overlay.append(axis.line, axis.text);
    }
    const origin = [40, this.size[1] - 38];
    const inverse = this.camera.matrixWorldInverse.elements;
    this.axes.forEach((axis, k) => {
      const direction = [inverse[4 * k], -inverse[4 * k + 1]];
      axis.line.setAttribute('d', `M${origin}l${direction[0] * 24},${direction[1] * 24}`);
      axis.text.setAttribute('x', origin[0] + direction[0] * 33);
      axis.text.setAttribute('y', origin[1] + direction[1] * 33 + 4);
    });
  }

  /** The picture as it stands, marks included, at `scale` pixels for one. */
  async save(filename, scale = 3) {
    const before = this.renderer.getPixelRatio();
    this.renderer.setPixelRatio(scale);
    this.draw();
    const picture = element('canvas', {width: this.canvas.width, height: this.canvas.height});
    const context = picture.getContext('2d');
    context.drawImage(this.canvas, 0, 0);
    this.renderer.setPixelRatio(before);
    this.draw();
    const marks = this.overlay.cloneNode(true);
    const styled = standaloneSvg(this.overlay);
    const image = new Image();
    image.src = 'data:image/svg+xml;charset=utf-8,' + encodeURIComponent(styled.replace('<svg ', `<svg width="${marks.viewBox.baseVal.width}" height="${marks.viewBox.baseVal.height}" `));
    await image.decode();
    context.drawImage(image, 0, 0, picture.width, picture.height);
    picture.toBlob((blob) => saveFile(filename, 'image/png', [blob]), 'image/png');
  }
}
