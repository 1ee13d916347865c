// Puts the page together.

const page = document.getElementById('page');
let view = null;
let squares = [];

function section(title, id, ...content) {
  const made = element('section', {'aria-labelledby': `${id}-title`}, element('h2', {id: `${id}-title`}, title), ...content);
  page.append(made);
  return made;
}

function checkbox(text, checked, onChange, id) {
  const box = element('input', {type: 'checkbox', id: id || null});
  box.checked = checked;
  box.addEventListener('change', () => onChange(box.checked));
  return element('label', {}, box, text);
}

function textButton(text, onClick, attributes = {}) {
  const button = element('button', {type: 'button', ...attributes}, text);
  button.addEventListener('click', onClick);
  return button;
}

function filename(suffix) {
  return (report.title || report.command).replace(/[^\p{L}\p{N}]+/gu, '-').slice(0, 60) + suffix;
}

// Selection: one node, arc, or point of the shown line, marked in every view.

let selected = null;
let shownPoints = [];  // of the line: parameters and coordinates

function markSelected() {
  for (const marked of document.querySelectorAll('.selected')) marked.classList.remove('selected');
  for (const pressed of document.querySelectorAll('.pick[aria-pressed="true"]')) pressed.setAttribute('aria-pressed', 'false');
  if (selected) {
    for (const shown of document.querySelectorAll(`[data-${selected.kind}="${selected.id}"]:not(.hit)`)) {
      shown.classList.add('selected');
      const button = shown.querySelector('.pick');
      if (button) button.setAttribute('aria-pressed', 'true');
    }
  }
  if (view) {
    for (const line of view.lines()) {
      const chosen = selected && line.userData[selected.kind] === selected.id;
      line.material.linewidth = line.userData.width * (chosen ? 2.1 : 1);
    }
    view.render();
  }
  const box = document.getElementById('selection');
  box.classList.toggle('screen-only', !selected);
  box.replaceChildren(...selectionWords());
}

function select(kind, id) {
  selected = selected && selected.kind === kind && selected.id === id ? null : {kind, id};
  if (kind === 'difference') showDifference(selected ? id : null);
  markSelected();
}

function selectionWords() {
  if (!selected) return [`Choose ${nodes.length ? 'a node or an arc' : 'a point'}, in a table, a square or in space: it is marked everywhere.`];
  if (selected.kind === 'difference') return differenceWords(selected.id);
  if (selected.kind === 'arc') {
    const arc = arcs[selected.id];
    return [element('b', {}, `Arc ${arc.id}`), ` of ${componentName(graph.components[arc.component])}, from node ${arc.from} to node ${arc.to}, ${arc.contact}, ${arc.on === 'interior' ? 'interior' : 'along a side of a patch'}; within ${boundText(arc.error_bound)} of its polyline of ${arc.polyline.length} vertices.`];
  }
  if (selected.kind === 'point') {
    const point = shownPoints[selected.id];
    return [element('b', {}, `Point ${pointLetter(selected.id)} of the line`), ': ', ...parameters.flatMap((p, i) => [i ? ', ' : '', element('i', {}, p), ` = ${String(point[i])}`]),
      `; (x, y, z) = (${inSpace(point).map((c) => Number(c.toPrecision(9))).join(', ')}).`];
  }
  const node = nodes[selected.id];
  return [element('b', {}, `Node ${node.id}`), `, ${nodeWords(node)}: `, ...parameters.flatMap((p, i) => [i ? ', ' : '', element('i', {}, p), ` = ${String(node.approx[p])}`]),
    `${parameters.length ? '; ' : ''}(x, y, z) = (${node.approx.point.map((c) => Number(c.toPrecision(9))).join(', ')}).`];
}

/** Clicks and keys on anything that stands for a node or an arc. */
function listenForSelection() {
  const chosen = (target) => target.closest('tr[data-node], tr[data-arc], tr[data-point], tr[data-difference], .node, .hit[data-arc], .hit[data-point]');
  page.addEventListener('click', (event) => {
    const target = chosen(event.target);
    if (!target || event.target.closest('.polynomial')) return;
    const kind = ['node', 'arc', 'point', 'difference'].find((name) => name in target.dataset);
    select(kind, Number(target.dataset[kind]));
  });
  page.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter' && event.key !== ' ' || !event.target.classList.contains('node')) return;
    event.preventDefault();
    select('node', Number(event.target.dataset.node));
  });
}

