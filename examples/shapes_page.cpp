#include "shapes_page.h"

#include <CGAL/Simple_manifolds/IO/Atomic_file.h>
#include <CGAL/Simple_manifolds/atlas/Plane_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Sphere_atlas.h>
#include <CGAL/Simple_manifolds/atlas/Torus_atlas.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <ostream>

namespace tools {

namespace SM = CGAL::Simple_manifolds;

namespace {

const char* const page_head = R"_page_(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Shapes</title>
<style>
:root { color-scheme: light dark; }
body { font: 15px/1.4 system-ui, sans-serif; margin: 0 auto; padding: 0 1.5rem 2rem; max-width: 1500px; }
h1 { font-size: 1.3rem; }
#views { display: grid; grid-template-columns: repeat(auto-fit, minmax(280px, 1fr)); gap: 0.75rem; }
figure { margin: 0; }
figcaption { overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
canvas { width: 100%; aspect-ratio: 1; border: 1px solid #8884; border-radius: 6px; touch-action: none; display: block; }
fieldset { border: 1px solid #8884; border-radius: 6px; margin: 0.75rem 0; }
label { display: inline-block; margin-right: 1.2rem; }
table { border-collapse: collapse; }
td, th { padding: 0.15rem 0.7rem; text-align: right; border-bottom: 1px solid #8884; }
</style>
</head>
<body>
<h1>Shapes over one canonical surface</h1>
<p id="words"></p>
<div id="views"></div>
<fieldset><legend>Colours</legend>
<label><input type="radio" name="colour" value="0" checked> the same point has the same colour</label>
<label><input type="radio" name="colour" value="1"> distortion against the mean shape</label>
</fieldset>
<fieldset><legend>Morph: weights of the shapes</legend><div id="weights"></div></fieldset>
<fieldset id="mode_box"><legend>Modes: standard deviations from the mean</legend><div id="modes"></div></fieldset>
<table id="figures"></table>
<script type="application/json" id="data">)_page_";

const char* const page_tail = R"_page_(</script>
<script>
'use strict';
const data = JSON.parse(document.getElementById('data').textContent);
const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
const floats = (text) => new Float32Array(bytes(text));
const words = (text) => new Uint32Array(bytes(text));
const vertexShader = `#version 300 es
in vec3 position; in vec3 domain; in float scalar;
uniform mat3 turn; uniform float zoom; uniform float pointSize;
out vec3 at; out vec3 home; out float value;
void main() {
  at = turn * position; home = domain; value = scalar;
  gl_Position = vec4(at.xy * zoom, -at.z * 0.2 * min(zoom, 2.0) - pointSize * 1e-3, 1.0);
  gl_PointSize = pointSize;
}`;
const fragmentShader = `#version 300 es
precision highp float;
in vec3 at; in vec3 home; in float value; uniform int mode; uniform float pointSize; out vec4 colour;
void main() {
  if (pointSize > 0.0) { if (length(gl_PointCoord - 0.5) > 0.5) discard; colour = vec4(0.85, 0.1, 0.1, 1.0); return; }
  vec3 n = normalize(cross(dFdx(at), dFdy(at)));
  vec3 base;
  if (mode == 0) {
    vec3 d = normalize(home);
    base = 0.55 + 0.4 * d;
    vec3 s = sin(9.0 * d);
    base *= s.x * s.y * s.z > 0.0 ? 1.0 : 0.72;
  } else {
    float t = clamp(value, 0.0, 1.0);
    base = mix(vec3(0.93, 0.93, 0.9), mix(vec3(0.95, 0.6, 0.2), vec3(0.6, 0.05, 0.25), smoothstep(0.5, 1.0, t)),
               smoothstep(0.0, 0.5, t));
  }
  colour = vec4(base * (0.3 + 0.7 * abs(n.z)), 1.0);
}`;
let turn = [1, 0, 0, 0, 1, 0, 0, 0, 1], zoom = 1, mode = 0;
const views = [];
function multiply(a, b) { // columns
  const c = new Array(9).fill(0);
  for (let i = 0; i < 3; ++i) for (let j = 0; j < 3; ++j) for (let k = 0; k < 3; ++k) c[3 * i + j] += a[3 * k + j] * b[3 * i + k];
  return c;
}
function rotate(dx, dy) {
  const c = Math.cos(dx), s = Math.sin(dx), d = Math.cos(dy), t = Math.sin(dy);
  turn = multiply(multiply([1, 0, 0, 0, d, t, 0, -t, d], [c, 0, -s, 0, 1, 0, s, 0, c]), turn);
  draw();
}
function addView(name, mesh) {
  const figure = document.createElement('figure'), canvas = document.createElement('canvas'),
    caption = document.createElement('figcaption');
  caption.textContent = name;
  figure.append(canvas, caption);
  document.getElementById('views').append(figure);
  const gl = canvas.getContext('webgl2', { antialias: true });
  if (!gl) { caption.textContent = name + ': this browser has no WebGL 2'; return; }
  const program = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  ['position', 'domain', 'scalar'].forEach((name, i) => gl.bindAttribLocation(program, i, name));
  gl.linkProgram(program);
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);
  const fill = (place, size, array) => {
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, array, gl.DYNAMIC_DRAW);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, size, gl.FLOAT, false, 0, 0);
    return buffer;
  };
  const position = fill(0, 3, mesh.positions);
  fill(1, 3, mesh.domain);
  if (mesh.scalar) fill(2, 1, mesh.scalar);
  const index = (array) => {
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, array, gl.STATIC_DRAW);
    return buffer;
  };
  const faces = index(mesh.faces), dots = index(mesh.landmarks);
  const uniform = (name) => gl.getUniformLocation(program, name);
  views.push({
    set(positions) { gl.bindBuffer(gl.ARRAY_BUFFER, position); gl.bufferData(gl.ARRAY_BUFFER, positions, gl.DYNAMIC_DRAW); },
    draw() {
      const size = Math.round(canvas.clientWidth * devicePixelRatio) || 300;
      if (canvas.width !== size || canvas.height !== size) canvas.width = canvas.height = size;
      gl.viewport(0, 0, size, size);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.uniformMatrix3fv(uniform('turn'), false, turn);
      gl.uniform1f(uniform('zoom'), zoom);
      gl.uniform1i(uniform('mode'), mesh.scalar ? mode : 0);
      gl.uniform1f(uniform('pointSize'), 0);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, faces);
      gl.drawElements(gl.TRIANGLES, mesh.faces.length, gl.UNSIGNED_INT, 0);
      gl.uniform1f(uniform('pointSize'), 9 * devicePixelRatio);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, dots);
      gl.drawElements(gl.POINTS, mesh.landmarks.length, gl.UNSIGNED_INT, 0);
    }
  });
  let last = null;
  canvas.addEventListener('pointerdown', (e) => { last = [e.clientX, e.clientY]; canvas.setPointerCapture(e.pointerId); });
  canvas.addEventListener('pointerup', () => { last = null; });
  canvas.addEventListener('pointermove', (e) => {
    if (!last) return;
    rotate((e.clientX - last[0]) * 0.01, (e.clientY - last[1]) * 0.01);
    last = [e.clientX, e.clientY];
  });
  canvas.addEventListener('wheel', (e) => { e.preventDefault(); zoom *= Math.exp(-e.deltaY * 0.001); draw(); }, { passive: false });
}
function draw() { for (const view of views) view.draw(); }

