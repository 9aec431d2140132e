#!/usr/bin/env python3
"""What the Snakefile runs: a step of one mesh, and what is seen of all of them.

  collection.py inspect|fit|export|register RESULTS ID [--threads N] [--memory MB] [--minutes M] [--attempt K]
  collection.py overview RESULTS      writes RESULTS/table.csv and RESULTS/index.html of what is there

A step writes RESULTS/ID/STEP.json: "status" is "done", "partly" (a tolerance was not reached, some bodies were not
served), "failed" with a "reason", or "skipped". The exit status is not 0, and nothing is written, where another
attempt may help: the program was killed, or ran out of memory or time.
"""
import argparse
import collections
import csv
import html
import json
import os
import pathlib
import re
import resource
import shlex
import subprocess
import sys
import tempfile
import time

EXTENSIONS = (".off", ".obj", ".ply", ".stl", ".vtk", ".vtp", ".gii", ".3mf", ".dae", ".glb", ".gltf")
BYTES_PER_FACE = {".off": 40, ".obj": 40, ".stl": 50}  # at least, of binary files where there are some
STEPS = ("inspect", "fit", "export", "register")


# ---- The meshes ---------------------------------------------------------------------------------------


def extension(path):
    name = path.name.lower()
    return pathlib.PurePath(name[:-3] if name.endswith(".gz") else name).suffix


def estimated_faces(path, size):
    """At most so many faces, but for files that are compressed very well."""
    return size * (4 if path.name.lower().endswith(".gz") else 1) // BYTES_PER_FACE.get(extension(path), 20)


def meshes(config):
    """{id: {"path", "bytes", "faces", and the other columns of the table}}; a file that is not there has 0 bytes."""
    source = pathlib.Path(config["meshes"])
    if source.is_dir():
        rows = [{"path": str(p), "id": str(p.relative_to(source))} for p in sorted(source.rglob("*"))
                if extension(p) in EXTENSIONS and p.is_file()]
    else:
        with open(source, newline="") as file:
            rows = list(csv.DictReader(file))
        if rows and "path" not in rows[0]:
            sys.exit(f"{source}: there is no column path")
    result = {}
    for row in rows:
        path = pathlib.Path(row["path"])
        name = re.sub(r"[^A-Za-z0-9._-]+", "-", row.get("id") or str(path)).strip("-.") or "mesh"
        number, unique = 1, name
        while unique in result:
            number += 1
            unique = f"{name}-{number}"
        size = path.stat().st_size if path.is_file() else 0
        result[unique] = {**row, "path": str(path), "bytes": size, "faces": estimated_faces(path, size)}
    return result


def write_atomically(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    with os.fdopen(handle, "w") as file:
        file.write(text)
    os.chmod(name, 0o644)
    os.replace(name, path)


def write_manifest(config, all_meshes):
    """Keeps what a job has to know, where all jobs find it."""
    path = pathlib.Path(config["results"]) / "manifest.json"
    text = json.dumps({"config": dict(config), "meshes": all_meshes}, indent=1)
    if not path.is_file() or path.read_text() != text:
        write_atomically(path, text)


# ---- A step of one mesh -------------------------------------------------------------------------------


class Again(Exception):
    """Another attempt may help."""


class Step:
    """Runs programs within limits, and takes down what came of them."""

    def __init__(self, arguments):
        self.results = pathlib.Path(arguments.results)
        manifest = json.loads((self.results / "manifest.json").read_text())
        self.config, self.mesh = manifest["config"], manifest["meshes"][arguments.id]
        self.folder = self.results / arguments.id
        self.folder.mkdir(parents=True, exist_ok=True)
        self.arguments = arguments
        self.end = time.monotonic() + 60 * arguments.minutes
        self.record = {"status": "done", "reason": "", "seconds": 0.0, "cpu_seconds": 0.0, "max_mb": 0.0,
                       "attempt": arguments.attempt}

    def is_last(self):
        return self.arguments.attempt >= self.config["attempts"]

    def run(self, program, *options):
        """The output of a program; its exit status and messages go into the record. None: it failed."""
        path = os.path.join(self.config["programs"], program) if self.config["programs"] else program
        command = [path, *options]
        limit = int(self.arguments.memory * 2**20)
        begin = time.monotonic()
        try:
            done = subprocess.run(command, capture_output=True, text=True, errors="replace",
                                  timeout=max(self.end - begin, 1),
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_DATA, (limit, limit)))
            status, output, message = done.returncode, done.stdout, done.stderr
        except subprocess.TimeoutExpired:
            status, output, message = None, "", f"more than {self.arguments.minutes} minutes"
        except OSError as e:
            sys.exit(f"{path}: {e}")
        self.record["seconds"] = round(self.record["seconds"] + time.monotonic() - begin, 3)
        used = resource.getrusage(resource.RUSAGE_CHILDREN)  # of all programs up to now
        self.record["cpu_seconds"] = round(used.ru_utime + used.ru_stime, 3)
        self.record["max_mb"] = round(used.ru_maxrss / 1024, 1)
        lines = [line.strip().removeprefix(f"{program}: ") for line in message.splitlines()]
        reason = " ".join(line for line in lines if line)[-600:]
        if status == 0:
            return output
        if status == 2:  # usage, or a disk that is full: of no mesh's making
            sys.exit(f"{shlex.join(command)}: {reason}")
        if status == 1:
            self.record["status"] = "partly"
            self.record["reason"] = reason
            return output
        lacks = status is None or status < 0 or status > 128 or (status == 4 and "memory" in reason)
        if lacks and not self.is_last():
            raise Again(reason or f"status {status}")
        self.record["status"] = "failed"
        self.record["reason"] = reason or f"{program} ended with {status}"
        return None

    def write(self):
        write_atomically(self.folder / f"{self.arguments.step}.json", json.dumps(self.record, indent=1))

    def earlier(self, step, folder=None):
        return json.loads(((folder or self.folder) / f"{step}.json").read_text())


