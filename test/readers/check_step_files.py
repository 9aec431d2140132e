#!/usr/bin/env python3
"""Usage: check_step_files.py freecad|gmsh|rhino FOLDER

Opens the STEP files of FOLDER, which write_files left there, with a program that is not ours and compares what it sees
with expected_step.json. Ends with 77 when the program is not there. FreeCAD and gmsh read them by OpenCASCADE; to
OpenNURBS, the kernel of Rhino, which does not read STEP, check_step_rhino.cjs gives the faces that it finds in them.
"""
import json
import math
import pathlib
import subprocess
import sys

from reader_checks import Checks, node_package, skip

RHINO = "rhino3dm@8"


def check_volume(check, what, found, expected): # OpenCASCADE's quadrature has a hundredth of error
    check.true(f"{what}: volume {found} instead of {expected}", math.isclose(found, expected, rel_tol=0.02))


def check_freecad(folder, expected, check):
    sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]
    try:
        import FreeCAD
        import Part
    except ImportError as error:
        skip(f"FreeCAD is not installed for {sys.executable} (scripts/setup cad): {error}")
    for name, e in expected.items():
        shape = Part.Shape()
        shape.read(str(folder / f"{name}.step"))
        check.true(f"{name}: valid", shape.isValid())
        check.equal(f"{name}: solids", len(shape.Solids), e["solids"])
        check.equal(f"{name}: shells", len(shape.Shells), e["shells"])
        check.equal(f"{name}: faces", len(shape.Faces), e["faces"])
        for solid in shape.Solids:
            check.true(f"{name}: closed", solid.isClosed())
        if e["solids"] == 0:
            continue
        check_volume(check, name, shape.Volume / e["unit"] ** 3, e["volume"])
        # a box cuts about half of it off
        b, far = shape.BoundBox, 2 * shape.BoundBox.DiagonalLength
        corner = FreeCAD.Vector((b.XMin + b.XMax) / 2 + 1e-3 * far, b.YMin - far / 4, b.ZMin - far / 4)
        cut = shape.Solids[0].cut(Part.makeBox(far, far, far, corner))
        check.true(f"{name}: valid after a cut", cut.isValid())
        check.true(f"{name}: smaller after a cut", 0 < cut.Volume < 0.9 * shape.Solids[0].Volume)


def check_gmsh(folder, expected, check):
    try:
        import gmsh
    except ImportError as error:
        skip(f"gmsh is not installed for {sys.executable} (scripts/setup cad): {error}")
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    for name, e in expected.items():
        gmsh.clear()
        gmsh.model.occ.importShapes(str(folder / f"{name}.step"))
        gmsh.model.occ.synchronize()
        bodies, faces = gmsh.model.getEntities(3), gmsh.model.getEntities(2)
        check.equal(f"{name}: bodies", len(bodies), e["solids"])
        check.equal(f"{name}: faces", len(faces), e["faces"])
        if len(bodies) != 1:
            continue
        # a mesh of the surface is closed: each edge is in two triangles
        gmsh.option.setNumber("Mesh.MeshSizeMax", 0.05 * e["diagonal"] * e["unit"])
        gmsh.model.mesh.generate(2)
        edges = {}
        for kind, _, nodes in zip(*gmsh.model.mesh.getElements(2)):
            check.equal(f"{name}: triangles only", kind, 2)
            for k in range(0, len(nodes), 3):
                for a, b in ((0, 1), (1, 2), (2, 0)):
                    key = frozenset((nodes[k + a], nodes[k + b]))
                    edges[key] = edges.get(key, 0) + 1
        check.true(f"{name}: a mesh", len(edges) > 100)
        check.true(f"{name}: a closed mesh", set(edges.values()) == {2})
    gmsh.finalize()


def check_rhino(folder, expected, check):
    tools = folder / "node_rhino"
    node = node_package(tools, RHINO)
    script = pathlib.Path(__file__).resolve().with_name("check_step_rhino.cjs")
    run = subprocess.run([node, script, str(tools.resolve()), *(str(folder / f"{name}.step") for name in expected)],
                         capture_output=True, text=True)
    check.equal("status of node", (run.returncode, run.stderr), (0, ""))
    for (name, e), found in zip(expected.items(), json.loads(run.stdout)):
        check.equal(f"{name}: faces", (found["valid"], found["faces"]), (e["faces"], e["faces"]))
        check.true(f"{name}: edges between faces", found["edges"] > 0 or e["faces"] == 1 and e["solids"] == 0)
        check.true(f"{name}: gap {found['gap']}", found["gap"] <= 1e-12)
        check.true(f"{name}: normals {found['angle']}", found["angle"] <= 1e-6)


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    expected = json.loads((folder / "expected_step.json").read_text())
    check = Checks()
    {"freecad": check_freecad, "gmsh": check_gmsh, "rhino": check_rhino}[program](folder, expected, check)
    check.finish(program)


main()
