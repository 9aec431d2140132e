#!/usr/bin/env python3
"""From a mesh to a smooth surface and what can be asked of it. Usage: tutorial.py [MESH [FOLDER]]

Prints figures, which are those of the same steps in C++ (test/tutorial.cpp), and writes files into FOLDER. Without a
mesh it makes one: a sphere with bumps.
"""
import sys

import numpy as np

import simple_manifolds as sm


def bumpy_sphere(n=24):
    """A sphere with bumps, as points and triangles: what any program may hold."""
    theta = np.linspace(0, np.pi, n + 1)[1:-1]
    phi = np.linspace(0, 2 * np.pi, 2 * n, endpoint=False)
    t, p = np.meshgrid(theta, phi, indexing="ij")
    ring = np.stack([np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)], axis=-1).reshape(-1, 3)
    unit = np.concatenate([ring, [[0, 0, 1], [0, 0, -1]]])
    points = unit * (1 + 0.2 * np.prod(np.sin(3 * unit), axis=1))[:, None]
    at = np.arange(len(ring)).reshape(n - 1, 2 * n)
    a, b = at[:-1], np.roll(at[:-1], -1, axis=1)
    c, d = at[1:], np.roll(at[1:], -1, axis=1)
    top, bottom = np.full(2 * n, len(ring)), np.full(2 * n, len(ring) + 1)
    triangles = np.concatenate([
        np.stack([a, c, d], axis=-1).reshape(-1, 3), np.stack([a, d, b], axis=-1).reshape(-1, 3),
        np.stack([top, at[0], np.roll(at[0], -1)], axis=-1),
        np.stack([bottom, np.roll(at[-1], -1), at[-1]], axis=-1)])
    return points, triangles


def main(file=None, folder="."):
    # A mesh: from a file, repaired where it needs it; or arrays, or an object of trimesh, meshio, pyvista.
    mesh = sm.read_mesh(file) if file else bumpy_sphere()
    for component in sm.inspect_mesh(mesh).components:
        print(f"{component.name}: {component.faces} faces, {component}")

    # A map to the canonical surface of its genus: one to one, with a certificate that says so.
    mesh_map = sm.map_mesh(mesh, for_fitting=True)
    assert mesh_map.certificate.is_valid
    print("domain", mesh_map.domain)
    print(f"symmetric dirichlet {mesh_map.distortion().symmetric_dirichlet:.17g}")

    # Both ways between the mesh and the domain.
    places = mesh_map.random_domain_points(1000)
    faces, barycentric = mesh_map.to_mesh(places)
    back = mesh_map.to_domain(faces, barycentric)
    assert np.abs(back - places).max() < 1e-9

    # A smooth surface, within a thousandth of the diagonal of the mesh.
    surface = sm.fit_surface(mesh_map, rms_error=1e-3)
    print("controls", surface.report.controls)
    print(f"rms error {surface.report.rms_error:.17g}")
    print(f"max error {surface.report.max_error:.17g}")

    # Everything that calculus knows of it, for as many points as you like at once.
    curvature = surface.curvatures(places)
    print(f"largest mean curvature {curvature.mean.max():.17g}")
    print(f"least gaussian curvature {curvature.gaussian.min():.17g}")
    x = surface.positions(places)
    closest = surface.closest_points(x + 1e-3 * mesh_map.diagonal * surface.normals(places))
    print(f"largest distance {closest.signed_distances.max():.17g}")

    # Files for other programs.
    tessellation = surface.tessellate(chord_error=1e-3)
    print("triangles", len(tessellation.faces))
    tessellation.save(f"{folder}/surface.glb")
    surface.save(f"{folder}/surface.json")
    cad = surface.to_cad()
    print("CAD faces", cad.report.faces, "controls", cad.report.controls)
    cad.save_step(f"{folder}/surface.step")


if __name__ == "__main__":
    main(*sys.argv[1:])
