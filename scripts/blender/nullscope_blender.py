"""Blender add-on: exports the camera as a path of nullscope, imports the layers that nullscope writes. docs/vfx.md says how.

Blender 5.0 and later: Edit, Preferences, Add-ons, Install from Disk. Then File, Export, nullscope camera, and File, Import, nullscope layers.
The hole is in the origin, its axis along z.
"""
import json
import math
import os
import re
import tempfile
from pathlib import Path

import bpy
from bpy.props import FloatProperty, StringProperty
from bpy_extras.io_utils import ExportHelper, ImportHelper

bl_info = {
    "name": "nullscope",
    "description": "The camera to nullscope, its layers back",
    "version": (1, 1, 0),
    "blender": (5, 0, 0),
    "location": "File > Export, File > Import",
    "category": "Import-Export",
}

COLUMNS = ("frame,time,x,y,z,look_x,look_y,look_z,up_x,up_y,up_z,fov,shift_x,shift_y")
LARGEST = 1e9   # r_s, that nullscope takes


class Refused(Exception):
    """What is wrong, and what is allowed, in one line."""


def write_whole(path, text):
    """The file appears under its name when it is complete."""
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=path.name)
    with os.fdopen(handle, "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(name, path)


def camera_row(scene, depsgraph, unit, rate):
    """The columns of path.file of the camera in the current frame. Lengths in `unit` Blender units; rate: r_s/c a second."""
    if scene.camera is None:
        raise Refused("the scene has no camera")
    camera, render = scene.camera.evaluated_get(depsgraph), scene.render
    if camera.data.type != "PERSP":
        raise Refused(f"camera '{camera.name}' is of type {camera.data.type}; allowed: PERSP")
    world = camera.matrix_world.normalized()
    place, look, up = world.translation / unit, -world.col[2].xyz, world.col[1].xyz
    if not 0 < place.length <= LARGEST:
        raise Refused(f"camera '{camera.name}' is at {place.length:g} r_s in frame {scene.frame_current}; allowed: (0, {LARGEST:g}]")
    width, height = size_of(render)
    # Of the sensor and its fit, shift and pixels' shape: the columns 0 and 2 are 2 f/width, and twice the middle's place in widths.
    lens = camera.calc_matrix_camera(depsgraph, x=width, y=height, scale_x=render.pixel_aspect_x, scale_y=render.pixel_aspect_y)
    frame = scene.frame_current - scene.frame_start
    time = frame * render.fps_base / render.fps * rate
    return (frame, time, *place, *look, *up, math.degrees(2 * math.atan(1 / lens[0][0])), lens[0][2] / 2, lens[1][2] / 2)


def size_of(render):
    return [max(1, side * render.resolution_percentage // 100) for side in (render.resolution_x, render.resolution_y)]


def export_camera(context, path, unit=1.0, rate=0.0):
    """Writes PATH, a scene of nullscope with [camera] and [path], and beside it the table of the path with a row for each frame."""
    path, scene, rows = Path(path), context.scene, []
    before = scene.frame_current, scene.frame_subframe
    try:
        for frame in range(scene.frame_start, scene.frame_end + 1):
            scene.frame_set(frame)
            rows.append(camera_row(scene, context.evaluated_depsgraph_get(), unit, rate))
    finally:
        scene.frame_set(before[0], subframe=before[1])
    render, (width, height) = scene.render, size_of(scene.render)
    table = path.with_suffix(".csv")
    write_whole(table, "\n".join([COLUMNS, *(",".join(map(repr, row)) for row in rows)]) + "\n")
    write_whole(path, "# The camera of Blender. Add what there is to see: [spacetime], [sky], [disc] ...\n"
                f"[camera]\nsize = [{width}, {height}]\npixel_aspect = {render.pixel_aspect_x / render.pixel_aspect_y}\n\n"
                f"[path]\nkind = \"keys\"\nfile = {json.dumps(table.name, ensure_ascii=False)}\nrate = {render.fps / render.fps_base}\n"
                f"frames = {max(2, len(rows))}\n")
    return len(rows)


def sequence_of(path):
    """(first number, count) of a sequence's files with this name but for the number before its ending; None: a single picture."""
    split = re.fullmatch(r"(.*?)(\d+)(\.\w+)", path.name)
    if not split:
        return None
    head, digits, tail = split.groups()
    name = re.compile(re.escape(head) + r"(\d+)" + re.escape(tail))
    numbers = sorted(int(found[1]) for found in map(name.fullmatch, os.listdir(path.parent)) if found)
    return (numbers[0], len(numbers)) if len(numbers) > 1 else None


class Tree:
    """Nodes of a compositing tree from left to right."""

    def __init__(self, name):
        self.group = bpy.data.node_groups.new(name, "CompositorNodeTree")

    def node(self, kind, column, row, label, **values):
        node = self.group.nodes.new(kind)
        node.location, node.label = (240 * column, -320 * row), label
        for key, value in values.items():
            setattr(node, key, value)
        return node

    def link(self, output, to):
        self.group.links.new(output, to)

    def blended(self, how, a, b, column, row):
        """a - b, a * b ... of colours, not clamped; the alpha is that of a."""
        mix = self.node("ShaderNodeMix", column, row, how.title(), data_type="RGBA", blend_type=how, clamp_result=False)
        mix.inputs["Factor_Float" if "Factor_Float" in mix.inputs else 0].default_value = 1.0
        sockets = {socket.identifier: socket for socket in mix.inputs}
        self.link(a, sockets["A_Color"])
        self.link(b, sockets["B_Color"])
        return next(socket for socket in mix.outputs if socket.type == "RGBA")


def picture_node(tree, path, row, label, scene):
    """An Image node of a file; of a sequence where others of its name stand beside it."""
    image = bpy.data.images.load(str(path))
    node = tree.node("CompositorNodeImage", 0, row, label, image=image)
    sequence = sequence_of(path)
    if sequence:
        image.source = "SEQUENCE"
        node.frame_duration, node.frame_start, node.frame_offset = sequence[1], scene.frame_start, sequence[0] - 1
    return node


def import_layers(context, path, plate=""):
    """A compositing tree of the layers: beauty; with a plate this behind the hole instead of the sky. Returns it."""
    path, scene = Path(path), context.scene
    if not path.is_file() or plate and not Path(plate).is_file():
        raise Refused(f"there is no file {plate if path.is_file() else path}")
    tree = Tree(path.stem)
    layers = picture_node(tree, path, 0, "nullscope layers", scene)
    out = {socket.name: socket for socket in layers.outputs}
    missing = [name for name in ("Combined", "sky", "st_plate") if name not in out]
    if missing:
        bpy.data.node_groups.remove(tree.group)
        raise Refused(f"{path.name} has no layer {missing[0]}; allowed: an EXR of nullscope capture --layers")
    shown = out["Combined"]
    front = tree.blended("SUBTRACT", shown, out["sky"], 1, 0)   # disc, bodies and matter, premultiplied
    for row, name in enumerate(("sky", *(f"disc{i}" for i in range(3)), "bodies", "medium")):
        if name in out:   # a way to each, to grade it
            tree.link(out[name], tree.node("NodeReroute", 1, 2 + row, name).inputs[0])
    if plate:
        bent = tree.node("CompositorNodeMapUV", 1, 1, "Bent by the hole")
        tree.link(picture_node(tree, Path(plate), 1, "Plate", scene).outputs["Image"], bent.inputs["Image"])
        tree.link(out["st_plate"], bent.inputs["UV"])
        seen = tree.node("ShaderNodeMath", 1, 8, "What is seen of the sky", operation="SUBTRACT")
        seen.inputs[0].default_value = 1.0
        tree.link(out["Alpha"], seen.inputs[1])
        behind = tree.blended("MULTIPLY", bent.outputs["Image"], seen.outputs[0], 2, 1)
        shown = tree.blended("ADD", front, behind, 3, 0)
    opaque = tree.node("CompositorNodeSetAlpha", 4, 0, "Opaque")
    opaque.inputs["Type"].default_value = "Replace Alpha"
    tree.link(shown, opaque.inputs["Image"])
    tree.group.interface.new_socket(name="Image", in_out="OUTPUT", socket_type="NodeSocketColor")
    for kind in ("NodeGroupOutput", "CompositorNodeViewer"):
        tree.link(opaque.outputs["Image"], tree.node(kind, 5, 0 if kind == "NodeGroupOutput" else 1, "").inputs[0])
    scene.compositing_node_group = tree.group
    scene.render.resolution_x, scene.render.resolution_y = layers.image.size
    scene.render.resolution_percentage = 100
    return tree.group


class NULLSCOPE_OT_export_camera(bpy.types.Operator, ExportHelper):
    """Write the active camera, frame by frame, as a scene of nullscope and the table of its path"""
    bl_idname, bl_label = "nullscope.export_camera", "Export nullscope camera"
    filename_ext = ".toml"
    filter_glob: StringProperty(default="*.toml", options={"HIDDEN"})
    unit: FloatProperty(name="Units per r_s", description="Blender units that are a Schwarzschild radius", default=1.0, min=1e-6, max=1e6)
    rate: FloatProperty(name="r_s/c per second", description="How fast the scene's time passes; 0: it stands", default=0.0)

    def execute(self, context):
        return done(self, lambda: export_camera(context, self.filepath, self.unit, self.rate), "{} frames")


class NULLSCOPE_OT_import_layers(bpy.types.Operator, ImportHelper):
    """Compose an EXR of nullscope capture --layers, with a plate behind the hole if there is one"""
    bl_idname, bl_label = "nullscope.import_layers", "Import nullscope layers"
    filename_ext = ".exr"
    filter_glob: StringProperty(default="*.exr", options={"HIDDEN"})
    plate: StringProperty(name="Plate", description="A photograph, bent by the hole in place of the sky", subtype="FILE_PATH")

    def execute(self, context):
        plate = bpy.path.abspath(self.plate) if self.plate else ""
        return done(self, lambda: import_layers(context, self.filepath, plate), "{0.name}")


def done(operator, work, words):
    try:
        operator.report({"INFO"}, "nullscope: " + words.format(work()))
        return {"FINISHED"}
    except (Refused, OSError, RuntimeError) as error:
        operator.report({"ERROR"}, f"nullscope: {error}")
        return {"CANCELLED"}


def export_entry(menu, _context):
    menu.layout.operator(NULLSCOPE_OT_export_camera.bl_idname, text="nullscope camera (.toml)")


def import_entry(menu, _context):
    menu.layout.operator(NULLSCOPE_OT_import_layers.bl_idname, text="nullscope layers (.exr)")


CLASSES = (NULLSCOPE_OT_export_camera, NULLSCOPE_OT_import_layers)
ENTRIES = ((bpy.types.TOPBAR_MT_file_export, export_entry), (bpy.types.TOPBAR_MT_file_import, import_entry))


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    for menu, entry in ENTRIES:
        menu.append(entry)


def unregister():
    for menu, entry in ENTRIES:
        menu.remove(entry)
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
