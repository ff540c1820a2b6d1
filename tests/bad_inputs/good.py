"""Sound inputs of every kind, made by the programs themselves, for damage.py to damage."""
import json
import pathlib
import shutil
import subprocess

POSE = {"format": "toile-pose", "version": 1, "units": "degrees",
        "joints": {"left_hip": {"flexion": 22, "abduction": 3}, "right_knee": {"flexion": 20}}}
SVG = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"
  width="400mm" height="300mm" viewBox="0 0 400 300">
<style>.gone { display: none }</style>
<defs><g id="notch"><circle r="1.5"/></g></defs>
<g id="yoke" transform="translate(10, 20) rotate(5)">
<path class="fabric" d="M 0,0 L 150,0 C 150,40 140,80 120,100 Q 60,120 0,100 z"/>
<path id="grainline" d="M 40,20 L 40,80"/>
<use xlink:href="#notch" x="150" y="0"/>
<text x="50" y="50"><tspan>yoke</tspan><tspan>cut 2 mirrored</tspan></text>
</g>
<rect class="fabric" x="200" y="20" width="100" height="120" rx="10"/>
<path class="fabric" d="M 200,200 l 40,0 M 240,200 v 40 h -40 v -40"/>
<path class="gone" d="M 0,0 L 5,5"/>
</svg>
"""
SCENE = {"body": "body.ply", "gravity": [0, -9.81, 0],
         "layers": [{"name": "band", "garment": "garment.obj", "fabric": "jersey"}]}


def make(folder, tools, source):
    """Fills `folder`. `tools` has the programs, `source` is the project's root."""
    samples = source / "samples"

    def program(name, *words):
        done = subprocess.run([tools / name, *map(str, words), "-q"], cwd=folder,
                              capture_output=True, text=True, check=False)
        if done.returncode not in (0, 3):
            raise SystemExit(f"a sound input can't be made: {name}: {done.stderr}")

    program("make-mannequin", "--edge-length", "15mm", "-o", "body.ply")
    for extension in ("obj", "stl", "off"):
        program("clean-body", "body.ply", "-o", f"mesh.{extension}")
    (folder / "mesh.body.json").unlink()
    program("mesh-pattern", samples / "band_small.json", "--edge-length", "30mm",
            "-o", "garment.obj")
    program("mesh-pattern", samples / "tube_top.json", "--edge-length", "30mm", "-o", "other.obj")
    program("dress", "--body", "body.ply", "garment.obj", "-o", "dressed.obj")
    for name in ("tshirt", "band", "elastic_skirt", "tube_top"):
        shutil.copy(samples / f"{name}.json", folder / f"pattern_{name}.json")
    shutil.copy(source / "tests/io/drawings/r2007.dxf", folder / "drawing.dxf")
    shutil.copy(source / "cloth/scene/fabrics/jersey.json", folder / "fabric.json")
    program("export-pattern", samples / "tshirt.json", "-o", "drawing.svg")
    (folder / "plain.svg").write_text(SVG)
    (folder / "scene.json").write_text(json.dumps(SCENE, indent=1))
    (folder / "pose.json").write_text(json.dumps(POSE, indent=1))


BODIES = ("body.ply", "mesh.obj", "mesh.stl", "mesh.off")
PATTERNS = ("pattern_tshirt.json", "pattern_band.json", "pattern_elastic_skirt.json",
            "pattern_tube_top.json")
JSONS = PATTERNS + ("garment.garment.json", "body.body.json", "scene.json", "pose.json",
                    "fabric.json")
SVGS = ("drawing.svg", "plain.svg")
TEXTS = JSONS + SVGS + ("mesh.obj", "mesh.off", "garment.obj", "dressed.obj", "drawing.dxf")
ALL = TEXTS + ("body.ply", "mesh.stl")

# What is beside a file that a command names, and read with it.
BESIDE = {"body.ply": ["body.body.json"], "garment.obj": ["garment.garment.json"],
          "scene.json": ["body.ply", "body.body.json", "garment.obj", "garment.garment.json"]}


def needed(words):
    """The sound files that a command reads."""
    names = {word for word in words if (word in ALL)}
    for name in list(names):
        names.update(BESIDE.get(name, []))
    return names


def commands(name):
    """Commands that read the file `name`, and their outputs."""
    dress = ["dress", "--body", "body.ply", "garment.obj", "--quality", "draft",
             "-o", "out.obj", "--report", "report.json"]
    ease = ["ease-map", "--body", "body.ply", "dressed.obj", "-o", "out.html", "--csv", "out.csv",
            "--report", "report.json"]
    clean = ["clean-body", "body.ply", "-o", "out.ply", "--report", "report.json"]
    mesh = ["mesh-pattern", name, "--edge-length", "30mm", "-o", "out.obj", "--report",
            "report.json"]
    render = ["render", "garment.obj", "-o", "out.png", "--width", "120"]

    def of(command, sound):
        return [name if word == sound else word for word in command]

    if name in BODIES:
        return [of(command, "body.ply") for command in (clean, clean, dress, ease)] + [
            ["render", "--body", name, "-o", "out.png", "--width", "120"]]
    if name == "body.body.json":
        return [dress, ease, clean]
    if name in PATTERNS:
        return [mesh, mesh, ["export-pattern", name, "-o", "out.svg", "--report", "report.json"],
                ["export-pattern", name, "--seam-allowance", "10mm", "-o", "out.dxf"],
                ["export-pattern", name, "-o", "out.pdf"]]
    if name == "drawing.dxf":
        return [["import-pattern", name, "-o", "out.json", "--report", "report.json"],
                ["import-pattern", name, "-o", "out.json", "--seam-allowance", "8mm"]]
    if name in SVGS:
        return [["import-pattern", name, "-o", "out.json", "--report", "report.json"]]
    if name == "garment.obj":
        return [dress, dress, render]
    if name == "garment.garment.json":
        return [dress]
    if name == "dressed.obj":
        return [ease, ease, of(render, "garment.obj")]
    if name == "scene.json":
        return [["dress", "--scene", "scene.json", "--quality", "draft", "-o", "out.obj",
                 "--report", "report.json"]]
    if name == "pose.json":
        return [["make-mannequin", "--pose", "pose.json", "--edge-length", "15mm", "-o",
                 "out.ply"]]
    if name == "fabric.json":
        return [dress + ["--fabric", "fabric.json"]]
    raise KeyError(name)


def outputs(words):
    """The files that a command is to write."""
    flags = ("-o", "--report", "--csv")
    named = [pathlib.Path(words[i + 1]) for i, word in enumerate(words) if word in flags]
    # A scene's layers go to files named after them, whose names the damage may have changed.
    return [path for path in named if "--scene" not in words or path.suffix == ".json"]
