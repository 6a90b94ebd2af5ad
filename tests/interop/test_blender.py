"""Blender, as the module bpy: the add-on of scripts/blender, layers bit for bit, Map UV, the camera in both programs."""
import math
import sys

import numpy as np

import support

sys.path.insert(0, str(support.ROOT / "scripts" / "blender"))
import bpy
import nullscope_blender as addon
from mathutils import Euler, Vector

PROGRAM = f"Blender {bpy.app.version_string}"
SIZE = 96, 54
# A plate's light at s (to the right) and t (up), linear in both.
PLATE = 0.1, 0.3, 0.5


def fresh():
    """An empty scene, whose compositor works with floats of 32 bits."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.compositor_precision = "FULL"
    scene.render.engine = "CYCLES"
    scene.view_settings.view_transform = "Raw"
    return scene


def composed(scene, sockets, folder):
    """Name -> array of what these outputs of the scene's compositing tree are, written by its node File Output."""
    group = scene.compositing_node_group
    node = group.nodes.new("CompositorNodeOutputFile")
    node.directory, node.file_name, node.save_as_render = str(folder), "composed", False
    node.format.media_type = "MULTI_LAYER_IMAGE"
    node.format.file_format, node.format.color_depth = "OPEN_EXR_MULTILAYER", "32"
    for name, socket in sockets.items():
        node.file_output_items.new({"VALUE": "FLOAT"}.get(socket.type, socket.type), name)
    for name, socket in sockets.items():
        group.links.new(socket, node.inputs[name])
    for old in folder.glob("composed*"):
        old.unlink()
    bpy.ops.render.render()
    (file,) = folder.glob("composed*.exr")
    group.nodes.remove(node)
    found = {name: {} for name in sockets}
    for channel, rows in support.exr(file).items():
        name, _, component = channel.rpartition(".")
        found[name or channel][component if name else "V"] = rows
    return found


def image_node(scene):
    return next(node for node in scene.compositing_node_group.nodes if node.bl_idname == "CompositorNodeImage" and node.label == "nullscope layers")


def layers_arrive(report, folder):
    support.nullscope("capture", "kerr-plunge", "--layers", "--frames", "8:9", "--size", "%dx%d" % SIZE, "-o", "layers-%d.exr", folder=folder)
    meant = support.exr(folder / "layers-8.exr")
    scene = fresh()
    addon.import_layers(bpy.context, folder / "layers-8.exr")
    outputs = {socket.name: socket for socket in image_node(scene).outputs}
    report.add("channels that no output of the Image node has", len({name.rpartition(".")[0] or "Combined" for name in meant if "." in name} - set(outputs)), 0)
    wanted = {name: outputs[name] for name in ("Combined", "sky", "disc0", "st_plate", "depth", "forward", "forward_known", "direction", "hit")}
    found = composed(scene, wanted, folder)
    for layer, said in (("Combined", "beauty"), ("sky", "sky"), ("disc0", "disc0"), ("st_plate", "st_plate"), ("direction", "direction")):
        parts = ("R", "G", "B", "A") if layer not in ("st_plate", "direction") else ("X", "Y", "Z")
        own = parts if layer == "Combined" else [f"{layer}.{part if part in 'RGBA' else part.lower()}" for part in parts]
        report.same_bits(said, np.stack([found[layer][part] for part in parts]), np.stack([meant[name] for name in own]))
    report.same_bits("depth", found["depth"]["V"], meant["depth.affine"])
    found_motion, motion = np.stack([found["forward"]["X"], found["forward"]["Y"]]), np.stack([meant["forward.u"], meant["forward.v"]])
    if bpy.app.version >= (5, 2):
        report.known_fault("motion: layers of two channels have memory that nothing was written to", (found_motion != motion).any())
    else:
        report.same_bits("motion", found_motion, motion)
    report.same_bits("motion known", found["forward_known"]["V"], meant["forward_known"])