/** The node, arc or point that is seen at a point of the view of space. */
function pick(x, y) {
  let best = null;
  const consider = (kind, id, distance) => {
    if (!best || distance < best.distance) best = {kind, id, distance};
  };
  for (const {at, id, point} of [...view.marks, ...view.extraMarks]) {
    const seen = view.onScreen(at);
    const distance = Math.hypot(seen[0] - x, seen[1] - y);
    if (distance < 13 && id !== undefined) consider('node', id, distance);
    if (distance < 13 && point !== undefined) consider('point', point, distance);
  }
  if (best) return best;  // arcs end in nodes and are as near
  for (const arc of arcs)
    arc.polyline.slice(1).reduce((from, vertex) => {
      const to = view.onScreen(inSpace(vertex));
      const chord = minus(to, from);
      const length = chord[0] ** 2 + chord[1] ** 2;
      const t = length ? Math.min(1, Math.max(0, ((x - from[0]) * chord[0] + (y - from[1]) * chord[1]) / length)) : 0;
      const distance = Math.hypot(from[0] + t * chord[0] - x, from[1] + t * chord[1] - y);
      if (distance < 9) consider('arc', arc.id, distance);
      return to;
    }, view.onScreen(inSpace(arc.polyline[0])));
  return best;
}

// The view of space.

function spaceFigure(caption) {
  const box = element('div', {class: 'space', id: 'space'});
  const controls = element('div', {class: 'controls'});
  return {figure: element('figure', {}, box, controls, element('figcaption', {}, caption)), box, controls};
}

/** A view, or a message in its place where the browser has no WebGL. */
function spaceView(box, seen, aim) {
  try {
    return new SpaceView(box, seen, aim.length > 2 ? aim : seen);
  } catch (error) {
    box.replaceChildren(element('p', {class: 'missing', role: 'status'}, 'This browser shows no WebGL, so the view of space is missing. The rest of the page is complete.'));
    return null;
  }
}

/** Lines u = k/8 and v = k/8 of a patch, its sides thicker; of a part of it as many. */
function patchWires(points, which, [[a, b], [c, d]] = wholeSquare) {
  for (let k = 0; k <= 8; ++k)
    for (const along of [0, 1]) {
      const value = along ? c + (d - c) * k / 8 : a + (b - a) * k / 8;
      const isSide = value === 0 || value === 1;
      const line = Array.from({length: 33}, (_, i) => patchAt(points, ...(along ? [a + (b - a) * i / 32, value] : [value, c + (d - c) * i / 32])).at);
      view.addWire(line, isSide ? '--soft' : `--wire${which}`, isSide ? 1.6 : 1, {patch: which});
    }
}

function gridOf(points, cells) {
  const at = [];
  for (let i = 0; i <= cells; ++i) for (let j = 0; j <= cells; ++j) at.push(patchAt(points, i / cells, j / cells).at);
  return at;
}

function netWires(points, which) {
  const columns = points[0].map((_, j) => points.map((row) => row[j]));
  for (const row of [...points, ...columns]) view.addWire(row.map((p) => p.slice(0, 3)), `--patch${which}`, 2, {patch: which, net: which, front: true, dashes: [0.03, 0.02]});
}

/** All patches, with their control nets, which are seen if they are asked for. */
function buildPatches() {
  report.patches.forEach(({points}, which) => {
    const rectangle = view.rectangle(points);
    if (!rectangle) return;
    view.addSurface(patchPiece(points, which, rectangle));
    patchWires(points, which, rectangle);
    netWires(points, which);
  });
}

/** Not the bare name, which is often that of an axis. */
const patchTitle = (patch) => /^patch\b/i.test(patch.name) ? patch.name : `patch ${patch.name}`;

