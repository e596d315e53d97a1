"""What voroprobe writes for printers, judged by a slicer program that shares no code with it.

Usage: slicer_test.py VOROPROBE TESTDATA. Exits with 77 where there is no PrusaSlicer, which ctest takes for skipped.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77

# What PrusaSlicer says of meshes that it had to touch, or would rather have touched.
COMPLAINTS = re.compile(r"repair|open edge|degenerate|reversed|backwards|non-manifold|faulty|error", re.IGNORECASE)


def run(*command):
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=1200)
    if result.returncode != 0:
        sys.exit(f"{' '.join(command)} ended with {result.returncode}:\n{result.stdout}")
    return result.stdout


def facts_of(slicer, mesh):
    """What the slicer finds in a file: {"manifold": "yes", "number_of_parts": "1", ...}."""
    return dict(re.findall(r"^(\w+) = +(\S+)", run(slicer, "--info", mesh), re.MULTILINE))


def check_slices(slicer, mesh, parts):
    facts = facts_of(slicer, mesh)
    assert facts["manifold"] == "yes", (mesh, facts)
    assert int(facts["number_of_parts"]) == parts, (mesh, facts)
    gcode = mesh + ".gcode"
    output = run(slicer, "--export-gcode", "--output", gcode, mesh)
    assert not COMPLAINTS.search(output), f"{mesh}:\n{output}"
    with open(gcode, encoding="utf-8") as file:
        assert sum(1 for line in file if line.startswith("G1 ")) > 1000, f"{gcode} hardly moves"


def check_that_holes_are_seen(slicer, whole, folder):
    """The slicer's word is worth something only where it can be a no."""
    with open(whole, encoding="ascii") as file:
        facets = file.read().split("facet normal")
    holed = os.path.join(folder, "holed.stl")
    with open(holed, "w", encoding="ascii") as file:
        file.write("facet normal".join(facets[:5] + facets[6:]))
    assert facts_of(slicer, holed)["manifold"] == "no"


def main():
    voroprobe, testdata = sys.argv[1:]
    slicer = shutil.which("prusa-slicer")
    if slicer is None:
        print("skipped: there is no prusa-slicer (Debian package prusa-slicer)")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as folder:
        scan, body, solid, hollow, text = (
            os.path.join(folder, name) for name in ("all.ply", "body.3mf", "body.stl", "hollow.3mf", "text.stl"))
        # A head ends in a flat neck. What touches the bed in a point has layers that are empty, which is no fault of a mesh.
        run(voroprobe, "mesh", os.path.join(testdata, "headsq_ct.nrrd"), "--isovalue", "500.5", "-o", scan)
        largest = (voroprobe, "process", scan, "--keep-largest", "1", "--drop-cavities", "--scale", "0.3", "--on-bed")
        run(*largest, "-o", body)
        run(*largest, "--decimate", "50%", "--relax", "-o", solid)
        run(*largest, "--hollow", "6", "--drain", "10", "-o", hollow)
        run(*largest, "--format", "stl-ascii", "-o", text)
        for mesh in (body, solid, hollow):
            check_slices(slicer, mesh, 1)
        check_that_holes_are_seen(slicer, text, folder)


if __name__ == "__main__":
    main()
