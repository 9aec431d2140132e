// Places to look at: where the error is largest, and where the surface turns over.

const place_colours = { worst: '#f0a000', fold: '#e0245e' };

// Those of a page or of a part of one: chart points with what there is.
const places_of = ({ fit = {} }) => fit.places || [];

// Rings of some pixels about points, nearer to the viewer than they are so that the surface does not cut them; faint
// where they are behind it.
function rings(points, colours) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', attribute(new Float32Array(points), 3));
  geometry.setAttribute('colour', attribute(new Float32Array(colours), 3));
  const group = new THREE.Group();
  for (const is_hidden of [true, false])
    group.add(
      new THREE.Points(
        geometry,
        new THREE.ShaderMaterial({
          vertexShader: `
            attribute vec3 colour;
            varying vec3 v_colour;
            void main() {
              v_colour = colour;
              gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
              gl_Position.z -= 0.004 * gl_Position.w;
              gl_PointSize = ${(18 * Math.min(window.devicePixelRatio || 1, 2)).toFixed(1)};
            }`,
          fragmentShader: `
            varying vec3 v_colour;
            void main() {
              float r = 2.0 * length(gl_PointCoord - 0.5);
              if (r > 1.0 || r < 0.5) discard;
              gl_FragColor = vec4(r > 0.9 || r < 0.6 ? vec3(1.0) : v_colour, ${is_hidden ? '0.3' : '1.0'});
            }`,
          depthTest: !is_hidden,
          transparent: is_hidden,
        })
      )
    );
  return group;
}

// What there is to see, with a button for each place that centres all views on it.
function show_places(view, { info, mesh, places, chosen }) {
  const line = by_id('places'),
    own = places.filter(place => place.part === chosen);
  const look_at = place => {
    const switch_ = by_id('places_switch');
    if (!switch_.checked) switch_.click();
    view.look_at(place, mesh);
  };
  const button = (place, label, title) => {
    const b = element('button', { type: 'button', title }, label);
    b.addEventListener('click', () => look_at(place));
    return b;
  };
  const of_kind = kind => own.filter(place => place.kind === kind),
    [worst] = of_kind('worst'),
    folds = of_kind('fold');
  const parts = [];
  if (worst) {
    const { surface } = info.figures || {};
    const how_much = surface && typeof surface.max_error === 'number' ? ` (${of_diagonal(surface.max_error)})` : '';
    parts.push(`The error is largest${how_much} `, button(worst, 'here', 'Centre the views on it'), '. ');
  }
  if (folds.length > 0) {
    const { folds: all } = info.fit;
    parts.push(`The surface turns over at ${count(all)} ${all === 1 ? 'face' : 'faces'} of the mesh: `);
    folds.forEach((place, k) => parts.push(button(place, k + 1, `Centre the views on fold ${k + 1}`), ' '));
    if (all > folds.length) parts.push('…');
  }
  line.replaceChildren(...parts);
  line.hidden = parts.length === 0;
}
