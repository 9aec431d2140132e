// The page: from the data to panels, switches, legend, plots and tables.

const element = (tag, attributes = {}, ...children) => {
  const e = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) e.setAttribute(name, value);
  e.append(...children);
  return e;
};
const by_id = id => document.getElementById(id);
const count = x => x.toLocaleString('en').replace(/,/g, '\u202f'); // a space that is not broken
const seconds = x => (x < 0.001 ? '<\u00a00.001' : short(x)) + '\u00a0s';

// ---- Head -------------------------------------------------------------------------------------------

const kind = ({ is_closed, genus, shapes }) =>
  `${is_closed ? `A closed mesh of genus ${genus}` : 'A disk'}, mapped one to one onto the ${shapes[0].title}`;

function show_head({ info, parts }) {
  const { figures = {} } = info,
    { input = {}, map = {}, surface, totals, seconds: times = {} } = figures;
  const name = String(input.file || 'Mesh')
    .split(/[\\/]/)
    .pop();
  document.title = `${name} – Simple_manifolds`;
  by_id('title').textContent = name;
  const smooth =
    surface && surface.smoothness > 0
      ? ` and the C${['⁰', '¹', '²', '³', '⁴'][surface.smoothness]} surface` + ' fitted to it'
      : '';
  by_id('summary').textContent = parts
    ? `${parts.filter(part => part.mesh).length} of ${count(parts.length)} parts, each mapped one to one onto its ` +
      `canonical surface${parts.some(part => part.surface) ? ', and the surfaces fitted to them' : ''}.`
    : `${kind(info.atlas)}${smooth ? ',' + smooth : ''}.`;
  const rows = [
    ...(totals ? [[totals.flipped, 'flipped in the domain', count]] : []),
    ...(totals ? [[totals.controls, 'controls', count]] : []),
    ...(totals ? [[totals.largest_rms_error, 'largest rms error, of the diagonal of a part', percent]] : []),
    ...(totals ? [[totals.largest_max_error, 'largest error, of the diagonal of a part', percent]] : []),
    [input.faces, 'faces', count],
    [map.flipped, 'flipped in the domain', count],
    [map.angle, 'angle distortion', short],
    [surface && surface.controls, 'controls', count],
    [surface && surface.rms_error, 'rms error, of the diagonal', percent],
    [surface && surface.max_error, 'largest error, of the diagonal', percent],
    times.fit >= 0 ? [times.map + times.fit, 'to map and fit', seconds] : [times.map, 'to map', seconds],
  ];
  for (const [value, label, show] of rows)
    if (typeof value === 'number')
      by_id('highlights').append(
        element('div', {}, element('dt', {}, label), element('dd', {}, show(value)))
      );
  if (figures.program)
    by_id('program').textContent =
      figures.program +
      (figures.version
        ? ` of Simple_manifolds ${figures.version.simple_manifolds}, CGAL ${figures.version.cgal}`
        : '');
}

function show_notice({ info }, parts = []) {
  const names = new Map(); // of the parts that an error is of
  for (const { info } of parts)
    if (info.error) names.set(info.error, [...(names.get(info.error) || []), info.name]);
  const lines = [...names].map(([error, list]) => {
    const more = list.length > 3 ? ` and ${list.length - 3} more` : '';
    return `${list.slice(0, 3).join(', ')}${more}: ${error}.`;
  });
  if (info.faces_of_map > info.faces)
    lines.unshift(
      `The mesh has ${count(info.faces_of_map)} faces. To keep this page small it is shown ` +
      `simplified, with ${count(info.faces)} faces; errors and curvatures are those of the ` +
        'vertices that are left, ' +
        'distortions those of the original faces.'
    );
  by_id('notice').hidden = lines.length === 0;
  by_id('notice').replaceChildren(...lines.map(line => element('p', {}, line)));
}

// ---- Panels -----------------------------------------------------------------------------------------

const with_capital = text => text[0].toUpperCase() + text.slice(1);

