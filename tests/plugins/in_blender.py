# SPDX-License-Identifier: AGPL-3.0-or-later
"""Bends a bar in Blender by two empties, one of which rotates and moves, and checks that the vertices in their spheres follow them.

Usage: blender -b --factory-startup --python-exit-code 1 --python in_blender.py -- ADDON [PICTURE]

With PICTURE, renders the result."""

import math
import sys

import bpy
from mathutils import Matrix, Vector

arguments = sys.argv[sys.argv.index("--") + 1:]
addon = {"__name__": "wend_bend"}
exec(compile(open(arguments[0]).read(), arguments[0], "exec"), addon)
addon["register"]()


def scene_of_bar():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = 1, 25
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=40, y_subdivisions=5)
    bar = bpy.context.active_object
    bar.scale = (3, 0.4, 1)
    bar.rotation_euler = (0.2, 0.1, 0.3)  # so that local and world coordinates differ
    solid = bar.modifiers.new("thick", "SOLIDIFY")
    solid.thickness = 0.6
    bpy.ops.object.modifier_apply(modifier="thick")
    bpy.context.view_layer.update()
    return bar


def empty(name, place):
    one = bpy.data.objects.new(name, None)
    one.empty_display_type, one.empty_display_size = "SPHERE", 0.8
    one.location = place
    bpy.context.collection.objects.link(one)
    return one


def evaluated(bar, frame):
    bpy.context.scene.frame_set(frame)
    mesh = bar.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    return [bar.matrix_world @ vertex.co for vertex in mesh.vertices]


def chosen(*objects):
    for one in bpy.context.scene.objects:
        one.select_set(one in objects)
    bpy.context.view_layer.objects.active = objects[0]


def refused(reason):
    try:
        bpy.ops.object.wend_bend()
    except RuntimeError as error:
        assert reason in str(error), error
        return
    raise AssertionError("not refused: " + reason)


bar = scene_of_bar()
rest = evaluated(bar, 1)
left = empty("left", bar.matrix_world @ Vector((-1, 0, 0)))
right = empty("right", bar.matrix_world @ Vector((1, 0, 0)))
chosen(bar)
refused("Select empties")
chosen(bar, left, right)
refused("No selected empty moves")

start = right.matrix_world.copy()
right.keyframe_insert("location", frame=1)
right.keyframe_insert("rotation_euler", frame=1)
right.location += Vector((-1.5, 0, 2.5))
right.rotation_euler = (0, -1.9, 0)
right.keyframe_insert("location", frame=25)
right.keyframe_insert("rotation_euler", frame=25)
bpy.context.scene.frame_set(10)
assert bpy.ops.object.wend_bend(vertices=1500, keys=13) == {"FINISHED"}
assert bpy.context.scene.frame_current in (1, 10)
keys = bar.data.shape_keys
assert len(keys.key_blocks) == 13 and not keys.use_relative
refused("shape keys already")

first, middle, last = evaluated(bar, 1), evaluated(bar, 13), evaluated(bar, 25)
assert max((p - q).length for p, q in zip(first, rest)) < 1e-4, "rest"
for frame, points in ((13, middle), (25, last)):
    bpy.context.scene.frame_set(frame)
    motion = right.matrix_world @ start.inverted()
    held = moved = 0
    for p, q in zip(rest, points):
        if (p - left.matrix_world.translation).length < 0.55:
            held += 1
            assert (p - q).length < 1e-3, ("held", p, q)
        if (p - start.translation).length < 0.55:
            moved += 1
            assert (motion @ p - q).length < 1e-3, ("moved", motion @ p, q)
    assert held > 4 and moved > 4, (held, moved)
edges = [(edge.vertices[0], edge.vertices[1]) for edge in bar.data.edges]
ratios = [(last[a] - last[b]).length / (rest[a] - rest[b]).length for a, b in edges]
assert 0.3 < min(ratios) and max(ratios) < 3, (min(ratios), max(ratios))

if len(arguments) > 1:
    scene = bpy.context.scene
    scene.render.engine, scene.cycles.samples, scene.cycles.device = "CYCLES", 48, "CPU"
    scene.cycles.use_denoising = False
    scene.render.resolution_x, scene.render.resolution_y, scene.render.filepath = 800, 450, arguments[1]
    scene.view_settings.view_transform = "Standard"
    world = bpy.data.worlds.new("world")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs[0].default_value = (0.93, 0.94, 0.96, 1)
    scene.world = world
    colours = [(0.06, 0.35, 0.42, 1), (0.25, 0.5, 0.55, 1), (0.85, 0.48, 0.17, 1)]
    for frame, colour in zip((1, 13, 25), colours):
        scene.frame_set(frame)
        mesh = bpy.data.meshes.new_from_object(bar.evaluated_get(bpy.context.evaluated_depsgraph_get()))
        copy = bpy.data.objects.new("copy", mesh)
        copy.matrix_world = Matrix.Translation((0, 0.09 * (13 - frame), 0)) @ bar.matrix_world
        material = bpy.data.materials.new("colour")
        material.use_nodes = True
        material.node_tree.nodes["Principled BSDF"].inputs[0].default_value = colour
        mesh.materials.clear()
        mesh.materials.append(material)
        for face in mesh.polygons:
            face.use_smooth = False
        bpy.context.collection.objects.link(copy)
    bar.hide_render = True
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location = (0.2, -11.5, 6.0)
    camera.rotation_euler = (math.radians(65), 0, 0)
    camera.data.lens = 45
    scene.collection.objects.link(camera)
    scene.camera = camera
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy, sun.rotation_euler = 1.1, (0.7, 0.3, 0.5)
    scene.collection.objects.link(sun)
    bpy.ops.render.render(write_still=True)
print("the bar bent in Blender")
