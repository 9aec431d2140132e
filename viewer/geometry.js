// Triangles of a mesh of the data (see data.js): what their corners have, where a ray or a chart point meets them.

const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = a => {
  const l = Math.hypot(...a) || 1;
  return a.map(x => x / l);
};
const item = (array, i, n) => Array.from(array.subarray(n * i, n * i + n));

const face_of = (mesh, triangle) => (mesh.faces ? mesh.faces[triangle] : triangle);
const chart_of = (mesh, triangle) => mesh.charts[mesh.triangles[3 * triangle]];

// Per corner the numbers of its vertex, `n` each.
function at_corners(mesh, array, n) {
  const { triangles } = mesh,
    out = new Float32Array(n * triangles.length);
  for (let c = 0; c < triangles.length; ++c)
    for (let k = 0; k < n; ++k) out[n * c + k] = array[n * triangles[c] + k];
  return out;
}

// The cross product of two sides of each triangle: twice its area long.
function area_vectors(mesh) {
  return Array.from({ length: mesh.triangles.length / 3 }, (_, t) => {
    const [a, b, c] = item(mesh.triangles, t, 3).map(v => item(mesh.points, v, 3));
    return cross(subtract(b, a), subtract(c, a));
  });
}

// The normals of corners: smooth ones where there are some, otherwise those of the faces.
function normals_at_corners(mesh, normals) {
  if (normals) return at_corners(mesh, normals, 3).map(x => x / 32767);
  const of_face = [],
    out = new Float32Array(3 * mesh.triangles.length);
  area_vectors(mesh).forEach((a, t) => {
    const sum = (of_face[face_of(mesh, t)] = of_face[face_of(mesh, t)] || [0, 0, 0]);
    a.forEach((x, k) => (sum[k] += x));
  });
  for (let c = 0; c < mesh.triangles.length; ++c)
    out.set(unit(of_face[face_of(mesh, Math.floor(c / 3))]), 3 * c);
  return out;
}

// Per corner its distances from the sides that are edges of the mesh, 1 at the corner opposite to the side.
function edges_at_corners(mesh) {
  const out = new Float32Array(3 * mesh.triangles.length);
  for (let c = 0; c < mesh.triangles.length; ++c)
    for (let side = 0; side < 3; ++side) {
      const is_edge = !mesh.edges || (mesh.edges[Math.floor(c / 3)] >> side) & 1;
      out[3 * c + side] = side === c % 3 || !is_edge ? 1 : 0;
    }
  return out;
}

// The value of a field at the place of a triangle that has the barycentric coordinates `weights`.
function value_at(mesh, field, { triangle, weights }) {
  const values = mesh[field.name];
  return field.is_per_face ? values[face_of(mesh, triangle)] : blend(mesh, values, 1, { triangle, weights })[0];
}

// Of a number per vertex, `n` each, the values at a place of a triangle. A weight 0 leaves out values that are none.
function blend(mesh, array, n, { triangle, weights }) {
  const out = new Array(n).fill(0);
  weights.forEach((w, k) => {
    if (w !== 0)
      for (let m = 0; m < n; ++m) out[m] += w * array[n * mesh.triangles[3 * triangle + k] + m];
  });
  return out;
}

// The first triangle that a ray meets and the place in it, or null; `p`: the positions of corners.
function first_hit(p, origin, direction) {
  let best = null,
    nearest = Infinity;
  for (let i = 0; i < p.length; i += 9) {
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
    nearest = distance;
    best = { triangle: i / 9, weights: [1 - b - g, b, g] };
  }
  return best;
}

// The chart point at a place of a triangle.
const chart_point = (mesh, place) => ({
  chart: chart_of(mesh, place.triangle),
  uv: blend(mesh, mesh.coordinates, 2, place),
});

// The place of a chart point: the triangle that contains it, or nearly so, since borders of tiles are bent; or null.
function locate(mesh, { chart, uv }) {
  const { triangles, charts, coordinates: c } = mesh;
  let best = null,
    outside = 0.01;
  for (let i = 0; i < triangles.length; i += 3) {
    const v = 2 * triangles[i];
    if (charts[triangles[i]] !== chart) continue;
    const w = 2 * triangles[i + 1],
      x = 2 * triangles[i + 2];
    const ax = c[w] - c[v],
      ay = c[w + 1] - c[v + 1],
      bx = c[x] - c[v],
      by = c[x + 1] - c[v + 1],
      px = uv[0] - c[v],
      py = uv[1] - c[v + 1];
    const det = ax * by - ay * bx;
    if (!(det > 0)) continue;
    const b = (px * by - py * bx) / det,
      g = (ax * py - ay * px) / det;
    const distance = -Math.min(1 - b - g, b, g) * Math.sqrt(det);
    if (distance >= outside) continue;
    outside = distance;
    best = { triangle: i / 3, weights: [1 - b - g, b, g] };
    if (distance <= 0) break;
  }
  return best;
}

// The areas of faces, and those of vertices: a third of their triangles'.
function areas_of(mesh) {
  const faces = new Float64Array(mesh.angle.length),
    vertices = new Float64Array(mesh.points.length / 3);
  area_vectors(mesh).forEach((a, t) => {
    const area = Math.hypot(...a) / 2;
    faces[face_of(mesh, t)] += area;
    for (const v of item(mesh.triangles, t, 3)) vertices[v] += area / 3;
  });
  return { faces, vertices };
}
