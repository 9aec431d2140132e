"""The compiled part of simple_manifolds."""
from os import PathLike
from typing import Any, Callable, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import ClosestPoints, Curvatures, Derivatives
from ._progress import Progress as _Progress

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]
Path = Union[str, PathLike[str]]
Progress = Optional[Callable[[str, float], Any]]
Points = Union[ArrayLike, tuple[ArrayLike, ArrayLike]]

class BorderLoop:
    edges: int
    is_small: bool
    length: float

class CadReport:
    area: float
    controls: int
    diagonal: float
    edges: int
    faces: int
    has_searched_intersections: bool
    largest_angle: float
    largest_curvature_jump: float
    max_deviation: float
    rms_deviation: float
    self_intersections: int
    singular_points: int
    smallest_sine: float
    tolerance_reached: bool
    volume: float

class CadSurface:
    report: CadReport
    def find_self_intersections(self) -> Floats: ...
    def save_step(self, file: Path, name: str = 'surface', *, unit: str = 'mm', scale: float = 1.0,
                  schema: str = 'ap214') -> None: ...

class Certificate:
    border_ok: bool
    degenerate: int
    degree: float
    faces: int
    flipped: int
    is_valid: bool
    offending_faces: list[int]
    offending_vertices: list[int]
    out_of_range: int
    smallest_domain_area: float
    topology_message: str
    topology_ok: bool
    unliftable: int

class CommonMesh:
    def aligned(self, scale: bool = False) -> CommonMesh: ...
    faces: Ints
    def morph(self, weights: list[float]) -> Floats: ...
    positions: list[Floats]

class Correspondence:
    def __init__(self, source: Map, target: Map) -> None: ...
    def distortion(self, samples: int = 100000) -> CorrespondenceDistortion: ...
    def inverse(self) -> Correspondence: ...
    def locations(self) -> tuple[Ints, Floats]: ...
    def positions(self) -> Floats: ...
    report: Optional[RegistrationReport]
    source: Map
    target: Map

class CorrespondenceDistortion:
    angle_mean: float
    area_mean_abs_log2: float
    max: float
    mean: float
    mean_on_target: float
    median: float
    not_positive: int
    p95: float
    p99: float
    samples: int
    symmetric: float

class Distortion:
    angle_max: float
    angle_mean: float
    angle_p99: float
    area_max_abs_log10: float
    area_mean_abs_log10: float
    l2_efficiency: float
    smallest_domain_area: float
    symmetric_dirichlet: float

class Error(Exception):
    code: str
    element: Optional[tuple[Any, ...]]

class FileError(Error):
    file: str
    line: Optional[int]

class FitReport:
    closest_point_max: float
    closest_point_rms: float
    controls: int
    folds: int
    levels: list[tuple[int, float, float]]
    max_error: float
    max_tolerance: float
    normal_deviation: float
    rms_error: float
    rms_tolerance: float
    seconds: float
    stop: str
    target_max: float
    target_rms: float
    tolerance_reached: bool
    vertex_max_error: float
    vertex_rms_error: float
    vertices: int
    worst_point: Floats

class GeometryError(Error): ...

class InputIndices:
    def __init__(self, vertices: list[int], faces: list[int]) -> None: ...

class InspectedComponent:
    area: float
    box: Optional[Floats]
    def canonical_surface(self, close_borders: str = 'none') -> Optional[str]: ...
    edges: int
    euler_characteristic: int
    faces: int
    faults: SurfaceFaults
    first_face: int
    genus: Optional[int]
    is_surface: bool
    loops: list[BorderLoop]
    name: str
    vertices: int

class LocatedElements:
    count: int
    names: list[str]
    places: Floats

class Map:
    def charted_mesh(self) -> Tessellation: ...
    certificate: Certificate
    diagonal: float
    def distortion(self) -> Distortion: ...
    domain: str
    domain_points: Floats
    faces: Ints
    genus: int
    input_faces: Ints
    input_vertices: Ints
    is_inward_oriented: bool
    number_of_charts: int
    number_of_input_vertices: int
    number_of_virtual_faces: int
    def positions(self, domain_points: ArrayLike) -> Floats: ...
    def random_domain_points(self, n: int, seed: int = 0) -> Floats: ...
    def save(self, file: Path, binary: bool = True) -> None: ...
    def to_domain(self, faces: ArrayLike, barycentric: ArrayLike) -> Floats: ...
    def to_mesh(self, domain_points: ArrayLike) -> tuple[Ints, Floats]: ...
    vertices: Floats

class MeshInspection:
    area: float
    box: Optional[Floats]
    components: list[InspectedComponent]
    edges: int
    faces: int
    faults: SurfaceFaults
    unused_vertices: int
    vertices: int

class NumericError(Error): ...

class RegistrationReport:
    energies: list[float]
    exact_at: int
    landmarks: int
    rotations: list[float]

class RepairOptions:
    def __init__(self, *, weld_distance: Optional[float] = 1e-06, drop_degenerate: bool = True,
                 drop_duplicates: bool = True, face_orientation: str = 'consistent', cut_non_manifold: bool = False,
                 drop_non_finite: bool = False, debris_share: float = 0.0) -> None: ...
    @staticmethod
    def everything() -> RepairOptions: ...
    @staticmethod
    def nothing() -> RepairOptions: ...

