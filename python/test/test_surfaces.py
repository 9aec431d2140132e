"""Fits, evaluation, closest points, tessellations, files."""
import signal
import threading
import time

import numpy as np
import pytest

import simple_manifolds as sm
from conftest import bumpy_sphere, disk, plate, torus

DOMAINS = ["sphere", "torus", "plane", "hyperbolic"]


def test_the_report_is_true(sphere_map, surface):
    r = surface.report
    assert r.tolerance_reached and r.stop == "tolerance" and r.rms_error <= r.rms_tolerance == 2e-3
    facets = sm.fit_surface(sphere_map, rms_error=2e-3, target="facets")
    error = np.linalg.norm(facets.positions(sphere_map.domain_points) - sphere_map.vertices, axis=1)
    assert np.sqrt((error**2).mean()) / sphere_map.diagonal == pytest.approx(facets.report.vertex_rms_error, rel=1e-9)


@pytest.mark.parametrize("domain", DOMAINS)
def test_derivatives_are_those_of_positions(surfaces, domain):
    s = surfaces[domain]
    assert s.domain == domain and s.smoothness == 2
    places = s.random_domain_points(200, seed=1)
    charts, uv = s.chart_points(places)
    inside = (np.abs(uv - 0.5) < 0.49).all(axis=1)
    charts, uv = charts[inside], uv[inside]
    d = s.derivatives((charts, uv))
    assert np.abs(d.position - s.positions(places)[inside]).max() < 1e-9
    h = 1e-5
    at = lambda a, b: s.positions((charts, uv + np.array([a, b])))
    scale = max(np.abs(d.du).max(), np.abs(d.dv).max())
    assert np.abs((at(h, 0) - at(-h, 0)) / (2 * h) - d.du).max() < 1e-6 * scale + 1e-6
    assert np.abs((at(0, h) - at(0, -h)) / (2 * h) - d.dv).max() < 1e-6 * scale + 1e-6
    first = s.derivatives((charts, uv), order=1)
    assert np.abs(first.du - d.du).max() < 1e-9 and first.duu is None
    n = np.cross(d.du, d.dv)
    assert np.abs(n / np.linalg.norm(n, axis=1, keepdims=True) - s.normals((charts, uv))).max() < 1e-9


def test_curvatures_of_a_sphere():
    points, faces = bumpy_sphere(20)
    points = 2 * points / np.linalg.norm(points, axis=1, keepdims=True)
    s = sm.fit_surface((points, faces), rms_error=1e-4)
    c = s.curvatures(s.random_domain_points(500))
    assert np.median(np.abs(c.mean - 0.5)) < 0.01 and np.median(np.abs(c.gaussian - 0.25)) < 0.01
    assert np.abs(c.k1 + c.k2 - 2 * c.mean).max() < 1e-9
    assert np.abs((c.direction1 * c.direction2).sum(axis=1)).max() < 1e-9


def test_batches_are_their_points(surfaces):
    for s in surfaces.values():
        places = s.random_domain_points(5000)
        all_of_them = s.positions(places)
        assert (all_of_them[17:18] == s.positions(places[17:18])).all()
        assert np.abs(s.derivatives(places).position - all_of_them).max() < 1e-12
    assert len(surfaces["sphere"].positions(np.zeros((0, 3)))) == 0


def test_memory_is_shared(surface):
    places = surface.random_domain_points(10)
    d = surface.derivatives(places)
    assert d.du.base is not None and np.shares_memory(d.du, d.dvv.base)
    t = surface.tessellate(subdivisions=4)
    assert np.shares_memory(t.vertices, t.vertices) and not t.vertices.flags.writeable
    vertices = t.vertices
    del t
    assert np.isfinite(vertices).all()


