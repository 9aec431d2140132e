// Colour maps, and the fields that are shown with them.

// Perceptually uniform: viridis (van der Walt and Smith), and the smooth cool-warm map (Moreland 2009).
const ramps = {
  sequential: [
    '440154',
    '482475',
    '414487',
    '355f8d',
    '2a788e',
    '21918c',
    '22a884',
    '44bf70',
    '7ad151',
    'bddf26',
    'fde725',
  ],
  diverging: [
    '3b4cc0',
    '5977e3',
    '7b9ff9',
    '9ebeff',
    'c0d4f5',
    'dddcdc',
    'f2cbb7',
    'f7ac8e',
    'ee8468',
    'd65244',
    'b40426',
  ],
};
const no_value = '9aa0a8'; // of a value that is not finite
const plain = 'c3c9d4';

// Of the k-th CAD face: hues that differ from those before.
const face_colour = k => new THREE.Color().setHSL((0.08 + 0.61803399 * k) % 1, 0.42, 0.64).toArray();

const rgb = hex => [0, 2, 4].map(i => parseInt(hex.replace('#', '').slice(i, i + 2), 16) / 255);
const gradient = ramp => `linear-gradient(to right, ${ramps[ramp].map(c => '#' + c).join(', ')})`;

// A ramp at n equally spaced places, as bytes with alpha.
function ramp_bytes(ramp, n) {
  const stops = ramps[ramp].map(rgb),
    bytes = new Uint8Array(4 * n);
  for (let i = 0; i < n; ++i) {
    const x = (i / (n - 1)) * (stops.length - 1),
      k = Math.min(Math.floor(x), stops.length - 2);
    for (let c = 0; c < 3; ++c)
      bytes[4 * i + c] = Math.round(255 * (stops[k][c] + (x - k) * (stops[k + 1][c] - stops[k][c])));
    bytes[4 * i + 3] = 255;
  }
  return bytes;
}

function short(x) {
  if (x === 0) return '0';
  if (!Number.isFinite(x)) return '–';
  const size = Math.abs(x);
  return size >= 1e5 || size < 1e-3
    ? x.toExponential(2).replace('e+', 'e').replace('-', '−').replace('e-', 'e−')
    : String(Number(x.toPrecision(3))).replace('-', '−');
}
const percent = x => short(100 * x) + '\u00a0%'; // with a space that is not broken
const of_diagonal = x => percent(x) + ' of the diagonal';

// The fields in the order of their switches. Those with a ramp are arrays of the meshes, per face or vertex.
const fields = [
  { name: 'charts', label: 'Charts', mode: 1 },
  {
    name: 'checker',
    label: 'Checkerboard',
    mode: 2,
    text: 'Squares of 1/16 in the coordinates (u,v) of each chart',
  },
  {
    name: 'angle',
    label: 'Angle',
    mode: 3,
    ramp: 'sequential',
    least: 1,
    is_per_face: true,
    text: 'Angle distortion σ₁/σ₂ of the map; 1 is conformal',
    show: short,
  },
  {
    name: 'area',
    label: 'Area',
    mode: 3,
    ramp: 'diverging',
    is_per_face: true,
    text: 'Area in the domain over area of the mesh, as shares of the whole; 1 keeps areas',
    show: x => short(10 ** x) + '\u00a0×',
  },
  {
    name: 'error',
    label: 'Fit error',
    mode: 3,
    ramp: 'sequential',
    least: 0,
    text: 'Distance of surface and mesh at the same domain point, in percent of the diagonal',
    show: percent,
    unit: ' of the diagonal',
  },
  {
    name: 'mean',
    label: 'Mean curvature',
    mode: 3,
    ramp: 'diverging',
    power: 1,
    text: 'Mean curvature H of the surface, in 1/length; positive where convex',
  },
  {
    name: 'gauss',
    label: 'Gaussian curvature',
    mode: 3,
    ramp: 'diverging',
    power: 2,
    text: 'Gaussian curvature K of the surface, in 1/length²',
  },
  { name: 'shape', label: 'Shape', mode: 0, text: 'Shape alone' },
];

const low_percentile = 0.02;

// The range of a field that the colours span, without the outliers, by weight; and the least and largest
// value. A diverging range is symmetric.
function range_of(field, values, weights) {
  const order = Array.from(values.keys())
    .filter(i => Number.isFinite(values[i]))
    .sort((i, j) => values[i] - values[j]);
  if (order.length === 0) return { low: 0, high: 1, least: NaN, largest: NaN };
  const sum = order.reduce((s, i) => s + weights[i], 0);
  const at = q => {
    let s = 0;
    for (const i of order) if ((s += weights[i]) >= q * sum) return values[i];
    return values[order[order.length - 1]];
  };
  let low = field.least === undefined ? at(low_percentile) : field.least,
    high = at(1 - low_percentile);
  if (field.ramp === 'diverging') {
    high = Math.max(Math.abs(low), Math.abs(high));
    low = -high;
  }
  if (!(high > low)) high = low + (Math.abs(low) || 1) * 1e-6;
  return { low, high, least: values[order[0]], largest: values[order[order.length - 1]] };
}