function fill_view(view, { mesh, domain = mesh, chosen, surface, net, cad, places, info }) {
  const { container } = view,
    { atlas } = info;
  const add = (title, text, triangles, k) => {
    const label = element('h3', {}, title, element('small', {}, text));
    const box = element(
      'div',
      {
        class: k === undefined ? 'panel' : 'panel domain',
        tabindex: 0,
        role: 'group',
        'aria-roledescription': '3D view',
        'aria-label': `${title}: ${text}`,
      },
      label
    );
    container.append(box);
    return view.add(box, triangles, atlas, k);
  };
  add('Mesh', `${count(info.faces)} faces` + (info.faces_of_map > info.faces ? ' (simplified)' : ''), mesh);
  atlas.shapes.forEach((shape, k) =>
    add(
      with_capital(shape.title),
      domain === mesh ? (shape.is_flat ? 'the same faces, face on' : 'the same faces') : chosen.info.name,
      domain,
      k
    )
  );
  if (surface) {
    const { chord_error } = chosen ? {} : info.fit; // that of one part is not that of all
    const within = typeof chord_error === 'number' ? `, at most ${percent(chord_error)} off` : '';
    const panel = add('Surface', `${count(surface.triangles.length / 3)} triangles${within}`, surface);
    if (net.points.length > 0) panel.add_net(net, atlas);
  }
  if (cad) {
    const n = 1 + cad.numbers.reduce((a, b) => Math.max(a, b), 0);
    add('CAD faces', `${count(n)} ${n === 1 ? 'face' : 'faces'} with their borders`, cad).add_borders(cad.borders);
  }
  if (places.length > 0) for (const panel of view.panels) panel.add_places(places);
  container.dataset.count = view.panels.length;
  container.dataset.domains = atlas.shapes.length;
}

// ---- Switches and legend ----------------------------------------------------------------------------

// Curvatures come in units of the diagonal.
const in_units = (field, info) => field.show || (x => short(x / info.diagonal ** field.power));

function legend(field, range, { info, chosen }) {
  const box = by_id('legend'),
    text = element('p', {}, field.text || '');
  box.replaceChildren();
  if (field.mode === 1) {
    const list = element('ul');
    const charts = info.atlas.charts.filter(({ part }) => !chosen || part === chosen.info.name);
    charts.forEach(({ colour }, c) =>
      list.append(element('li', {}, element('i', { style: `background: ${colour}` }), `chart ${c}`))
    );
    box.append(list);
    box.setAttribute('aria-label', `Colours of ${charts.length} charts`);
    return;
  }
  if (field.ramp) {
    const show = in_units(field, info),
      { low, high, least, largest } = range;
    const ticks = [
      element('span', {}, (least < low ? '≤ ' : '') + show(low)),
      element('span', {}, show((low + high) / 2)),
      element('span', {}, (largest > high ? '≥ ' : '') + show(high)),
    ];
    box.append(
      element(
        'div',
        { class: 'scale' },
        element('div', { class: 'ramp', style: `background: ${gradient(field.ramp)}` }),
        element('div', { class: 'ticks' }, ...ticks)
      )
    );
    text.append(
      element(
        'span',
        { class: 'quiet' },
        `. Colours span the ${100 * low_percentile}nd to ${100 - 100 * low_percentile}th percentile ` +
          'of the area;' +
          ` values from ${show(least)} to ${show(largest)}.`
      )
    );
  }
  box.append(text);
  box.setAttribute('aria-label', box.textContent);
}

