"""look.py, run by Blender: -- WORN.glb GARMENT.obj BODY.obj PICTURE.png

What glTF and OBJ give in Blender is compared with the text of the OBJ files. The body has to stand, its
feet on z = 0 and its front at -y, which is Blender's. UV maps have to be the `vt`. It draws a picture.
"""
import sys

import bpy
import mathutils
import mathutils.kdtree
import numpy

# The glTF importer of Blender 3.4 asks for it, and Debian 12's numpy has it no more.
numpy.bool = bool

worn, garment, body, picture = sys.argv[sys.argv.index("--") + 1:]


def expect(truth, what):
    if not truth:
        raise SystemExit(f"look: {what}")


def read_obj(file):
    """Points (x, y, z), and of each object the (point, vt) of its corners and its material."""
    points, texture, objects, name = [], [], {}, None
    for line in open(file):
        word, *rest = line.split()
        if word == "v":
            points.append(tuple(map(float, rest)))
        elif word == "vt":
            texture.append(tuple(map(float, rest)))
        elif word == "o":
            name = line[2:].strip()
            objects[name] = {"corners": set(), "material": ""}
        elif word == "usemtl":
            objects[name]["material"] = rest[0]
        elif word == "f":
            for corner in rest:
                v, vt, _ = corner.split("/")
                objects[name]["corners"].add((points[int(v) - 1], texture[int(vt) - 1] if vt else None))
    return points, objects


NEAR = 1e-5  # metres: floats of some metres are as fine


def check(panels, objects, title):
    """Objects of Blender against those of the OBJ. y up is z up there, and z to the front is -y."""
    bpy.context.view_layer.update()
    for name, panel in panels.items():
        expect(name in objects, f"{title}: there is no object {name}")
        thing = objects[name]
        expect(thing.data.materials[0].name.split(".")[0] == panel["material"], f"{title}: material of {name}")
        loops = thing.data.loops
        places = mathutils.kdtree.KDTree(len(loops))
        for loop in loops:
            places.insert(thing.matrix_world @ thing.data.vertices[loop.vertex_index].co, loop.index)
        places.balance()
        for (x, y, z), vt in panel["corners"]:
            there = [index for _, index, _ in places.find_range((x, -z, y), NEAR)]
            expect(there, f"{title}: {name}: nothing is at {x, -z, y}")
            if vt:
                uvs = [thing.data.uv_layers[0].data[index].uv for index in there]
                expect(any((uv - mathutils.Vector(vt)).length < NEAR for uv in uvs),
                       f"{title}: {name}: at {x, -z, y} the UV is {uvs[0][:]}, not {vt}")
    count = sum(len(panel["corners"]) for panel in panels.values())
    print(f"look: {title}: {len(panels)} objects with {count} corners agree")


def box(thing):
    corners = [thing.matrix_world @ mathutils.Vector(corner) for corner in thing.bound_box]
    return [(min(c[k] for c in corners), max(c[k] for c in corners)) for k in range(3)]


def clear():
    bpy.ops.wm.read_factory_settings(use_empty=True)


points, panels = read_obj(garment)
skin, bodies = read_obj(body)

clear()
bpy.ops.wm.obj_import(filepath=garment)
bpy.ops.wm.obj_import(filepath=body)
check(panels, bpy.data.objects, "OBJ")
check(bodies, bpy.data.objects, "OBJ of the body")

clear()
bpy.ops.import_scene.gltf(filepath=worn)
check(panels, bpy.data.objects, "glTF")
check(bodies, bpy.data.objects, "glTF, the body")
standing = box(bpy.data.objects["body"])
expect(abs(standing[2][0]) < 1e-4, f"the feet are at {standing[2][0]}")
expect(1.6 < standing[2][1] < 1.8, f"the head is at {standing[2][1]}")
# Feet reach farther to the front than heels to the back.
low = [v.co for v in bpy.data.objects["body"].data.vertices if (bpy.data.objects["body"].matrix_world @ v.co).z < 0.05]
ys = [(bpy.data.objects["body"].matrix_world @ co).y for co in low]
expect(-min(ys) > max(ys), "the body does not face -y")
for name in panels:
    data = bpy.data.objects[name].data
    expect(len(data.uv_layers) == 2, f"{name} has {len(data.uv_layers)} UV maps")
    expect(len(data.color_attributes) == 1, f"{name} has no vertex colours")
    uses = [node.type for node in data.materials[0].node_tree.nodes]
    expect("VERTEX_COLOR" in uses, f"the material of {name} does not show vertex colours: {uses}")
print(f"look: the body stands {standing[2][1]:.3f} m tall on z = 0 and faces -y")

scene = bpy.context.scene
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
camera.location = (1.2, -2.6, 1.35)
target = mathutils.Vector((0, 0, 1.05))
camera.rotation_euler = (target - camera.location).to_track_quat("-Z", "Y").to_euler()
scene.collection.objects.link(camera)
scene.camera = camera
sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
sun.data.energy = 3
sun.rotation_euler = (0.9, 0.2, 0.5)
scene.collection.objects.link(sun)
world = bpy.data.worlds.new("world")
world.use_nodes = True
world.node_tree.nodes["Background"].inputs[0].default_value = (0.6, 0.6, 0.6, 1)
scene.world = world
scene.view_settings.view_transform = "Standard"
scene.render.engine = "CYCLES"
scene.cycles.samples = 8
scene.cycles.use_denoising = False
scene.render.resolution_x, scene.render.resolution_y = 500, 600
scene.render.filepath = picture
bpy.ops.render.render(write_still=True)
print(f"look: drew {picture}")