/** Names of patches and of their parameters at the corner (0,0) and the ends of the sides from there. */
function patchLabels() {
  return report.patches.flatMap((patch, which) => {
    const at = (u, v) => patchAt(patch.points, u, v).at;
    const [first, second] = parameters.slice(2 * which, 2 * which + 2);
    const name = patchTitle(patch).slice(0, 30);
    return [[name, plus(at(0, 0), minus(at(0, 0), at(0.5, 0.5)), 0.1)], [first, plus(at(0.5, 0), minus(at(0.5, 0), at(0.5, 0.5)), 0.09)],
      [second, plus(at(0, 0.5), minus(at(0, 0.5), at(0.5, 0.5)), 0.09)]].map(([text, place]) => {
      const node = drawing('g', {'data-patch': which}, drawing('text', {class: 'label', 'text-anchor': 'middle', y: 4, 'font-style': text === name ? null : 'italic'}, text));
      view.overlay.append(node);
      return {node, at: place};
    });
  });
}

const equationTitle = ({name, kind}) => name === kind ? kind : `${kind} ${name}`;

/** The name of a surface given by its equation, at its point that is the farthest from the middle of the patch, or of all. */
function equationLabel(equation, k) {
  const middle = report.patches.length ? patchAt(report.patches[0].points, 0.5, 0.5).at : view.whole.centre;
  const away = (p) => dot(minus(p, middle), minus(p, middle));
  const place = equationCorners(equation).reduce((best, p) => !best || away(p) > away(best) ? p : best, null) || (k ? view.whole.high : view.whole.low);
  const node = drawing('g', {'data-patch': report.patches.length + k}, drawing('text', {class: 'label', 'text-anchor': 'middle', y: 4}, equationTitle(equation).slice(0, 30)));
  view.overlay.append(node);
  return {node, at: place};
}

function buildCurve() {
  const rims = (graph.overlaps || []).flatMap((overlap) => overlap.chains.flat());
  for (const arc of [...arcs, ...rims]) {
    const dashes = componentDashes(arc.component).split(' ').map((d) => 0.0065 * d);
    view.addWire(arc.polyline.map(inSpace), arc.component < 0 ? '--ink' : `--c${arc.component % 7}`, arc.component < 0 ? 2 : 3.4,
      {arc: arc.component < 0 ? undefined : arc.id, dashes: dashes.length > 1 ? [dashes[0], dashes[1]] : null});
  }
}

function nodeMarks() {
  return nodes.map((node) => {
    const mark = drawing('g', {class: 'node', 'data-node': node.id}, drawing('circle', {class: 'ringed', r: 9.5}),
      glyphPath(glyphName(node), nodeColour(node)), drawing('text', {class: 'number', 'text-anchor': 'middle'}, String(node.id)));
    view.overlay.append(mark);
    return {node: mark, at: node.approx.point, id: node.id};
  });
}

/** The figure fills the screen, by the browser or, where it cannot, by the style sheet. */
function fullScreenButton(figure) {
  const button = textButton('full screen', () => {
    if (document.fullscreenElement) return document.exitFullscreen();
    if (figure.classList.contains('large') || !document.fullscreenEnabled) return show(!figure.classList.contains('large'));
    return figure.requestFullscreen().catch(() => show(true));
  }, {id: 'full-screen', 'aria-pressed': 'false'});
  const show = (on) => {
    figure.classList.toggle('large', on);
    button.setAttribute('aria-pressed', String(on));
  };
  document.addEventListener('fullscreenchange', () => show(document.fullscreenElement === figure));
  document.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && figure.classList.contains('large') && !document.fullscreenElement) show(false);
  });
  return button;
}

