// The view of space: translucent surfaces, curves, and marks that are drawn as SVG on top.

const meshCells = 44;

/** A patch over a rectangle of its square, by default all of it. */
function patchPiece(points, which, [[a, b], [c, d]] = [[0, 1], [0, 1]]) {
  const piece = gridPiece(meshCells, meshCells, (s, t) => {
    const {at, first, second} = patchAt(points, a + (b - a) * s, c + (d - c) * t);
    return {at, normal: unit(cross(first, second))};
  }, `--patch${which}`, 0.62);
  return {...piece, patch: which};
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

/** Round numbers in [low, high], some `count` of them, as [number, text]. */
function roundTicks(low, high, count) {
  const rough = (high - low) / count;
  if (!(rough > 0)) return [];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((width) => width >= rough * 0.999);
  const digits = Math.min(17, Math.max(1, Math.ceil(Math.log10(Math.max(Math.abs(low), Math.abs(high)) / step)) + 2));
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step && ticks.length < 50; ++k) ticks.push([k * step, String(Number((k * step).toPrecision(digits)))]);
  return ticks;
}

/** Where a text of some size goes beside a point so that it covers no obstacle ([x, y, radius]) and stays in the picture. */
function freePlace([x, y], [width, height], obstacles, [right, bottom], taken = [], reach = 11) {
  const candidates = [[1, -0.7], [1, 0.7], [-1, -0.7], [-1, 0.7], [0, -1], [0, 1], [1.2, 0], [-1.2, 0], [1.7, -1.2], [-1.7, -1.2], [1.7, 1.2], [-1.7, 1.2]];
  let best = null;
  candidates.forEach(([dx, dy], order) => {
    const centre = [x + dx * (reach + width / 2) * (Math.abs(dx) > 0 ? 1 : 0), y + dy * (reach + height / 2)];
    let cost = order * 0.01;
    for (const [a, b, radius] of obstacles)
      if (Math.abs(a - centre[0]) < width / 2 + radius && Math.abs(b - centre[1]) < height / 2 + radius) cost += 1;
    for (const [a, b, w, h] of taken)
      if (Math.abs(a - centre[0]) < (width + w) / 2 && Math.abs(b - centre[1]) < (height + h) / 2) cost += 2;
    if (centre[0] < width / 2 || centre[0] > right - width / 2 || centre[1] < height / 2 || centre[1] > bottom - height / 2) cost += 1.5;
    if (!best || cost < best.cost) best = {cost, centre};
  });
  return best.centre;
}

/** The smallest rectangle of halved and quartered parameters outside of which a patch does not meet a ball. */
function rectangleInBall(points, centre, radius) {
  const transposed = (net) => net[0].map((_, j) => net.map((row) => row[j]));
  const split = (row) => {
    const levels = [row];
    while (levels.at(-1).length > 1) levels.push(levels.at(-1).slice(1).map((q, i) => plus(levels.at(-1)[i], minus(q, levels.at(-1)[i]), 0.5)));
    return [levels.map((level) => level[0]), levels.map((level) => level.at(-1)).reverse()];
  };
  const halves = (net, along) => {
    const rows = (along ? net : transposed(net)).map(split);
    return [0, 1].map((k) => along ? rows.map((row) => row[k]) : transposed(rows.map((row) => row[k])));
  };
  const found = [[1, 0], [1, 0]];
  // In homogeneous coordinates. A weight that is not positive has no place in a hull: such parts are halved.
  const homogeneous = points.map((row) => row.map(([x, y, z, w = 1]) => [w * x, w * y, w * z, w]));
  const stack = [{net: homogeneous, at: [0, 0], size: 1}];
  while (stack.length) {
    const {net, at, size} = stack.pop();
    const isHull = net.flat().every((p) => p[3] > 0);
    const {low, high} = isHull ? ballAround(net.flat().map((p) => p.slice(0, 3).map((t) => t / p[3]))) : {low: centre.map((t) => t - radius), high: centre.map((t) => t + radius)};
    if (low.some((t, k) => t > centre[k] + radius || high[k] < centre[k] - radius)) continue;
    if (found.every(([a, b], k) => a <= at[k] && b >= at[k] + size)) continue;
    if (Math.max(...minus(high, low)) < radius / 2 || size < 1e-9) {
      found.forEach((range, k) => range.splice(0, 2, Math.min(range[0], at[k]), Math.max(range[1], at[k] + size)));
      continue;
    }
    halves(net, false).forEach((half, i) => halves(half, true).forEach((quarter, j) =>
      stack.push({net: quarter, at: [at[0] + i * size / 2, at[1] + j * size / 2], size: size / 2})));
  }
  return found[0][0] < found[0][1] ? found : null;
}