for (const shape of data.shapes)
  addView(shape.name, { faces: words(shape.faces), positions: floats(shape.positions), domain: floats(shape.domain),
    landmarks: words(shape.landmarks) });
const common = data.common;
const forms = common.positions.map(floats), mean = floats(common.mean), modes = common.modes.map(floats);
addView('morph', { faces: words(common.faces), positions: forms[0], domain: floats(common.domain),
  scalar: floats(common.scalar), landmarks: words(data.shapes[0].landmarks) });
const morphView = views[views.length - 1];

function slider(box, text, least, most, value, changed) {
  const label = document.createElement('label'), input = document.createElement('input');
  Object.assign(input, { type: 'range', min: least, max: most, step: (most - least) / 200, value });
  input.addEventListener('input', changed);
  label.append(text + ' ', input);
  document.getElementById(box).append(label);
  return input;
}
function morph() {
  const sum = weights.reduce((s, w) => s + Number(w.value), 0) || 1;
  const x = new Float32Array(mean.length);
  weights.forEach((w, i) => { const t = Number(w.value) / sum; if (t) for (let k = 0; k < x.length; ++k) x[k] += t * forms[i][k]; });
  morphView.set(x);
  draw();
}
function vary() {
  const x = Float32Array.from(mean);
  sliders.forEach((s, i) => { for (let k = 0; k < x.length; ++k) x[k] += Number(s.value) * modes[i][k]; });
  morphView.set(x);
  draw();
}
const weights = forms.map((f, i) => slider('weights', data.shapes[i].name, 0, 1, 0.5, morph));
const sliders = modes.map((m, i) => slider('modes', 'mode ' + (i + 1), -3, 3, 0, vary));
document.getElementById('mode_box').hidden = modes.length === 0;
document.querySelectorAll('input[name=colour]').forEach((r) =>
  r.addEventListener('change', () => { mode = Number(r.value); draw(); }));