function spaceControls(controls, nets) {
  if (!view) return;
  const redraw = (change) => (on) => {
    change(on);
    view.repaint();
  };
  const solidity = element('input', {type: 'range', min: 10, max: 100, step: 1, id: 'solidity', 'aria-label': 'opacity of the surfaces, in percent'});
  solidity.value = 62;
  solidity.addEventListener('input', () => redraw((value) => { view.solidity = value; })(Number(solidity.value) / 100));
  const shown = [...(report.patches || []).map(patchTitle), ...equations.map(equationTitle)];
  const patches = shown.length > 1 ? shown.map((title, which) =>
    checkbox(title, true, redraw((on) => on ? view.hidden.delete(which) : view.hidden.add(which)), `patch-${which}`)) : [];
  controls.append(...patches,
    ...(nets ? [checkbox('control nets', false, redraw((on) => { view.netsShown = on; }), 'nets')] : []),
    ...(nodes.length ? [checkbox('node numbers', false, (on) => {
      page.classList.toggle('numbered', on);
      view.render();
    }, 'numbers')] : []),
    checkbox('axes', true, redraw((on) => { view.hasAxes = on; }), 'axes'),
    element('label', {}, 'opacity', solidity),
    element('span', {class: 'group', role: 'group', 'aria-label': 'view along an axis'}, ...['x', 'y', 'z'].map((name, k) => textButton(name, () => view.along(k), {'aria-label': `view along ${name}`, class: 'axis-button'}))),
    element('span', {class: 'group'}, textButton('turn back', () => view.home()), textButton('+', () => view.zoom(0.85), {'aria-label': 'closer'}), textButton('−', () => view.zoom(1 / 0.85), {'aria-label': 'further'}),
      fullScreenButton(controls.closest('figure'))),
    element('span', {class: 'group'}, textButton('save picture', () => view.save(filename('.png')), {'aria-label': 'save picture as PNG'}),
      textButton('save drawing', () => saveFile(filename('-space.svg'), 'image/svg+xml', [vectorPicture(view)]), {'aria-label': 'save drawing: SVG, hidden lines removed'})));
}

function listenForPicks() {
  let pressed = null;
  view.canvas.addEventListener('pointerdown', (event) => {
    pressed = [event.clientX, event.clientY];
  });
  view.canvas.addEventListener('pointerup', (event) => {
    if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
    const box = view.canvas.getBoundingClientRect();
    const found = pick(event.clientX - box.left, event.clientY - box.top);
    if (found) select(found.kind, found.id);
  });
}

// The pictures of a result with nodes and arcs, or of a line.

function patchCaption(which) {
  const patch = report.patches[Math.min(which, report.patches.length - 1)];
  return element('figcaption', {}, element('b', {}, patchTitle(patch)), ` (${parameters[2 * which]}, ${parameters[2 * which + 1]})`);
}

const drawnInDoubles = 'Coordinates are in the units of the file. Pictures are drawn in double precision and decide nothing.';

/** A square with its buttons. */
function squareFigure(square, which) {
  zoomable(square, () => markSelected());
  return element('figure', {}, patchCaption(which), square.svg, element('div', {class: 'controls'},
    textButton('+', () => square.zoom(0.6), {'aria-label': `closer in the square of ${parameters[2 * which]} and ${parameters[2 * which + 1]}`}),
    textButton('−', () => square.zoom(1 / 0.6), {'aria-label': 'further'}), textButton('whole square', () => square.whole(), {class: 'whole'}),
    textButton('save as SVG', () => saveFile(filename(`-${parameters[2 * which]}${parameters[2 * which + 1]}.svg`), 'image/svg+xml', [standaloneSvg(square.svg)]))));
}

/** The view of space, and beside it both squares, or what is given. */
function pictures(withSquares, beside = []) {
  const {figure, box, controls} = spaceFigure(`Drag or use the arrow keys to turn; with a picture in focus the wheel zooms. ${drawnInDoubles}`);
  const views = element('div', {class: !withSquares ? 'views pair' : parameters.length ? 'views' : 'views flat'}, figure, ...beside);
  page.append(views);
  const curve = [...arcs, ...(graph.overlaps || []).flatMap((overlap) => overlap.chains.flat())].flatMap((arc) => arc.polyline.map(inSpace));
  const seen = [...report.patches.flatMap((patch) => gridOf(patch.points, 10)), ...equations.flatMap(equationCorners), ...(report.patches.length ? [] : curve)];
  view = spaceView(box, seen.length ? seen : [[-1, -1, -1], [1, 1, 1]], curve);
  if (withSquares) {
    const right = element('div', {class: 'squares'});
    if (parameters.length) views.append(right);
    squares = [0, 1].slice(0, parameters.length / 2).map((which) => resultSquare(which, report.patches[Math.min(which, report.patches.length - 1)].name));
    squares.forEach((square, which) => right.append(squareFigure(square, which)));
    page.append(resultLegend());
  }
  page.append(element('div', {id: 'selection', role: 'status', 'aria-live': 'polite'}));
  if (view) {
    view.build(buildPatches);
    const around = report.patches.length ? view.whole : boxAround(view.seen, 0.15);
    equations.forEach((equation, k) => view.build(() => view.addSurface(equationPiece(equation, around, report.patches.length + k))));
    if (withSquares) view.build(buildCurve);
    view.marks = withSquares ? nodeMarks() : [];
    view.labels.push(...patchLabels(), ...equations.map(equationLabel));
    view.resize();
    listenForPicks();
  }
  spaceControls(controls, report.patches.length > 0);
}

