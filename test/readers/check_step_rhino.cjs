// Usage: node check_step_rhino.cjs FOLDER FILE.step...
//
// Gives the faces of STEP files, as write_step() writes them, to OpenNURBS, which is in FOLDER (npm's rhino3dm). Prints for
// each file how many faces are valid there, the largest gap between two faces along their edges, as a fraction of the
// diagonal, and the largest angle between their normals, in degrees.
const { readFileSync } = require('node:fs');
const { createRequire } = require('node:module');

const [tools, ...files] = process.argv.slice(2);
const references = text => [...text.matchAll(/#(\d+)/g)].map(m => m[1]);
const lists_of_numbers = text => [...text.matchAll(/\(([^()#]*)\)/g)].map(m => m[1].split(',').map(Number));

function check(rhino, file) {
  const entities = new Map(), text = readFileSync(file, 'latin1').replace(/\r?\n/g, '');
  for (const [, id, kind, rest] of text.matchAll(/#(\d+)=([A-Z0-9_]+)\(([^;]*)\);/g)) entities.set(id, [kind, rest]);
  const of_kind = (...kinds) => [...entities].filter(([, [kind]]) => kinds.includes(kind));
  const referred = id => references(entities.get(id)[1]);
  const numbers = id => lists_of_numbers(`${entities.get(id)[1]})`)[0];
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity], surfaces = new Map();

  for (const [id, [, definition]] of of_kind('B_SPLINE_SURFACE_WITH_KNOTS')) {
    const [, p, q, net] = definition.match(/^'[^']*',(\d+),(\d+),\(\((.*?)\)\)/), rows = net.split('),(').map(references);
    const surface = rhino.NurbsSurface.create(3, false, Number(p) + 1, Number(q) + 1, rows.length, rows[0].length);
    rows.forEach((row, i) =>
      row.forEach((point, j) => {
        const x = numbers(point);
        x.forEach((y, k) => {
          low[k] = Math.min(low[k], y);
          high[k] = Math.max(high[k], y);
        });
        surface.points().set(i, j, [...x, 1]);
      })
    );
    const [multiplicities_u, multiplicities_v, u, v] = lists_of_numbers(definition);
    const set = (knots, values, multiplicities) => // OpenNURBS leaves out the first and the last
      values.flatMap((x, i) => Array(multiplicities[i]).fill(x)).slice(1, -1).forEach((x, i) => knots.set(i, x));
    set(surface.knotsU(), u, multiplicities_u);
    set(surface.knotsV(), v, multiplicities_v);
    surfaces.set(id, surface);
  }

  const diagonal = Math.hypot(...low.map((x, k) => high[k] - x));
  let edges = 0, gap = 0, angle = 0;
  for (const [, [, definition]] of of_kind('SURFACE_CURVE', 'SEAM_CURVE')) {
    const [curve, ...pcurves] = references(definition);
    if (pcurves.length !== 2) continue; // on the border
    ++edges;
    const sides = pcurves.map(pcurve => {
      const [surface, representation] = referred(pcurve), [line] = referred(representation), [from, vector] = referred(line);
      return { surface: surfaces.get(surface), from: numbers(from), along: numbers(referred(vector)[0]) };
    });
    const knots = lists_of_numbers(entities.get(curve)[1]).at(-1);
    for (let n = 0; n <= 20; ++n) {
      const r = knots[0] + ((knots.at(-1) - knots[0]) * n) / 20;
      const [a, b] = sides.map(({ surface, from, along }) => {
        const uv = from.map((x, k) => x + r * along[k]);
        return { point: surface.pointAt(...uv), normal: surface.normalAt(...uv) };
      });
      const [x, y] = [a.normal, b.normal], k = [0, 1, 2];
      const cross = k.map(i => x[(i + 1) % 3] * y[(i + 2) % 3] - x[(i + 2) % 3] * y[(i + 1) % 3]);
      const dot = k.reduce((sum, i) => sum + x[i] * y[i], 0);
      gap = Math.max(gap, Math.hypot(...k.map(i => a.point[i] - b.point[i])) / diagonal);
      angle = Math.max(angle, (Math.atan2(Math.hypot(...cross), dot) * 180) / Math.PI);
    }
  }
  const valid = [...surfaces.values()].filter(surface => surface.isValid).length;
  return { valid, faces: surfaces.size, edges, gap, angle };
}

createRequire(`${tools}/`)('rhino3dm')().then(rhino => console.log(JSON.stringify(files.map(file => check(rhino, file)))));
