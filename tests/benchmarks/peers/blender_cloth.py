# Dresses a garment by Blender's cloth modifier, to compare:
#
#   blender -b -t 2 -P blender_cloth.py -- garment.obj garment.garment.json body.ply out.obj [--frames N] [--lift METRES]
#
# garment.obj and .garment.json are mesh-pattern's, body.ply is clean-body's. The start is the panels where
# the pattern places them, raised by --lift metres (a user would move them so that the shoulders
# clear the body; dress says how far it raised them); seams are sewing springs; the body is a
# collision object. out.obj is garment.obj with its points moved, out.json the settings and times.
#
# Settings, as a user would choose them for a light woven:
#   fabric      the cotton preset: 0.3 kg a vertex, tension, compression and shear 15, bending 0.5,
#               damping 5 and 0.5, air 1. (Tried as well: real masses, a tenth of a gram a vertex,
#               Toile's stiffness as force at strain 1, damping scaled by the mass, rest lengths
#               from a flat shape key, sewing forces of 3 and 30 weights. Seams stayed some 0.3 m
#               open at the median; which of these was the cause was not examined.)
#   quality     10 steps a frame, collision quality 5: the preset's 5 and the default 2, raised as
#               is advised for fine cloth and contact
#   distances   3 mm from the body, 2 mm between cloth, self-collision on, friction 0.4 in the cloth,
#               5 (the default) on the body
#   sewing      springs of at most 15 N, drawn together for 60 frames without gravity, which then
#               grows to its full strength in 24
#   frames      250 at 24 a second, the defaults: 10.4 s

import json
import sys
import time

import bpy

SEWING_FRAMES = 60
GRAVITY = 9.81


def read_garment(obj, description):
    points, faces = [], []
    for line in open(obj):
        words = line.split()
        if not words:
            continue
        if words[0] == "v":
            points.append(tuple(float(w) for w in words[1:4]))
        elif words[0] == "f":
            faces.append(tuple(int(w.split("/")[0]) - 1 for w in words[1:]))
    garment = json.load(open(description))
    pairs = {(min(a, b), max(a, b)) for seam in garment["seams"]
             for a, b in zip(seam["a"], seam["b"]) if a != b}
    return points, faces, sorted(pairs)


def add_cloth(points, faces, pairs, frames):
    mesh = bpy.data.meshes.new("garment")
    mesh.from_pydata(points, pairs, faces)
    garment = bpy.data.objects.new("garment", mesh)
    bpy.context.scene.collection.objects.link(garment)

    modifier = garment.modifiers.new("cloth", "CLOTH")
    cloth, contact = modifier.settings, modifier.collision_settings
    cloth.quality = 10
    cloth.mass = 0.3
    cloth.tension_stiffness = cloth.compression_stiffness = cloth.shear_stiffness = 15
    cloth.bending_stiffness = 0.5
    cloth.tension_damping = cloth.compression_damping = cloth.shear_damping = 5
    cloth.bending_damping = 0.5
    cloth.air_damping = 1
    cloth.use_sewing_springs = True
    cloth.sewing_force_max = 15
    contact.collision_quality = 5
    contact.distance_min = 0.003
    contact.use_self_collision = True
    contact.self_distance_min = 0.002
    contact.self_friction = 0.4
    modifier.point_cache.frame_start = 1
    modifier.point_cache.frame_end = frames
    weights = cloth.effector_weights
    for frame, weight in ((1, 0.0), (SEWING_FRAMES, 0.0), (SEWING_FRAMES + 24, 1.0)):
        weights.gravity = weight
        weights.keyframe_insert("gravity", frame=frame)
    settings = {name: getattr(cloth, name) for name in
                ("quality", "mass", "tension_stiffness", "shear_stiffness", "bending_stiffness",
                 "tension_damping", "air_damping", "sewing_force_max")}
    settings["collision_quality"] = contact.collision_quality
    return garment, settings


def add_body(path):
    bpy.ops.import_mesh.ply(filepath=path)
    body = bpy.context.object
    body.modifiers.new("collision", "COLLISION")
    body.collision.thickness_outer = 0.001
    body.collision.thickness_inner = 0.02
    body.collision.cloth_friction = 5


def main():
    arguments = sys.argv[sys.argv.index("--") + 1:]
    options = {"--frames": 250, "--lift": 0.0}
    for name in options:
        if name in arguments:
            at = arguments.index(name)
            options[name] = float(arguments[at + 1])
            del arguments[at:at + 2]
    frames = int(options["--frames"])
    source, description, body, target = arguments

    started = time.time()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.gravity = (0, -GRAVITY, 0)
    scene.frame_start, scene.frame_end = 1, frames
    points, faces, pairs = read_garment(source, description)
    points = [(x, y + options["--lift"], z) for x, y, z in points]
    add_body(body)
    garment, settings = add_cloth(points, faces, pairs, frames)
    read = time.time()
    for frame in range(1, frames + 1):
        scene.frame_set(frame)
    evaluated = garment.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    places = [garment.matrix_world @ v.co for v in evaluated.vertices]
    simulated = time.time()
    if len(places) != len(points):
        raise SystemExit("Blender changed the number of points")

    at = iter(places)
    with open(target, "w") as out:
        for line in open(source):
            out.write("v %r %r %r\n" % tuple(next(at)) if line.startswith("v ") else line)
    report = {"program": "Blender " + bpy.app.version_string, "frames": frames,
              "seconds_read": read - started, "seconds_simulated": simulated - read,
              "settings": settings}
    with open(target.rsplit(".", 1)[0] + ".json", "w") as out:
        json.dump(report, out, indent=1)


try:
    main()
except BaseException as error:  # Blender would print it and exit with 0
    print("blender_cloth.py:", repr(error), file=sys.stderr)
    sys.exit(1)