// The slider, and the fibre it shows.

/** Points of arcs over a value of the first parameter of either square, read off the polylines. */
function pointsOnPolylines(value) {
  const found = [];
  for (const arc of arcs)
    for (const index of report.command === 'self' ? [0, 2] : [0])
      arc.polyline.slice(1).reduce((from, to) => {
        if ((from[index] - value) * (to[index] - value) <= 0 && from[index] !== to[index])
          found.push(plus(from, minus(to, from), (value - from[index]) / (to[index] - from[index])));
        return to;
      }, arc.polyline[0]);
  return found;
}

function pointsOfFibre(fibre) {
  return fibre.result.points.map((point) => [...parameters.map((p) => point.approx[p]), ...point.approx.point]);
}

const shownParts = {line: false, plane: false, cylinder: false};

function lineSwitches(update) {
  const surfaces = report.patches.every(isBiquadratic) ? {plane: 'its plane', cylinder: 'its cylinder'} : {};
  return Object.entries({line: 'line and points', ...surfaces}).map(([part, text]) => checkbox(text, shownParts[part], (on) => {
    shownParts[part] = on;
    update();
  }, `show-${part}`));
}

function switchOn() {
  if (Object.values(shownParts).some(Boolean)) return;
  for (const part of Object.keys(shownParts)) {
    shownParts[part] = true;
    const box = document.getElementById(`show-${part}`);
    if (box) box.checked = true;
  }
}

function sliderSection() {
  const fixed = parameters[0];
  const steps = 40;
  const slider = element('input', {type: 'range', min: 0, max: steps, step: 1, id: 'slider', 'aria-label': `parameter ${fixed}, in fortieths`});
  slider.value = 20;
  const value = element('output', {class: 'value', id: 'value', for: 'slider'});
  const body = element('div', {id: 'fibre'});
  const update = () => {
    const k = Number(slider.value);
    const fibre = report.fibres && report.fibres[k];
    const points = fibre ? pointsOfFibre(fibre) : pointsOnPolylines(k / steps);
    shownPoints = points;
    if (selected && selected.kind === 'point') selected = null;
    const text = fibre ? Object.values(fibre.result.fixed)[0] : String(k / steps);
    value.textContent = `${fixed} = ${text}`;
    slider.setAttribute('aria-valuetext', `${fixed} = ${text}, ${counted(points.length, 'point')}`);
    showLine(view, squares, fixed, k / steps, points, shownParts);
    body.replaceChildren(...(fibre ? [fibreBody(fibre)] : [element('p', {id: 'fibre-count'}, `${counted(points.length, 'point')} of the line, read off the polylines: for the eye, not proved.`)]));
    markSelected();
  };
  slider.addEventListener('input', () => {
    switchOn();
    update();
  });
  section(`A parameter line ${fixed} = const`, 'line',
    element('p', {}, report.fibres ? `The line ${fixed} = const of the first patch is cut out of space by a plane and a quadratic cylinder. Pulled back to the other patch, they leave an equation in one variable. The points below are exact, for each of 41 values of ${fixed}.`
      : equations.length ? `The line ${fixed} = const of the patch, and where it meets the ${equations[0].kind}.`
      : report.command === 'intersect' ? `The line ${fixed} = const of the first patch, and where it meets the other one.`
        : `The line ${fixed} = const of the patch, its plane and quadratic cylinder, and where it meets other parts of the patch.`),
    element('div', {class: 'controls'}, value, slider, ...lineSwitches(update)), body);
  update();
}

function fibreBody(fibre) {
  const {svg, legend} = fibrePicture(fibre);
  return element('div', {class: 'fibre'}, element('figure', {}, svg, legend), element('div', {}, fibreFacts(fibre), ...linePolynomials(fibre.result)));
}

// Data.

