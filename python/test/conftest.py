"""Meshes that the tests are made of."""
import pathlib
import sys

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))  # tutorial.py
from tutorial import bumpy_sphere  # noqa: E402

import simple_manifolds as sm  # noqa: E402


def grid_triangles(rows, columns, wrap):
    """Triangles of a grid of vertices; wrap: it closes in both directions."""
    last = 0 if wrap else 1
    i, j = np.meshgrid(np.arange(rows - last), np.arange(columns - last), indexing="ij")
    at = lambda a, b: (a % rows) * columns + b % columns
    a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
    return np.concatenate([np.stack([a, b, c], axis=-1).reshape(-1, 3), np.stack([a, c, d], axis=-1).reshape(-1, 3)])


def torus(n=24, m=12, radius=0.4):
    u, v = np.meshgrid(np.arange(n) * 2 * np.pi / n, np.arange(m) * 2 * np.pi / m, indexing="ij")
    r = 1 + radius * np.cos(v)
    points = np.stack([r * np.cos(u), r * np.sin(u), radius * np.sin(v)], axis=-1).reshape(-1, 3)
    return points, grid_triangles(n, m, True)


def disk(n=15):
    x, y = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n), indexing="ij")
    points = np.stack([x, y, 0.3 * np.sin(2 * x) * np.cos(y)], axis=-1).reshape(-1, 3)
    return points, grid_triangles(n, n, False)


def plate(holes=2, subdivisions=2):
    """A plate of cubes with holes, as quadrilaterals: a closed surface whose genus is the number of holes."""
    solid = np.ones((2 * holes + 1, 3, 1), bool)
    solid[1::2, 1] = False
    for axis in range(3):
        solid = solid.repeat(subdivisions, axis=axis)
    padded = np.pad(solid, 1)
    quads = []
    for axis in range(3):
        a, b = [np.eye(3, dtype=int)[k] for k in ((axis + 1) % 3, (axis + 2) % 3)]
        step = np.eye(3, dtype=int)[axis]
        for cell in np.argwhere(padded):
            if not padded[tuple(cell + step)]:
                corner = cell + step
                quads.append([corner, corner + a, corner + a + b, corner + b])
            if not padded[tuple(cell - step)]:
                quads.append([cell, cell + b, cell + a + b, cell + a])
    points, inverse = np.unique(np.array(quads).reshape(-1, 3), axis=0, return_inverse=True)
    return points.astype(float), inverse.reshape(-1, 4)


@pytest.fixture(scope="session")
def sphere_map():
    return sm.map_mesh(bumpy_sphere(16), for_fitting=True)


@pytest.fixture(scope="session")
def surface(sphere_map):
    return sm.fit_surface(sphere_map, rms_error=2e-3)


@pytest.fixture(scope="session")
def surfaces(surface):
    """One over each canonical surface."""
    return {"sphere": surface, "torus": sm.fit_surface(torus()), "plane": sm.fit_surface(disk()),
            "hyperbolic": sm.fit_surface(plate(), rms_error=1e-2)}
