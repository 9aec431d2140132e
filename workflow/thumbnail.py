#!/usr/bin/env python3
"""Usage: thumbnail.py SURFACE.ply PICTURE.png

A small picture of a surface as fit_mesh writes it, tinted by chart. Needs numpy and nothing else: the triangles are
filled by points, as many as they have pixels, and of the points of a pixel the nearest is seen.
"""
import importlib.machinery
import importlib.util
import pathlib
import sys

import numpy as np

SIZE, SAMPLES = 192, 2  # pixels; per pixel and direction

_path = str(pathlib.Path(__file__).resolve().parent.parent / "scripts" / "picture")  # has no extension
_spec = importlib.util.spec_from_loader("picture", importlib.machinery.SourceFileLoader("picture", _path))
picture = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(picture)


def points_in_triangles(corners):
    """(triangle, barycentric coordinates) of points that leave no pixel out; corners in pixels, shape (n, 3, 2)."""
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    steps = np.maximum(np.ceil(longest * 1.3).astype(int), 1)
    triangles, weights = [], []
    for n in np.unique(steps):
        i, j = np.meshgrid(np.arange(n + 1), np.arange(n + 1))
        b = np.stack([i, j, n - i - j], axis=-1)[i + j <= n] / n
        of = np.flatnonzero(steps == n)
        triangles.append(np.repeat(of, len(b)))
        weights.append(np.tile(b, (len(of), 1)))
    return np.concatenate(triangles), np.concatenate(weights)


def render(points, triangles, colours, normals):
    """An image of SIZE x SIZE x 3 values in [0,1]; the view of scripts/picture."""
    n = SIZE * SAMPLES
    view = (180 + 25, 10)
    xyz = picture.turn(points, *view)
    low, high = xyz.min(axis=0), xyz.max(axis=0)
    scale = 0.92 * n / max((high - low)[:2].max(), 1e-300)
    pixels = (xyz - (low + high) / 2)[:, :2] * [scale, -scale] + n / 2
    a, b, c = (xyz[triangles[:, k]] for k in range(3))
    seen = np.cross(b - a, c - a)[:, 2] > 0
    triangles, colours = triangles[seen], colours[seen]
    image = np.ones((n, n, 3))
    if len(triangles):
        f, b = points_in_triangles(pixels[triangles])
        mix = lambda values: (b[:, :, None] * values[triangles[f]]).sum(axis=1)
        place = np.clip(mix(pixels).astype(int), 0, n - 1)
        order = np.argsort(mix(xyz[:, 2:])[:, 0], kind="stable")  # the nearest is drawn last
        normal = mix(picture.turn(normals, *view))
        normal /= np.linalg.norm(normal, axis=1, keepdims=True) + 1e-300
        lights = ((np.array([-0.4, 0.6, 0.7]), 0.65), (np.array([0.8, 0.1, 0.5]), 0.25))
        shade = 0.22 + sum(share * np.clip(normal @ (l / np.linalg.norm(l)), 0, None) for l, share in lights)
        colour = np.clip(shade[:, None] * colours[f], 0, 1)
        image[place[order, 1], place[order, 0]] = colour[order]
    return image.reshape(SIZE, SAMPLES, SIZE, SAMPLES, 3).mean(axis=(1, 3))


def thumbnail(file, target):
    _, vertices, triangles, faces = picture.read_ply(str(file))
    tints = 0.55 * picture.GREY + 0.45 * picture.CHART_COLOURS[faces["chart"] % len(picture.CHART_COLOURS)]
    picture.write_png(str(target), render(picture.columns(vertices, "x", "y", "z"), triangles, tints,
                                          picture.columns(vertices, "nx", "ny", "nz")))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    thumbnail(*sys.argv[1:])
