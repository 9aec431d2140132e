#!/usr/bin/env python3
"""Usage: check_files.py assimp|vtk|gltf_validator FOLDER

Opens the files of FOLDER, which write_files left there, with a program that is not ours and compares what it
sees with expected.json. Ends with 77 when the program is not there.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys

from reader_checks import Checks, node_package, skip

VALIDATOR = "gltf-validator@2.0.0-dev.3.10"


def check_near(check, what, found, expected, tolerance):
    is_near = len(found) == len(expected) and all(abs(f - e) <= tolerance for f, e in zip(found, expected))
    check.equal(what, expected if is_near else found, expected)


def check_assimp(folder, expected, check):
    if not shutil.which("assimp"):
        skip("assimp is not installed (Debian: assimp-utils)")

    def info(file):
        run = subprocess.run(["assimp", "info", str(file), "-r"], capture_output=True, text=True)
        check.equal(f"{file.name}: status of assimp", run.returncode, 0)

        def figure(name):
            found = re.search(rf"^{re.escape(name)}: *(\d+)", run.stdout, re.MULTILINE)
            return int(found[1]) if found else None

        def point(name):
            found = re.search(rf"^{name} point *\(([^)]*)\)", run.stdout, re.MULTILINE)
            return [float(x) for x in found[1].split()] if found else []
        return figure, point

    for name, e in expected.items():
        for extension in ("obj", "ply", "glb"):
            file = folder / f"{name}.{extension}"
            figure, point = info(file)
            check.equal(f"{file.name}: faces", figure("Faces"), e["faces"])
            meshes = 1 if extension == "ply" else e["charts"]
            check.equal(f"{file.name}: meshes", figure("Meshes"), meshes)
            vertices = {"obj": 3 * e["faces"], "ply": e["vertices"], "glb": e["wedges"]}[extension]
            check.equal(f"{file.name}: vertices", figure("Vertices"), vertices)
            if extension == "glb":
                check.equal(f"{file.name}: images", figure("Textures (embed.)"), e["images"])
            if extension == "obj":
                check.equal(f"{file.name}: materials", figure("Materials"), e["charts"] + 1) # and its default
            # The box of a raw import of glTF is that before the translation of the node.
            for end in ("low", "high") if extension != "glb" else ():
                found = point("Minimum" if end == "low" else "Maximum")
                check_near(check, f"{file.name}: {end} point", found, e[end], 1e-5)


def check_vtk(folder, expected, check):
    try:
        from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader
        from vtkmodules.vtkIOPLY import vtkPLYReader
        from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    except ImportError as error:
        skip(f"VTK is not installed for {sys.executable} (Debian: python3-vtk9): {error}")

    def read(reader, file):
        reader.SetFileName(str(file))
        reader.Update()
        return reader.GetOutput()

    def leaves(data):
        if hasattr(data, "GetNumberOfBlocks"):
            return [leaf for i in range(data.GetNumberOfBlocks()) for leaf in leaves(data.GetBlock(i))]
        return [data]

    for name, e in expected.items():
        box = [x for pair in zip(e["low"], e["high"]) for x in pair]
        for extension, kind in (("obj", vtkOBJReader), ("ply", vtkPLYReader), ("vtp", vtkXMLPolyDataReader)):
            mesh = read(kind(), folder / f"{name}.{extension}")
            check.equal(f"{name}.{extension}: faces", mesh.GetNumberOfCells(), e["faces"])
            check_near(check, f"{name}.{extension}: box", mesh.GetBounds(), box, 1e-6)
            if extension != "obj": # there VTK has one vertex per corner
                check.equal(f"{name}.{extension}: vertices", mesh.GetNumberOfPoints(), e["vertices"])
        # the VTK file, bit for bit
        found = [list(mesh.GetPoint(i)) for i in range(mesh.GetNumberOfPoints())]
        check.equal(f"{name}.vtp: points", found, e["points"])
        found = []
        for i in range(mesh.GetNumberOfCells()):
            corners = mesh.GetCell(i).GetPointIds()
            found.append([corners.GetId(k) for k in range(corners.GetNumberOfIds())])
        check.equal(f"{name}.vtp: triangles", found, e["triangles"])
        data = mesh.GetPointData()
        fields = ["normal"] * ("normals" in e) + ["chart", "uv"] + list(e.get("fields") or {})
        fields += ["part"] * ("part_names" in e)
        names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
        check.equal(f"{name}.vtp: fields", names, fields)
        for field, values in (e.get("fields") or {}).items():
            array = data.GetArray(field)
            found = [array.GetValue(i) for i in range(array.GetNumberOfTuples())] if array else None
            check.equal(f"{name}.vtp: {field}", found, values)
        if "normals" in e:
            array = data.GetNormals()
            found = [list(array.GetTuple3(i)) for i in range(array.GetNumberOfTuples())] if array else None
            check.equal(f"{name}.vtp: normals", found, e["normals"])
        array = mesh.GetCellData().GetArray("chart")
        found = [array.GetValue(i) for i in range(array.GetNumberOfTuples())] if array else None
        check.equal(f"{name}.vtp: charts of faces", found, e["face_charts"])
        if "part_names" in e:
            array = mesh.GetCellData().GetArray("part")
            found = [array.GetValue(i) for i in range(array.GetNumberOfTuples())] if array else None
            check.equal(f"{name}.vtp: parts of faces", found, e["parts"])
            array = mesh.GetFieldData().GetAbstractArray("part_names")
            found = [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else None
            check.equal(f"{name}.vtp: names of parts", found, e["part_names"])

        reader = vtkGLTFReader()
        parts = leaves(read(reader, folder / f"{name}.glb"))
        check.equal(f"{name}.glb: primitives", len(parts), e["charts"])
        check.equal(f"{name}.glb: vertices", sum(p.GetNumberOfPoints() for p in parts), e["wedges"])
        check.equal(f"{name}.glb: faces", sum(p.GetNumberOfCells() for p in parts), e["faces"])
        check.equal(f"{name}.glb: images", reader.GetNumberOfTextures(), e["images"])
        bounds = [p.GetBounds() for p in parts]
        found = [(max if i % 2 else min)(b[i] for b in bounds) for i in range(6)]
        check_near(check, f"{name}.glb: box", found, box, 1e-5)


def check_gltf_validator(folder, expected, check):
    tools = folder / "node"
    node = node_package(tools, VALIDATOR)
    script = """const validator = require('gltf-validator'), fs = require('fs');
      Promise.all(process.argv.slice(1).map(f => validator.validateBytes(new Uint8Array(fs.readFileSync(f)))))
        .then(reports => console.log(JSON.stringify(reports)))"""
    run = subprocess.run([node, "-e", script] + [str(folder / f"{name}.glb") for name in expected],
                         capture_output=True, text=True, cwd=tools)
    check.equal("status of node", (run.returncode, run.stderr), (0, ""))
    for (name, e), report in zip(expected.items(), json.loads(run.stdout)):
        issues, info = report["issues"], report["info"]
        # Without image a viewer need not look at the coordinates: not a fault.
        messages = [m for m in issues["messages"] if m["code"] != "UNUSED_OBJECT"]
        check.equal(f"{name}.glb: messages", messages, [])
        check.equal(f"{name}.glb: errors, warnings", [issues["numErrors"], issues["numWarnings"]], [0, 0])
        check.equal(f"{name}.glb: primitives", info["drawCallCount"], e["charts"])
        check.equal(f"{name}.glb: vertices", info["totalVertexCount"], e["wedges"])
        check.equal(f"{name}.glb: faces", info["totalTriangleCount"], e["faces"])
        images = [r["image"] for r in info.get("resources", []) if "image" in r]
        sizes = [(i["width"], i["height"]) for i in images]
        check.equal(f"{name}.glb: images", sizes, [(32, 32)] * e["images"])


def main():
    reader, folder = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    expected = json.loads((folder / "expected.json").read_text())
    check = Checks()
    readers = {"assimp": check_assimp, "vtk": check_vtk, "gltf_validator": check_gltf_validator}
    readers[reader](folder, expected, check)
    check.finish(reader)


main()