def test_closest_points(surface):
    x = surface.positions(surface.random_domain_points(100))
    n = surface.normals(surface.random_domain_points(100))
    for distance in (0.01, -0.01):
        c = surface.closest_points(x + distance * n)
        assert np.abs(c.signed_distances - distance).max() < 1e-9
        assert np.abs(surface.positions(c.domain_points) - c.points).max() < 1e-9
    assert (surface.closest_points([[0, 0, 0]]).signed_distances < 0).all()
    with pytest.raises(ValueError):
        surface.closest_points([[np.inf, 0, 0]])


@pytest.mark.parametrize("domain", DOMAINS)
def test_tessellations(surfaces, domain, tmp_path):
    t = surfaces[domain].tessellate(chord_error=5e-3)
    found = sm.inspect_mesh(t)
    assert t.criteria_met and not found.faults and len(found.components) == 1
    assert found.components[0].genus == surfaces[domain].genus
    assert len(surfaces[domain].tessellate(chord_error=1e-3).faces) > len(t.faces)
    assert np.allclose(np.linalg.norm(t.normals, axis=1), 1) and set(t.fields) >= {"mean_curvature"}
    assert len(t.charts) == len(t.uv) == len(t.vertices) and len(t.face_charts) == len(t.faces)
    for name in ("t.ply", "t.obj", "t.glb", "t.vtp"):
        t.save(tmp_path / name)
    assert (sm.read_mesh(tmp_path / "t.ply").vertices == t.vertices).all()
    assert len(sm.read_mesh(tmp_path / "t.obj").faces) == len(t.faces)
    assert (tmp_path / "t.glb").read_bytes()[:4] == b"glTF"
    with pytest.raises(sm.FileError) as e:
        t.save(tmp_path / "t.docx")
    assert e.value.code == "unsupported_format"
    coarse = surfaces[domain].tessellate(edge_length=1e-3, max_faces=5000)
    assert not coarse.criteria_met and len(coarse.faces) <= 5000


@pytest.mark.parametrize("domain", DOMAINS)
@pytest.mark.parametrize("extension", ["json", "cbor"])
def test_files_hold_every_bit(surfaces, domain, extension, tmp_path):
    s = surfaces[domain]
    s.save(tmp_path / f"s.{extension}")
    again = sm.load_surface(tmp_path / f"s.{extension}")
    places = s.random_domain_points(100)
    assert (again.positions(places) == s.positions(places)).all()
    assert again.tolerance == s.tolerance and again.report is None


def test_step_files(surfaces, tmp_path):
    for domain in ("sphere", "torus", "plane"):
        cad = surfaces[domain].to_cad(2e-3)
        assert cad.report.tolerance_reached and cad.report.max_deviation <= 2e-3
        cad.save_step(tmp_path / "s.step", name="körper", unit="m")
        text = (tmp_path / "s.step").read_text()
        assert text.startswith("ISO-10303-21") and text.count("B_SPLINE_SURFACE_WITH_KNOTS") >= cad.report.faces
    direct = sm.fit_cad_surface(bumpy_sphere(12), rms_error=2e-3)
    assert direct.report.faces >= 6 and direct.report.volume > 0
    assert len(direct.find_self_intersections()) == 0 and direct.report.has_searched_intersections
    assert surfaces["hyperbolic"].to_cad(1e-2).report.volume > 0


