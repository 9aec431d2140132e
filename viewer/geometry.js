// Triangles as they are drawn: three corners each, which know their place in a face of a mesh.

// Numbers that come one after the other, `width` per item.
class Numbers {
  constructor(width, capacity) {
    this.width = width;
    this.length = 0;
    this.array = new Float32Array(width * capacity);
  }

  push(numbers) {
    if (this.length + this.width > this.array.length) {
      const larger = new Float32Array(2 * this.array.length);
      larger.set(this.array);
      this.array = larger;
    }
    for (let k = 0; k < this.width; ++k) this.array[this.length++] = numbers[k];
  }

  finished() {
    return this.array.subarray(0, this.length);
  }
}

// Where a corner is in its face decides its values; a face may be drawn in several triangles.
class Corners {
  constructor(mesh, dimension) {
    const n = mesh.faces.length;
    this.mesh = mesh;
    this.faces = [];
    this.weights = new Numbers(3, n); // barycentric coordinates in the face
    this.position = new Numbers(3, n);
    this.normal = new Numbers(3, n);
    this.edge = new Numbers(3, n); // 1 at the opposite corner: distances from the edges to be drawn
    this.domain = dimension ? new Numbers(dimension, n) : null; // on the flat torus not wrapped
  }

  // `is_edge[k]`: whether the side opposite to corner k is an edge of the mesh
  add(face, weights, positions, normals, is_edge, domain) {
    this.faces.push(face);
    for (let k = 0; k < 3; ++k) {
      this.weights.push(weights[k]);
      this.position.push(positions[k]);
      this.normal.push(normals[k]);
      this.edge.push(is_edge.map((is_one, e) => (e === k || !is_one ? 1 : 0)));
      if (domain) this.domain.push(domain[k]);
    }
  }

  // Plain arrays from now on.
  finish() {
    for (const name of ['weights', 'position', 'normal', 'edge', 'domain'])
      if (this[name]) this[name] = this[name].finished();
    return this;
  }

  get count() {
    return 3 * this.faces.length;
  }
  face(corner) {
    return this.faces[Math.floor(corner / 3)];
  }
}

const units = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
const all_edges = [true, true, true];
const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = a => {
  const l = Math.hypot(...a) || 1;
  return a.map(x => x / l);
};
const item = (array, i, n) =>
  n === 3 ? [array[3 * i], array[3 * i + 1], array[3 * i + 2]] : [array[2 * i], array[2 * i + 1]];

// The mesh in space: flat faces, or smooth ones where it has normals.
function space_corners(mesh) {
  const out = new Corners(mesh),
    n = mesh.faces.length / 3;
  for (let f = 0; f < n; ++f) {
    const v = item(mesh.faces, f, 3),
      p = v.map(i => item(mesh.points, i, 3));
    const flat = mesh.normals ? null : unit(cross(subtract(p[1], p[0]), subtract(p[2], p[0])));
    out.add(
      f,
      units,
      p,
      v.map(i => flat || item(mesh.normals, i, 3).map(x => x / 32767)),
      all_edges
    );
  }
  return out.finish();
}

// The faces of the mesh on its canonical surface. Long edges are halved, so that the surface looks round.
function domain_corners(mesh, atlas, shape) {
  const out = new Corners(mesh, atlas.dimension),
    n = mesh.faces.length / 3;
  const middle = (a, b) => a.map((x, k) => (x + b[k]) / 2);
  const round = p => (atlas.dimension === 3 ? unit(p) : p);
  const is_long = (a, b) => Math.hypot(...a.map((x, k) => x - b[k])) > shape.split;
  const add = (f, d, w, is_edge) => {
    const long = [0, 1, 2].filter(k => is_long(d[(k + 1) % 3], d[(k + 2) % 3]));
    if (long.length === 0) {
      out.add(f, w, d.map(shape.place), d.map(shape.normal), is_edge, d);
      return;
    }
    // Halve the side opposite to corner k; both faces at it do, so that they still meet.
    const length = k => Math.hypot(...d[(k + 1) % 3].map((x, m) => x - d[(k + 2) % 3][m]));
    const k = long.reduce((a, b) => (length(b) > length(a) ? b : a)),
      i = (k + 1) % 3,
      j = (k + 2) % 3;
    const m = round(middle(d[i], d[j])),
      u = middle(w[i], w[j]);
    add(f, [d[k], d[i], m], [w[k], w[i], u], [is_edge[k], false, is_edge[j]]);
    add(f, [d[k], m, d[j]], [w[k], u, w[j]], [is_edge[k], is_edge[i], false]);
  };
  for (let f = 0; f < n; ++f) {
    const v = item(mesh.faces, f, 3);
    const d = v.map(i => atlas.lift(mesh.domain, v[0], i));
    if (!shape.has_copies) {
      add(f, d, units, all_edges);
      continue;
    }
    const range = c => {
      // the shifts by which the face reaches into [0,1]
      const x = d.map(p => p[c]),
        shifts = [];
      for (let s = -1; s <= 1; ++s) if (Math.max(...x) + s > 0 && Math.min(...x) + s < 1) shifts.push(s);
      return shifts;
    };
    for (const s of range(0))
      for (const t of range(1))
        add(
          f,
          d.map(p => [p[0] + s, p[1] + t]),
          units,
          all_edges
        );
  }
  return out.finish();
}