class RepairReport:
    cut_edges: LocatedElements
    cut_vertices: LocatedElements
    dropped_debris: LocatedElements
    dropped_debris_faces: int
    dropped_degenerate: LocatedElements
    dropped_duplicate: LocatedElements
    dropped_non_finite: LocatedElements
    flipped: LocatedElements
    has_changes: bool
    input_faces: Ints
    input_vertices: Ints
    joined_corners: LocatedElements
    left: SurfaceFaults
    split_edges: LocatedElements
    unused_vertices: int
    welded: LocatedElements

class ShapeSet:
    def __init__(self, maps: list[Map]) -> None: ...
    def __len__(self) -> int: ...
    def __getitem__(self, i: int) -> Map: ...
    def common_mesh(self, i: int = 0, chord_error: Optional[float] = None,
                    max_faces: int = 1048576) -> CommonMesh: ...
    def correspondence(self, i: int, j: int) -> Correspondence: ...

class Surface:
    def positions(self, points: Points) -> Floats: ...
    def normals(self, points: Points) -> Floats: ...
    def derivatives(self, points: Points, order: int = 2) -> Derivatives: ...
    def curvatures(self, points: Points) -> Curvatures: ...
    def closest_points(self, points: ArrayLike) -> ClosestPoints: ...
    def tessellate(self, *, chord_error: Optional[float] = None, edge_length: Optional[float] = None,
                   subdivisions: Optional[int] = None, max_faces: Optional[int] = None) -> Tessellation: ...
    def to_cad(self, tolerance: float = 1e-3, *, face_cost: float = 500.0, max_faces: int = 0,
               max_controls: int = 200000, progress: _Progress = None) -> CadSurface: ...
    def chart_points(self, domain_points: ArrayLike) -> tuple[Ints, Floats]: ...
    domain: str
    genus: int
    number_of_charts: int
    def random_domain_points(self, n: int, seed: int = 0) -> Floats: ...
    report: Optional[FitReport]
    def save(self, file: Path) -> None: ...
    smoothness: int
    tolerance: float

class SurfaceFaults:
    coincident_borders: LocatedElements
    degenerate_faces: LocatedElements
    duplicate_faces: LocatedElements
    inconsistent_edges: LocatedElements
    missing_vertices: LocatedElements
    non_finite_vertices: LocatedElements
    non_manifold_edges: LocatedElements
    non_manifold_vertices: LocatedElements
    number: int
    one_sided_components: int
    repeated_corners: LocatedElements

class Tessellation:
    charts: Ints
    criteria_met: bool
    face_charts: Ints
    faces: Ints
    fields: dict[str, Floats]
    normals: Floats
    def save(self, file: Path) -> None: ...
    uv: Floats
    vertices: Floats

class TopologyError(Error): ...

def certify(domain: str, domain_points: ArrayLike, triangles: ArrayLike, genus: int) -> Certificate: ...
def charted_mesh(map: Map) -> Tessellation: ...
def closest_points(surface: Surface, points: ArrayLike) -> tuple[Floats, Floats, Floats, Floats]: ...
def curvatures_of_jets(jets: ArrayLike) -> tuple[Floats, Floats, Floats, Floats, Floats, Floats]: ...
def fit(map: Map, options: dict[str, Any], progress: Progress) -> Surface: ...
def inspect(points: ArrayLike, corners: ArrayLike, sizes: ArrayLike) -> MeshInspection: ...
def jets(surface: Surface, points: Points, order: int) -> Floats: ...
def load_map(file: Path) -> Map: ...
def load_surface(file: Path) -> Surface: ...
def make_map(domain: str, points: ArrayLike, triangles: ArrayLike, domain_points: ArrayLike, genus: int) -> Map: ...
def map(points: ArrayLike, triangles: ArrayLike, outer: InputIndices, domain: str, options: dict[str, Any],
        corners: list[int], landmark_vertices: ArrayLike, landmark_points: ArrayLike, landmark_weights: ArrayLike,
        progress: Progress) -> Map: ...
def map_components(points: ArrayLike, triangles: ArrayLike, outer: InputIndices, options: dict[str, Any],
                   max_components: Optional[int], progress: Progress) -> list[tuple[str, Ints, Ints, Optional[Map],
                   Optional[Error]]]: ...
def map_to_cad(map: Map, rms_error: float, max_error: Optional[float], face_cost: float, max_faces: int,
               max_controls: int, progress: Progress) -> CadSurface: ...
def normals_of_jets(jets: ArrayLike) -> Floats: ...
def positions(surface: Surface, points: Points) -> Floats: ...
def read(file: Path, options: Optional[RepairOptions]) -> dict[str, Any]: ...
def register_maps(source: Map, target: Map, landmarks: ArrayLike, effort: str, fix_target: bool,
                  progress: Progress) -> Correspondence: ...
def register_shapes(maps: list[Map], landmarks: ArrayLike, template_shape: int, mean_iterations: int, effort: str,
                    progress: Progress) -> ShapeSet: ...
def repair(points: ArrayLike, corners: ArrayLike, sizes: ArrayLike, options: RepairOptions) -> tuple[Any, ...]: ...
def surface_to_cad(surface: Surface, tolerance: float, face_cost: float, max_faces: int, max_controls: int,
                   progress: Progress) -> CadSurface: ...
def tessellate(surface: Surface, chord_error: Optional[float], edge_length: Optional[float],
               subdivisions: Optional[int], max_faces: Optional[int]) -> Tessellation: ...
def triangulate(points: ArrayLike, corners: ArrayLike, sizes: ArrayLike) -> tuple[Ints, Ints]: ...
