// Mouse, touch and keys.

function add_controls(view, { on_point, on_leave }) {
  for (const panel of view.panels) {
    const { element } = panel,
      pointers = new Map();
    let is_armed = false,
      spread = 0,
      has_moved = false;

    const point_at = event => {
      const r = element.getBoundingClientRect();
      return panel.chart_point_at(
        (2 * (event.clientX - r.left)) / r.width - 1,
        1 - (2 * (event.clientY - r.top)) / r.height
      );
    };
    const distance = () => {
      const [a, b] = pointers.values();
      return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
    };

    element.addEventListener('pointerdown', event => {
      element.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, event);
      if (pointers.size === 2) spread = distance();
      is_armed = true;
      has_moved = false;
    });
    element.addEventListener('pointermove', event => {
      const before = pointers.get(event.pointerId);
      if (!before) {
        if (event.pointerType === 'mouse') on_point(panel, point_at(event), event);
        return;
      }
      pointers.set(event.pointerId, event);
      if (pointers.size === 2) {
        const now = distance();
        view.zoom_by(now / spread);
        spread = now;
      } else if (pointers.size === 1) {
        view.turn((event.clientX - before.clientX) * 0.008, (event.clientY - before.clientY) * 0.008);
      }
      has_moved = true;
      on_leave();
    });
    const end = event => {
      if (!pointers.delete(event.pointerId)) return;
      if (event.type === 'pointerup' && !has_moved) on_point(panel, point_at(event), event);
    };
    element.addEventListener('pointerup', end);
    element.addEventListener('pointercancel', end);
    element.addEventListener('pointerleave', event => {
      is_armed = false;
      if (event.pointerType === 'mouse') on_leave();
    });
    element.addEventListener('dblclick', event => view.centre_on(point_at(event)));
    element.addEventListener(
      'wheel',
      event => {
        if (!is_armed && !event.ctrlKey) return; // the page scrolls
        event.preventDefault();
        view.zoom_by(Math.exp(-event.deltaY * 0.0015));
      },
      { passive: false }
    );

    const step = Math.PI / 18;
    const keys = {
      ArrowLeft: () => view.turn(-step, 0),
      ArrowRight: () => view.turn(step, 0),
      ArrowUp: () => view.turn(0, -step),
      ArrowDown: () => view.turn(0, step),
      '+': () => view.zoom_by(1.2),
      '=': () => view.zoom_by(1.2),
      '-': () => view.zoom_by(1 / 1.2),
      0: () => view.reset(),
      Home: () => view.reset(),
      Escape: on_leave,
      Enter: () => {
        const r = element.getBoundingClientRect();
        on_point(panel, panel.chart_point_at(0, 0), {
          clientX: r.left + r.width / 2,
          clientY: r.top + r.height / 2,
        });
      },
    };
    element.addEventListener('keydown', event => {
      const act = keys[event.key];
      if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      act();
    });
    element.addEventListener('blur', on_leave);
  }
}
