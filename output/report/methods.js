// The pages of implicitize, revolve and compare.

/** The picture that the program drew and the HTML holds. */
function programPicture() {
  const svg = still.querySelector('svg');
  const text = new XMLSerializer().serializeToString(svg);
  svg.style.maxWidth = `${svg.viewBox.baseVal.width}px`;
  svg.setAttribute('role', 'img');
  svg.setAttribute('aria-label', 'Picture of the result');
  return element('figure', {}, still.querySelector('.picture'),
    element('div', {class: 'controls'}, textButton('save as SVG', () => saveFile(filename('.svg'), 'image/svg+xml', [text]))));
}

/** A view of space, beside it the program's picture if there is one; `build` adds what is in the view. */
function plainSpace(seen, aim, caption, build) {
  const {figure, box, controls} = spaceFigure(caption);
  page.append(element('div', {class: still ? 'views pair' : 'views flat'}, figure, ...(still ? [programPicture()] : [])));
  view = spaceView(box, seen, aim);
  if (view) view.build(build);
  return controls;
}

function finishSpace(controls, nets) {
  if (view) view.resize();
  spaceControls(controls, nets);
}

function equationBoxes() {
  return result.equations.map(({name, degree, terms}) => polynomialBox({title: `${name}, degree ${degree}, ${counted(terms.length, 'term')}`, identifier: name, variables: variablesOf(name), terms}));
}

/** Of a surface of revolution the profile has r, z and the surface x, y, z. */
function variablesOf(name) {
  if (report.command === 'revolve') return name === 'profile' ? ['r', 'z'] : ['x', 'y', 'z'];
  return result.variables;
}

function statementTable() {
  const rows = result.proved.map(({name, statement, value, approx}) => element('tr', {'data-statement': name},
    element('td', {}, name), element('td', {class: 'statement'}, statement),
    element('td', {class: 'number'}, approx === undefined || approx === null ? '' : element('span', {class: 'decimal'}, String(approx))),
    element('td', {}, value === undefined || value === null ? '' : element('span', {class: 'exact'}, `= ${value}`))));
  return tableOf({id: 'statements'}, 'Statements about exactly these equations; the decimal is not below the exact number', [['name'], ['statement'], ['number', 'number'], ['exactly']], rows);
}

function provedSection(how) {
  section('What was proved, and how', 'proofs', ...how.map((text) => element('p', {}, text)), statementTable(), proofSection([]));
}

/** The zero sets of the equations in a box; they are sampled once. */
function zeroSurfaces(box, properties, opacity) {
  return properties.map((property, i) => zeroSurface(polynomialFunction(result.equations[i].terms), box, 40, property, opacity));
}

function implicitizePage() {
  if (report.patches) {
    const points = gridOf(report.patches[0].points, 10);
    const box = boxAround(points, 0.12);
    const zeros = zeroSurfaces(box, ['--patch1'], 0.5);
    const controls = plainSpace(box.corners, points, `The patch in blue, the zero set of the equation around it in orange. ${drawnInDoubles}`, () => {
      buildPatches();
      zeros.forEach((piece) => view.addSurface(piece));
    });
    finishSpace(controls, true);
  } else if (report.curve) {
    const box = boxAround(report.curve, 0.3);
    const zeros = zeroSurfaces(box, ['--patch0', '--patch1'].slice(0, result.equations.length), 0.55);
    const controls = plainSpace(box.corners, report.curve, `The curve, and the zero sets of f (blue) and g (orange) around it. ${drawnInDoubles}`, () => {
      zeros.forEach((piece) => view.addSurface(piece));
      view.addWire(report.curve, '--c1', 4);
    });
    finishSpace(controls, false);
  } else {
    page.append(programPicture());
  }
  if (result.equations.length) section('Equations', 'equations', ...equationBoxes());
  else if (result.cells) section('Equations', 'equations', element('p', {}, `The equation is a spline of ${counted(result.cells.length, 'cell')}; the JSON result has the polynomial of each.`));
  provedSection([result.exact ? 'The equations vanish identically on the curve or patch: shown by exact elimination over the rational numbers.'
    : 'The equations were found in floating point and then rounded to short rational numbers. Everything below was proved afterwards, for these exact numbers, by Bernstein coefficients with rational arithmetic.']);
  paperSection();
  dataSection();
}

function ringTable() {
  if (!result.rings || !result.rings.length) return [];
  const rows = result.rings.map((ring, i) => element('tr', {}, element('td', {}, String(i)), valueCell(ring.r.approx, ring.r.box), valueCell(ring.z.approx, ring.z.box)));
  return [tableOf({id: 'rings'}, 'Singular rings: each box holds exactly one', [['ring'], ['r'], ['z']], rows)];
}

function branchTable() {
  if (!result.branches) return [];
  const {critical, counts: gaps} = result.branches;
  const {z} = result.region;
  const end = (i) => i < 0 ? short(toDouble(z[0])) : i >= critical.length ? short(toDouble(z[1])) : short(critical[i].approx);
  const rows = gaps.map((gap, i) => element('tr', {}, element('td', {class: 'number'}, end(i - 1)), element('td', {class: 'number'}, end(i)), element('td', {class: 'number'}, String(gap.own)), element('td', {class: 'number'}, String(gap.mirrored))));
  return [tableOf({id: 'branches'}, 'Branches over each interval of heights: of the profile\'s equation, and of its mirror image, which belong to no revolved profile (phantoms)', [['from z', 'number'], ['to z', 'number'], ['own', 'number'], ['mirrored', 'number']], rows)];
}

