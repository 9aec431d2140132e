"""Smooth surfaces over simple manifolds: meshes to maps to surfaces.

    import simple_manifolds as sm
    mesh = sm.read_mesh("hand.off")                # or any mesh of trimesh, meshio, pyvista, or (points, faces)
    surface = sm.fit_surface(mesh, rms_error=1e-3) # twice differentiable; surface.report says how well it fits
    points = surface.random_domain_points(1000)
    surface.positions(points), surface.normals(points), surface.curvatures(points).mean
    surface.tessellate(chord_error=1e-3).save("hand.glb")
    surface.to_cad().save_step("hand.step")

Lengths that are tolerances are fractions of the diagonal of the bounding box. Bad data raise an `Error`, which says
what is wrong and where; arguments that make no sense raise ValueError or TypeError.

Long functions take `progress`: True shows a bar of tqdm where it is installed, a function is called with the name of
the phase and its share that is done; an exception that it raises cancels the work, as ctrl-C does. Meanwhile other
threads of Python run. Results do not depend on the number of threads.
"""
from __future__ import annotations

from os import PathLike, fspath
from typing import Any, NamedTuple, Optional, Sequence, Union

import numpy as np

from . import _core, _meshes
from ._core import (BorderLoop, CadReport, CadSurface, Certificate, CommonMesh, Correspondence,
                    CorrespondenceDistortion, Distortion, Error, FileError, FitReport, GeometryError,
                    InspectedComponent, LocatedElements, Map, MeshInspection, NumericError, RegistrationReport,
                    RepairOptions, RepairReport, ShapeSet, Surface, SurfaceFaults, Tessellation, TopologyError)
from ._meshes import Mesh
from ._progress import Progress, callback as _callback

__all__ = [
    "BorderLoop", "CadReport", "CadSurface", "Certificate", "ClosestPoints", "CommonMesh", "Component",
    "Correspondence", "CorrespondenceDistortion", "Curvatures", "Derivatives", "Distortion", "Error", "FileError",
    "FitReport", "GeometryError", "InspectedComponent", "LocatedElements", "Map", "Mesh", "MeshInspection",
    "NumericError", "RegistrationReport", "RepairOptions", "RepairReport", "ShapeSet", "Surface", "SurfaceFaults",
    "Tessellation", "TopologyError", "certify", "fit_cad_surface", "fit_surface", "inspect_mesh", "load_map",
    "load_surface", "make_map", "map_components", "map_mesh", "morph", "read_mesh", "register_maps",
    "register_shapes", "repair_mesh",
]

Points = Union[np.ndarray, Sequence[Sequence[float]], tuple]

# The options of maps to which a surface is going to be fitted: angles before areas.
_FOR_FITTING = {"energy": "amips", "energy_lambda": 0.1, "area_floor": 0.02}


class Component(NamedTuple):
    """A connected component of a mesh, with its map or the error that says why there is none."""
    name: str
    vertices: np.ndarray
    faces: np.ndarray
    map: Optional[Map]
    error: Optional[Error]


class Derivatives(NamedTuple):
    """Positions and derivatives by the coordinates (u, v) of a chart, each of shape (n, 3)."""
    position: np.ndarray
    du: np.ndarray
    dv: np.ndarray
    duu: Optional[np.ndarray]
    duv: Optional[np.ndarray]
    dvv: Optional[np.ndarray]


class Curvatures(NamedTuple):
    """Principal curvatures k1 >= k2, 1/length, positive on a sphere with outward normals; unit tangents."""
    k1: np.ndarray
    k2: np.ndarray
    mean: np.ndarray
    gaussian: np.ndarray
    direction1: np.ndarray
    direction2: np.ndarray


class ClosestPoints(NamedTuple):
    """The points of a surface that are closest to given ones; signed distances are negative inside."""
    domain_points: np.ndarray
    points: np.ndarray
    distances: np.ndarray
    signed_distances: np.ndarray


# ---- Meshes -------------------------------------------------------------------------------------------


def _repair_options(repair: Union[bool, RepairOptions]) -> Optional[RepairOptions]:
    if repair is False:
        return None
    return RepairOptions() if repair is True else repair


def read_mesh(file: Union[str, PathLike], repair: Union[bool, RepairOptions] = True) -> Mesh:
    """Reads OFF, OBJ, PLY, STL, VTK, GIfTI, FreeSurfer, 3MF, COLLADA or glTF, compressed by gzip or not.

    repair: True does what cannot change the object (welds borders that coincide, drops degenerate and duplicate
      faces, orients faces consistently), RepairOptions what they say; the result is an oriented manifold. False takes
      the faces as they stand, for inspect_mesh().
    Raises FileError; TopologyError or GeometryError when the repair leaves no oriented manifold.
    """
    read = _core.read(fspath(file), _repair_options(repair))
    points, corners, sizes = read["arrays"]
    return Mesh(points, _meshes.faces_of(corners, sizes), read["vertex_properties"], read["face_properties"],
                read["unit"], read["warnings"], read["repair"] if repair is not False else None)


