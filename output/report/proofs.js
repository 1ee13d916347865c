// What was proved, and how, in plain words.

/** Statements as [what, how it was proved]. */
function intersectionProofs(pair) {
  const steps = (graph.work && graph.work.steps) || {};
  const list = [];
  const fibres = steps.fibres ? `${counted(steps.fibres, 'sample value')} of u` : 'sample values of a parameter';
  if (equations.length === 2) {
    list.push(['Complete: every common point of the surfaces lies on a reported arc or node, or on the surface that they are both.',
      'One of the surfaces was covered by charts over the rational numbers, in which the other one is a plane curve with rational coefficients. The values over which its points change in number or meet are isolated as roots of exact polynomials; between them every point is an arc, and over each of them every point was matched with the arcs that end there.']);
    list.push(['Topology: which node joins which arcs, and which arcs are of one curve, is that of the true curve.',
      'Signs of algebraic numbers were decided exactly; arcs that belong to a multiple factor are contacts. Lines and conics are recognised by exact factors.']);
  } else if (equations.length) {
    list.push(['Complete: every point of the patch on the surface lies on a reported arc, node or overlap.',
      'The equation was pulled back to the square of the patch: a polynomial in u and v with rational coefficients. The values of u over which its zeros in v, or those on the bounds of a box, change in number or meet are isolated as roots of exact polynomials; between them every zero is an arc, and over each of them every point was matched with the arcs that end there.']);
    list.push(['Topology: components, their shape, and which node joins which are those of the true curve.',
      'Signs of algebraic numbers were decided exactly; arcs that belong to a multiple factor of the equation are contacts.']);
  } else if (pair && steps.filtered) {
    list.push(['Complete: every point of the intersection lies on a reported arc or node.',
      `Computed in doubles with a proved bound of every rounding error; a pair for which this does not decide everything is solved with exact numbers instead. All points on the sides of both patches were isolated, and ${counted(steps['searched boxes'] || 0, 'pair')} of pieces of the patches searched: each pair has no common point, or no extreme of a closed curve and no singular point, or lies in a tube whose curve is reported.`]);
    list.push(['Topology: components, their shape, and which node joins which are those of the true curve.',
      `Arcs were followed in ${counted(steps.tubes || 0, 'tube')}, each proved to hold exactly one regular curve, by a contraction (Krawczyk); neighbouring tubes are proved to hold the same curve.`]);
  } else if (pair) {
    list.push(['Complete: every point of the intersection lies on a reported arc, node or overlap.',
      `All values of a parameter where the number of points on a line can change are roots of exact polynomials, found as isolated algebraic numbers. Between them, at ${fibres}, the points of the line on the other patch were computed exactly: the line is a plane cut by a quadratic cylinder, both are pulled back to the other patch, and the real roots of their eliminant are isolated with rational arithmetic and checked against the feasible intervals. No arc can hide between two samples, and a root that belongs to no point is recognised.`]);
    list.push(['Topology: components, their shape, and which node joins which are those of the true curve.',
      `Arcs were followed in ${steps.tubes ? counted(steps.tubes, 'tube') : 'tubes'}, each proved to hold exactly one curve, by a contraction (Krawczyk) with rounded arithmetic enclosed; neighbouring tubes are proved to hold the same curve. Every point of every exact sample lies on exactly one followed curve.`]);
  } else {
    list.push(['Complete: every pair of different parameters with the same point of space lies on a reported arc or node, once.',
      `With midpoint and half difference as unknowns the pairs become a regular curve${steps['searched boxes'] ? `; ${steps['searched boxes']} boxes of their domain were searched` : ''}: in each either there is none, or one curve that is already reported, or a new one, which was followed. Where a side of the parameter square is met, the points were computed exactly.`]);
    list.push(['Topology: components, their shape, and which node joins which are those of the true curve.',
      `Arcs were followed in ${steps.tubes ? counted(steps.tubes, 'tube') : 'tubes'}, each proved to hold exactly one curve, by a contraction (Krawczyk) with rounded arithmetic enclosed. A curve of pairs and its mirror image, the pairs in the other order, are told apart and reported once.`]);
  }
  if (nodes.length) list.push(['Nodes: each box holds exactly one point with the stated properties.',
    parameters.length === 0 ? 'The ends of the exact intervals are rational numbers. Where an interval is a single number, it is that number.' : 'The ends of the exact intervals are rational numbers. Points on sides are isolated with a proof that there is exactly one, turning points by proved signs of the derivative. Where an interval is a single number, it is that number.']);
  if (arcs.length) list.push([`Polylines: each is within its stated distance of the true arc, and the other way round; the largest is ${boundText(worstBound())}.`,
    equations.length === 2 ? 'Zeros are enclosed over pieces of the arc, and their images in space; the bound is rounded up.'
      : equations.length ? 'Zeros are enclosed over pieces of the arc, and the patch bends no more than its second derivatives there; the bound is rounded up.' : 'The second derivative of the curve is bounded over each tube; the bound is rounded up.']);
  if (graph.overlaps.length) list.push([`Overlaps: in ${counted(graph.overlaps.length, 'region')} ${equations.length ? 'the patch lies on the surface' : 'the patches lie on one surface'}; the chains are the rim.`,
    equations.length ? 'The equation vanishes on the whole patch, exactly.' : 'The eliminant vanishes for every u, exactly. The rim consists of pieces of the sides of both patches, found as exact parts of parameter lines that lie on the other patch.']);
  return list;
}

