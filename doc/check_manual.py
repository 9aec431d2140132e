"""Usage: check_manual.py HTML_FOLDER NAMES.tag PackageDescription.txt parameters.h

Every link in the manual leads somewhere, and the list of the reference names every public name: all classes,
functions, constants and types in the namespace of the package, all concepts and all named parameters.
"""
import html
import pathlib
import re
import sys
import urllib.parse
import xml.etree.ElementTree as xml

NAMESPACE = "CGAL::Simple_manifolds"


def public_names(tags, parameters):
    names = set(re.findall(r"^  X\((\w+)\)", parameters, re.M))
    for compound in xml.parse(tags).getroot().iter("compound"):
        name = compound.findtext("name")
        if compound.get("kind") in ("class", "struct"):
            scope, _, last = name.rpartition("::")
            if scope == NAMESPACE or not scope:  # a concept is in no namespace
                names.add(re.sub("<.*", "", last))
        elif compound.get("kind") == "namespace" and name == NAMESPACE:
            names.update(m.findtext("name") for m in compound.iter("member") if m.get("kind") != "enumvalue")
    return names


def broken_links(folder):
    texts = {file: file.read_text(errors="replace") for file in folder.rglob("*.html")}
    anchors = {file: set(re.findall(r'\b(?:id|name)="([^"]+)"', text)) for file, text in texts.items()}
    for file, text in texts.items():
        for link in set(re.findall(r'\b(?:href|src|data)="([^"]+)"', text)):
            if re.match(r"\w+:|/", link):  # of the network or the system
                continue
            path, _, anchor = urllib.parse.unquote(html.unescape(link)).partition("#")
            target = file.parent / path if path else file
            if not target.exists() or (anchor and target in anchors and anchor not in anchors[target]):
                yield f"{file.name}: {link}"


def main():
    folder, tags, listed, parameters = map(pathlib.Path, sys.argv[1:])
    words = set(re.findall(r"\w+", listed.read_text()))
    missing = public_names(tags, parameters.read_text()) - words
    faults = [f"{name} is not in {listed.name}" for name in sorted(missing)]
    faults += [f"broken link in {link}" for link in sorted(broken_links(folder))]
    print("\n".join(faults), file=sys.stderr, end="\n" if faults else "")
    return 1 if faults else 0


sys.exit(main())
