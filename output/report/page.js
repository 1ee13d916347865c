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
    for (const line of view.wireGroup.children) {
      const chosen = selected && selected.kind === 'arc' && line.userData.arc === selected.id;
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
  markSelected();
}

function selectionWords() {
  if (!selected) return [`Choose ${nodes.length ? 'a node or an arc' : 'a point'}, in a table, a square or in space: it is marked everywhere.`];
  if (selected.kind === 'arc') {
    const arc = arcs[selected.id];
    return [element('b', {}, `Arc ${arc.id}`), ` of component ${arc.component}, from node ${arc.from} to node ${arc.to}, ${arc.contact}, ${arc.on === 'interior' ? 'interior' : 'along a side of a patch'}; within ${boundText(arc.error_bound)} of its polyline of ${arc.polyline.length} vertices.`];
  }
  if (selected.kind === 'point') {
    const point = shownPoints[selected.id];
    return [element('b', {}, `Point ${pointLetter(selected.id)} of the line`), ': ', ...parameters.flatMap((p, i) => [i ? ', ' : '', element('i', {}, p), ` = ${String(point[i])}`]),
      `; (x, y, z) = (${point.slice(4).map((c) => Number(c.toPrecision(9))).join(', ')}).`];
  }
  const node = nodes[selected.id];
  return [element('b', {}, `Node ${node.id}`), `, ${nodeWords(node)}: `, ...parameters.flatMap((p, i) => [i ? ', ' : '', element('i', {}, p), ` = ${String(node.approx[p])}`]),
    `; (x, y, z) = (${node.approx.point.map((c) => Number(c.toPrecision(9))).join(', ')}).`];
}

