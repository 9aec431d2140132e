// The panels: one canvas with one view per panel, all turned, zoomed and centred together.

const vertex_shader = `
  attribute vec3 edge, chart_colour;
  attribute float value;
  varying vec3 v_normal, v_edge, v_chart_colour;
  varying vec2 v_uv;
  varying float v_value;
  void main() {
    v_normal = normalMatrix * normal;
    v_edge = edge;
    v_chart_colour = chart_colour;
    v_uv = uv;
    v_value = value;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

const fragment_shader = `
  uniform int mode; // as in fields
  uniform bool is_flat;
  uniform float wire;
  uniform vec3 plain, no_value;
  uniform sampler2D ramp;
  varying vec3 v_normal, v_edge, v_chart_colour;
  varying vec2 v_uv;
  varying float v_value;
  void main() {
    vec3 distances = fwidth(v_edge);
    vec3 colour = plain;
    if (mode == 1) colour = v_chart_colour;
    if (mode == 2) {
      vec2 squares = floor(16.0 * v_uv);
      bool is_dark = mod(squares.x + squares.y, 2.0) > 0.5;
      colour = is_dark ? v_chart_colour * 0.55 : mix(v_chart_colour, vec3(1.0), 0.55);
    }
    if (mode == 3)
      colour = v_value < -0.5 ? no_value : texture2D(ramp, vec2(v_value * 0.996 + 0.002, 0.5)).rgb;

    vec3 n = normalize(v_normal);
    if (!gl_FrontFacing) {
      n = -n;
      colour = mix(colour, vec3(dot(colour, vec3(0.3, 0.6, 0.1))), 0.45) * 0.8;
    }
    float key = max(dot(n, vec3(-0.40, 0.53, 0.75)), 0.0), fill = max(dot(n, vec3(0.85, -0.1, 0.5)), 0.0);
    float shine = pow(max(dot(n, vec3(-0.21, 0.28, 0.94)), 0.0), 40.0);
    vec3 lit = is_flat ? colour : colour * (0.40 + 0.60 * key + 0.17 * fill) + 0.10 * shine;

    vec3 near = 1.0 - smoothstep(vec3(0.0), distances * 1.3 + 1e-5, v_edge);
    float density = max(distances.x, max(distances.y, distances.z)); // faces of few pixels would be all line
    float line = max(near.x, max(near.y, near.z)) * (1.0 - smoothstep(0.25, 0.8, density));
    lit = mix(lit, vec3(0.06, 0.08, 0.12), wire * 0.75 * line);
    gl_FragColor = vec4(lit, 1.0);
  }`;

function ramp_texture(name) {
  const texture = new THREE.DataTexture(ramp_bytes(name, 256), 256, 1, THREE.RGBAFormat);
  texture.magFilter = texture.minFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

const inverse_of = matrix =>
  matrix.invert ? matrix.clone().invert() : new THREE.Matrix4().getInverse(matrix);
const attribute = (array, n) => new THREE.BufferAttribute(array, n);

// One view of a mesh: in space, or in the k-th shape of the canonical surface.
class Panel {
  constructor(element, mesh, atlas, k, uniforms) {
    this.element = element;
    this.mesh = mesh;
    this.shape = k === undefined ? null : atlas.shapes[k];
    this.places = this.shape ? mesh[`shape${k}`] : mesh.points;
    this.position = at_corners(mesh, this.places, 3);
    const count = mesh.triangles.length,
      geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', attribute(this.position, 3));
    geometry.setAttribute('normal', attribute(this.normals(k), 3));
    geometry.setAttribute('edge', attribute(edges_at_corners(mesh), 3));
    geometry.setAttribute('uv', attribute(at_corners(mesh, mesh.coordinates, 2), 2));
    const colours = atlas.charts.map(chart => rgb(chart.colour)),
      colour_of = t => (mesh.numbers ? face_colour(mesh.numbers[t]) : colours[chart_of(mesh, t)]),
      chart_colour = new Float32Array(3 * count);
    for (let c = 0; c < count; ++c) chart_colour.set(colour_of(Math.floor(c / 3)), 3 * c);
    geometry.setAttribute('chart_colour', attribute(chart_colour, 3));
    this.value = attribute(new Float32Array(count), 1);
    geometry.setAttribute('value', this.value);
    this.material = new THREE.ShaderMaterial({
      vertexShader: vertex_shader,
      fragmentShader: fragment_shader,
      side: THREE.DoubleSide,
      extensions: { derivatives: true },
      uniforms: { ...uniforms, is_flat: { value: !!this.shape && this.shape.is_flat } },
    });
    if (mesh.numbers) {
      this.material.uniforms.mode = { value: 1 }; // always
      Object.assign(this.material, { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    }
    this.object = new THREE.Group();
    const triangles = new THREE.Mesh(geometry, this.material);
    triangles.frustumCulled = false;
    this.object.add(triangles);
    this.scene = new THREE.Scene();
    this.scene.add(this.object);
    this.camera = new THREE.PerspectiveCamera(22, 1, 0.01, 100);
    this.frame();
    this.dot = document.createElement('i');
    this.dot.className = 'dot';
    this.dot.hidden = true;
    element.append(this.dot);
  }

  normals(k) {
    if (!this.shape) return normals_at_corners(this.mesh, this.mesh.normals);
    if (this.shape.is_flat) return this.position.map((_, i) => (i % 3 === 2 ? 1 : 0));
    return normals_at_corners(this.mesh, this.mesh[`shape${k}_normals`]);
  }

  // What is seen when nothing is zoomed: a ball about `centre`. Data in space have theirs at the origin.
  frame() {
    const p = this.position,
      box = new THREE.Box3();
    this.centre = [0, 0, 0];
    if (this.shape) this.centre = box.setFromArray(p).getCenter(new THREE.Vector3()).toArray();
    let r = 0;
    for (let i = 0; i < p.length; i += 3)
      r = Math.max(r, Math.hypot(...this.centre.map((x, k) => p[i + k] - x)));
    this.radius = (r || 1) * (!this.shape ? 1 : this.shape.is_flat ? 0.96 : 1.06);
  }

  show(field, range) {
    if (this.mesh.numbers) return; // CAD faces keep their colours
    const { mesh } = this,
      out = this.value.array,
      scale = 1 / (range.high - range.low);
    for (let c = 0; c < out.length; ++c) {
      const values = mesh[field.name];
      const value = values[field.is_per_face ? face_of(mesh, Math.floor(c / 3)) : mesh.triangles[c]];
      const x = (value - range.low) * scale;
      out[c] = Number.isNaN(x) ? -1 : Math.min(1, Math.max(0, x));
    }
    this.value.needsUpdate = true;
  }

  add_net(net, atlas) {
    const ends = [],
      colours = [];
    for (let q = 0; 12 * q < net.points.length; ++q)
      for (let k = 0; k < 4; ++k)
        for (const corner of [k, (k + 1) % 4]) {
          ends.push(...item(net.points, 4 * q + corner, 3));
          colours.push(...rgb(atlas.charts[net.charts[q]].colour).map(x => 0.55 * x));
        }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', attribute(new Float32Array(ends), 3));
    geometry.setAttribute('color', attribute(new Float32Array(colours), 3));
    this.net = new THREE.Group();
    for (const hidden of [false, true]) {
      const look = {
        vertexColors: THREE.VertexColors === undefined ? true : THREE.VertexColors,
        depthTest: !hidden,
        transparent: hidden,
        opacity: hidden ? 0.22 : 1,
      };
      this.net.add(new THREE.LineSegments(geometry, new THREE.LineBasicMaterial(look)));
    }
    this.net.add(
      new THREE.Points(
        geometry,
        new THREE.PointsMaterial({
          size: 4,
          sizeAttenuation: false,
          vertexColors: this.net.children[0].material.vertexColors,
        })
      )
    );
    this.net.visible = false;
    this.object.add(this.net);
  }

  // The borders of CAD faces: segments.
  add_borders(ends) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', attribute(ends, 3));
    for (const hidden of [false, true]) {
      const look = { color: 0x0f1420, depthTest: !hidden, transparent: hidden, opacity: hidden ? 0.12 : 1 };
      this.object.add(new THREE.LineSegments(geometry, new THREE.LineBasicMaterial(look)));
    }
  }

  add_places(places) {
    const points = [],
      colours = [];
    for (const q of places) {
      const at = this.place(q);
      if (!at) continue;
      points.push(...at);
      colours.push(...rgb(place_colours[q.kind]));
    }
    this.marks = rings(points, colours);
    this.marks.visible = false;
    this.object.add(this.marks);
  }

  // Where a chart point is in this panel, or null.
  place(q) {
    const at = locate(this.mesh, q);
    return at && blend(this.mesh, this.places, 3, at);
  }

  // The chart point that is seen at (x,y) in [-1,1]^2, or null.
  chart_point_at(x, y) {
    const inverse = inverse_of(this.object.matrixWorld);
    const from = new THREE.Vector3(0, 0, 0).setFromMatrixPosition(this.camera.matrixWorld);
    const to = new THREE.Vector3(x, y, 0.5).unproject(this.camera).sub(from).transformDirection(inverse);
    from.applyMatrix4(inverse);
    const hit = first_hit(this.position, from.toArray(), to.toArray());
    return hit && chart_point(this.mesh, hit);
  }
}

class View {
  constructor(container, canvas, has_three_sides) {
    this.container = container;
    this.panels = [];
    this.renderer = new THREE.WebGLRenderer({
      canvas,
      antialias: true,
      alpha: true,
      preserveDrawingBuffer: true,
    });
    this.renderer.autoClear = false;
    this.uniforms = {
      mode: { value: 1 },
      wire: { value: 0 },
      ramp: { value: null },
      plain: { value: new THREE.Vector3(...rgb(plain)) },
      no_value: { value: new THREE.Vector3(...rgb(no_value)) },
    };
    this.ramps = { sequential: ramp_texture('sequential'), diverging: ramp_texture('diverging') };
    this.front = new THREE.Quaternion();
    this.is_requested = false;
    this.marked = null;
    new ResizeObserver(() => this.request()).observe(container);
    this.reset();
  }

  // Takes all panels away.
  clear() {
    for (const { element, object } of this.panels) {
      element.remove();
      object.traverse(part => part.geometry && part.geometry.dispose());
    }
    this.panels = [];
    this.targets = this.marked = null;
  }

  // `k`: the shape of the canonical surface, or undefined
  add(element, mesh, atlas, k) {
    const panel = new Panel(element, mesh, atlas, k, this.uniforms);
    this.panels.push(panel);
    return panel;
  }

  // The side of the mesh that is seen first: where most of it is seen, or where a disk looks to.
  face_the_viewer(mesh, is_closed) {
    const seen = [0, 0, 0];
    for (const a of area_vectors(mesh))
      a.forEach((x, k) => {
        seen[k] += is_closed ? Math.abs(x) : x;
      });
    const axis = [2, 0, 1].reduce((a, b) => (Math.abs(seen[b]) > 1.05 * Math.abs(seen[a]) ? b : a));
    const forward = [0, 0, 0].map((_, k) => (k !== axis ? 0 : seen[axis] < 0 ? -1 : 1)),
      up = axis === 1 ? [0, 0, 1] : [0, 1, 0];
    const matrix = new THREE.Matrix4().makeBasis(
      new THREE.Vector3(...cross(up, forward)),
      new THREE.Vector3(...up),
      new THREE.Vector3(...forward)
    );
    this.front.setFromRotationMatrix(matrix.transpose());
  }

  reset() {
    this.zoom = 1;
    this.targets = null;
    this.turned = new THREE.Quaternion();
    this.turn(-0.45, 0.3);
  }

  // Turns all panels about the vertical axis of the first view and the horizontal axis of the screen.
  turn(right, down) {
    const about = (x, y, z, angle) =>
      new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(x, y, z), angle);
    this.turned
      .multiply(about(0, 1, 0, right))
      .premultiply(about(1, 0, 0, down))
      .normalize();
    this.request();
  }

  zoom_by(factor) {
    this.zoom = Math.min(60, Math.max(0.4, this.zoom * factor));
    this.request();
  }

  // A chart point, or null.
  centre_on(q) {
    this.targets = q && this.panels.map(panel => panel.place(q));
    this.request();
  }

  // Centres on a chart point, turned so that its side of the mesh is seen.
  look_at(q, mesh) {
    const at = locate(mesh, q);
    if (at) {
      const [a, b, c] = item(mesh.triangles, at.triangle, 3).map(v => item(mesh.points, v, 3));
      const normal = new THREE.Vector3(...unit(cross(subtract(b, a), subtract(c, a))));
      this.turned.setFromUnitVectors(normal.applyQuaternion(this.front), new THREE.Vector3(0, 0, 1));
    }
    this.zoom = Math.max(this.zoom, 3);
    this.centre_on(q);
  }

  mark(q) {
    this.marked = q && this.panels.map(panel => panel.place(q));
    this.request();
  }

  set(field, range) {
    this.uniforms.mode.value = field.mode;
    if (field.ramp) {
      this.uniforms.ramp.value = this.ramps[field.ramp];
      for (const panel of this.panels) panel.show(field, range);
    }
    this.request();
  }

  set_wire(is_on) {
    this.uniforms.wire.value = is_on ? 1 : 0;
    this.request();
  }
  set_net(is_on) {
    for (const { net } of this.panels) if (net) net.visible = is_on;
    this.request();
  }

  set_places(is_on) {
    for (const { marks } of this.panels) if (marks) marks.visible = is_on;
    this.request();
  }

  request() {
    if (this.is_requested) return;
    this.is_requested = true;
    requestAnimationFrame(() => {
      this.is_requested = false;
      this.draw();
    });
  }

  draw() {
    const box = this.container.getBoundingClientRect(),
      { renderer } = this;
    renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    renderer.setSize(box.width, box.height);
    renderer.setScissorTest(false);
    renderer.setClearColor(0, 0);
    renderer.clear();
    renderer.setScissorTest(true);
    this.panels.forEach((panel, k) => {
      const r = panel.element.getBoundingClientRect(),
        x = r.left - box.left,
        y = box.bottom - r.bottom;
      this.arrange(panel, r.width / r.height, this.targets && this.targets[k]);
      renderer.setViewport(x, y, r.width, r.height);
      renderer.setScissor(x, y, r.width, r.height);
      renderer.render(panel.scene, panel.camera);
      this.place_dot(panel, this.marked && this.marked[k], r);
    });
  }

  arrange(panel, aspect, target) {
    const { camera, object, radius, shape, centre } = panel;
    const half = (camera.fov * Math.PI) / 360,
      narrow = Math.min(1, aspect);
    const distance = (1.02 * radius) / Math.sin(Math.atan(Math.tan(half) * narrow));
    camera.aspect = aspect;
    camera.near = distance / 50;
    camera.far = distance + 4 * radius;
    camera.zoom = this.zoom;
    camera.position.set(0, 0, distance);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    object.quaternion.set(0, 0, 0, 1);
    if (!shape || !shape.is_flat) object.quaternion.copy(this.turned);
    if (!shape) object.quaternion.multiply(this.front);
    object.position.fromArray(target || centre).applyQuaternion(object.quaternion).negate();
    object.updateMatrixWorld();
  }

  place_dot(panel, place, r) {
    const { dot, camera, object } = panel;
    dot.hidden = !place;
    if (!place) return;
    const p = new THREE.Vector3(...place).applyMatrix4(object.matrixWorld).project(camera);
    dot.hidden = Math.max(Math.abs(p.x), Math.abs(p.y)) > 1;
    dot.style.left = `${((p.x + 1) / 2) * r.width}px`;
    dot.style.top = `${((1 - p.y) / 2) * r.height}px`;
  }
}
