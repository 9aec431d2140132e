#!/usr/bin/env python3
"""Usage: check_step_files.py freecad|gmsh|rhino FOLDER

Opens the STEP files of FOLDER, which write_files left there, with a program that is not ours and compares what it sees
with expected_step.json. Ends with 77 when the program is not there. FreeCAD and gmsh read them by OpenCASCADE; to
OpenNURBS, the kernel of Rhino, which does not read STEP, check_step_rhino.cjs gives the faces that it finds in them.
"""
import json
import math
import pathlib
import shutil
import subprocess
import sys

RHINO = "rhino3dm@8"


def skip(why):
    print("skipped:", why)
    sys.exit(77)


class Checks:
    failures = 0
    count = 0

    def true(self, what, is_true):
        self.count += 1
        if not is_true:
            self.failures += 1
            print("wrong:", what)

    def equal(self, what, found, expected):
        self.true(f"{what}: {found} instead of {expected}", found == expected)

    def volume(self, what, found, expected): # OpenCASCADE's quadrature has a hundredth of error
        self.true(f"{what}: volume {found} instead of {expected}", math.isclose(found, expected, rel_tol=0.02))


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
        check.volume(name, shape.Volume / e["unit"] ** 3, e["volume"])
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
    npm, node = shutil.which("npm"), shutil.which("node")
    if not npm or not node:
        skip("npm or node is not installed, which OpenNURBS comes with")
    tools = folder / "node_rhino"
    if not (tools / "node_modules" / "rhino3dm").is_dir():
        tools.mkdir(exist_ok=True)
        run = subprocess.run([npm, "install", "--no-audit", "--no-fund", "--prefix", str(tools), RHINO],
                             capture_output=True, text=True, cwd=tools)
        if run.returncode:
            skip(f"npm cannot get {RHINO}: {run.stderr.strip().splitlines()[-1:]}")
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
    print(f"{program}: {check.count} checks, {check.failures} failures")
    sys.exit(check.failures > 0)


main()