def inspect(step):
    output = step.run("map_mesh", step.mesh["path"], "--inspect", "--json")
    if output is not None:
        step.record["found"] = summary(json.loads(output))


def summary(found):
    """The columns of the table that an inspection fills."""
    state = found.get("repaired") or found["read"]
    parts = state["parts"]
    return {"vertices": found["vertices"], "faces": found["faces"], "parts": len(parts),
            "genus": " ".join(str(p.get("genus", "-")) for p in parts[:8]),
            "borders": sum(len(p.get("borders", ())) for p in parts),
            "surfaces": counted([p.get("surface") or "none" for p in parts])}


def counted(words):
    """`sphere`, or of several `6 sphere 1 plane`."""
    return words[0] if len(words) == 1 else " ".join(f"{n} {w}" for w, n in collections.Counter(words).most_common())


def fit(step):
    if step.earlier("inspect")["status"] == "failed":
        step.record.update(status="skipped", reason="it cannot be read")
        return
    target = step.folder / "fit"
    options = shlex.split(step.config["fit"])
    step.run("fit_mesh", step.mesh["path"], "-o", str(target), "-q", "--threads", str(step.arguments.threads),
             *options)


def export(step):
    if step.earlier("fit")["status"] in ("failed", "skipped"):
        step.record.update(status="skipped", reason="there is no surface")
        return
    files = []
    for kind in step.config["formats"]:
        file = step.folder / f"surface.{kind}"
        if step.run("export_surface", str(step.folder / "fit"), "-o", str(file),
                    *shlex.split(step.config["export"])) is not None:
            files.append(file.name)
    step.record["files"] = files
    try:
        from thumbnail import thumbnail  # needs numpy
        thumbnail(step.folder / "fit" / "surface.ply", step.folder / "thumbnail.png")
    except ImportError:
        pass


def register(step):
    template = step.config["template"]
    for folder in (step.folder, step.results / template):
        if step.earlier("fit", folder)["status"] in ("failed", "skipped"):
            step.record.update(status="skipped", reason="there is no map")
            return
        if step.earlier("inspect", folder)["found"]["surfaces"] != "sphere":
            step.record.update(status="skipped", reason="it is not one closed body without handles")
            return
    if step.arguments.id == template:
        return
    other = json.loads((step.results / "manifest.json").read_text())["meshes"][template]
    step.run("map_shapes", other["path"], step.mesh["path"], "-o", str(step.folder / "registered"), "-q", "--repair",
             "--threads", str(step.arguments.threads), *shlex.split(step.config["register"]))


# ---- All of them --------------------------------------------------------------------------------------


def load(path):
    try:
        return json.loads(path.read_text())
    except (OSError, ValueError):
        return None


def rows(results):
    manifest = json.loads((results / "manifest.json").read_text())
    steps = [s for s in STEPS if s != "register" or manifest["config"]["template"]]
    for name, mesh in manifest["meshes"].items():
        folder = results / name
        records = {s: load(folder / f"{s}.json") for s in steps}
        row = {"id": name, **{k: v for k, v in mesh.items() if k not in ("id", "faces")}}
        row["status"], row["reason"] = "done", ""
        for s in steps:
            record = records[s]
            if record is None:
                row["status"], row["reason"] = "unfinished", f"{s}: not run, or killed"
                break
            if record["status"] != "done" and row["status"] in ("done", "partly"):
                if record["status"] == "skipped" and s == "register":
                    continue  # says nothing against the mesh
                row["status"], row["reason"] = record["status"], f"{s}: {record['reason']}"
        row.update((records["inspect"] or {}).get("found") or {})
        if (records["fit"] or {}).get("status") in ("done", "partly"):
            row.update(figures(load(folder / "fit" / "metrics.json") or {}))
        row["files"] = " ".join((records.get("export") or {}).get("files", ()))
        if "register" in steps:
            row["registered"] = (records["register"] or {}).get("status", "")
        for key in ("seconds", "cpu_seconds"):
            row[key] = round(sum(r.get(key, 0) for r in records.values() if r), 2)
        row["max_mb"] = max([r["max_mb"] for r in records.values() if r], default="")
        yield row