def repair_mesh(mesh: Any, options: Optional[RepairOptions] = None) -> Mesh:
    """Mends a mesh; `repair` of the result says what was done, and which elements of the input are left.

    Raises TopologyError or GeometryError when what is left is no oriented manifold.
    """
    (points, corners, sizes), report = _core.repair(*_meshes.arrays(mesh), options or RepairOptions())
    return Mesh(points, _meshes.faces_of(corners, sizes), repair=report)


def inspect_mesh(mesh: Any) -> MeshInspection:
    """Tells what a mesh is, whatever it is: components, borders, genus, faults."""
    return _core.inspect(*_meshes.arrays(mesh))


# ---- Maps ---------------------------------------------------------------------------------------------


def _map_options(energy: Optional[str], energy_lambda: Optional[float], area_floor: Optional[float], effort: str,
                 position: str, close_borders: str, for_fitting: bool) -> dict:
    options = {"energy": "symmetric_dirichlet", "energy_lambda": 0.3, "area_floor": 0.05}
    if for_fitting:
        options.update(_FOR_FITTING)
    given = {"energy": energy, "energy_lambda": energy_lambda, "area_floor": area_floor}
    options.update({key: value for key, value in given.items() if value is not None})
    return {**options, "effort": effort, "position": position, "close_borders": close_borders}


def map_mesh(mesh: Any, domain: str = "auto", *, energy: Optional[str] = None, energy_lambda: Optional[float] = None,
             area_floor: Optional[float] = None, effort: str = "default", position: str = "none",
             close_borders: str = "none", corners: Sequence[int] = (), landmarks: Sequence[tuple] = (),
             for_fitting: bool = False, progress: Progress = None) -> Map:
    """Maps a mesh one to one onto a canonical surface; every map is certified.

    mesh: a Mesh, any object with vertices and faces (trimesh), points and cells_dict (meshio), points and faces
      (pyvista), or a pair (points, faces).
    domain: 'auto', or 'plane' (the unit square, for disks), 'sphere', 'torus', 'hyperbolic' (genus 2 or more).
    energy: 'symmetric_dirichlet' or 'amips' with energy_lambda, the weight of areas; area_floor: share of uniform
      area in the target areas. for_fitting: other defaults of these three, which suit surfaces.
    position: how the map lies, without corners or landmarks: 'none', 'shape' (by the shape's own moments, so that noise
      and motions do not turn it) or 'space' (the sphere by the axes of space).
    effort: 'fast', 'default' or 'quality'. close_borders: 'none', 'small', 'inner' or 'all'.
    corners: four vertices of the border of a disk, counterclockwise. landmarks: (vertex, point of the domain) or
      (vertex, point, weight), towards which the map is drawn; they need a domain.
    Raises TopologyError, GeometryError, NumericError.
    """
    if domain == "square":
        domain = "plane"
    if domain not in ("auto", "plane", "sphere", "torus", "hyperbolic"):
        raise ValueError(f"domain is {domain!r}, not one of auto, plane, sphere, torus, hyperbolic")
    options = _map_options(energy, energy_lambda, area_floor, effort, position, close_borders, for_fitting)
    points, triangles, outer = _meshes.triangles(mesh)
    if len(corners) not in (0, 4):
        raise ValueError("corners are four vertices")
    if len(corners) and domain not in ("auto", "plane"):
        raise ValueError("only the square has corners")
    corner_list = [int(v) for v in corners]
    if corner_list:
        border = _meshes.border_from(triangles, corner_list[0])
        missing = [v for v in corner_list if v not in border]
        if missing:
            raise ValueError(f"vertex {missing[0]} is not on the border")
        if sorted(set(corner_list), key=border.index) != corner_list:
            raise ValueError("the corners have to be different vertices in counterclockwise order")
    if len(landmarks) and domain not in ("plane", "sphere", "torus"):
        raise ValueError("landmarks need a domain: 'plane', 'sphere' or 'torus'")
    marked = [int(l[0]) for l in landmarks]
    for v in marked:
        if not (triangles == v).any():
            raise ValueError(f"vertex {v} is of no face")
    with _callback(progress) as report:
        return _core.map(points, triangles, outer, domain, options, corner_list, np.array(marked, np.int32),
                         np.array([np.asarray(l[1], float) for l in landmarks]),
                         np.array([l[2] if len(l) > 2 else 1.0 for l in landmarks], float), report)