const table = document.getElementById('figures');
const row = (cells, tag) => {
  const tr = document.createElement('tr');
  for (const c of cells) { const td = document.createElement(tag); td.textContent = c; tr.append(td); }
  table.append(tr);
};
const short = (x) => (typeof x === 'number' ? Number(x.toPrecision(4)) : x);
row(['shapes', 'mean on a', 'mean on b', 'median', '95 %', '99 %', 'landmarks', 'exact', 'largest error'], 'th');
for (const p of data.metrics.pairs)
  row([p.a + ' and ' + p.b, p.sd_a, p.sd_b, p.median, p.p95, p.p99, p.landmarks.used, p.landmarks.exact, p.landmarks.max].map(short), 'td');
document.getElementById('words').textContent = 'Every point of a shape has one point of the sphere, and so one point of ' +
  'every other shape: proved for each map. The distortion is the symmetric Dirichlet density, 1 for an isometry. Drag to turn, scroll to zoom.';
addEventListener('resize', draw);
morph();
</script>
</body>
</html>
)_page_";

template <class T>
std::string base_64(const std::vector<T>& values)
{
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string raw(values.size() * sizeof(T), '\0'), text;
  if (!values.empty()) std::memcpy(&raw[0], values.data(), raw.size());
  for (std::size_t i = 0; i < raw.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < raw.size() ? static_cast<unsigned char>(raw[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= raw.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

// Into the square that is shown.
struct Frame {
  Eigen::Vector3d centre;
  double scale;
};
Frame frame_of(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : points) box.extend(x);
  const double half = box.diagonal().norm() / 2;
  return {box.center(), half > 0 ? 1 / half : 1};
}
std::string shown(const std::vector<Eigen::Vector3d>& points, const Frame& frame)
{
  std::vector<float> values;
  for (const Eigen::Vector3d& x : points)
    for (int k = 0; k < 3; ++k) values.push_back(static_cast<float>(frame.scale * (x[k] - frame.centre[k])));
  return base_64(values);
}
std::string shown(const std::vector<SM::Triangle>& faces)
{
  std::vector<std::uint32_t> values;
  for (const SM::Triangle& t : faces)
    for (const int v : t) values.push_back(static_cast<std::uint32_t>(v));
  return base_64(values);
}

std::string name_of(const Json& shape)
{
  return std::filesystem::path(shape["input"]["file"].get<std::string>()).filename().string();
}

// Per vertex how far the faces of the mean are from those of the first shape: a third of the logarithm to base 2 of the
// symmetric Dirichlet density.
std::vector<float> distortions(const SM::Common_mesh& mesh, const std::vector<Eigen::Vector3d>& mean)
{
  std::vector<double> sum(mean.size(), 0.), weight(mean.size(), 0.);
  const std::vector<Eigen::Vector3d>& x = mesh.positions[0];
  for (const SM::Triangle& t : mesh.faces) {
    const Eigen::Vector3d a = x[t[1]] - x[t[0]], b = x[t[2]] - x[t[0]], c = mean[t[1]] - mean[t[0]],
                          d = mean[t[2]] - mean[t[0]];
    const double s = a.cross(b).norm(), q = c.cross(d).norm();
    if (!(s > 0) || !(q > 0)) continue;
    const double trace =
      (a.squaredNorm() * d.squaredNorm() - 2 * a.dot(b) * c.dot(d) + b.squaredNorm() * c.squaredNorm()) /
      (s * s);
    for (const int v : t) {
      sum[v] += s * std::log2(trace * (1 + s * s / (q * q)) / 4) / 3;
      weight[v] += s;
    }
  }
  std::vector<float> result;
  for (std::size_t v = 0; v < sum.size(); ++v)
    result.push_back(static_cast<float>(weight[v] > 0 ? sum[v] / weight[v] : 0.));
  return result;
}

// Points of the canonical surface as colours are made from them: in the directions that they have from the origin.
template <class>
std::vector<Eigen::Vector3d> in_space(const std::vector<Eigen::Vector3d>& sphere)
{
  return sphere;
}
template <class Atlas>
std::vector<Eigen::Vector3d> in_space(const std::vector<Eigen::Vector2d>& points)
{
  const double turn = 2 * std::acos(-1.);
  std::vector<Eigen::Vector3d> result;
  for (const Eigen::Vector2d& p : points) {
    const double u = turn * p[0], v = turn * p[1];
    if (Atlas::is_closed) // a ring
      result.emplace_back((1 + 0.5 * std::cos(v)) * std::cos(u), (1 + 0.5 * std::cos(v)) * std::sin(u),
                          0.5 * std::sin(v));
    else // as a map shows a part of the earth
      result.emplace_back(2 * p[0] - 1, 2 * p[1] - 1, 1.);
  }
  return result;
}

} // namespace

template <class Atlas>
void write_shapes_page(const std::string& file, const SM::Shape_set<Atlas>& set,
                       const SM::Common_mesh& common, const std::vector<SM::Similarity>& motions,
                       const SM::Shape_statistics<>& statistics,
                       const std::vector<std::vector<std::size_t>>& landmarks, const Json& metrics)
{
  const Frame sphere{Eigen::Vector3d::Zero(), 1};
  Json data = {{"shapes", Json::array()}, {"metrics", {{"pairs", metrics["pairs"]}}}};
  for (std::size_t i = 0; i < set.size(); ++i) {
    const auto& map = set.map(i);
    std::vector<SM::Triangle> faces = map.faces();
    faces.resize(faces.size() - map.number_of_virtual_faces());
    std::vector<Eigen::Vector3d> points = map.points();
    for (Eigen::Vector3d& x : points) x = motions[i](x);
    std::vector<std::uint32_t> dots;
    for (const auto& row : landmarks) dots.push_back(static_cast<std::uint32_t>(row[i]));
    data["shapes"].push_back({{"name", std::to_string(i + 1) + ": " + name_of(metrics["shapes"][i])},
                              {"faces", shown(faces)},
                              {"positions", shown(points, frame_of(points))},
                              {"domain", shown(in_space<Atlas>(map.domain_points()), sphere)},
                              {"landmarks", base_64(dots)}});
  }
  const Frame frame = frame_of(statistics.mean());
  Json positions = Json::array(), modes = Json::array();
  for (const auto& x : common.positions) positions.push_back(shown(x, frame));
  const std::size_t shown_modes =
    set.size() > 2 ? (std::min)(statistics.number_of_modes(), std::size_t(3)) : 0;
  for (std::size_t m = 0; m < shown_modes; ++m) {
    Eigen::VectorXd c = Eigen::VectorXd::Zero(Eigen::Index(m + 1));
    c[Eigen::Index(m)] = std::sqrt(statistics.variances()[Eigen::Index(m)]);
    std::vector<Eigen::Vector3d> x = statistics.shape(c);
    for (std::size_t v = 0; v < x.size(); ++v) x[v] -= statistics.mean()[v];
    modes.push_back(shown(x, {Eigen::Vector3d::Zero(), frame.scale}));
  }
  data["common"] = {{"faces", shown(common.faces)},
                    {"domain", shown(in_space<Atlas>(set.map(0).domain_points()), sphere)},
                    {"positions", positions},
                    {"mean", shown(statistics.mean(), frame)},
                    {"modes", modes},
                    {"scalar", base_64(distortions(common, statistics.mean()))}};
  SM::Atomic_file output(file);
  std::string text = data.dump(-1, ' ', true, Json::error_handler_t::replace);
  for (std::size_t i = 0; (i = text.find("</", i)) != std::string::npos;)
    text.replace(i, 2, "<\\/"); // no end of the script
  output.stream() << page_head << text << page_tail;
  output.commit();
}

#define WRITE_SHAPES_PAGE(Atlas)                                                                             \
  template void write_shapes_page(const std::string&, const SM::Shape_set<SM::Atlas>&,                       \
                                  const SM::Common_mesh&, const std::vector<SM::Similarity>&,                \
                                  const SM::Shape_statistics<>&,                                             \
                                  const std::vector<std::vector<std::size_t>>&, const Json&)
WRITE_SHAPES_PAGE(Sphere_atlas);
WRITE_SHAPES_PAGE(Torus_atlas);
WRITE_SHAPES_PAGE(Plane_atlas);
#undef WRITE_SHAPES_PAGE

} // namespace tools
