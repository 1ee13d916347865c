// Tables of nodes, arcs and components; what each row shows is in the JSON result under the same id.

/** The cells know their heads, which they show where there is no room for columns (class "cards"). */
function tableOf(attributes, caption, heads, rows) {
  for (const row of rows) [...row.cells].forEach((cell, i) => cell.setAttribute('data-head', heads[i] ? heads[i][0] : ''));
  return element('div', {class: 'scroll'}, element('table', attributes, element('caption', {}, caption),
    element('thead', {}, element('tr', {}, heads.map(([head, kind]) => element('th', {scope: 'col', class: kind || null}, head)))),
    element('tbody', {}, rows)));
}

function pickButton(label, mark, name) {
  return element('button', {type: 'button', class: 'pick', 'aria-pressed': 'false', 'aria-label': `mark ${name}`},
    drawing('svg', {viewBox: '-8 -8 16 16', 'aria-hidden': 'true'}, mark), label);
}

function nodeTable() {
  const rows = nodes.map((node) => element('tr', {'data-node': node.id},
    element('td', {}, pickButton(String(node.id), glyphPath(glyphName(node), nodeColour(node)), `node ${node.id}`)),
    element('td', {class: 'kinds'}, node.kinds.join(', ') || '–'),
    element('td', {class: 'place'}, [...node.on, ...node.wrt.map((p) => `turns in ${p}`), ...node.free.map((p) => `${p} free`)].join(', ') || '–'),
    parameters.map((p) => valueCell(node.approx[p], node.box[p])),
    parameters.length ? element('td', {class: 'point'}, node.approx.point.map((c) => element('span', {class: 'decimal'}, c === null ? '' : String(Number(c.toPrecision(9))), element('br'))))
      : node.approx.point.map((c, k) => valueCell(c, node.box[k]))));
  return tableOf({id: 'nodes', class: 'cards'}, 'Decimals are the doubles of the JSON result. Below each stands the exact interval that is proved to hold the true value.',
    [['node'], ['kind'], ...(parameters.length ? [['on, turns in'], ...parameters.map((p) => [p]), ['x, y, z']] : [['on'], ['x'], ['y'], ['z']])], rows);
}

function arcMark(arc) {
  return drawing('path', {d: 'M-8,0H8', fill: 'none', stroke: componentColour(arc.component), 'stroke-width': 3, 'stroke-dasharray': componentDashes(arc.component)});
}

function arcTable() {
  const rows = arcs.map((arc) => element('tr', {'data-arc': arc.id},
    element('td', {}, pickButton(String(arc.id), arcMark(arc), `arc ${arc.id}`)),
    element('td', {class: 'number component'}, String(arc.component)), element('td', {class: 'number from'}, String(arc.from)), element('td', {class: 'number to'}, String(arc.to)),
    element('td', {class: 'kinds'}, [arc.on === 'interior' ? 'interior' : 'along a side of a patch', arc.contact, ...arc.free.map((p) => `${p} free`)].join(', ')),
    element('td', {class: 'number vertices'}, String(arc.polyline.length)),
    element('td', {class: 'number bound'}, boundText(arc.error_bound))));
  return tableOf({id: 'arcs', class: 'cards'}, 'Every point of the true arc is within the proved bound of the polyline, and the other way round.',
    [['arc'], [graph.curves && !report.components ? 'curve' : 'component', 'number'], ['from node', 'number'], ['to node', 'number'], ['kind'], ['vertices', 'number'], ['distance at most', 'number']], rows);
}

function componentTable() {
  const rows = graph.components.map((component) => element('tr', {},
    element('td', {}, drawing('svg', {width: 34, height: 12, viewBox: '0 -6 34 12', 'aria-hidden': 'true'}, drawing('path', {d: 'M0,0H34', stroke: componentColour(component.id), 'stroke-width': 3, 'stroke-dasharray': componentDashes(component.id)})), ` ${component.id}`),
    element('td', {}, component.shape), element('td', {}, component.arcs.join(', '))));
  return tableOf({id: 'components'}, 'open: a simple path; closed: a simple loop; branched: with a node where more than two arcs meet', [['component'], ['shape'], ['arcs in order']], rows);
}

/** The curves of two surfaces given by their equations, with what is rational of them. */
function curveTable() {
  const exact = (values) => values ? `(${values.join(', ')})` : '–';
  const rows = graph.curves.map((curve) => element('tr', {},
    element('td', {class: 'number'}, String(curve.id)), element('td', {}, curve.kind), element('td', {}, curve.closed ? 'closed' : 'open'),
    element('td', {}, curve.multiplicity === 1 ? 'transversal' : curve.multiplicity ? `tangential, of order ${curve.multiplicity}` : 'one surface'), element('td', {}, exact(curve.point)), element('td', {}, exact(curve.direction)),
    element('td', {}, curve.radius_squared || '–'), element('td', {}, curve.arcs.join(', '))));
  return tableOf({id: 'curves', class: 'cards'}, 'point: of a line, or the centre of a conic; direction: of a line, or the normal of the plane; where all of it is rational',
    [['curve', 'number'], ['kind'], ['shape'], ['contact'], ['point'], ['direction'], ['radius squared'], ['arcs']], rows);
}

function overlapTable() {
  const rows = graph.overlaps.flatMap((overlap) => overlap.chains.map((chain) => element('tr', {}, element('td', {class: 'number'}, String(overlap.id)),
    element('td', {}, chain.map((arc) => `${arc.from}–${arc.to}`).join(', ')), element('td', {class: 'number bound'}, boundText(Math.max(...chain.map((arc) => arc.error_bound)))))));
  return tableOf({id: 'overlaps'}, 'Regions where the patches lie on one surface, each with the closed chains of its rim', [['overlap', 'number'], ['arcs of the rim, by their nodes'], ['distance at most', 'number']], rows);
}

/** The legend of both squares: components, kinds of nodes, and what else occurs. */
function resultLegend() {
  const entries = graph.components.slice(0, 14).map((component) => [drawing('path', {d: 'M1,8H33', fill: 'none', stroke: componentColour(component.id), 'stroke-width': 2.6,
    'stroke-dasharray': componentDashes(component.id)}), `${componentName(component)}, ${component.shape}`]);
  if (graph.components.length > 14) entries.push([drawing('path'), `and ${graph.components.length - 14} more`]);
  const occurring = new Set(nodes.flatMap((node) => [-1, 0, 1].map((which) => glyphName(node, which))));
  for (const name of glyphOrder)
    if (occurring.has(name)) {
      const glyph = glyphPath(name, 'var(--ink)', {transform: 'translate(17,8)'});
      entries.push([glyph, glyphs[name].text]);
    }
  if (arcs.some((arc) => arc.contact === 'tangential')) entries.push([drawing('path', {class: 'arc', d: 'M1,8H33', stroke: 'var(--ink)', 'stroke-dasharray': '5 2.5'}), 'tangential contact']);
  if (arcs.some((arc) => arc.on === 'patch-boundary')) entries.push([drawing('path', {class: 'arc side', d: 'M1,8H33', stroke: 'var(--ink)'}), 'along a side of a patch']);
  if (graph.overlaps.length) entries.push([drawing('path', {class: 'overlap', d: 'M2,1H32V15H2Z', fill: 'url(#hatch)'}), 'overlap']);
  if (graph.incomplete.length) entries.push([drawing('path', {class: 'undecided', d: 'M2,1H32V15H2Z'}), 'not decided']);
  return legendList(entries);
}
