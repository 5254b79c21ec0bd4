# SPDX-License-Identifier: AGPL-3.0-or-later
"""Adds an operator to Blender that bends the active mesh with the selected empties and keeps the motion as shape keys.

Each empty holds or moves the part of the mesh inside its sphere. The program wend computes the motion in a cage around
the mesh, so that the mesh may be open, intersect itself or have several parts."""

import json
import os
import subprocess
import tempfile

import bpy
from bpy.props import EnumProperty, IntProperty
from mathutils import Vector

bl_info = {
    "name": "Bend with Wend",
    "author": "The authors of Wend",
    "version": (0, 3, 0),
    "blender": (3, 4, 0),
    "location": "Object > Animation > Bend with Wend",
    "description": "Bends a mesh by empties as handles, and keeps the motion as shape keys",
    "category": "Animation",
}


class WendError(Exception):
    pass


def poses(scene, empties):
    """Returns for each empty one row per frame: time from 0 to 1, position, and rotation vector."""
    rows = {one: [] for one in empties}
    current, first, last = scene.frame_current, scene.frame_start, scene.frame_end
    for frame in range(first, last + 1):
        scene.frame_set(frame)
        for one in empties:
            place, turn, _scale = one.matrix_world.decompose()
            rows[one].append([(frame - first) / max(last - first, 1), *place, *turn.to_exponential_map()])
    scene.frame_set(current)
    return rows


def moves(rows):
    return any(abs(a - b) > 1e-7 for row in rows for a, b in zip(row[1:], rows[0][1:]))


def handle(empty, rows):
    radius = empty.empty_display_size * max(empty.matrix_world.to_scale())
    one = {"name": empty.name, "at": {"region": {"sphere": {"centre": rows[0][1:4], "radius": radius}}}}
    if moves(rows):
        one["motion"] = [{"kind": "poses", "poses": rows, "time": [0, 1]}]
    return one


def write_surface(mesh, matrix, path):
    with open(path, "w") as file:
        for vertex in mesh.vertices:
            file.write("v %r %r %r\n" % tuple(matrix @ vertex.co))
        for face in mesh.polygons:
            file.write("f " + " ".join(str(k + 1) for k in face.vertices) + "\n")


def read_vertices(path):
    with open(path) as file:
        return [Vector(map(float, line.split()[1:4])) for line in file if line.startswith("v ")]


def run(folder, project, count):
    """Runs a project in the folder and returns the vertices at `count` equally spaced times."""
    with open(os.path.join(folder, "object.wend"), "w") as file:
        json.dump(project, file)
    line = [os.environ.get("WEND", "wend"), "run", "object.wend", "--quiet", "--count", str(count), "--frames", "at_####.obj"]
    try:
        done = subprocess.run(line, cwd=folder, capture_output=True, text=True)
    except OSError:
        raise WendError("The program wend was not found. Please install Wend.")
    if done.returncode:
        raise WendError(done.stderr.strip())
    names = sorted(name for name in os.listdir(folder) if name.startswith("at_"))
    return [read_vertices(os.path.join(folder, name)) for name in names]


def bend(scene, target, empties, phi, vertices, count):
    """Returns the object's vertices in world coordinates at `count` times from the first frame to the last."""
    rows = poses(scene, empties)
    if not any(map(moves, rows.values())):
        raise WendError("No selected empty moves between the first and the last frame")
    scene.frame_set(scene.frame_start)
    with tempfile.TemporaryDirectory() as folder:
        write_surface(target.data, target.matrix_world, os.path.join(folder, "object.obj"))
        project = {
            "format": "wend", "version": 1,
            "domain": {"surface": "object.obj", "cage": True, "vertices": vertices},
            "material": {"phi": phi},
            "handles": [handle(one, rows[one]) for one in empties],
            "time": {"end": 1},
        }
        return run(folder, project, count)


def keep_as_shape_keys(scene, target, steps):
    """Adds the steps as absolute shape keys and animates them linearly from the first frame to the last."""
    back = target.matrix_world.inverted()
    for number, points in enumerate(steps):
        if len(points) != len(target.data.vertices):
            raise WendError("The bent mesh has another number of vertices")
        key = target.shape_key_add(name="Wend %d" % number, from_mix=False)
        key.data.foreach_set("co", [x for point in points for x in back @ point])
    keys = target.data.shape_keys
    keys.use_relative = False
    for frame, key in ((scene.frame_start, keys.key_blocks[0]), (scene.frame_end, keys.key_blocks[-1])):
        keys.eval_time = key.frame
        keys.keyframe_insert("eval_time", frame=frame)
    for point in keys.animation_data.action.fcurves[0].keyframe_points:
        point.interpolation = "LINEAR"


class OBJECT_OT_wend_bend(bpy.types.Operator):
    """Bend the active mesh with the selected empties. Each empty holds or moves the part of the mesh inside its sphere"""

    bl_idname = "object.wend_bend"
    bl_label = "Bend with Wend"
    bl_options = {"REGISTER", "UNDO"}

    keep: EnumProperty(
        name="Keep", default="metr", description="What the shape keeps while it bends",
        items=[("equia", "Volume", "Volume is kept first"), ("metr", "Length", "Lengths are kept"),
               ("akvf", "Rigid", "As rigid as possible"), ("conf", "Angles", "Angles are kept, sizes change")])
    vertices: IntProperty(name="Detail", default=2000, min=50, max=1000000, description="Vertices of the cage")
    keys: IntProperty(name="Shape keys", default=12, min=2, max=1000, description="Steps that the motion is kept in")

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT" and context.active_object is not None and context.active_object.type == "MESH"

    def execute(self, context):
        target = context.active_object
        empties = [one for one in context.selected_objects if one.type == "EMPTY"]
        try:
            if not empties:
                raise WendError("Select empties, too: each holds or moves what lies in its sphere")
            if target.data.shape_keys:
                raise WendError("The object has shape keys already")
            steps = bend(context.scene, target, empties, self.keep, self.vertices, self.keys)
            keep_as_shape_keys(context.scene, target, steps)
        except WendError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}

    def invoke(self, context, _event):
        return context.window_manager.invoke_props_dialog(self)


def menu(self, _context):
    self.layout.operator_context = "INVOKE_DEFAULT"
    self.layout.operator(OBJECT_OT_wend_bend.bl_idname)


def register():
    bpy.utils.register_class(OBJECT_OT_wend_bend)
    bpy.types.VIEW3D_MT_object_animation.append(menu)


def unregister():
    bpy.types.VIEW3D_MT_object_animation.remove(menu)
    bpy.utils.unregister_class(OBJECT_OT_wend_bend)