function make_switches(view, data) {
  const { mesh } = data,
    ranges = {},
    areas = areas_of(mesh);
  const choose = field => {
    if (field.ramp && !ranges[field.name])
      ranges[field.name] = range_of(
        field,
        mesh[field.name],
        field.is_per_face ? areas.faces : areas.vertices
      );
    view.set(field, ranges[field.name]);
    legend(field, ranges[field.name], data);
  };
  const chosen_before = document.querySelector('input[name=field]:checked'),
    on = [...document.querySelectorAll('#toggles input:checked')].map(e => e.id);
  for (const id of ['fields', 'toggles'])
    for (const label of by_id(id).querySelectorAll('label')) label.remove();
  const toggle = (name, label, key, act, starts_on = false) => {
    const input = element('input', { type: 'checkbox', id: name });
    input.addEventListener('change', () => act(input.checked));
    input.checked = on.includes(name) || (!chosen_before && starts_on);
    act(input.checked);
    by_id('toggles').append(element('label', { title: `Key ${key}` }, input, element('span', {}, label)));
  };
  const shown = fields.filter(field => !field.ramp || mesh[field.name]);
  const first = shown.find(field => chosen_before && field.name === chosen_before.value) || shown[0];
  shown.forEach((field, k) => {
    const input = element('input', { type: 'radio', name: 'field', value: field.name });
    input.addEventListener('change', () => choose(field));
    input.checked = field === first;
    by_id('fields').append(
      element(
        'label',
        { title: `${field.text || 'Chart colours'} (key ${k + 1})` },
        input,
        element('span', {}, field.label)
      )
    );
  });
  toggle('wireframe', 'Wireframe', 'W', is_on => view.set_wire(is_on));
  if (data.net && data.net.points.length > 0)
    toggle('nets', 'Control nets', 'N', is_on => view.set_net(is_on));
  if (data.places.length > 0)
    toggle(
      'places_switch',
      'Places',
      'P',
      is_on => view.set_places(is_on),
      data.places.some(place => place.kind === 'fold')
    );
  by_id('last_key').textContent = shown.length;
  by_id('net_key').hidden = !by_id('nets');
  by_id('places_key').hidden = !by_id('places_switch');
  choose(first);
}

function add_keys(view) {
  by_id('reset').addEventListener('click', () => view.reset());
  document.addEventListener('keydown', event => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const key = event.key.toLowerCase();
    const target =
      key === 'w'
        ? by_id('wireframe')
        : key === 'n'
          ? by_id('nets')
          : key === 'p'
            ? by_id('places_switch')
            : /^[1-9]$/.test(key)
              ? document.querySelectorAll('input[name=field]')[key - 1]
              : null;
    if (target) target.click();
  });
}

// ---- Values at a point ------------------------------------------------------------------------------

function make_inspector(view, data) {
  const tip = by_id('tip'),
    container = by_id('panels'),
    { mesh, domain = mesh, info } = data;
  const on_leave = () => {
    tip.hidden = true;
    view.mark(null);
  };
  const on_point = (panel, q, event) => {
    const at = q && locate(mesh, q);
    if (!at) return on_leave();
    view.mark(q);
    const fixed = x => x.map(y => y.toFixed(3)).join(', ');
    const [shape] = info.atlas.shapes,
      { part, number = q.chart } = info.atlas.charts[q.chart],
      there = domain === mesh ? at : locate(domain, q),
      place = there && blend(domain, domain.shape0, 3, there),
      in_space = blend(mesh, mesh.points, 3, at);
    const rows = [
      [info.faces_of_map > info.faces ? 'face (simplified)' : 'face', count(face_of(mesh, at.triangle))],
      ['chart', `${number} at (${fixed(q.uv)})`],
      ...(place ? [[`on the ${shape.title}`, `(${fixed(shape.is_flat ? place.slice(0, 2) : place)})`]] : []),
      ['in space', `(${in_space.map((x, k) => short(x * info.diagonal + info.centre[k])).join(', ')})`],
    ];
    if (part) rows.unshift(['part', part]);
    for (const field of fields)
      if (field.ramp && mesh[field.name])
        rows.push([
          field.label.toLowerCase(),
          in_units(field, info)(value_at(mesh, field, at)) + (field.unit || ''),
        ]);
    tip.replaceChildren(
      ...rows.flatMap(([name, value]) => [element('b', {}, name), element('span', {}, value)])
    );
    tip.hidden = false;
    const box = container.getBoundingClientRect(),
      size = tip.getBoundingClientRect();
    const x = event.clientX - box.left,
      y = event.clientY - box.top;
    tip.style.left = `${Math.max(4, x + 18 + size.width > box.width ? x - size.width - 18 : x + 18)}px`;
    tip.style.top = `${Math.max(4, Math.min(y + 12, box.height - size.height - 4))}px`;
  };
  return { on_point, on_leave };
}

