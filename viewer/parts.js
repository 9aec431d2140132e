// Several parts on one page: those that are shown become one mesh, the canonical surface is that of one of them.

const typed = (Type, lists) => {
  const out = new Type(lists.reduce((n, list) => n + list.length, 0));
  lists.reduce((at, list) => (out.set(list, at), at + list.length), 0);
  return out;
};

// Meshes one after the other. Values that only some of them have are none in the others.
function concatenated(meshes) {
  const all = {},
    sum = (size, k) => meshes.slice(0, k).reduce((n, mesh) => n + size(mesh), 0);
  const vertices = mesh => mesh.charts.length,
    faces = mesh => mesh.angle.length;
  const have = name => meshes.filter(mesh => mesh[name]).length;
  for (const name of ['points', 'coordinates', 'angle', 'area'])
    all[name] = typed(Float32Array, meshes.map(mesh => mesh[name]));
  for (const name of ['charts', 'edges', 'normals'])
    if (have(name) === meshes.length) all[name] = typed(Int16Array, meshes.map(mesh => mesh[name]));
  const shifted = (name, size) =>
    typed(Uint32Array, meshes.map((mesh, k) => mesh[name].map(i => i + sum(size, k))));
  all.triangles = shifted('triangles', vertices);
  if (have('faces') === meshes.length) all.faces = shifted('faces', faces);
  for (const name of ['error', 'mean', 'gauss'])
    if (have(name) > 0)
      all[name] = typed(
        Float32Array,
        meshes.map(mesh => mesh[name] || new Float32Array(vertices(mesh)).fill(NaN))
      );
  return all;
}

// Numbers from 0 on, one list after the other, as numbers through all of them.
function numbered(lists) {
  let first = 0;
  return typed(
    Int16Array,
    lists.map(list => {
      const own = list.map(k => k + first);
      first = 1 + own.reduce((a, b) => Math.max(a, b), first);
      return own;
    })
  );
}

// The smallest box about the points of parts, in space: its middle and its diagonal.
function box_of(parts) {
  const low = [Infinity, Infinity, Infinity],
    high = [-Infinity, -Infinity, -Infinity];
  for (const { mesh, info } of parts)
    mesh.points.forEach((x, i) => {
      const k = i % 3,
        at = x * info.diagonal + info.centre[k];
      low[k] = Math.min(low[k], at);
      high[k] = Math.max(high[k], at);
    });
  return {
    centre: low.map((x, k) => (x + high[k]) / 2),
    diagonal: Math.hypot(...low.map((x, k) => high[k] - x)) || 1,
  };
}

// The data of a page (see data.js) of the parts `shown`; canonical surface, plots and figures are those of `chosen`,
// one of them. Charts are numbered through all parts; curvatures are in units of the common diagonal, errors in those
// of each part, as its tolerance.
function data_of_parts({ info, parts }, shown, chosen) {
  const box = box_of(shown),
    charts = [];
  const placed = shown.map(part => {
    const scale = part.info.diagonal / box.diagonal,
      first = charts.length;
    part.info.atlas.charts.forEach(({ colour }, c) => charts.push({ colour, number: c, part: part.info.name }));
    const place = points =>
      points.map((x, i) => x * scale + (part.info.centre[i % 3] - box.centre[i % 3]) / box.diagonal);
    const curvature = (values, power) => values && values.map(x => x / scale ** power);
    const moved = mesh =>
      mesh && {
        ...mesh,
        points: place(mesh.points),
        charts: mesh.charts.map(c => c + first),
        mean: curvature(mesh.mean, 1),
        gauss: curvature(mesh.gauss, 2),
      };
    const net = part.net && { points: place(part.net.points), charts: part.net.charts.map(c => c + first) };
    const cad = part.cad && { ...moved(part.cad), borders: place(part.cad.borders) };
    const places = places_of(part.info).map(place => ({ ...place, chart: place.chart + first, part }));
    return { part, mesh: moved(part.mesh), surface: moved(part.surface), net, cad, places };
  });
  const all = name => placed.map(p => p[name]).filter(Boolean),
    own = placed.find(p => p.part === chosen);
  const surfaces = all('surface'),
    nets = all('net'),
    cads = all('cad');
  return {
    info: {
      ...chosen.info,
      ...box,
      faces: shown.reduce((n, part) => n + part.info.faces, 0),
      faces_of_map: shown.reduce((n, part) => n + part.info.faces_of_map, 0),
      figures: { ...info.figures, ...chosen.info.figures },
      atlas: { ...chosen.info.atlas, charts },
    },
    mesh: concatenated(all('mesh')),
    domain: own.mesh,
    chosen,
    places: all('places').flat(),
    surface: surfaces.length > 0 ? concatenated(surfaces) : undefined,
    cad:
      cads.length > 0
        ? {
            ...concatenated(cads),
            numbers: numbered(cads.map(cad => cad.numbers)),
            borders: typed(Float32Array, cads.map(cad => cad.borders)),
          }
        : undefined,
    net: {
      points: typed(Float32Array, nets.map(net => net.points)),
      charts: typed(Int16Array, nets.map(net => net.charts)),
    },
  };
}

// The list of parts: show(data) is called with what is chosen from it, now and after each choice.
function make_parts_list(data, show) {
  const { parts } = data,
    have_mesh = parts.filter(part => part.mesh),
    inputs = new Map(),
    select = element('select', { id: 'part', title: 'Whose canonical surface, plots and figures are shown' });
  let chosen = have_mesh[0];
  const update = () => {
    const is_on = part => inputs.get(part).checked;
    if (!have_mesh.some(is_on)) inputs.get(chosen).checked = true; // something is shown
    if (!is_on(chosen)) chosen = have_mesh.find(is_on);
    select.value = parts.indexOf(chosen);
    show(data_of_parts(data, have_mesh.filter(is_on), chosen));
  };
  const switch_all = (label, is_on) => {
    const button = element('button', { type: 'button' }, label);
    button.addEventListener('click', () => {
      for (const part of have_mesh) inputs.get(part).checked = is_on || part === chosen;
      update();
    });
    return button;
  };
  const list = by_id('parts');
  parts.forEach((part, k) => {
    const { name, error } = part.info,
      input = element('input', { type: 'checkbox', name: 'part', value: name });
    const title = error || (part.info.atlas ? `${kind(part.info.atlas)}: ${count(part.info.faces_of_map)} faces` : '');
    inputs.set(part, input);
    if (part.mesh) {
      input.checked = true;
      input.addEventListener('change', update);
      select.append(element('option', { value: k }, name));
    } else {
      input.disabled = true;
    }
    list.append(element('label', { title }, input, element('span', {}, name)));
  });
  select.addEventListener('change', () => {
    chosen = parts[Number(select.value)];
    inputs.get(chosen).checked = true;
    update();
  });
  by_id('parts_bar').hidden = false;
  by_id('parts_bar').append(switch_all('All', true), switch_all('Only one', false), element('label', { class: 'choice' }, 'Details of ', select));
  update();
}