def plate_is_bent(report, folder):
    """A plate that is linear in its coordinates, by Map UV; and nullscope's own picture of a sky with that light in these directions."""
    width, height, wide = 960, 540, 2 * math.tan(math.radians(50) / 2)
    c, by_s, by_t = PLATE
    # The camera looks along -x, its right is y, its up z.
    formula = f"{c} + {by_s}*(0.5 - y/x/{wide!r}) + {by_t}*(0.5 - z/x/{wide * height / width!r})"
    (folder / "bent.toml").write_text(
        f'[spacetime]\nmetric = "kerr"\nspin = 0.9\n[camera]\nr = 20\ntheta = 90\nfov = 50\nsize = [{width}, {height}]\n'
        f'[sky]\nkind = "formula"\nformula = "{formula}"\ncolour = [1, 0.5, 0.25]\nsecond_colour = [0, 0, 0]\n[picture]\nrefine = "off"\n')
    support.nullscope("capture", "bent.toml", "--layers", "-o", "bent.exr", folder=folder)
    s, t = np.meshgrid((np.arange(256) + 0.5) / 256, 1 - (np.arange(128) + 0.5) / 128)
    light = c + by_s * s + by_t * t
    support.write_exr(folder / "plate.exr", {"R": light, "G": light / 2, "B": light / 4})
    meant, scene = support.exr(folder / "bent.exr"), fresh()
    group = addon.import_layers(bpy.context, folder / "bent.exr", folder / "plate.exr")
    bent = next(node for node in group.nodes if node.bl_idname == "CompositorNodeMapUV").outputs["Image"]
    result = next(node for node in group.nodes if node.label == "Opaque").outputs["Image"]
    found = composed(scene, {"bent": bent, "result": result}, folder)
    # Where all four neighbours of a place are in the plate; and where the light is linear across a pixel: a formula is averaged over four places of it.
    inside = (np.abs(meant["st_plate.x"] - 0.5) < 0.5 - 0.6 / 256) & (np.abs(meant["st_plate.y"] - 0.5) < 0.5 - 0.6 / 128)
    inside &= (meant["st_plate.z"] == 1) & (meant["A"] == 0)
    linear = inside & (bend_of(c + by_s * meant["st_plate.x"].astype(float) + by_t * meant["st_plate.y"].astype(float)) < 4e-5)
    report.add("share of the plate's pixels that are not linear", 1 - linear.sum() / inside.sum(), 0.25)
    for name in ("bent", "result"):
        off = max(np.abs(found[name][part] - meant[part])[linear].max() for part in "RGB")
        report.add(f"Map UV of a linear plate, {name}, against nullscope's picture, {linear.sum()} pixels: largest difference", off, 1e-6)


def bend_of(values):
    """How far the largest second difference with neighbours in a line is from 0."""
    padded, (height, width) = np.pad(values, 1, constant_values=np.inf), values.shape
    with np.errstate(invalid="ignore"):
        return np.nan_to_num(np.max([np.abs(padded[1 + y:1 + y + height, 1 + x:1 + x + width] + padded[1 - y:1 - y + height, 1 - x:1 - x + width] - 2 * values)
                                     for x, y in ((1, 0), (0, 1), (1, 1), (1, -1))], axis=0), nan=np.inf)


def marks():
    """Twenty directions all round, evenly (a spiral), and their plate: equirectangular, azimuth 0 in its middle, to the left."""
    z = 1 - (2 * np.arange(20) + 1) / 20
    turn = np.pi * (1 + math.sqrt(5)) * np.arange(20)
    directions = np.stack([np.sqrt(1 - z * z) * np.cos(turn), np.sqrt(1 - z * z) * np.sin(turn), z], axis=-1)
    azimuth, polar = np.meshgrid(np.pi * (1 - (2 * np.arange(2048) + 1) / 2048), np.pi * (np.arange(1024) + 0.5) / 1024)
    places = np.stack([np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)], axis=-1)
    light = np.zeros(azimuth.shape)
    for direction in directions:
        light += np.exp((places @ direction - 1) * 2 / math.radians(1.2) ** 2)
    return directions, light


def drawn_by_blender(scene, plate, folder, frame):
    world = bpy.data.worlds.new("marks")
    scene.world, world.use_nodes = world, True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    sky = nodes.new("ShaderNodeTexEnvironment")
    sky.image, sky.interpolation = bpy.data.images.load(str(plate)), "Linear"
    links.new(sky.outputs["Color"], next(node for node in nodes if node.bl_idname == "ShaderNodeBackground").inputs["Color"])
    scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.use_adaptive_sampling = 64, False, False
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 1.0
    scene.frame_set(frame)
    scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "OPEN_EXR", "32"
    scene.render.filepath = str(folder / f"blender-{frame}.exr")
    bpy.ops.render.render(write_still=True)
    return support.exr(folder / f"blender-{frame}.exr")


def centre_of(light, near):
    """Of a mark's light within some pixels of a place, px from the upper left corner."""
    height, width = light.shape
    x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    weight = light * ((x - near[0]) ** 2 + (y - near[1]) ** 2 < 9 ** 2)
    return np.array([(weight * x).sum(), (weight * y).sum()]) / weight.sum()


def camera(scene, frames=6):
    """Animated, to six sides, with all that a camera of Blender has: lens, shift, a parent that is scaled."""
    data = bpy.data.cameras.new("camera")
    made, parent = bpy.data.objects.new("camera", data), bpy.data.objects.new("parent", None)
    for one in (made, parent):
        scene.collection.objects.link(one)
    made.parent, parent.scale = parent, (1.5, 1.5, 1.5)
    scene.camera, scene.frame_start, scene.frame_end = made, 1, frames
    scene.render.resolution_percentage = 50
    made.rotation_mode = "QUATERNION"
    aslant, quarter = Euler((0.3, 0.5, 0.2)).to_quaternion(), math.pi / 2
    sides = [(0, 0, 0), (quarter, 0, 0), (2 * quarter, 0, 0), (3 * quarter, 0, 0), (0, quarter, 0), (0, -quarter, 0)]
    for frame, turn in enumerate(sides[:frames]):
        made.location = 6 - frame, 2 * frame - 3, 1 + frame
        made.rotation_quaternion = aslant @ Euler(turn).to_quaternion()
        data.lens, data.shift_x, data.shift_y = 11 + 0.2 * frame, 0.02 * frame, -0.015 * frame
        for what, names in ((made, ("location", "rotation_quaternion")), (data, ("lens", "shift_x", "shift_y"))):
            for name in names:
                what.keyframe_insert(name, frame=frame + 1)
    return made


