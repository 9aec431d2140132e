"""Meshes as they come: of this package, of trimesh, meshio or pyvista, or as arrays."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from . import _core


@dataclass(eq=False)
class Mesh:
    """Points and faces, with what a file or a repair says of them.

    `faces` is an array of shape (m, k) where all faces have k corners, else a list of arrays.
    """

    vertices: np.ndarray
    faces: Any
    vertex_properties: dict[str, np.ndarray] = field(default_factory=dict)
    face_properties: dict[str, np.ndarray] = field(default_factory=dict)
    unit: str = ""
    warnings: list[str] = field(default_factory=list)
    repair: _core.RepairReport | None = None

    def __repr__(self) -> str:
        return f"<simple_manifolds.Mesh of {len(self.vertices)} vertices and {len(self.faces)} faces>"


def integers(array: Any, name: str, limit: int = 2**31) -> np.ndarray:
    """Positions below a limit as 32 bits; -1 for what is none, so that nothing wraps round."""
    array = np.asarray(array)
    if array.size == 0:
        return array.astype(np.int32)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} has to be an array of integers, not of {array.dtype}")
    if array.dtype != np.int32:
        array = np.where((array < 0) | (array >= max(limit, 1)), -1, array)
    return np.ascontiguousarray(array, dtype=np.int32)


def _polygons(faces: Any, vertices: int) -> tuple[np.ndarray, np.ndarray]:
    """(corners, sizes) of faces: an array of shape (m, k), a list of sequences, or [k, v1, ..., vk, k, ...]."""
    if isinstance(faces, np.ndarray) and faces.ndim == 2 or not isinstance(faces, np.ndarray) and _is_table(faces):
        table = integers(faces, "faces", vertices)
        return table.reshape(-1), np.full(table.shape[0], table.shape[1], np.int32)
    if isinstance(faces, np.ndarray) and faces.dtype != object:  # the flat list of VTK and pyvista
        flat = np.asarray(faces)
        if flat.ndim != 1 or flat.size and flat.dtype.kind not in "iu":
            raise TypeError("faces has to be an array of integers of shape (m, k), or a list of faces")
        starts, at = [], 0
        while at < flat.size:
            starts.append(at)
            at += int(flat[at]) + 1
            if flat[starts[-1]] < 0 or at > flat.size:
                raise ValueError("faces is no list [k, v1, ..., vk, k, ...]")
        sizes = flat[starts].astype(np.int32) if starts else np.zeros(0, np.int32)
        return integers(np.delete(flat, starts), "faces", vertices), sizes
    faces = [np.asarray(f) for f in faces]
    sizes = np.array([f.size for f in faces], np.int32)
    corners = np.concatenate(faces) if faces else np.zeros(0, np.int32)
    return integers(corners, "faces", vertices), sizes


def _is_table(faces: Any) -> bool:
    try:
        return len({len(f) for f in faces}) == 1
    except TypeError:
        return np.ndim(faces) == 2


def arrays(mesh: Any) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(points, corners, sizes) of a mesh: a pair (points, faces), or an object that has `vertices` and `faces` (this
    package, trimesh), `points` and `cells_dict` (meshio), or `points` and `faces` (pyvista)."""
    if isinstance(mesh, (tuple, list)):
        if len(mesh) != 2:
            raise TypeError("a mesh is a pair (points, faces), or an object that has both")
        points, faces = mesh
    elif hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        points, faces = mesh.vertices, mesh.faces
    elif hasattr(mesh, "points") and hasattr(mesh, "cells_dict"):
        points, faces = mesh.points, None
    elif hasattr(mesh, "points") and hasattr(mesh, "faces"):
        points, faces = mesh.points, mesh.faces
    else:
        raise TypeError(f"{type(mesh).__name__} has neither vertices and faces nor points and cells")
    points = np.ascontiguousarray(points, dtype=np.float64)
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError("the points have to be an array of shape (n, 3)")
    if faces is None:
        parts = [_polygons(np.asarray(mesh.cells_dict[kind]), len(points))
                 for kind in ("triangle", "quad", "polygon") if kind in mesh.cells_dict]
        if not parts:
            raise ValueError("the mesh has neither triangles nor quads")
        return points, np.concatenate([p[0] for p in parts]), np.concatenate([p[1] for p in parts])
    return (points, *_polygons(faces, len(points)))


def faces_of(corners: np.ndarray, sizes: np.ndarray) -> Any:
    """The faces of a `Mesh`."""
    if len(sizes) == 0:
        return np.zeros((0, 3), np.int32)
    if (sizes == sizes[0]).all():
        return corners.reshape(-1, sizes[0])
    return np.split(corners, np.cumsum(sizes)[:-1])


def triangles(mesh: Any) -> tuple[np.ndarray, np.ndarray, _core.InputIndices]:
    """(points, triangles, which faces they are parts of), as maps want them."""
    points, corners, sizes = arrays(mesh)
    if (sizes == 3).all():
        return points, corners.reshape(-1, 3), _core.InputIndices([], [])
    cut, polygons = _core.triangulate(points, corners, sizes)
    return points, cut, _core.InputIndices([], polygons.tolist())


def border_from(faces: np.ndarray, vertex: int) -> list[int]:
    """The border loop of a triangle mesh on which a vertex lies, from there counterclockwise; empty if on none."""
    edges = faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2).astype(np.int64)
    size = edges.max(initial=0) + 1
    both = np.isin(edges @ [size, 1], edges @ [1, size])
    after = dict(edges[~both].tolist())
    loop = [vertex] if vertex in after else []
    while loop and after.get(loop[-1], vertex) != vertex and len(loop) <= len(after):
        loop.append(after[loop[-1]])
    return loop
