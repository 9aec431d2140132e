// Plots as inline SVG. Colours come from the style sheet, so that they follow light and dark.

function svg(tag, attributes = {}, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

const plot_width = 420,
  plot_height = 220,
  plot_left = 54,
  plot_top = 12,
  plot_bottom = 40,
  plot_right = 12;

// An axis: value -> place, and the places of its ticks.
function axis(low, high, from, to, is_logarithmic) {
  const f = is_logarithmic ? Math.log10 : x => x,
    a = f(low),
    b = f(high);
  const at = x => from + ((f(x) - a) / (b - a)) * (to - from);
  const ticks = [];
  if (is_logarithmic && b - a > 0.7) {
    const factors = b - a > 2.5 ? [1] : b - a > 1.2 ? [1, 3] : [1, 2, 5];
    for (let d = Math.floor(a); d <= b; ++d)
      for (const x of factors.map(m => m * 10 ** d)) if (x >= low * 0.999 && x <= high * 1.001) ticks.push(x);
  } else {
    const rough = (high - low) / 5,
      power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map(m => m * power).find(s => s >= rough);
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high * (1 + 1e-9) + 1e-12; ++k)
      ticks.push(k * step);
  }
  return { at, ticks };
}

function frame(title, x, y, x_label, show_x, show_y) {
  const right = plot_width - plot_right,
    bottom = plot_height - plot_bottom;
  const plot = svg('svg', { viewBox: `0 0 ${plot_width} ${plot_height}`, role: 'img', 'aria-label': title });
  for (const t of y ? y.ticks : [])
    plot.append(
      svg('line', { class: 'grid', x1: plot_left, x2: right, y1: y.at(t), y2: y.at(t) }),
      svg('text', { x: plot_left - 6, y: y.at(t) + 4, 'text-anchor': 'end' }, show_y(t))
    );
  for (const t of x ? x.ticks : [])
    plot.append(
      svg('line', { class: 'tick', x1: x.at(t), x2: x.at(t), y1: bottom, y2: bottom + 4 }),
      svg('text', { x: x.at(t), y: bottom + 17, 'text-anchor': 'middle' }, show_x(t))
    );
  plot.append(
    svg('line', { class: 'axis', x1: plot_left, x2: right, y1: bottom, y2: bottom }),
    svg(
      'text',
      { class: 'label', x: (plot_left + right) / 2, y: plot_height - 4, 'text-anchor': 'middle' },
      x_label
    )
  );
  return plot;
}

function figure(title, plot, text) {
  const element = document.createElement('figure'),
    caption = document.createElement('figcaption');
  const strong = document.createElement('strong');
  strong.textContent = title;
  caption.append(strong, ' ', text);
  element.append(caption, plot);
  return element;
}

const y_axis = (low, high, is_logarithmic) =>
  axis(low, high, plot_height - plot_bottom, plot_top, is_logarithmic);
const x_axis = (low, high, is_logarithmic) =>
  axis(low, high, plot_left, plot_width - plot_right, is_logarithmic);

// How much of the mesh's area has which value of a field; colours as in the views.
function histogram(field, values, areas, range) {
  const count = 40,
    bins = new Float64Array(count),
    low = range.low,
    high = range.high;
  let sum = 0,
    mean = 0;
  for (let f = 0; f < values.length; ++f) {
    if (!Number.isFinite(values[f])) continue;
    const k = Math.floor(((values[f] - low) / (high - low)) * count);
    bins[Math.min(count - 1, Math.max(0, k))] += areas[f];
    sum += areas[f];
    mean += areas[f] * values[f];
  }
  if (!(sum > 0)) return null; // a mesh without area
  const most = Math.max(...bins) / sum,
    y = y_axis(0, most * 1.08);
  const is_ratio = field.name === 'area'; // given by its logarithm
  const axis_of = is_ratio ? x_axis(10 ** low, 10 ** high, true) : x_axis(low, high);
  const x = {
    at: is_ratio ? v => axis_of.at(10 ** v) : axis_of.at,
    ticks: is_ratio ? axis_of.ticks.map(Math.log10) : axis_of.ticks,
  };
  const plot = frame(
    `${field.label} distortion: histogram`,
    x,
    y,
    field.name === 'angle' ? 'σ₁/σ₂' : 'area ratio, logarithmic',
    field.show,
    percent
  );
  const bytes = ramp_bytes(field.ramp, count),
    width = x.at(low + (high - low) / count) - x.at(low);
  bins.forEach((b, k) => {
    if (b === 0) return;
    plot.append(
      svg('rect', {
        x: plot_left + k * width + 0.5,
        width: width - 1,
        y: y.at(b / sum),
        height: y.at(0) - y.at(b / sum),
        fill: `rgb(${bytes.slice(4 * k, 4 * k + 3).join()})`,
      })
    );
  });
  const at = Math.min(high, Math.max(low, mean / sum));
  plot.append(
    svg('line', { class: 'mark', x1: x.at(at), x2: x.at(at), y1: plot_top, y2: y.at(0) }),
    svg('text', { x: x.at(at) + 5, y: plot_top + 10 }, 'mean ' + field.show(mean / sum))
  );
  return figure(
    `${field.label} distortion`,
    plot,
    'share of the area of the mesh; the ends collect what lies beyond.'
  );
}