function netTable(patch) {
  const rows = patch.net.map((row, i) => element('tr', {}, element('th', {scope: 'row'}, `row ${i}`), row.map((point, j) => element('td', {}, `(${point.join(', ')})${patch.weights ? `, weight ${patch.weights[i][j]}` : ''}`))));
  return tableOf({class: 'net'}, `Control points of ${patch.name}; the row belongs to the first parameter`, [[''], ...patch.net[0].map((_, j) => [`column ${j}`])], rows);
}

function dataSection() {
  section('Data', 'data-section', ...equations.map((equation, k) => polynomialBox({title: equationTitle(equation), identifier: 'FG'[k], variables: ['x', 'y', 'z'], terms: equation.terms})), ...((report.patches || []).length ? [element('div', {class: 'nets'}, report.patches.map(netTable))] : []),
    element('div', {class: 'controls'}, textButton('save the result as JSON', () => saveFile(filename('.json'), 'application/json', [JSON.stringify(result, null, 1), '\n']))));
}

// The pages.

function graphPage() {
  pictures(true);
  if (parameters.length) sliderSection();
  graphTables();
  section('What was proved, and how', 'proofs', proofSection(intersectionProofs(report.command === 'intersect')));
  paperSection();
  dataSection();
  listenForSelection();
  markSelected();
}

function graphTables() {
  if (!nodes.length) return;
  const made = section('Nodes', 'nodes-section', element('div', {class: 'controls'}, checkbox('exact intervals', true, (on) => made.classList.toggle('hide-exact', !on), 'exact')), nodeTable());
  if (arcs.length) section(graph.curves && !report.components ? 'Arcs and curves' : 'Arcs and components', 'arcs-section', arcTable(), graph.curves && !report.components ? curveTable() : componentTable());
  if (graph.overlaps.length) section('Overlaps', 'overlaps-section', overlapTable());
}

/** The largest bound of all polylines, rims of overlaps included. */
function worstBound() {
  return Math.max(0, ...[...arcs, ...graph.overlaps.flatMap((overlap) => overlap.chains.flat())].map((arc) => arc.error_bound));
}

function linePage() {
  const fibre = {...report.fibres[0], result, polynomials: true};
  const [fixed, value] = Object.entries(result.fixed)[0];
  const {svg, legend} = fibrePicture(fibre);
  pictures(false, [element('div', {class: 'fibre-facts'}, fibreFacts(fibre))]);
  Object.assign(shownParts, {line: true, plane: true, cylinder: true});
  shownPoints = pointsOfFibre(fibre);
  const own = Math.floor(parameters.indexOf(fixed) / 2);
  const square = unitSquare(parameters[2 * own], parameters[2 * own + 1], `The line in the square of ${report.patches[own].name}`);
  square.paint(() => {
    square.fibre = drawing('g', {class: 'fibre-layer'});
    square.marks.append(square.fibre);
    if (square.line) square.line();
  });
  squares = own === 0 ? [square] : [];
  const update = () => {
    showLine(view, own === 0 ? [square] : [{...noSquare}, square], fixed, toDouble(value), shownPoints, shownParts);
    markSelected();
  };
  document.querySelector('.views .controls').prepend(...lineSwitches(update));
  section('The line in both squares', 'line', element('div', {class: 'views pair fibre'}, element('figure', {}, patchCaption(own), square.svg),
    element('figure', {}, patchCaption(1 - own), svg, legend)));
  update();
  const equations = linePolynomials(fibre.result);
  if (equations.length) section('Equations', 'equations', ...equations);
  section('What was proved, and how', 'proofs', proofSection(lineProofs()));
  paperSection();
  dataSection();
  listenForSelection();
  markSelected();
}

/** Stands for a square that the page does not show. */
const noSquare = {fibre: element('g'), domain: wholeSquare, shows: () => false};

const still = document.getElementById('still');  // the picture that is seen without a script
if (still) still.remove();
document.getElementById('footer').textContent = `Made by ${report.program}. The page holds its data and loads nothing.`;
({intersect: graphPage, self: graphPage, line: linePage, implicitize: implicitizePage, revolve: revolvePage, compare: comparePage, verify: verifyPage})[report.command]();
document.documentElement.dataset.ready = 'true';