// ---- Plots and figures ------------------------------------------------------------------------------

function show_plots({ info, mesh }) {
  const areas = areas_of(mesh).faces,
    list = [];
  for (const field of fields.filter(f => f.is_per_face))
    list.push(histogram(field, mesh[field.name], areas, range_of(field, mesh[field.name], areas)));
  if (info.fit) list.unshift(errors_per_chart(info.fit, info.atlas), convergence(info.fit));
  by_id('plots').replaceChildren(...list.filter(Boolean));
}

// What numbers are, by words in their names.
const meanings = [
  [/seconds/, seconds],
  [/bytes/, x => short(x / 1e6) + '\u00a0MB'],
  [/normal deviation/, x => short((x * 180) / Math.PI) + '°'],
  [/error|closest point|tolerance|disagreement/, of_diagonal],
];

function text_of(value, label) {
  if (value === null) return '–';
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  if (typeof value !== 'number') return String(value);
  const meaning = meanings.find(([words]) => words.test(label));
  return meaning ? meaning[1](value) : Number.isInteger(value) ? count(value) : short(value);
}

// Names and values of a group, with those of the groups in it; lists of numbers in one row, others left out.
function rows_of(group, prefix) {
  return Object.entries(group).flatMap(([name, value]) => {
    const label = `${prefix} ${name}`.replace(/_/g, ' ');
    if (value === null || typeof value !== 'object') return [[label, text_of(value, label)]];
    if (!Array.isArray(value)) return rows_of(value, label);
    return value.every(x => typeof x === 'number')
      ? [[label, value.map(x => text_of(x, label)).join('\u00a0· ')]]
      : [];
  });
}

function show_figures({ info }) {
  const { figures = {} } = info,
    single = {};
  by_id('figures').replaceChildren();
  const add = (name, group) => {
    const rows = rows_of(group, name).map(([label, value]) =>
      element(
        'tr',
        {},
        element('th', { scope: 'row' }, label.slice(name.length + 1).replace(/ bytes$/, '')),
        element('td', /[\/\\]/.test(value) ? { class: 'path' } : {}, value)
      )
    );
    if (rows.length > 0)
      by_id('figures').append(
        element('table', {}, element('caption', {}, name), element('tbody', {}, ...rows))
      );
  };
  for (const [name, group] of Object.entries(figures)) {
    if (group === null || typeof group !== 'object') single[name] = group;
    else add(name, group);
  }
  add('program', single);
}

async function start() {
  const data = await read_data(),
    container = by_id('panels');
  let view;
  show_head(data);
  const show = shown => {
    show_notice(shown, data.parts);
    show_plots(shown.chosen || shown);
    show_figures(shown);
    if (!view) {
      view = new View(container, container.querySelector('canvas'));
      view.face_the_viewer(shown.mesh, shown.info.atlas.is_closed);
    }
    view.clear();
    fill_view(view, shown);
    make_switches(view, shown);
    show_places(view, shown);
    add_controls(view, make_inspector(view, shown));
    view.draw();
  };
  if (data.parts) make_parts_list(data, show);
  else show({ ...data, places: places_of(data.info) });
  add_keys(view);
  return view;
}

// For scripts that take pictures: resolves to the view when all is drawn.
window.report = start();
window.report.catch(error => {
  by_id('notice').hidden = false;
  by_id('notice').textContent = `The views cannot be shown: ${error.message}.`;
});