def test_options_of_fits(sphere_map):
    fast = sm.fit_surface(sphere_map, rms_error=1e-3, max_error=1, target="facets")
    compact = sm.fit_surface(sphere_map, rms_error=1e-3, max_error=1, target="facets", fit_effort="compact")
    assert compact.report.controls < fast.report.controls
    assert np.array_equal(fast.map.domain_points, sphere_map.domain_points)
    moved = compact.map
    assert np.array_equal(moved.vertices, sphere_map.vertices)
    apart = [np.linalg.norm(compact.positions(m.domain_points) - m.vertices) for m in (moved, sphere_map)]
    assert apart[0] < apart[1]
    limited = sm.fit_surface(sphere_map, rms_error=1e-6, max_controls=500, target="facets")
    assert not limited.report.tolerance_reached and limited.report.stop != "tolerance"
    weights = np.ones(len(sphere_map.vertices))
    assert sm.fit_surface(sphere_map, degree=4, fairness=1e-9, vertex_weights=weights).report.tolerance_reached
    for wrong in ({"rms_error": -1.0}, {"rms_error": np.nan}, {"degree": 9}, {"max_controls": 3}, {"target": "round"},
                  {"fairness": -1.0}, {"noise_level": 2.0}, {"crease_angle": 400.0}, {"vertex_weights": [1.0]},
                  {"vertex_weights": -weights}):
        with pytest.raises(ValueError):
            sm.fit_surface(sphere_map, **wrong)
    with pytest.raises(TypeError, match="max_controls is -1"):
        sm.fit_surface(sphere_map, max_controls=-1)


@pytest.mark.parametrize("call", [
    lambda s: s.positions([[np.nan, 0, 0]]), lambda s: s.positions([[0, 0]]),
    lambda s: s.positions(([7], [[0.5, 0.5]])),
    lambda s: s.positions(([0], [[1.5, 0.5]])), lambda s: s.positions(([0, 1], [[0.5, 0.5]])),
    lambda s: s.derivatives([[1, 0, 0]], order=3), lambda s: s.tessellate(chord_error=0.0),
    lambda s: s.tessellate(subdivisions=0), lambda s: s.to_cad(-1.0),
    lambda s: s.to_cad().save_step("x", unit="ell")])
def test_wrong_arguments(surface, call):
    with pytest.raises(ValueError):
        call(surface)


def test_progress():
    seen = []
    sm.fit_surface(bumpy_sphere(10), progress=lambda phase, fraction: seen.append((phase, fraction)))
    assert len({phase for phase, _ in seen}) > 2 and all(0 <= fraction <= 1 for _, fraction in seen)
    sm.fit_surface(disk(8), progress=True)  # with tqdm or without


def test_an_exception_of_the_callback_cancels():
    class Enough(Exception):
        pass

    def stop(phase, fraction):
        raise Enough

    points, faces = bumpy_sphere(10)
    two = np.concatenate([points, points + 5]), np.concatenate([faces, faces + len(points)])
    seen = []
    assert len(sm.map_components(two, progress=lambda *call: seen.append(call))) == 2 and seen[-1] == ("map", 1)
    for work in (lambda: sm.map_mesh(bumpy_sphere(10), progress=stop),
                 lambda: sm.map_components(two, progress=stop),  # in threads
                 lambda: sm.fit_surface(sm.map_mesh(torus(12, 6)), progress=stop)):
        with pytest.raises(Enough):
            work()


def test_ctrl_c_ends_long_work():
    found = sm.map_mesh(bumpy_sphere(60))
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background jobs do not hear it
    timer = threading.Timer(0.2, lambda: signal.raise_signal(signal.SIGINT))
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        timer.start()
        while time.monotonic() < begin + 60:
            sm.fit_surface(found, rms_error=1e-6, max_controls=20000, target="facets")
    timer.join()


def test_other_threads_run_meanwhile(sphere_map):
    count, done = 0, threading.Event()

    def work():
        sm.fit_surface(sphere_map, rms_error=1e-5, max_controls=5000, target="facets")
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.is_set():
        count += 1
        time.sleep(0.001)
    thread.join()
    assert count > 10  # with the lock held, the loop would not be entered again before the end


def test_threads_do_not_disturb_each_other(surfaces):
    expected = {d: s.positions(s.random_domain_points(20000)) for d, s in surfaces.items()}
    results = {}

    def work(domain):
        s = surfaces[domain]
        results[domain] = [s.positions(s.random_domain_points(20000)) for _ in range(3)]

    threads = [threading.Thread(target=work, args=(d,)) for d in surfaces]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert all((r == expected[d]).all() for d in surfaces for r in results[d])