function cubicProofs() {
  return [
    ['The equations vanish on the line, and nowhere else at all once.', 'They come from the moving planes that follow the line: planes whose coefficients are polynomials of low degree in its parameter and that hold its point at each value, found as an exact null space.'],
    ['Complete: the points listed are all points of the line on the other patch.', 'All common zeros of the equations in the other patch\'s square are found as exact algebraic points; at each the parameter on the line is a quotient of two polynomials, and signs of exact numbers decide whether it is in [0,1].'],
    ['Every box holds exactly one of the points; its interval is at most 2⁻⁶⁴ wide.', 'Multiplicity 1 says that line and patch cross: the determinant of the line\'s tangent and the patch\'s tangent plane is not zero, exactly.'],
  ];
}

function lineProofs() {
  const line = result;
  if (line.pullback.cubic) return cubicProofs();
  return [
    ['The line is exactly what its two surfaces have in common.', 'Plane and quadratic cylinder (or two planes) vanish on it identically, with rational coefficients; the parameter along the line is a quotient of two of the linear forms.'],
    ['Complete: the points listed are all points of the line on the other patch.', `Every common point is a root of the eliminant${line.eliminant.degree > 0 ? `, of degree ${line.eliminant.degree}` : ''}. Its real roots are isolated exactly; which of them lie in a feasible interval, and on which branch, is decided by signs of exact numbers.`],
    ['Every box holds exactly one of the points; its interval is at most 2⁻⁶⁴ wide.', 'The other coordinates are rational functions of the root, enclosed and refined.'],
    ['Feasible intervals: outside of them a branch leaves the patch or the line ends.', 'Their ends are real algebraic numbers; open or closed was decided exactly.'],
  ];
}

function proofSection(statements) {
  const list = element('dl', {class: 'proofs'});
  for (const [what, how] of statements) {
    list.append(element('dt', {}, what));
    if (how) list.append(element('dd', {class: 'how'}, how));
  }
  for (const gap of [...(graph.incomplete || []), ...(result.not_proved || [])]) {
    const where = gap.where && Object.entries(gap.where).map(([p, box]) => `${p} in [${box.map((q) => short(toDouble(q))).join(', ')}]`).join(', ');
    list.append(element('dt', {class: 'incomplete'}, `Not decided${gap.name ? ` (${gap.name})` : ''}: ${gap.why}`), element('dd', {class: 'how'}, where || ''));
  }
  return list;
}