/** The revolved profile, rings, and the patch that it is intersected with; phantom branches if they are asked for. */
function buildRevolution(phantoms) {
  view.addSurface(turnedPiece(report.profile, '--patch1', 0.5));
  for (const polyline of phantoms) view.addSurface(turnedPiece(polyline, '--phantom', 0.22));
  (report.patches || []).forEach((patch) => {
    const rectangle = view.rectangle(patch.points);
    if (!rectangle) return;
    view.addSurface(patchPiece(patch.points, 0, rectangle));
    patchWires(patch.points, 0, rectangle);
    netWires(patch.points, 0);
  });
  for (const {sheet, polyline} of report.patch_curve || [])
    if (polyline.length > 1) view.addWire(polyline.map(([u, v]) => patchAt(report.patches[0].points, u, v).at), sheet === 'own' ? '--c0' : '--phantom', 3.4, sheet === 'own' ? {} : {dashes: [0.03, 0.02]});
  for (const ring of result.rings || []) view.addWire(circle(ring.r.approx, ring.z.approx), '--c3', 3.2);
  for (const height of [report.profile[0], report.profile.at(-1)]) view.addWire(circle(...height), '--soft', 1.4);
  for (let k = 0; k < 12; ++k)
    view.addWire(report.profile.map(([r, z]) => [r * Math.cos(k * Math.PI / 6), r * Math.sin(k * Math.PI / 6), z]), k ? '--wire1' : '--c1', k ? 1 : 3.2);
}

function revolvePage() {
  const rings = result.rings || [];
  const seen = [...report.profile.flatMap(([r, z]) => circle(r, z).filter((_, i) => i % 8 === 0)), ...(report.patches || []).flatMap((patch) => gridOf(patch.points, 8))];
  const phantoms = [...report.mirrored, ...report.further].filter((polyline) => polyline.length > 1);
  let seenPhantoms = [];
  const controls = plainSpace(seen, [], `The revolved profile; with mirrored and further branches, in grey, where the method makes them. ${drawnInDoubles}`, () => buildRevolution(seenPhantoms));
  if (view && phantoms.length)
    controls.append(checkbox('phantom branches', false, (on) => {
      seenPhantoms = on ? phantoms : [];
      view.rebuild();
    }, 'phantoms'));
  finishSpace(controls, Boolean(report.patches));
  page.append(legendList([[drawing('path', {class: 'arc', d: 'M1,8H33', stroke: 'var(--c1)'}), 'profile'],
    ...(rings.length ? [[drawing('path', {class: 'arc', d: 'M1,8H33', stroke: 'var(--c3)'}), 'singular ring']] : []),
    ...(report.patches ? [[drawing('path', {class: 'arc', d: 'M1,8H33', stroke: 'var(--c0)'}), 'the surface on the patch']] : [])]));
  const tables = [...ringTable(), ...branchTable()];
  if (tables.length) section('Singular rings and branches', 'branches-section', ...tables);
  if (result.equations.length) section('Equations', 'equations', ...equationBoxes());
  provedSection([result.exact ? 'The profile\'s equation vanishes identically on the profile.' : 'The profile\'s equation was found in floating point and rounded to short rational numbers; what follows was proved for these exact numbers.',
    rings.length || result.branches ? 'Singular rings and branches were counted with exact real root isolation.' : ''].filter(Boolean));
  paperSection();
  dataSection();
}

function methodTable() {
  const dash = (x) => x === null ? '–' : String(x);
  const rows = result.methods.map((row) => element('tr', {}, element('td', {}, row.method), element('td', {}, row.detail), element('td', {class: 'answer'}, row.answer),
    [row.found.number, row.found.open, row.found.closed, row.phantoms.met, row.phantoms.removed, row.points.exact, row.points.certified, row.points.missed, row.points.phantoms, row.points.phantoms_removed].map((n) => element('td', {class: 'number'}, dash(n))),
    element('td', {class: 'number'}, row.milliseconds.toFixed(0)), element('td', {class: 'number'}, row.peak_kib === null ? '–' : (row.peak_kib / 1024).toFixed(1))));
  return tableOf({id: 'methods'}, `On ${result.check_lines} lines u = const: exact points, how many each method finds with a proof, how many it misses; phantoms are branches, regions or points that belong to no point of the intersection.`,
    [['method'], [''], ['answer'], ['found', 'number'], ['open', 'number'], ['closed', 'number'], ['phantoms', 'number'], ['removed', 'number'], ['points', 'number'], ['certified', 'number'], ['missed', 'number'], ['phantom points', 'number'], ['removed', 'number'], ['ms', 'number'], ['MiB', 'number']], rows);
}

function comparePage() {
  pictures(true);
  section('The methods side by side', 'methods-section', methodTable(), programPicture());
  graphTables();
  section('What was proved, and how', 'proofs', proofSection([...intersectionProofs(true),
    ['The resultant\'s curve is exact; its phantom branches are removed with a proof, up to isolated points.', 'Whole arcs of the curve are accepted or refused by exact fibres over rational samples.'],
    ['Outside of the regions of the quartics there is no point of the intersection.', 'By Bernstein coefficients and a proved bound of the quartic on its piece of the patch. What quartics find inside is measured on the check lines and proves nothing.']]));
  paperSection();
  dataSection();
  listenForSelection();
  markSelected();
}