def map_components(mesh: Any, *, max_components: Optional[int] = None, energy: Optional[str] = None,
                   energy_lambda: Optional[float] = None, area_floor: Optional[float] = None, effort: str = "default",
                   position: str = "none", close_borders: str = "none", for_fitting: bool = False,
                   progress: Progress = None) -> list[Component]:
    """Maps each connected component by itself; the error of one does not lose the others. See map_mesh()."""
    options = _map_options(energy, energy_lambda, area_floor, effort, position, close_borders, for_fitting)
    points, triangles, outer = _meshes.triangles(mesh)
    with _callback(progress) as report:
        found = _core.map_components(points, triangles, outer, options, max_components, report)
    return [Component(*component) for component in found]


def _genus(points: int, triangles: np.ndarray) -> int:
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    euler = len(np.unique(triangles)) - len(np.unique(edges, axis=0)) + len(triangles)
    return (2 - euler) // 2


def make_map(mesh: Any, domain: str, domain_points: Points) -> Map:
    """A map that was made elsewhere: a point of the domain per vertex of a triangle mesh.

    Raises TopologyError when the mesh does not suit the domain, NumericError when the map is not one to one.
    """
    points, triangles, _ = _meshes.triangles(mesh)
    return _core.make_map("plane" if domain == "square" else domain, points, triangles, domain_points,
                          _genus(len(points), triangles))


def certify(domain: str, domain_points: Points, faces: Any) -> Certificate:
    """Examines any map of a triangle mesh, by exact signs. `domain_points`: one per vertex."""
    domain_points = np.asarray(domain_points, float)
    triangles = _meshes.integers(faces, "faces", len(domain_points))
    return _core.certify("plane" if domain == "square" else domain, domain_points, triangles,
                         _genus(len(domain_points), triangles))


def load_map(file: Union[str, PathLike]) -> Map:
    """Reads a map that Map.save() or map_mesh has written; it is certified anew."""
    return _core.load_map(fspath(file))


# ---- Surfaces -----------------------------------------------------------------------------------------


def fit_surface(mesh_or_map: Any, rms_error: float = 2e-3, max_error: Optional[float] = None, *, degree: int = 3,
                max_controls: Optional[int] = None, refinement: str = "adaptive", joint_solve: str = "at_end",
                marking: str = "all_points", target: str = "automatic", fit_effort: str = "fast",
                crease_angle: float = 40.0, fairness: Optional[float] = None, noise_level: float = 0.0,
                vertex_weights: Optional[Sequence[float]] = None, progress: Progress = None) -> Surface:
    """Fits a smooth surface to a map, or to a mesh, which is mapped for it.

    rms_error, max_error: tolerances, fractions of the diagonal; the second is 10 times the first by default.
    degree: of the splines, 2..5. max_controls: limit; None: four for each vertex, from 10,000 to 200,000.
    refinement: 'adaptive' or 'uniform'. joint_solve: 'at_end', 'always' or 'never'. marking: 'all_points' or
      'vertices'.
    target: 'automatic', 'curved' or 'facets': what the mesh says of the surface. fit_effort: 'fast' or 'compact',
      which has far fewer controls for the same distance. crease_angle: degrees.
    noise_level: how far the vertices are from where they should be, of the diagonal: what the surface does not follow.
    fairness: from 0 to 1, 0.003 with a noise_level, else 0.
    vertex_weights: one per vertex of the map.
    The surface is returned also where the tolerances are not reached: surface.report says so.
    """
    options = {"rms_error": rms_error, "max_error": max_error, "degree": degree, "max_controls": max_controls,
               "refinement": refinement, "joint_solve": joint_solve, "marking": marking, "target": target,
               "fit_effort": fit_effort, "crease_angle": crease_angle, "fairness": fairness,
               "noise_level": noise_level,
               "vertex_weights": vertex_weights}
    is_map = isinstance(mesh_or_map, Map)
    map_ = mesh_or_map if is_map else map_mesh(mesh_or_map, for_fitting=True, progress=progress)
    with _callback(progress) as report:
        return _core.fit(map_, options, report)


def fit_cad_surface(mesh_or_map: Any, rms_error: float = 2e-3, max_error: Optional[float] = None, *,
                    face_cost: float = 500.0, max_faces: int = 0, max_controls: int = 200000,
                    progress: Progress = None) -> CadSurface:
    """Fits few B-spline faces to a map or a mesh directly: fewer than Surface.to_cad() needs."""
    is_map = isinstance(mesh_or_map, Map)
    map_ = mesh_or_map if is_map else map_mesh(mesh_or_map, for_fitting=True, progress=progress)
    with _callback(progress) as report:
        return _core.map_to_cad(map_, rms_error, max_error, face_cost, max_faces, max_controls, report)