const decade = (x, up) => (up ? 10 ** Math.ceil(Math.log10(x)) : 10 ** Math.floor(Math.log10(x)));

function tolerance_lines(plot, y, fit) {
  for (const [name, value] of [
    ['rms tolerance', fit.rms_tolerance],
    ['max tolerance', fit.max_tolerance],
  ])
    if (value > 0 && y.at(value) > plot_top && y.at(value) < plot_height - plot_bottom)
      plot.append(
        svg('line', {
          class: 'mark',
          x1: plot_left,
          x2: plot_width - plot_right,
          y1: y.at(value),
          y2: y.at(value),
        }),
        svg(
          'text',
          { class: 'quiet', x: plot_width - plot_right, y: y.at(value) - 4, 'text-anchor': 'end' },
          name
        )
      );
}

function error_axis(errors, fit) {
  const all = errors.concat(fit.rms_tolerance, fit.max_tolerance).filter(x => x > 0);
  return all.length > 0
    ? y_axis(decade(Math.min(...all) * 0.999), decade(Math.max(...all) * 1.001, true), true)
    : null;
}

function errors_per_chart(fit, atlas) {
  const y = error_axis(
    fit.charts.flatMap(c => [c.rms, c.max]),
    fit
  );
  if (!y) return null;
  const plot = frame('Errors per chart', null, y, 'chart', short, percent);
  const step = (plot_width - plot_right - plot_left) / fit.charts.length;
  fit.charts.forEach((c, k) => {
    const x = plot_left + (k + 0.5) * step,
      { colour } = atlas.charts[k];
    plot.append(svg('text', { x, y: plot_height - plot_bottom + 17, 'text-anchor': 'middle' }, k));
    if (!(c.rms > 0)) return;
    const title = svg(
      'title',
      {},
      `chart ${k}: rms ${percent(c.rms)}, largest ${percent(c.max)}, ${c.controls} controls`
    );
    plot.append(
      svg(
        'g',
        {},
        title,
        svg('line', { x1: x, x2: x, y1: y.at(c.rms), y2: y.at(c.max), stroke: colour, 'stroke-width': 3 }),
        svg('circle', { class: 'dotted', cx: x, cy: y.at(c.rms), r: 5, fill: colour }),
        svg('rect', { x: x - 7, y: y.at(c.max) - 1.5, width: 14, height: 3, fill: colour })
      )
    );
  });
  tolerance_lines(plot, y, fit);
  return figure(
    'Errors per chart',
    plot,
    'root mean square (dot) and largest (bar), of the diagonal, logarithmic.'
  );
}

function convergence(fit) {
  const levels = (fit.levels || []).filter(l => l.rms > 0 && l.controls > 0);
  if (levels.length < 2) return null;
  const y = error_axis(
    levels.flatMap(l => [l.rms, l.max]),
    fit
  );
  const controls = levels.map(l => l.controls),
    low = Math.min(...controls),
    high = Math.max(...controls);
  const x = x_axis(low / 1.15, high * 1.15, true);
  const plot = frame('Error over controls', x, y, 'controls', count, percent);
  for (const kind of ['max', 'rms']) {
    const points = levels.map(l => [x.at(l.controls), y.at(l[kind])]);
    plot.append(svg('polyline', { class: 'series ' + kind, points: points.map(p => p.join()).join(' ') }));
    levels.forEach((l, k) =>
      plot.append(
        svg(
          'circle',
          { class: 'point ' + kind, cx: points[k][0], cy: points[k][1], r: 3.5 },
          svg('title', {}, `${l.controls} controls: rms ${percent(l.rms)}, largest ${percent(l.max)}`)
        )
      )
    );
    plot.append(
      svg(
        'text',
        { class: kind, x: points[0][0] + 8, y: points[0][1] - 6 },
        kind === 'rms' ? 'rms' : 'largest'
      )
    );
  }
  tolerance_lines(plot, y, fit);
  return figure(
    'Refinement',
    plot,
    'error at each step, of the diagonal, over the number of controls; both logarithmic.'
  );
}
