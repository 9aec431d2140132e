"""Maps to the canonical surfaces, and both ways through them."""
import numpy as np
import pytest

import simple_manifolds as sm
from conftest import bumpy_sphere, disk, plate, torus


@pytest.fixture(scope="module")
def maps(sphere_map):
    return {"sphere": sphere_map, "torus": sm.map_mesh(torus()), "plane": sm.map_mesh(disk()),
            "hyperbolic": sm.map_mesh(plate())}


@pytest.mark.parametrize("domain", ["sphere", "torus", "plane", "hyperbolic"])
def test_both_ways(maps, domain, tmp_path):
    found = maps[domain]
    assert found.domain == domain and found.certificate and "one to one" in str(found.certificate)
    assert found.genus == {"sphere": 0, "plane": 0, "torus": 1, "hyperbolic": 2}[domain]
    places = found.random_domain_points(500, seed=3)
    faces, weights = found.to_mesh(places)
    back = found.to_domain(faces, weights)
    if domain != "hyperbolic":  # there a point may have several names
        assert np.abs(back - places).max() < 1e-9
    x = (weights[:, :, None] * found.vertices[found.faces[faces]]).sum(axis=1)
    assert np.abs(x - found.positions(back)).max() < 1e-9
    # vertices are where the map says
    assert np.abs(found.positions(found.domain_points) - found.vertices).max() < 1e-12
    found.save(tmp_path / "map.ply")
    again = sm.load_map(tmp_path / "map.ply")
    assert (again.vertices == found.vertices).all() and (again.domain_points == found.domain_points).all()
    assert found.distortion().symmetric_dirichlet >= 1


def test_arrays_are_the_memory_of_the_map(sphere_map):
    a, b = sphere_map.vertices, sphere_map.vertices
    assert np.shares_memory(a, b) and not a.flags.writeable
    with pytest.raises(ValueError):
        a[0] = 0
    alive = sm.map_mesh(bumpy_sphere(6)).domain_points  # outlives the variable that it came from
    assert np.allclose(np.linalg.norm(alive, axis=1), 1)


def test_domain_points_need_not_be_normalised_nor_aligned(maps):
    places = maps["sphere"].random_domain_points(50)
    assert (maps["sphere"].positions(3 * places) - maps["sphere"].positions(places)).max() < 1e-12
    flat = maps["torus"].random_domain_points(50)
    shifted = np.frombuffer(np.concatenate([[0], flat.ravel()]).tobytes(), offset=8).reshape(-1, 2)
    assert (maps["torus"].positions(shifted) == maps["torus"].positions(flat)).all()
    assert np.abs(maps["torus"].positions(flat + 1) - maps["torus"].positions(flat)).max() < 1e-12


def test_options():
    mesh = bumpy_sphere(10)
    area = sm.map_mesh(mesh, energy="amips", energy_lambda=2.0).distortion()
    angle = sm.map_mesh(mesh, energy="amips", energy_lambda=0.01).distortion()
    assert angle.angle_mean < area.angle_mean and area.area_mean_abs_log10 < angle.area_mean_abs_log10
    assert sm.map_mesh(mesh, effort="quality").distortion().symmetric_dirichlet < 1.1
    points, faces = mesh
    holed = sm.map_mesh((points, faces[faces.max(axis=1) < len(points) - 1]), close_borders="all")  # no south pole
    assert holed.domain == "sphere" and holed.number_of_virtual_faces > 0


def test_corners_and_landmarks():
    n = 15
    corners = [0, n * (n - 1), n * n - 1, n - 1]
    found = sm.map_mesh(disk(n), corners=corners)
    assert (found.domain_points[corners] == [[0, 0], [1, 0], [1, 1], [0, 1]]).all()
    north = np.array([0.0, 0.0, 1.0])
    drawn = sm.map_mesh(bumpy_sphere(10), "sphere", landmarks=[(5, north, 100.0)])
    assert drawn.domain_points[5] @ north > 0.99
    for wrong in ({"corners": [0, 1, 2]}, {"corners": [0, 1, 2, n + 1]}, {"corners": [0, 0, 1, 2]},
                  {"corners": corners[::-1]}, {"corners": [0, n * n - 1, n - 1, n * (n - 1)]},
                  {"landmarks": [(0, north)]}, {"domain": "plane", "landmarks": [(10**6, [0.5, 0.5])]},
                  {"domain": "plane", "landmarks": [(0, [np.nan, 0.5])]}, {"domain": "cube"}, {"effort": "much"},
                  {"energy_lambda": 0.0}, {"area_floor": 2.0}):
        with pytest.raises(ValueError):
            sm.map_mesh(disk(n), **wrong)


def test_components():
    a, b = torus(12, 6), disk(5)
    points = np.concatenate([a[0], b[0], np.eye(3)])
    faces = np.concatenate([a[1], len(a[0]) + b[1]])
    found = sm.map_components((points, faces))
    assert [c.map.domain for c in found] == ["torus", "plane"] and [c.name for c in found] == ["part-1", "part-2"]
    assert (points[found[1].map.input_vertices] == found[1].map.vertices[:25]).all()
    assert len(sm.map_components((points, faces), max_components=1)) == 1
    points, faces = disk(7)  # with a hole
    inside = np.argmin(np.abs(points[faces].mean(axis=1)[:, :2]).max(axis=1))
    two = sm.map_components((np.concatenate([a[0], points]),
                             np.concatenate([a[1], len(a[0]) + np.delete(faces, inside, axis=0)])))
    assert two[1].map is None and two[1].error.code == "several_border_loops"
    assert isinstance(two[1].error, sm.TopologyError)


def test_maps_made_elsewhere():
    points, faces = bumpy_sphere(8)
    unit = points / np.linalg.norm(points, axis=1, keepdims=True)
    assert sm.make_map((points, faces), "sphere", unit).certificate.is_valid
    good = sm.certify("sphere", unit, faces)
    assert good and good.degree == pytest.approx(1)
    bad = unit.copy()
    bad[3] = -bad[3]
    assert not sm.certify("sphere", bad, faces) and sm.certify("sphere", bad, faces).flipped > 0
    with pytest.raises(sm.NumericError) as e:
        sm.make_map((points, faces), "sphere", bad)
    assert e.value.code == "map_not_bijective" and e.value.element[0] == "face"
    assert not sm.certify("sphere", unit * np.nan, faces) and not sm.certify("sphere", unit, [[0, 1, 10**6]])
    with pytest.raises(ValueError):
        sm.certify("cube", unit, faces)


@pytest.mark.parametrize("call", [
    lambda m: m.to_mesh([[np.nan, 0, 0]]), lambda m: m.to_mesh([[0, 0, 0]]), lambda m: m.to_mesh([[0, 0]]),
    lambda m: m.to_domain([10**6], [[1, 0, 0]]), lambda m: m.to_domain([-1], [[1, 0, 0]]),
    lambda m: m.to_domain([0], [[2, -1, 0]]), lambda m: m.to_domain([0], [[1, 1, 1]]),
    lambda m: m.to_domain([0, 1], [[1, 0, 0]])])
def test_wrong_arguments(sphere_map, call):
    with pytest.raises(ValueError):
        call(sphere_map)