def load_surface(file: Union[str, PathLike]) -> Surface:
    """Reads a surface that Surface.save() or fit_mesh has written, JSON or CBOR."""
    return _core.load_surface(fspath(file))


def _positions(self: Surface, points: Points) -> np.ndarray:
    """Positions at points of the domain, shape (n, 3); or at chart points, a pair (charts, uv)."""
    return _core.positions(self, points)


def _normals(self: Surface, points: Points) -> np.ndarray:
    """Unit normals, shape (n, 3)."""
    return _core.normals_of_jets(_core.jets(self, points, 1))


def _derivatives(self: Surface, points: Points, order: int = 2) -> Derivatives:
    """Positions with first (order=1) or first and second derivatives, by the coordinates of the given charts, or of
    the best charts of points of the domain: see chart_points()."""
    jets = _core.jets(self, points, order)
    parts = [jets[:, k] for k in range(6)]
    return Derivatives(*parts[:3], *(parts[3:] if order == 2 else (None,) * 3))


def _curvatures(self: Surface, points: Points) -> Curvatures:
    """Principal curvatures and directions, mean and Gaussian curvature."""
    return Curvatures(*_core.curvatures_of_jets(_core.jets(self, points, 2)))


def _closest_points(self: Surface, points: Points) -> ClosestPoints:
    """The points of the surface closest to points of space, shape (n, 3). What is needed to search is kept."""
    return ClosestPoints(*_core.closest_points(self, points))


def _tessellate(self: Surface, *, chord_error: Optional[float] = None, edge_length: Optional[float] = None,
                subdivisions: Optional[int] = None, max_faces: Optional[int] = None) -> Tessellation:
    """A watertight triangle mesh.

    chord_error: largest distance of faces from the surface, a fraction of the diagonal; edge_length: of the longest
      edge, likewise. With either the mesh is adaptive, up to max_faces; with none it is a grid of subdivisions per
      tile.
    """
    return _core.tessellate(self, chord_error, edge_length, subdivisions, max_faces)


def _to_cad(self: Surface, tolerance: float = 1e-3, *, face_cost: float = 500.0, max_faces: int = 0,
            max_controls: int = 200000, progress: Progress = None) -> CadSurface:
    """Few B-spline faces within a distance of the surface, a fraction of the diagonal."""
    with _callback(progress) as report:
        return _core.surface_to_cad(self, tolerance, face_cost, max_faces, max_controls, report)


def _charted_mesh(self: Map) -> Tessellation:
    """The mesh of the map with its places in the charts, for files."""
    return _core.charted_mesh(self)


for _class, _function in (*((Surface, f) for f in (_positions, _normals, _derivatives, _curvatures, _closest_points,
                                                   _tessellate, _to_cad)), (Map, _charted_mesh)):
    _function.__name__ = _function.__name__[1:]
    _function.__qualname__ = f"{_class.__name__}.{_function.__name__}"
    setattr(_class, _function.__name__, _function)


# ---- Registration -------------------------------------------------------------------------------------


def register_maps(source: Map, target: Map, landmarks: Any = (), *, effort: str = "default", fix_target: bool = False,
                  progress: Progress = None) -> Correspondence:
    """The one to one map between two shapes with little distortion, from their maps to the sphere, torus or square.

    landmarks: pairs (vertex of the source, vertex of the target), shape (k, 2), which are met exactly.
    Raises NumericError when landmarks contradict each other or cannot be met.
    """
    pairs = _meshes.integers(landmarks, "landmarks").reshape(-1, 2)
    with _callback(progress) as report:
        return _core.register_maps(source, target, pairs, effort, fix_target, report)


def register_shapes(maps: Sequence[Map], landmarks: Any = (), *, template_shape: int = 0, mean_iterations: int = 2,
                    effort: str = "default", progress: Progress = None) -> ShapeSet:
    """Registers several shapes, from their maps to the sphere, torus or square.

    landmarks: a row for each, with its vertex of each shape. template_shape: which the others are registered to.
    """
    rows = _meshes.integers(landmarks, "landmarks").reshape(-1, max(len(maps), 1))
    with _callback(progress) as report:
        return _core.register_shapes(list(maps), rows, template_shape, mean_iterations, effort, report)


def morph(correspondence: Correspondence, t: float, *, align: bool = True) -> Mesh:
    """The shape between source (t = 0) and target (t = 1), with the triangulation of the source."""
    mesh = ShapeSet([correspondence.source, correspondence.target]).common_mesh(0)
    if align:
        mesh = mesh.aligned()
    return Mesh(mesh.morph([1.0 - t, t]), mesh.faces)