def cameras_agree(report, folder, fit="AUTO", size=(480, 360), aspect=(1.0, 1.0), frames=6, least=20):
    scene = fresh()
    camera(scene, frames).data.sensor_fit = fit
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.render.pixel_aspect_x, scene.render.pixel_aspect_y = aspect
    directions, light = marks()
    support.write_exr(folder / "plate.exr", {"R": light, "G": light, "B": light})
    addon.export_camera(bpy.context, folder / "shot.toml")
    scene_file = (folder / "shot.toml").read_text()
    (folder / "shot.toml").write_text('[spacetime]\nmetric = "minkowski"\n' + scene_file +
                                      '[sky]\nkind = "image"\nimage = "plate.exr"\n[picture]\nsamples = 8\n')
    support.nullscope("capture", "shot.toml", "--frames", f"0:{frames}", "-o", "own-%d.exr", folder=folder)
    worst, seen = 0.0, set()
    for frame in range(frames):
        theirs = drawn_by_blender(scene, folder / "plate.exr", folder, frame + 1)["R"]
        ours = support.exr(folder / f"own-{frame}.exr")["R"]
        if ours.shape != theirs.shape:
            raise AssertionError(f"{ours.shape} and {theirs.shape} pixels")
        for number, place in places_of(scene, directions):
            off = np.hypot(*(centre_of(ours, place) - centre_of(theirs, place)))
            worst, _ = max(worst, off), seen.add(number)
    report.add(f"camera, fit {fit}, {size[0]}x{size[1]}, pixels {aspect[0]:g}:{aspect[1]:g}, {frames} frames: marks of 20 not seen", 20 - len(seen), 20 - least)
    report.add("    marks of the plate in both pictures: largest distance", worst, 0.02, "px ")


def places_of(scene, directions):
    """Where Blender's own projection has the marks, of those well within the picture."""
    width, height = addon.size_of(scene.render)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    seen_by = scene.camera.evaluated_get(depsgraph)
    lens = seen_by.calc_matrix_camera(depsgraph, x=width, y=height, scale_x=scene.render.pixel_aspect_x, scale_y=scene.render.pixel_aspect_y)
    turn = seen_by.matrix_world.normalized().to_3x3().inverted()
    for number, direction in enumerate(directions):
        own = lens @ (turn @ Vector(direction)).to_4d()
        if own.w > 0.1:
            place = (0.5 + own.x / own.w / 2) * width, (0.5 - own.y / own.w / 2) * height
            if 12 < place[0] < width - 12 and 12 < place[1] < height - 12:
                yield number, place


def other_cameras(report, folder):
    for fit, size, aspect in (("VERTICAL", (480, 400), (1.0, 1.0)), ("AUTO", (360, 480), (1.0, 1.0)), ("HORIZONTAL", (400, 400), (1.5, 1.0))):
        cameras_agree(report, folder, fit, size, aspect, frames=2, least=5)


def wrong_is_said(report, folder):
    """What cannot be is one line, and leaves no file."""
    scene, said = fresh(), []
    addon.register()

    def refuses(call):
        try:
            said.append(call())
        except (addon.Refused, RuntimeError) as error:
            said.append(str(error))
    refuses(lambda: bpy.ops.nullscope.export_camera(filepath=str(folder / "no.toml")))
    camera(scene).data.type = "ORTHO"
    refuses(lambda: bpy.ops.nullscope.export_camera(filepath=str(folder / "no.toml")))
    support.write_exr(folder / "plain.exr", {"R": np.eye(4), "G": np.eye(4), "B": np.eye(4)})
    refuses(lambda: bpy.ops.nullscope.import_layers(filepath=str(folder / "plain.exr")))
    refuses(lambda: bpy.ops.nullscope.import_layers(filepath=str(folder / "missing.exr")))
    words = ("has no camera", "of type ORTHO; allowed: PERSP", "plain.exr has no layer", "there is no file")
    report.add("errors without their words", sum(word not in str(what) for word, what in zip(words, said)), 0)
    report.add("files that errors left", sum(1 for file in folder.iterdir() if file.name != "plain.exr"), 0)
    addon.unregister()


if __name__ == "__main__":
    support.main(PROGRAM, layers_arrive, plate_is_bent, cameras_agree, other_cameras, wrong_is_said)