/**
 * The view of space. All of `seen` is in the picture at first, from a side where the points `aim` spread most.
 * Coordinates are scaled to a ball of radius 1, so that any model fits into single precision; a place that is flown to
 * becomes that ball. What is in the view is made by builders, anew for every ball.
 */
class SpaceView {
  constructor(box, seen, aim) {
    this.seen = seen;
    this.aim = aim;
    this.whole = ballAround(seen);
    this.ball = this.whole;
    this.focused = false;
    this.canvas = element('canvas', {tabindex: 0, role: 'img', 'aria-label': 'View of space. Arrow keys turn it, plus and minus zoom, 0 goes back.'});
    this.overlay = drawing('svg', {'aria-hidden': 'true'});
    this.axesLayer = drawing('g', {class: 'axes'});
    this.overlay.append(this.axesLayer);
    box.append(this.canvas, this.overlay);
    this.box = box;
    this.renderer = new THREE.WebGLRenderer({canvas: this.canvas, antialias: true, preserveDrawingBuffer: true});
    this.renderer.setPixelRatio(Math.min(devicePixelRatio || 1, 2));
    this.renderer.autoClear = false;
    this.camera = new THREE.PerspectiveCamera(26, 1, 0.05, 60);
    this.camera.up.set(0, 0, 1);
    this.scene = new THREE.Scene();
    this.front = new THREE.Scene();
    this.translucent = new Translucent();
    this.wireGroup = new THREE.Group();
    this.extraGroup = new THREE.Group();
    this.frontGroup = new THREE.Group();
    this.axisGroup = new THREE.Group();
    this.scene.add(this.axisGroup, this.wireGroup, this.extraGroup);
    this.front.add(this.frontGroup);
    this.controls = new THREE.OrbitControls(this.camera, this.canvas);
    this.controls.enablePan = false;
    this.controls.enableZoom = false;
    this.controls.minDistance = 1.2;
    this.controls.maxDistance = 20;
    this.canvas.style.touchAction = 'pan-y';
    this.controls.addEventListener('change', () => this.render());
    Object.assign(this, {marks: [], extraMarks: [], labels: [], surfaces: [], extraSurfaces: [], builders: [], hidden: new Set(), solidity: 0.62, hasAxes: true});
    this.home();
    this.listen();
  }

  /** The first view: from above, where the area that the points of the curve cover is largest, as near as can be. */
  home() {
    this.flight = null;
    this.refocus(this.whole);
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
    this.lookFrom(best.direction);
  }

  /** Along a direction, with everything in the picture. */
  lookFrom(direction) {
    this.camera.position.set(...direction.map((t) => 5 * t));
    this.controls.target.set(0, 0, 0);
    this.controls.update();
    this.fit();
  }

  /** Along an axis; from above the first parameter of space runs to the right. */
  along(axis) {
    this.refocus(this.ball);
    this.lookFrom([[1, 0, 0], [0, -1, 0], [0, -1e-4, 1]][axis]);
  }

  /** The corners of the box of axes. */
  corners() {
    const {low, high} = this.ball;
    return Array.from({length: 8}, (_, i) => [0, 1, 2].map((k) => (i >> k & 1 ? high[k] : low[k])));
  }