def figures(metrics):
    """Errors and controls from the metrics.json of fit_mesh, which has one surface or a list of parts."""
    parts = metrics.get("parts") or ([metrics] if "surface" in metrics else [])
    surfaces = [p["surface"] for p in parts if "surface" in p]
    if not surfaces:
        return {}
    return {"controls": sum(s["controls"] for s in surfaces), "rms_error": max(s["rms_error"] for s in surfaces),
            "max_error": max(s["max_error"] for s in surfaces), "folds": sum(s["folds"] for s in surfaces)}


COLUMNS = ("id", "path", "bytes", "status", "reason", "vertices", "faces", "parts", "genus", "borders", "surfaces",
           "controls", "rms_error", "max_error", "folds", "files", "registered", "seconds", "cpu_seconds", "max_mb")

PAGE = """<!doctype html><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>{title}</title><style>
body {{ font: 15px/1.4 system-ui, sans-serif; margin: 1rem auto; max-width: 76rem; padding: 0 1rem; color: #223 }}
main {{ display: grid; grid-template-columns: repeat(auto-fill, minmax(11rem, 1fr)); gap: 1rem }}
figure {{ margin: 0; border: 1px solid #dde; border-radius: 6px; padding: .5rem; overflow-wrap: anywhere }}
figure {{ font-size: 13px }}
figure img, figure .none {{ width: 100%; aspect-ratio: 1; background: #f4f5f8; display: block }}
.failed {{ border-color: #c44 }} .partly {{ border-color: #c90 }} .reason {{ color: #a33 }}
details {{ margin-bottom: 1rem }} ul {{ padding-left: 1.2rem; font-size: 13px; overflow-wrap: anywhere }}
</style><h1>{title}</h1><p>{totals}. All figures: <a href="table.csv">table.csv</a></p>{failures}<main>{cards}</main>
"""


def card(results, row):
    text = lambda key: html.escape(str(row.get(key, "")))
    picture = (f'<img loading="lazy" alt="" src="{html.escape(row["id"])}/thumbnail.png">'
               if (results / row["id"] / "thumbnail.png").is_file() else '<div class="none"></div>')
    report = results / row["id"] / "fit" / "report.html"
    name = text("id")
    if report.is_file():
        name = f'<a href="{name}/fit/report.html">{name}</a>'
    lines = [f"<b>{name}</b>", f"{text('faces')} faces, {text('surfaces')}"]
    if "rms_error" in row:
        lines.append(f"{text('controls')} controls, rms {row['rms_error']:.2g}")
    links = [f'<a href="{html.escape(row["id"])}/{html.escape(f)}">{html.escape(f.split(".")[-1])}</a>'
             for f in str(row.get("files", "")).split()]
    if links:
        lines.append(" ".join(links))
    if row["reason"]:
        lines.append(f'<span class="reason">{text("reason")[:200]}</span>')
    return f'<figure class="{row["status"]}">{picture}<figcaption>{"<br>".join(lines)}</figcaption></figure>'


def listed(some_rows, what, is_open):
    if not some_rows:
        return ""
    lines = "".join(f"<li><b>{html.escape(r['id'])}</b>: {html.escape(r['reason'])}" for r in some_rows)
    return f"<details {is_open}><summary>{len(some_rows)} {what}</summary><ul>{lines}</ul></details>"


def overview(results):
    """Writes table.csv and index.html of what there is."""
    results = pathlib.Path(results)
    all_rows = list(rows(results))
    columns = list(COLUMNS) + sorted({k for r in all_rows for k in r} - set(COLUMNS))
    handle, name = tempfile.mkstemp(dir=results, prefix=".table.csv.")
    with os.fdopen(handle, "w", newline="") as file:
        writer = csv.DictWriter(file, columns)
        writer.writeheader()
        writer.writerows(all_rows)
    os.chmod(name, 0o644)
    os.replace(name, results / "table.csv")
    count = collections.Counter(r["status"] for r in all_rows)
    totals = f"{len(all_rows)} meshes: " + ", ".join(f"{n} {s}" for s, n in sorted(count.items()))
    begun = [r for r in all_rows if r["status"] != "unfinished"]
    failures = (listed([r for r in begun if r["status"] in ("failed", "skipped")], "without a surface", "open") +
                listed([r for r in all_rows if r["status"] == "unfinished"], "not finished", ""))
    write_atomically(results / "index.html", PAGE.format(
        title="Collection", totals=html.escape(totals), failures=failures,
        cards="\n".join(card(results, r) for r in begun)))
    print(totals)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("step", choices=(*STEPS, "overview"))
    parser.add_argument("results")
    parser.add_argument("id", nargs="?")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--memory", type=float, default=4096, help="megabytes")
    parser.add_argument("--minutes", type=float, default=60)
    parser.add_argument("--attempt", type=int, default=1)
    arguments = parser.parse_args()
    if arguments.step == "overview":
        overview(arguments.results)
        return
    if arguments.id is None:
        parser.error("which mesh?")
    step = Step(arguments)
    try:
        {"inspect": inspect, "fit": fit, "export": export, "register": register}[arguments.step](step)
    except Again as reason:
        sys.exit(f"{arguments.step} of {arguments.id}, attempt {arguments.attempt}: {reason}")
    step.write()


if __name__ == "__main__":
    main()