// The chart coordinates of the corners, in the chart of their face.
function chart_coordinates(corners, atlas) {
  const { mesh, weights, domain } = corners,
    uv = new Float32Array(2 * corners.count);
  for (let c = 0; c < corners.count; ++c) {
    const f = corners.face(c),
      chart = mesh.charts[f];
    if (chart < 0) continue;
    const p = domain
      ? item(domain, c, atlas.dimension)
      : atlas.interpolate(mesh.domain, ...item(mesh.faces, f, 3), item(weights, c, 3));
    uv.set(atlas.coordinates(chart, p), 2 * c);
  }
  return uv;
}

// The value of a field at the item `at` of the barycentric coordinates `weights`.
function value_at(mesh, field, face, weights, at = 0) {
  const values = mesh[field.name],
    { faces } = mesh;
  if (field.is_per_face) return values[face];
  let x = 0;
  for (let k = 0; k < 3; ++k) {
    const weight = weights[3 * at + k];
    if (weight !== 0) x += weight * values[faces[3 * face + k]];
  }
  return x;
}

// The first triangle that a ray meets: its first corner and the place in it, or null.
function first_hit(corners, origin, direction, is_shown) {
  const p = corners.position;
  let best = null,
    nearest = Infinity;
  for (let c = 0; c < corners.count; c += 3) {
    const i = 3 * c;
    const ux = p[i + 3] - p[i],
      uy = p[i + 4] - p[i + 1],
      uz = p[i + 5] - p[i + 2];
    const vx = p[i + 6] - p[i],
      vy = p[i + 7] - p[i + 1],
      vz = p[i + 8] - p[i + 2];
    const qx = direction[1] * vz - direction[2] * vy,
      qy = direction[2] * vx - direction[0] * vz,
      qz = direction[0] * vy - direction[1] * vx;
    const det = ux * qx + uy * qy + uz * qz;
    if (det === 0) continue;
    const tx = origin[0] - p[i],
      ty = origin[1] - p[i + 1],
      tz = origin[2] - p[i + 2];
    const b = (tx * qx + ty * qy + tz * qz) / det;
    if (b < 0 || b > 1) continue;
    const rx = ty * uz - tz * uy,
      ry = tz * ux - tx * uz,
      rz = tx * uy - ty * ux;
    const g = (direction[0] * rx + direction[1] * ry + direction[2] * rz) / det;
    if (g < 0 || b + g > 1) continue;
    const distance = (vx * rx + vy * ry + vz * rz) / det;
    if (distance <= 0 || distance >= nearest) continue;
    const at = [1 - b - g, b, g];
    if (is_shown && !is_shown(c, at)) continue;
    nearest = distance;
    best = { corner: c, at };
  }
  return best;
}

// Sums of the values of three corners, `n` each, with weights.
function blend(array, corner, n, at) {
  return Array.from(
    { length: n },
    (_, m) =>
      at[0] * array[n * corner + m] +
      at[1] * array[n * (corner + 1) + m] +
      at[2] * array[n * (corner + 2) + m]
  );
}

// The face of a mesh that contains a domain point, up to rounding, and the point's place in it.
function locate(mesh, atlas, p) {
  const { faces, domain } = mesh;
  let best = null,
    margin = -1e-3;
  for (let f = 0; 3 * f < faces.length; ++f) {
    const b = atlas.barycentric(domain, faces[3 * f], faces[3 * f + 1], faces[3 * f + 2], p);
    const least = Math.min(b[0], b[1], b[2]);
    if (least > margin) {
      margin = least;
      best = { face: f, weights: b };
      if (least >= 0) break;
    }
  }
  return best;
}

function place_of(mesh, { face, weights }) {
  const p = [0, 0, 0];
  for (let k = 0; k < 3; ++k)
    for (let c = 0; c < 3; ++c) p[c] += weights[k] * mesh.points[3 * mesh.faces[3 * face + k] + c];
  return p;
}

// The areas of faces, or of vertices: a third of their faces'.
function areas_of(mesh) {
  const faces = new Float64Array(mesh.faces.length / 3),
    vertices = new Float64Array(mesh.points.length / 3);
  for (let f = 0; f < faces.length; ++f) {
    const v = item(mesh.faces, f, 3),
      [a, b, c] = v.map(i => item(mesh.points, i, 3));
    faces[f] = Math.hypot(...cross(subtract(b, a), subtract(c, a))) / 2;
    for (const i of v) vertices[i] += faces[f] / 3;
  }
  return { faces, vertices };
}
