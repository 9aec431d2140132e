"""Meshes of every kind come in; what is wrong with them is said."""
import types

import numpy as np
import pytest

import simple_manifolds as sm
from conftest import bumpy_sphere, disk, plate, torus


def write_off(path, points, faces):
    with open(path, "w") as file:
        print("OFF", len(points), len(faces), 0, file=file)
        for p in points:
            print(*(repr(float(x)) for x in p), file=file)
        for f in faces:
            print(len(f), *f, file=file)


def test_a_file_is_read_to_the_last_bit(tmp_path):
    points, faces = bumpy_sphere(8)
    write_off(tmp_path / "mesh.off", points, faces)
    mesh = sm.read_mesh(tmp_path / "mesh.off")
    assert (mesh.vertices == points).all() and (mesh.faces == faces).all()
    assert not mesh.repair.has_changes and not mesh.warnings


def test_properties_of_files(tmp_path):
    (tmp_path / "mesh.ply").write_text(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
        "property float heat\nproperty int label\nelement face 4\nproperty list uchar int vertex_indices\n"
        "end_header\n"
        "0 0 0 0.5 3\n1 0 0 1.5 4\n0 1 0 2.5 5\n0 0 1 3.5 6\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
    mesh = sm.read_mesh(tmp_path / "mesh.ply")
    assert mesh.vertex_properties["heat"].tolist() == [0.5, 1.5, 2.5, 3.5]
    assert mesh.vertex_properties["label"].tolist() == [3, 4, 5, 6]
    assert mesh.vertex_properties["label"].dtype == np.int64


def test_a_repair_says_what_it_did():
    points, faces = disk(6)
    soup = points[faces].reshape(-1, 3)  # each triangle has corners of its own
    mesh = sm.repair_mesh((soup, np.arange(len(soup)).reshape(-1, 3)))
    assert len(mesh.vertices) == len(points) and len(mesh.faces) == len(faces)
    assert mesh.repair.has_changes and "welded" in str(mesh.repair)
    assert mesh.repair.welded.count == len(soup) - len(points)
    assert (soup[mesh.repair.input_vertices] == mesh.vertices).all()


def test_options_of_repairs():
    points, faces = bumpy_sphere(6)
    turned = sm.repair_mesh((points, faces[:, ::-1]), sm.RepairOptions(face_orientation="outward"))
    assert turned.repair.flipped.count == len(faces)
    book = ([[0, 0, 0], [0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, -1, 0]], [[0, 1, 2], [1, 0, 3], [0, 1, 4]])
    with pytest.raises(sm.TopologyError) as e:
        sm.repair_mesh(book)
    assert e.value.code == "non_manifold_edge"
    assert sm.repair_mesh(book, sm.RepairOptions.everything()).repair.cut_edges.count > 0
    with pytest.raises(ValueError, match="debris_share"):
        sm.RepairOptions(debris_share=2)


def test_inspection_takes_anything():
    two = np.concatenate([torus(12, 6)[0], 3 + bumpy_sphere(6)[0]])
    faces = np.concatenate([torus(12, 6)[1], 72 + bumpy_sphere(6)[1]])
    found = sm.inspect_mesh((two, faces))
    assert [c.genus for c in found.components] == [1, 0] or [c.genus for c in found.components] == [0, 1]
    assert {c.canonical_surface() for c in found.components} == {"torus", "sphere"}
    assert found.faces == len(faces) and not found.faults and found.box.shape == (2, 3)
    bad = sm.inspect_mesh((np.arange(15).reshape(5, 3), [[0, 1, 2], [0, 1, 3], [0, 1, 4]]))
    assert bad.faults and bad.faults.non_manifold_edges.count == 1 and bad.components[0].genus is None
    assert sm.inspect_mesh((np.zeros((0, 3)), np.zeros((0, 3), int))).faces == 0


class Like_trimesh:
    def __init__(self, points, faces):
        self.vertices, self.faces = points, faces


class Like_pyvista:
    def __init__(self, points, faces):
        self.points = points.astype(np.float32)
        self.faces = np.concatenate([[len(f), *f] for f in faces])


def like_meshio(points, faces):
    kind = "triangle" if faces.shape[1] == 3 else "quad"
    try:
        import meshio
    except ImportError:
        return types.SimpleNamespace(points=points, cells_dict={kind: faces})
    return meshio.Mesh(points, [(kind, faces)])


@pytest.mark.parametrize("make", [Like_trimesh, Like_pyvista, like_meshio, lambda p, f: (p.tolist(), f.tolist()),
                                  lambda p, f: (p, [list(x) for x in f]), lambda p, f: (p, f.astype(np.uint64)),
                                  lambda p, f: (p[:, ::-1].copy()[:, ::-1], np.asfortranarray(f))])
@pytest.mark.parametrize("shape", [lambda: bumpy_sphere(8), lambda: plate(0)])
def test_meshes_of_other_packages(make, shape):
    points, faces = shape()
    found = sm.map_mesh(make(points, faces))
    assert found.domain == "sphere" and found.certificate.is_valid
    assert np.allclose(found.vertices[:len(points)], points, atol=1e-6)
    assert sorted(set(found.input_faces)) == list(range(len(faces)))


def test_faces_of_several_sizes():
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1]], float)
    faces = [[3, 2, 1, 0], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]
    found = sm.map_mesh((points, faces))
    assert len(found.faces) == 6 and sorted(found.input_faces) == [0, 0, 1, 2, 3, 4]
    assert [len(f) for f in sm.repair_mesh((points, faces)).faces] == [4, 3, 3, 3, 3]


def test_errors_have_fields(tmp_path):
    with pytest.raises(sm.FileError) as e:
        sm.read_mesh(tmp_path / "none.off")
    assert e.value.code == "cannot_open" and e.value.file.endswith("none.off") and e.value.line is None
    (tmp_path / "bad.off").write_text("OFF 3 1 0\n0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n")
    with pytest.raises(sm.Error) as e:
        sm.read_mesh(tmp_path / "bad.off")
    assert isinstance(e.value, sm.FileError) and e.value.code == "syntax_error" and e.value.line == 3
    with pytest.raises(sm.TopologyError) as e:
        sm.map_mesh(disk(5), "sphere")
    assert e.value.code == "not_closed" and e.value.element is None
    points, faces = bumpy_sphere(6)
    points[7, 1] = np.nan
    with pytest.raises(sm.GeometryError) as e:
        sm.map_mesh((points, faces))
    assert e.value.code == "non_finite_coordinate" and e.value.element == ("vertex", 7)


@pytest.mark.parametrize("mesh, error", [
    (3, TypeError), (([[0, 0]], [[0, 0, 0]]), ValueError), ((np.eye(3), [[0.5, 1, 2]]), TypeError),
    ((np.eye(3), [[0, 1, 3]]), sm.TopologyError), ((np.eye(3), [[0, 1, 2 + 2**32]]), sm.TopologyError),
    ((np.eye(3), [[0, 1, -1]]), sm.TopologyError), ((np.eye(3), np.array([3, 0, 1])), ValueError),
    ((np.eye(3), np.zeros((0, 3), int)), sm.TopologyError), ((np.eye(3), []), sm.TopologyError),
    ((np.eye(3), [[0, 1]]), sm.TopologyError), ((np.eye(4, 3), [[0, 1, 2, 2], [0, 1, 2, 3]]), sm.TopologyError)])
def test_nonsense_is_refused(mesh, error):
    with pytest.raises(error):
        sm.map_mesh(mesh)
