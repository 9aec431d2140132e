"""Correspondences between shapes."""
import numpy as np
import pytest

import simple_manifolds as sm
from conftest import bumpy_sphere, disk, torus


@pytest.fixture(scope="module")
def pair():
    points, faces = bumpy_sphere(10)
    other, other_faces = bumpy_sphere(12)
    return sm.map_mesh((points, faces)), sm.map_mesh((other * [1.5, 1, 0.8], other_faces))


def test_landmarks_are_met(pair):
    a, b = pair
    directions = np.concatenate([np.eye(3), -np.eye(3)])
    landmarks = [(np.argmax(a.vertices @ d), np.argmax(b.vertices @ d)) for d in directions]
    c = sm.register_maps(a, b, landmarks, effort="fast")
    assert c.report.landmarks == 6 and c.source.certificate.is_valid and c.target.certificate.is_valid
    x = c.positions()
    for s, t in landmarks:
        assert np.abs(x[s] - b.vertices[t]).max() < 1e-9
    faces, weights = c.locations()
    assert np.abs((weights[:, :, None] * c.target.vertices[c.target.faces[faces]]).sum(axis=1) - x).max() < 1e-9
    assert c.distortion(2000).not_positive == 0 and c.distortion(2000).symmetric >= 1
    assert len(c.inverse().positions()) == len(b.vertices)


def test_morphs(pair):
    c = sm.register_maps(*pair, effort="fast")
    assert np.allclose(sm.morph(c, 0, align=False).vertices, c.source.vertices)
    assert np.allclose(sm.morph(c, 1, align=False).vertices, c.positions())
    half = sm.morph(c, 0.5)
    assert not sm.inspect_mesh(half).faults and len(half.vertices) == len(c.source.vertices)


def test_sets_of_shapes(pair):
    shapes = sm.register_shapes([*pair, sm.map_mesh(bumpy_sphere(9))], effort="fast", mean_iterations=1)
    assert len(shapes) == 3 and shapes[-1].certificate.is_valid
    mesh = shapes.common_mesh(0, chord_error=0.05).aligned()
    assert len(mesh.positions) == 3 and all(len(x) == len(mesh.positions[0]) for x in mesh.positions)
    assert mesh.faces.max() == len(mesh.positions[0]) - 1
    assert np.allclose(mesh.morph([1, 0, 0]), mesh.positions[0])
    assert len(shapes.correspondence(0, 2).positions()) == len(pair[0].vertices)
    with pytest.raises(IndexError):
        shapes[3]
    with pytest.raises(ValueError):
        mesh.morph([1, 0])


def test_wrong_arguments(pair):
    with pytest.raises(sm.TopologyError):
        sm.register_maps(pair[0], sm.map_mesh(torus(12, 6)))
    with pytest.raises(ValueError):
        sm.register_maps(*pair, [(0, 10**6)])
    with pytest.raises(ValueError):
        sm.register_maps(*pair, [(0, 2**32)])  # does not wrap round
    with pytest.raises(sm.NumericError) as e:
        sm.register_maps(*pair, [(0, 1), (0, 2)])
    assert e.value.code == "landmarks_not_met"
    with pytest.raises(ValueError):
        sm.register_shapes([])


@pytest.mark.parametrize("domain", ["torus", "plane"])
def test_tori_and_squares(domain):
    shapes = {"torus": (torus(24, 12), torus(20, 14), torus(22, 12)), "plane": (disk(15), disk(17), disk(13))}
    maps = [sm.map_mesh(shape) for shape in shapes[domain]]
    assert all(m.domain == domain for m in maps)
    c = sm.register_maps(*maps[:2], [(0, 0)], effort="fast")
    assert c.source.certificate.is_valid and c.target.certificate.is_valid
    assert np.abs(c.positions()[0] - maps[1].vertices[0]).max() < 1e-9
    assert c.report.kept in ("search", "given_maps_improved", "given_maps")
    assert isinstance(c.report.is_backwards, bool)
    assert c.distortion(2000).median < 1.5
    shapes = sm.register_shapes(maps, [[0, 0, 0]], effort="fast", mean_iterations=1)
    around = [shapes.correspondence(i, (i + 1) % 3) for i in range(3)]
    for i, step in enumerate(around):
        assert step.source.certificate.is_valid
        assert np.abs(step.positions()[0] - maps[(i + 1) % 3].vertices[0]).max() < 1e-9
    assert len(sm.morph(c, 0.5).vertices) == len(maps[0].vertices)
    with pytest.raises(sm.TopologyError):
        sm.Correspondence(maps[0], sm.map_mesh(bumpy_sphere(6)))


def test_what_is_registered_stays(pair):
    c = sm.register_maps(pair[0], pair[0], effort="fast")
    assert c.report.kept == "given_maps" and not c.report.is_backwards
    assert c.distortion(2000).max < 1 + 1e-6


def test_maps_lie_as_the_shape_says():
    points, faces = bumpy_sphere(10)
    points = points * [1.5, 1, 0.8] + 0.1 * points[:, [1, 2, 0]] ** 2
    a = sm.map_mesh((points, faces), position="shape")
    angle = 0.7
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    b = sm.map_mesh((7 * points @ turn.T + [1, 2, 3], faces), position="shape")
    assert np.abs(a.domain_points - b.domain_points).max() < 0.05
    with pytest.raises(ValueError):
        sm.map_mesh((points, faces), position="left")
