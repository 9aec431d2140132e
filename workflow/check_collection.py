#!/usr/bin/env python3
"""Usage: check_collection.py PROGRAMS WORK

Runs the workflow on a few meshes that it makes, kills it in the middle, and runs it again: every mesh is served once,
or listed with its reason.
"""
import base64
import csv
import json
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent


def write_grid(path, n, m, point, closed):
    """An OFF file of a grid of n x m vertices, triangles; closed: a torus."""
    rows, columns = (n, m) if closed else (n - 1, m - 1)
    faces = []
    for i in range(rows):
        for j in range(columns):
            a, b = i * m + j, (i + 1) % n * m + j
            c, d = (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m
            faces += [(a, b, c), (a, c, d)]
    with open(path, "w") as file:
        print("OFF", n * m, len(faces), 0, file=file)
        for i in range(n):
            for j in range(m):
                print(*point(i / n, j / m), file=file)
        for f in faces:
            print(3, *f, file=file)


def torus(radius):
    def point(s, t):
        a, b = 2 * math.pi * s, 2 * math.pi * t
        r = 1 + radius * math.cos(b)
        return r * math.cos(a), r * math.sin(a), radius * math.sin(b)

    return point


def write_box(path, size):
    corners = [(x, y, z) for x in (0, size) for y in (0, 1) for z in (0, 1)]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    with open(path, "w") as file:
        print("OFF 8 6 0", file=file)
        for c in corners:
            print(*c, file=file)
        for q in quads:
            print(4, *q, file=file)


def make_meshes(folder):
    """A table of them, and what is to come of each."""
    folder.mkdir()
    write_grid(folder / "torus.off", 16, 8, torus(0.4), True)
    write_grid(folder / "thin torus.off", 20, 8, torus(0.2), True)
    write_grid(folder / "sheet.off", 9, 9, lambda s, t: (s, t, s * t), False)
    write_box(folder / "box.off", 1)
    write_box(folder / "long.off", 3)
    (folder / "broken.off").write_text("OFF 3 1 0\n0 0 0\n")
    with open(folder / "table.csv", "w") as file:
        print("path,id,kind", file=file)
        for name in ("torus", "thin torus", "sheet", "box", "long", "broken", "missing"):
            print(f"{folder}/{name}.off,{name},{name.split()[-1]}", file=file)
    return {"torus": "done", "thin-torus": "done", "sheet": "done", "box": "done", "long": "done", "broken": "failed",
            "missing": "failed"}


def command(programs, work, *more):
    return ["snakemake", "-s", str(HERE / "Snakefile"), "--profile", str(HERE / "profiles" / "local"), "--cores", "2",
            *more, "--config", f"meshes={work}/meshes/table.csv", f"results={work}/results", f"programs={programs}",
            "fit=--repair --tolerance 1e-2 --target facets", "template=box"]


def expect(condition, what):
    if not condition:
        sys.exit(f"check_collection: {what}")


def killed_run(programs, work):
    run = subprocess.Popen(command(programs, work), cwd=work, start_new_session=True, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)
    end = time.monotonic() + 120
    while time.monotonic() < end and run.poll() is None and len(list(work.glob("results/*/fit.json"))) < 2:
        time.sleep(0.02)
    expect(run.poll() is None, "the run ended before it could be killed")
    os.killpg(run.pid, signal.SIGKILL)
    run.wait()


def main():
    programs, work = (pathlib.Path(a).resolve() for a in sys.argv[1:])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    expected = make_meshes(work / "meshes")
    killed_run(programs, work)
    running = {base64.b64decode(f.name).decode() for f in (work / ".snakemake" / "incomplete").iterdir()}
    finished = {p: p.stat().st_mtime_ns for p in work.glob("results/*/*.json") if str(p) not in running}
    expect(finished, "nothing was finished before the kill")
    expect(len(finished) < 4 * len(expected), "everything was finished before the kill")

    subprocess.run(command(programs, work, "--unlock"), cwd=work, check=True, capture_output=True)
    done = subprocess.run(command(programs, work), cwd=work, capture_output=True, text=True)
    expect(done.returncode == 0, done.stdout + done.stderr)
    again = [str(p) for p, t in finished.items() if p.stat().st_mtime_ns != t]
    expect(not again, f"done twice: {again}")

    rows = {r["id"]: r for r in csv.DictReader(open(work / "results" / "table.csv"))}
    expect({i: r["status"] for i, r in rows.items()} == expected, str(rows))
    expect("line" in rows["broken"]["reason"] and rows["missing"]["reason"], str(rows["broken"]))
    expect(rows["thin-torus"]["kind"] == "torus" and rows["torus"]["surfaces"] == "torus", str(rows["torus"]))
    expect(rows["long"]["registered"] == "done" and rows["torus"]["registered"] == "skipped", str(rows["long"]))
    expect(float(rows["sheet"]["rms_error"]) <= 1e-2 and int(rows["sheet"]["controls"]) > 0, str(rows["sheet"]))
    results = work / "results"
    expect((results / "torus" / "surface.glb").read_bytes()[:4] == b"glTF", "no glTF file")
    expect((results / "long" / "registered" / "1_on_2.ply").is_file(), "no registered mesh")
    page = (results / "index.html").read_text()
    expect("5 done, 2 failed" in page and page.count("<figure") == len(expected), "the page does not show all meshes")

    third = subprocess.run(command(programs, work), cwd=work, capture_output=True, text=True)
    expect("Nothing to be done" in third.stdout + third.stderr, "a third run found something to do: " + third.stderr)

    # too little memory is another attempt's matter, and of the last one a result
    step = [sys.executable, str(HERE / "collection.py"), "fit", str(results), "torus", "--memory", "16"]
    (results / "torus" / "fit.json").unlink()
    first = subprocess.run([*step, "--attempt", "1"], capture_output=True, text=True)
    expect(first.returncode != 0 and not (results / "torus" / "fit.json").exists(), "no second attempt")
    last = subprocess.run([*step, "--attempt", "3"], capture_output=True, text=True)
    expect(last.returncode == 0, last.stderr)
    expect(json.loads((results / "torus" / "fit.json").read_text())["status"] == "failed", "no failure")
    shutil.rmtree(work)


main()
