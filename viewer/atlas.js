// The canonical surfaces, as far as the page needs them. A domain point is an array of numbers, 3 on the
// sphere, else 2.
//
//   coordinates(chart, p)         the chart's (u,v)
//   barycentric(d, i, j, k, p)    of p in the domain triangle of the items i, j, k of the array d
//   interpolate(d, i, j, k, b)    the domain point with barycentric coordinates b
//   lift(d, i, j)                 item j, on the flat torus its copy nearest to item i
//   shapes                        how it is drawn: a place and a normal per domain point

const turn = 2 * Math.PI;

const sphere_atlas = {
  dimension: 3,
  name: 'unit sphere',
  coordinates(chart, p) {
    const g = chart >> 1,
      odd = chart & 1;
    const [x, y, z] = g === 0 ? p : g === 1 ? [p[2], p[0], p[1]] : [p[1], p[2], p[0]];
    return [
      odd + Math.atan2(y, x) / Math.PI,
      ((Math.asin(Math.max(-1, Math.min(1, z))) + (3 * Math.PI) / 8) * 4) / (3 * Math.PI),
    ];
  },
  barycentric(d, i, j, k, p) {
    const det = (a, b, x, y, z) =>
      // of the items a and b and of (x,y,z)
      (d[a + 1] * d[b + 2] - d[a + 2] * d[b + 1]) * x +
      (d[a + 2] * d[b] - d[a] * d[b + 2]) * y +
      (d[a] * d[b + 1] - d[a + 1] * d[b]) * z;
    i *= 3;
    j *= 3;
    k *= 3;
    const a = det(j, k, p[0], p[1], p[2]),
      b = det(k, i, p[0], p[1], p[2]),
      c = det(i, j, p[0], p[1], p[2]);
    const sum = Math.abs(a + b + c);
    return [a / sum, b / sum, c / sum];
  },
  interpolate(d, i, j, k, b) {
    const p = [0, 1, 2].map(n => b[0] * d[3 * i + n] + b[1] * d[3 * j + n] + b[2] * d[3 * k + n]);
    const length = Math.hypot(...p);
    return p.map(x => x / length);
  },
  lift: (d, i, j) => [d[3 * j], d[3 * j + 1], d[3 * j + 2]],
  shapes: { sphere: { title: 'Unit sphere', radius: 1.07, place: p => p, normal: p => p, split: 0.12 } },
};

// The square and the flat torus differ by the copies of a point.
function flat_atlas(name, shorten, wrap, shapes) {
  return {
    dimension: 2,
    name,
    lift: (d, i, j) => [0, 1].map(n => d[2 * i + n] + shorten(d[2 * j + n] - d[2 * i + n])),
    barycentric(d, i, j, k, p) {
      i *= 2;
      j *= 2;
      k *= 2;
      const ax = shorten(d[j] - d[i]),
        ay = shorten(d[j + 1] - d[i + 1]);
      const bx = shorten(d[k] - d[i]),
        by = shorten(d[k + 1] - d[i + 1]);
      const px = shorten(p[0] - d[i]),
        py = shorten(p[1] - d[i + 1]);
      const det = ax * by - ay * bx;
      if (!(det > 0)) return [-1, -1, -1];
      const b = (px * by - py * bx) / det,
        c = (ax * py - ay * px) / det;
      return [1 - b - c, b, c];
    },
    interpolate(d, i, j, k, b) {
      const q = this.lift(d, i, j),
        r = this.lift(d, i, k);
      return [0, 1].map(n => wrap(b[0] * d[2 * i + n] + b[1] * q[n] + b[2] * r[n]));
    },
    shapes,
  };
}

const flat_shape = title => ({
  title,
  radius: 0.68,
  is_flat: true,
  place: p => [p[0] - 0.5, p[1] - 0.5, 0],
  normal: () => [0, 0, 1],
  split: Infinity,
});

const plane_atlas = {
  ...flat_atlas(
    'unit square',
    x => x,
    x => x,
    { square: flat_shape('Unit square') }
  ),
  coordinates: (chart, p) => p,
};

const torus_atlas = {
  ...flat_atlas(
    'flat torus',
    x => x - Math.round(x),
    x => x - Math.floor(x),
    {
      flat: { ...flat_shape('Flat torus'), has_copies: true },
      ring: {
        title: 'Ring torus',
        radius: 2.6,
        split: 0.03,
        place: ([u, v]) => {
          const a = turn * u,
            b = turn * v,
            r = 1.5 + Math.cos(a);
          return [r * Math.cos(b), Math.sin(a), r * Math.sin(b)];
        },
        normal: ([u, v]) => {
          const a = turn * u,
            b = turn * v;
          return [Math.cos(a) * Math.cos(b), Math.sin(a), Math.cos(a) * Math.sin(b)];
        },
      },
    }
  ),
  coordinates: (chart, p) =>
    [chart % 3, Math.floor(chart / 3)].map((c, n) => {
      const x = p[n] - c / 3;
      return 1.5 * (x - Math.floor(x + 1 / 6)); // the copy of x that is nearest to the chart's [0, 2/3]
    }),
};

const atlases = { sphere: sphere_atlas, torus: torus_atlas, plane: plane_atlas };