/** Clicks and keys on anything that stands for a node or an arc. */
function listenForSelection() {
  const chosen = (target) => target.closest('tr[data-node], tr[data-arc], tr[data-point], .node, .hit[data-arc], .hit[data-point]');
  page.addEventListener('click', (event) => {
    const target = chosen(event.target);
    if (!target || event.target.closest('.polynomial')) return;
    const kind = ['node', 'arc', 'point'].find((name) => name in target.dataset);
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
      const to = view.onScreen(vertex.slice(4));
      const chord = minus(to, from);
      const length = chord[0] ** 2 + chord[1] ** 2;
      const t = length ? Math.min(1, Math.max(0, ((x - from[0]) * chord[0] + (y - from[1]) * chord[1]) / length)) : 0;
      const distance = Math.hypot(from[0] + t * chord[0] - x, from[1] + t * chord[1] - y);
      if (distance < 9) consider('arc', arc.id, distance);
      return to;
    }, view.onScreen(arc.polyline[0].slice(4)));
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

/** Lines u = k/8 and v = k/8 of a patch, its sides thicker. */
function patchWires(points, which) {
  const wires = [];
  for (let k = 0; k <= 8; ++k)
    for (const along of [0, 1]) {
      const line = Array.from({length: 33}, (_, i) => patchAt(points, ...(along ? [i / 32, k / 8] : [k / 8, i / 32])).at);
      wires.push(view.wire(line, k % 8 ? `--patch${which}` : '--soft', k % 8 ? 1 : 1.6, {opacity: k % 8 ? 0.75 : 0.9, order: 3}));
    }
  return wires;
}

function gridOf(points, cells) {
  const at = [];
  for (let i = 0; i <= cells; ++i) for (let j = 0; j <= cells; ++j) at.push(patchAt(points, i / cells, j / cells).at);
  return at;
}

function netWires(points, which) {
  const rows = [0, 1, 2].flatMap((i) => [points[i], points.map((row) => row[i])]);
  return rows.map((row) => view.wire(row, `--patch${which}`, 2, {order: 3, dashes: [0.03, 0.02]}));
}

function showPatches() {
  report.patches.forEach((patch, which) => {
    view.surfaces.push(patchPiece(patch.points, which));
    view.wireGroup.add(...patchWires(patch.points, which));
  });
}

/** Names of patches and of their parameters at the corner (0,0) and the ends of the sides from there. */
function patchLabels() {
  return report.patches.flatMap((patch, which) => {
    const at = (u, v) => patchAt(patch.points, u, v).at;
    const [first, second] = parameters.slice(2 * which, 2 * which + 2);
    return [[patch.name.slice(0, 24), plus(at(0, 0), minus(at(0, 0), at(0.5, 0.5)), 0.1)], [first, plus(at(0.5, 0), minus(at(0.5, 0), at(0.5, 0.5)), 0.09)],
      [second, plus(at(0, 0.5), minus(at(0, 0.5), at(0.5, 0.5)), 0.09)]].map(([text, place]) => {
      const node = drawing('g', {}, drawing('text', {class: 'label', 'text-anchor': 'middle', y: 4, 'font-style': text === patch.name.slice(0, 24) ? null : 'italic'}, text));
      view.overlay.append(node);
      return {node, at: place};
    });
  });
}

function curveWires() {
  const rims = (graph.overlaps || []).flatMap((overlap) => overlap.chains.flat());
  for (const arc of [...arcs, ...rims]) {
    const dashes = componentDashes(arc.component).split(' ').map((d) => 0.0065 * d);
    view.wireGroup.add(view.wire(arc.polyline.map((vertex) => vertex.slice(4)), arc.component < 0 ? '--ink' : `--c${arc.component % 7}`, arc.component < 0 ? 2 : 3.4,
      {arc: arc.component < 0 ? undefined : arc.id, dashes: dashes.length > 1 ? [dashes[0], dashes[1]] : null}));
  }
}

function nodeMarks() {
  return nodes.map((node) => {
    const mark = drawing('g', {class: 'node', 'data-node': node.id}, drawing('circle', {class: 'ringed', r: 9.5}),
      glyphPath(glyphName(node), nodeColour(node)), drawing('text', {class: 'number', x: 9, y: -7}, String(node.id)));
    view.overlay.append(mark);
    return {node: mark, at: node.approx.point, id: node.id};
  });
}

function spaceControls(controls, nets) {
  if (!view) return;
  const netGroup = new THREE.Group();
  controls.append(
    ...(nets ? [checkbox('control nets', false, (on) => {
      netGroup.visible = on;
      view.render();
    }, 'nets')] : []),
    ...(nodes.length ? [checkbox('node numbers', false, (on) => page.classList.toggle('numbered', on), 'numbers')] : []),
    textButton('turn back', () => view.home()), textButton('+', () => view.zoom(0.85), {'aria-label': 'closer'}), textButton('−', () => view.zoom(1 / 0.85), {'aria-label': 'further'}),
    textButton('save picture', () => view.save(filename('.png'))));
  if (!nets) return;
  netGroup.visible = false;
  report.patches.forEach((patch, which) => netGroup.add(...netWires(patch.points, which)));
  for (const line of netGroup.children) line.material.color.set(colour(line.userData.property));
  onColoursChanged(() => netGroup.children.forEach((line) => line.material.color.set(colour(line.userData.property))));
  view.scene.add(netGroup);
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
  return element('figcaption', {}, element('b', {}, patch.name), ` (${parameters[2 * which]}, ${parameters[2 * which + 1]})`);
}

function pictures(withSquares) {
  const {figure, box, controls} = spaceFigure('Drag or use the arrow keys to turn; with the view in focus the wheel zooms. Pictures are drawn in double precision and decide nothing.');
  const views = element('div', {class: withSquares ? 'views' : 'views flat'}, figure);
  page.append(views);
  const curve = [...arcs, ...(graph.overlaps || []).flatMap((overlap) => overlap.chains.flat())].flatMap((arc) => arc.polyline.map((vertex) => vertex.slice(4)));
  view = spaceView(box, report.patches.flatMap((patch) => gridOf(patch.points, 10)), curve);
  if (withSquares) {
    const right = element('div', {class: 'squares'});
    views.append(right);
    squares = [0, 1].map((which) => resultSquare(which, report.patches[Math.min(which, report.patches.length - 1)].name));
    squares.forEach((square, which) => right.append(element('figure', {}, patchCaption(which), square.svg,
      element('div', {class: 'controls'}, textButton('save as SVG', () => saveFile(filename(`-${parameters[2 * which]}${parameters[2 * which + 1]}.svg`), 'image/svg+xml', [standaloneSvg(square.svg)]))))));
    page.append(resultLegend());
  }
  page.append(element('div', {id: 'selection', role: 'status', 'aria-live': 'polite'}));
  if (view) {
    showPatches();
    if (withSquares) curveWires();
    view.marks = withSquares ? nodeMarks() : [];
    view.marks.push(...patchLabels());
    view.repaint();
    view.resize();
    listenForPicks();
  }
  spaceControls(controls, true);
}

// The slider, and the fibre it shows.

/** Points of arcs over a value of the first parameter of either square, read off the polylines. */
function pointsOnPolylines(value) {
  const found = [];
  for (const arc of arcs)
    for (const index of report.patches.length === 1 ? [0, 2] : [0])
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
  return Object.entries({line: 'line and points', plane: 'its plane', cylinder: 'its cylinder'}).map(([part, text]) => checkbox(text, shownParts[part], (on) => {
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
      : `The line ${fixed} = const of the patch, its plane and quadratic cylinder, and where it meets other parts of the patch.`),
    element('div', {class: 'controls'}, value, slider, ...lineSwitches(update)), body);
  update();
}

function fibreBody(fibre) {
  const {svg, legend} = fibrePicture(fibre);
  return element('div', {class: 'fibre'}, element('figure', {}, svg, legend), element('div', {}, fibreFacts(fibre), ...linePolynomials(fibre.result)));
}

// Head and data.

function header() {
  const complete = result.status === 'complete';
  document.getElementById('title').textContent = report.title || `exsect ${report.command}`;
  document.getElementById('origin').textContent = [`exsect ${report.command}`, report.file].filter(Boolean).join(' · ');
  const verdicts = {agrees: 'Agrees, proved.', disagrees: 'Disagrees, proved.', undecided: 'Not decided.'};
  const word = result.verdict ? verdicts[result.verdict] : complete ? report.command === 'compare' ? 'Complete.' : 'Complete, proved.' : 'Incomplete.';
  const good = result.verdict ? result.verdict === 'agrees' : complete;
  document.getElementById('answer').replaceChildren(element('span', {class: good ? 'complete' : 'incomplete'}, word), ' ', answerWords());
  document.getElementById('footer').textContent = `Made by ${report.program}. The page holds its data and loads nothing.`;
}

function counts(pairs) {
  document.getElementById('counts').append(...pairs.map(([name, value]) => element('div', {}, element('dt', {}, name), element('dd', {}, String(value)))));
}

function shapeWords() {
  const shapes = ['closed', 'open', 'branched'].filter((shape) => graph.summary[shape]).map((shape) => `${graph.summary[shape]} ${shape}`);
  const more = [graph.summary.isolated ? counted(graph.summary.isolated, 'isolated point') : '', graph.summary.overlaps ? counted(graph.summary.overlaps, 'overlap') : ''].filter(Boolean);
  return [`${counted(graph.summary.components, 'component')}${shapes.length ? ` (${shapes.join(', ')})` : ''}`, ...more].join(', ');
}

function answerWords() {
  const names = report.patches ? report.patches.map((patch) => patch.name) : [];
  if (report.command === 'intersect') return `${names[0]} and ${names[1]} intersect in ${shapeWords()}.`;
  if (report.command === 'self') return `${names[0]} meets itself in ${shapeWords()}.`;
  if (report.command === 'line') {
    const [fixed, value] = Object.entries(result.fixed)[0];
    return `The line ${fixed} = ${value} meets the other patch in ${counted(result.points.length, 'point')}${result.on_patch.length ? ` and ${counted(result.on_patch.length, 'piece')}` : ''}.`;
  }
  if (report.command === 'verify') return verdictWords();
  if (report.command === 'compare') return `${names[0]} and ${names[1]} intersect in ${shapeWords()}; ${result.methods.length} methods side by side.`;
  const last = result.equations.at(-1);
  const bound = result.proved.find(({name}) => name === 'two-sided') || result.proved.find(({name}) => name === 'one-sided');
  return [result.exact ? 'Exact' : 'Approximate', report.command === 'revolve' ? `surface of revolution by ${result.method}` : `implicit ${result.equations.length === 1 ? 'equation' : 'equations'}`,
    last ? `of degree ${last.degree}` : ''].join(' ').trim() + (bound && bound.approx !== undefined && !result.exact ? `, distance at most ${boundText(bound.approx)}.` : '.');
}

function netTable(patch) {
  const rows = patch.net.map((row, i) => element('tr', {}, element('th', {scope: 'row'}, `row ${i}`), row.map((point) => element('td', {}, `(${point.join(', ')})`))));
  return tableOf({class: 'net'}, `Control points of ${patch.name}; the row belongs to the first parameter`, [[''], ['column 0'], ['column 1'], ['column 2']], rows);
}

function dataSection() {
  section('Data', 'data-section', ...(report.patches ? [element('div', {class: 'nets'}, report.patches.map(netTable))] : []),
    element('div', {class: 'controls'}, textButton('save the result as JSON', () => saveFile(filename('.json'), 'application/json', [JSON.stringify(result, null, 1), '\n']))));
}

// The pages.

function graphPage() {
  const {summary} = graph;
  counts([['nodes', nodes.length], ['arcs', arcs.length], ['boundary points', summary.boundary],
    ...parameters.map((p) => [`turning in ${p}`, summary.turning[p]]), ['largest distance of a polyline', boundText(worstBound())],
    ['computed in', `${Math.round(graph.work.milliseconds)} ms`]]);
  pictures(true);
  sliderSection();
  graphTables();
  section('What was proved, and how', 'proofs', proofSection(intersectionProofs(report.command === 'intersect')));
  dataSection();
  listenForSelection();
  markSelected();
}

function graphTables() {
  if (!nodes.length) return;
  const made = section('Nodes', 'nodes-section', element('div', {class: 'controls'}, checkbox('exact intervals', true, (on) => made.classList.toggle('hide-exact', !on), 'exact')), nodeTable());
  if (arcs.length) section('Arcs and components', 'arcs-section', arcTable(), componentTable());
  if (graph.overlaps.length) section('Overlaps', 'overlaps-section', overlapTable());
}

/** The largest bound of all polylines, rims of overlaps included. */
function worstBound() {
  return Math.max(0, ...[...arcs, ...graph.overlaps.flatMap((overlap) => overlap.chains.flat())].map((arc) => arc.error_bound));
}

function linePage() {
  const fibre = {...report.fibres[0], result, polynomials: true};
  const [fixed, value] = Object.entries(result.fixed)[0];
  counts([['points', result.points.length], ['phantom roots', fibre.phantoms.length], ['shape of the line', result.shape], ['degree of the eliminant', result.eliminant.degree]]);
  pictures(false);
  Object.assign(shownParts, {line: true, plane: true, cylinder: true});
  shownPoints = pointsOfFibre(fibre);
  const update = () => {
    showLine(view, [], fixed, toDouble(value), shownPoints, shownParts);
    markSelected();
  };
  document.querySelector('.views .controls').prepend(...lineSwitches(update));
  update();
  section('The line on the other patch', 'line', fibreBody(fibre));
  section('What was proved, and how', 'proofs', proofSection(lineProofs()));
  dataSection();
  listenForSelection();
  markSelected();
}

header();
({intersect: graphPage, self: graphPage, line: linePage, implicitize: implicitizePage, revolve: revolvePage, compare: comparePage, verify: verifyPage})[report.command]();
document.documentElement.dataset.ready = 'true';