  /** As near as all of `seen` is in the picture, and the box of axes with its numbers. */
  fit() {
    const points = this.focused ? this.corners() : [...this.seen, ...this.corners()];
    const [width, height] = this.size || [640, 480];
    for (let step = 0; step < 8; ++step) {
      this.camera.updateMatrixWorld();
      let most = 0;
      for (const p of points) {
        const q = new THREE.Vector3(...this.scaled(p)).project(this.camera);
        most = Math.max(most, Math.abs(q.x) / (1 - 2 * Math.min(46, width / 9) / width), Math.abs(q.y) / (1 - 2 * Math.min(34, height / 9) / height));
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
    this.camera.position.multiplyScalar(Math.min(20, Math.max(1.2, this.camera.position.length() * factor)) / this.camera.position.length());
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
    const grown = this.size && (Math.abs(this.size[0] - width) > 1 || Math.abs(this.size[1] - height) > 1);
    const first = !this.size;
    this.size = [width, height];
    if (first || grown) this.fit();
    this.render();
  }

  scaled(p) {
    return minus(p, this.ball.centre).map((t) => t / this.ball.radius);
  }

  /** Another ball to scale to: everything is built anew. */
  refocus(ball) {
    this.ball = ball;
    this.focused = ball !== this.whole;
    if (this.builders.length) this.rebuild();
  }

  /** Flies to a ball around a place of space. */
  fly(centre, radius) {
    const goal = {centre, radius, low: centre.map((t) => t - radius / 1.8), high: centre.map((t) => t + radius / 1.8)};
    const from = this.ball;
    const duration = matchMedia('(prefers-reduced-motion: reduce)').matches ? 0 : 450;  // milliseconds
    const start = performance.now();
    const flight = this.flight = {};
    const step = () => {
      if (this.flight !== flight) return;
      const t = duration ? Math.min(1, (performance.now() - start) / duration) : 1;
      const size = from.radius * (radius / from.radius) ** t;
      // The place comes to the middle as the ball shrinks.
      const along = from.radius === radius ? t : (from.radius - size) / (from.radius - radius);
      const between = plus(from.centre, minus(centre, from.centre), along);
      this.refocus(t === 1 ? goal : {centre: between, radius: size, low: between.map((a) => a - size / 1.8), high: between.map((a) => a + size / 1.8)});
      if (t === 1) this.fit();
      else requestAnimationFrame(step);
    };
    step();
  }

  /** Adds what `builder` makes, with add-functions of this view, now and for every other ball. */
  build(builder) {
    this.builders.push(builder);
    this.rebuild();
  }

  rebuild() {
    for (const group of [this.axisGroup, this.wireGroup, this.frontGroup]) this.clear(group);
    const corners = this.corners();
    for (let i = 0; i < 8; ++i)
      for (let k = 0; k < 3; ++k) if (!(i >> k & 1)) this.axisGroup.add(this.wire([corners[i], corners[i | 1 << k]], '--rule', 1, {edge: [i, i | 1 << k]}));
    this.surfaces = [];
    for (const builder of this.builders) builder(this);
    if (this.extraBuilder) this.rebuildExtra();
    this.repaint();
  }

  clear(group) {
    for (const line of [...group.children]) {
      line.geometry.dispose();
      line.material.dispose();
      group.remove(line);
    }
  }

  /** The part of a patch that is drawn: near a place that was flown to, with all its cells. */
  rectangle(points) {
    return this.focused ? rectangleInBall(points, this.ball.centre, 1.6 * this.ball.radius) : [[0, 1], [0, 1]];
  }

  addSurface(piece) {
    this.surfaces.push(piece);
  }

  addWire(points, property, width, options = {}) {
    const line = this.wire(points, property, width, options);
    (options.front ? this.frontGroup : this.wireGroup).add(line);
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
    line.frustumCulled = false;
    line.userData = {property, width, points, ...options};
    return line;
  }

  /** Replaces what belongs to the shown line; `make` returns {surfaces, wires, marks}. */
  showExtra(make) {
    this.extraBuilder = make;
    this.rebuildExtra();
    this.repaint();
  }

  rebuildExtra() {
    for (const mark of this.extraMarks) mark.node.remove();
    this.clear(this.extraGroup);
    const {surfaces, wires, marks} = this.extraBuilder();
    this.extraSurfaces = surfaces;
    this.extraMarks = marks;
    for (const line of wires) this.extraGroup.add(line);
  }

  /** Surfaces that are not hidden, as opaque as asked for. */
  shownSurfaces() {
    const opacity = (usual) => this.solidity <= 0.62 ? usual * this.solidity / 0.62 : usual + (1 - usual) * (this.solidity - 0.62) / 0.38;
    return [...this.surfaces, ...this.extraSurfaces].filter((piece) => piece && !this.hidden.has(piece.patch)).map((piece) => ({...piece, opacity: opacity(piece.opacity)}));
  }

  lines() {
    return [...this.axisGroup.children, ...this.wireGroup.children, ...this.extraGroup.children, ...this.frontGroup.children];
  }

  /** Colours anew, after light and dark have changed or pieces were exchanged. */
  repaint() {
    this.paper = new THREE.Color(colour('--panel'));
    const scale = (piece) => {
      const positions = new Array(piece.positions.length);
      for (let i = 0; i < positions.length; ++i) positions[i] = (piece.positions[i] - this.ball.centre[i % 3]) / this.ball.radius;
      return {...piece, positions};
    };
    this.translucent.show(this.shownSurfaces().map(scale));
    for (const line of this.lines()) {
      line.material.color.set(colour(line.userData.property));
      line.visible = !this.hidden.has(line.userData.patch) && !(line.userData.net !== undefined && !this.netsShown);
    }
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
    if (!this.size || !this.paper) return;
    this.renderer.setRenderTarget(null);
    this.renderer.setClearColor(this.paper, 1);
    this.renderer.clear();
    this.showFarEdges();
    this.renderer.render(this.scene, this.camera);
    this.translucent.draw(this.renderer, this.camera);
    this.renderer.render(this.front, this.camera);
    this.drawAxes();
    this.placeMarks();
  }

  /** Of the box of axes the edges that do not end in the corner before everything. */
  showFarEdges() {
    const nearest = this.camera.position.toArray().reduce((sum, t, k) => sum | (t > 0 ? 1 << k : 0), 0);
    for (const line of this.axisGroup.children) line.visible = this.hasAxes && !line.userData.edge.includes(nearest);
  }

  /** Where a point of space is seen, in units of the overlay. */
  onScreen(p) {
    const q = new THREE.Vector3(...this.scaled(p)).project(this.camera);
    return [(q.x + 1) / 2 * this.size[0], (1 - q.y) / 2 * this.size[1]];
  }

  /** The same with the reciprocal of the distance along the view, not positive behind the eye. */
  placed(p) {
    const q = new THREE.Vector3(...this.scaled(p)).applyMatrix4(this.camera.matrixWorldInverse);
    return [...this.onScreen(p), -1 / q.z];
  }

  /** Marks stand at their points; numbers and names beside them, where nothing is covered. */
  placeMarks() {
    const obstacles = [];
    for (const mark of [...this.marks, ...this.extraMarks]) {
      mark.seen = this.onScreen(mark.at);
      mark.node.setAttribute('transform', `translate(${mark.seen[0].toFixed(1)},${mark.seen[1].toFixed(1)})`);
      mark.node.style.display = this.focused && mark.seen.some((t, k) => t < 0 || t > this.size[k]) ? 'none' : null;
      obstacles.push([...mark.seen, 7]);
    }
    const taken = [];
    for (const {node, at} of this.labels) {
      const wanted = this.onScreen(at);
      const size = [7.6 * node.textContent.length + 4, 15];
      const free = (place) => obstacles.every(([a, b, r]) => Math.abs(a - place[0]) > size[0] / 2 + r || Math.abs(b - place[1]) > size[1] / 2 + r);
      const place = free(wanted) ? wanted : freePlace(wanted, size, obstacles, this.size, taken, 4);
      taken.push([...place, ...size]);
      node.setAttribute('transform', `translate(${place.map((t) => t.toFixed(1))})`);
      node.style.display = this.focused || this.hidden.has(node.dataset.patch === undefined ? -1 : Number(node.dataset.patch)) ? 'none' : null;
    }
    for (const mark of this.marks) {
      const number = mark.node.querySelector('.number');
      if (!number) continue;
      const size = [7 * number.textContent.length + 2, 12];
      const place = freePlace(mark.seen, size, obstacles.filter(([a, b]) => a !== mark.seen[0] || b !== mark.seen[1]), this.size, taken);
      if (page.classList.contains('numbered')) taken.push([...place, ...size]);
      number.setAttribute('x', (place[0] - mark.seen[0]).toFixed(1));
      number.setAttribute('y', (place[1] - mark.seen[1] + 4).toFixed(1));
    }
  }

  /** The box of coordinates, with numbers along an edge for each that lies at the rim of the picture. */
  drawAxes() {
    this.axesLayer.replaceChildren();
    if (!this.hasAxes) return;
    const {low, high} = this.ball;
    const corners = this.corners().map((p) => this.onScreen(p));
    const eye = unit(this.camera.position.toArray());
    const middle = corners.reduce((sum, p) => plus(sum, p), [0, 0]).map((t) => t / 8);
    for (let k = 0; k < 3; ++k) {
      const edges = [0, 1, 2, 3].map((i) => {
        const others = [0, 1, 2].filter((m) => m !== k);
        const from = (i & 1) << others[0] | (i >> 1) << others[1];
        return {from, to: from | 1 << k};
      });
      const outer = ({from, to}) => k < 2 ? corners[from][1] + corners[to][1] : -(corners[from][0] + corners[to][0]);
      const edge = edges.sort((a, b) => outer(b) - outer(a))[0];
      const [p, q] = [corners[edge.from], corners[edge.to]];
      const length = Math.hypot(...minus(q, p));
      if (length < 44 || Math.abs(eye[k]) > 0.99) continue;  // seen from its end
      const along = unit(minus(q, p));
      let out = [-along[1], along[0]];
      if (dot([...out, 0], [...minus(plus(p, q).map((t) => t / 2), middle), 0]) < 0) out = out.map((t) => -t);
      const at = (t) => plus(p, minus(q, p), (t - low[k]) / (high[k] - low[k]));
      let ticks = '';
      const anchor = out[0] > 0.5 ? 'start' : out[0] < -0.5 ? 'end' : 'middle';
      for (const [value, text] of roundTicks(low[k], high[k], Math.max(1, Math.min(5, length / 62)))) {
        const place = at(value);
        const end = plus(place, out, 5);
        ticks += `M${place.map((t) => t.toFixed(1))}L${end.map((t) => t.toFixed(1))}`;
        const where = plus(place, out, 11);
        this.axesLayer.append(drawing('text', {class: 'tick', x: where[0].toFixed(1), y: (where[1] + 4).toFixed(1), 'text-anchor': anchor}, text));
      }
      this.axesLayer.append(drawing('path', {class: 'axis-line', d: `M${p.map((t) => t.toFixed(1))}L${q.map((t) => t.toFixed(1))}${ticks}`}));
      const name = plus(plus(p, minus(q, p), 0.5), out, anchor === 'middle' ? 28 : 40);
      this.axesLayer.append(drawing('text', {class: 'axis-name', x: name[0].toFixed(1), y: (name[1] + 5).toFixed(1), 'text-anchor': 'middle'}, ['x', 'y', 'z'][k]));
    }
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
