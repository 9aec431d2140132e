"""The tutorial has the figures of C++; everything is documented, and the stub knows everything."""
import ast
import os
import pathlib
import re
import subprocess

import pytest

import simple_manifolds as sm
import tutorial
from test_meshes import write_off


def test_the_tutorial_prints_what_the_manual_shows(tmp_path, capsys):
    shown = pathlib.Path(tutorial.__file__).with_suffix(".out").read_text()
    tutorial.main(None, tmp_path)
    printed = capsys.readouterr().out
    number = re.compile(r"-?\d+(?:\.\d+)?(?:e-\d+)?")
    assert number.sub("#", printed) == number.sub("#", shown)
    # roughly, so that a better map need not change the manual
    values = lambda text: [float(x) for x in number.findall(text)]
    assert values(printed) == pytest.approx(values(shown), 0.1)


@pytest.mark.skipif("SIMPLE_MANIFOLDS_TUTORIAL" not in os.environ, reason="the tutorial in C++ is not built")
def test_the_tutorial_has_the_figures_of_cpp(tmp_path, capsys):
    program = os.environ["SIMPLE_MANIFOLDS_TUTORIAL"]
    write_off(tmp_path / "mesh.off", *tutorial.bumpy_sphere())
    (tmp_path / "cpp").mkdir()
    (tmp_path / "python").mkdir()
    expected = subprocess.run([program, str(tmp_path / "mesh.off"), str(tmp_path / "cpp")], check=True, text=True,
                              capture_output=True).stdout
    tutorial.main(tmp_path / "mesh.off", tmp_path / "python")
    assert capsys.readouterr().out == expected
    for name in ("surface.json", "surface.glb", "surface.step"):
        assert (tmp_path / "python" / name).read_bytes() == (tmp_path / "cpp" / name).read_bytes(), name


def test_everything_is_documented():
    for name in sm.__all__:
        item = getattr(sm, name)
        assert item.__doc__, name
        if isinstance(item, type) and item.__module__ == "simple_manifolds._core":
            for key, value in vars(item).items():
                assert key.startswith("_") or getattr(value, "__doc__", None), f"{name}.{key}"


def test_the_stub_knows_all_names():
    stub = pathlib.Path(sm.__file__).with_name("_core.pyi")
    assert stub.with_name("py.typed").exists()
    module = {}
    for node in ast.parse(stub.read_text()).body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            module[node.name] = node
    core = sm._core
    names = {n for n in vars(core) if not n.startswith("__")}
    assert names == set(module)
    for name in names:
        if not isinstance(getattr(core, name), type) or issubclass(getattr(core, name), Exception):
            continue
        known = {n.name if isinstance(n, ast.FunctionDef) else n.target.id for n in module[name].body
                 if isinstance(n, ast.FunctionDef) or isinstance(n, ast.AnnAssign)}
        real = {n for n in vars(getattr(core, name)) if not n.startswith("_")}
        assert real == {n for n in known if not n.startswith("_")}, name
