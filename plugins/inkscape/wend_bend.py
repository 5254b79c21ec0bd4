#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Bends the selected paths in the same manner as a project of Wend bends its picture.

`wend run --points` maps samples of the paths, and new curves are fitted to the mapped samples. Strokes keep their width."""

import json
import os
import subprocess
import tempfile

import inkex

import wend_curves

_ = inkex.localization.inkex_gettext


def wend(*arguments):
    """Runs wend, or the program that the environment variable WEND names, and returns its output. If the program fails,
    its message ends the extension."""
    try:
        done = subprocess.run([os.environ.get("WEND", "wend"), *arguments], capture_output=True, text=True)
    except OSError:
        raise inkex.AbortExtension(_("The program wend was not found. Please install Wend."))
    if done.returncode:
        raise inkex.AbortExtension(done.stderr.strip())
    return done.stdout


def mapped(project, points, at):
    """Returns the positions of points in the deformed shape, as complex numbers in the project's coordinates. A negative
    time means the end."""
    with tempfile.TemporaryDirectory() as folder:
        before, after = os.path.join(folder, "before.csv"), os.path.join(folder, "after.csv")
        with open(before, "w") as file:
            file.write("x,y\n" + "".join(f"{p.real!r},{p.imag!r}\n" for p in points))
        time = [] if at < 0 else ["--at", repr(at)]
        wend("run", project, "--quiet", "--points", before, after, *time)
        with open(after) as file:
            return [complex(*map(float, line.split(","))) for line in list(file)[1:]]


def picture_size(project):
    """Returns the width and height of the picture that the project bends."""
    domain = json.loads(wend("info", "--json", project))["domain"]
    name = domain.get("texture") or (domain["kind"] == "image" and domain["file"])
    if not name:
        raise inkex.AbortExtension(_("This project bends no single picture. Choose “at the origin, a unit per pixel”."))
    picture = json.loads(wend("info", "--json", os.path.join(os.path.dirname(project), name)))
    return picture["width"], picture["height"]


def through(transform, z):
    return complex(*transform.apply_to_point((z.real, z.imag)))


def chains(path):
    """Returns the subpaths as pairs of a list of cubics and whether the subpath is closed."""
    result = []
    for piece in path.proxy_iterator():
        if piece.letter in "Mm":
            result.append(([], False))
            continue
        begin = complex(*piece.previous_end_point)
        if piece.letter in "Zz":
            end = complex(*piece.end_point)
            if abs(end - begin) > 1e-9:
                result[-1][0].append((begin, begin + (end - begin) / 3, end - (end - begin) / 3, end))
            result[-1] = (result[-1][0], True)
            result.append(([], False))  # segments that follow without a move begin there
            continue
        for curve in piece.to_curves():
            a, b, c = (complex(curve.args[k], curve.args[k + 1]) for k in (0, 2, 4))
            if not begin == a == b == c:
                result[-1][0].append((begin, a, b, c))
            begin = c
    return [chain for chain in result if chain[0]]


def written(chain, closed):
    begin = chain[0][0]
    commands = [inkex.paths.Move(begin.real, begin.imag)]
    for _first, a, b, c in chain:
        commands.append(inkex.paths.Curve(a.real, a.imag, b.real, b.imag, c.real, c.imag))
    return commands + ([inkex.paths.ZoneClose()] if closed else [])


class BendWithWend(inkex.EffectExtension):
    def add_arguments(self, pars):
        pars.add_argument("--project", default="")
        pars.add_argument("--place", default="page")
        pars.add_argument("--at", type=float, default=-1)
        pars.add_argument("--precision", type=float, default=0.1)

    def effect(self):
        if not os.path.isfile(self.options.project):
            raise inkex.AbortExtension(_("Please choose the project, a file *.wend."))
        shapes = self.shapes(self.svg.selection.rendering_order())
        if not shapes:
            raise inkex.AbortExtension(_("Please select what is to be bent: paths or shapes."))
        to_pixels = self.to_pixels()
        # Samples are taken in the project's coordinates, in which the shape is bent; curves are fitted in those of the drawing.
        to_drawing = -to_pixels
        rest = []
        for shape in shapes:
            whole = to_pixels @ shape.composed_transform()
            rest.append([([tuple(through(whole, z) for z in one) for one in chain], closed)
                         for chain, closed in chains(shape.path.to_absolute())])
        samples = [wend_curves.sampled(one) for shape in rest for chain, _closed in shape for one in chain]
        images = iter(mapped(self.options.project, [z for one in samples for z in one], self.options.at))
        images = iter([[through(to_drawing, next(images)) for _z in one] for one in samples])
        for shape, subpaths in zip(shapes, rest):
            back = -shape.composed_transform()
            path = []
            for chain, closed in subpaths:
                curves = wend_curves.bent(chain, [next(images) for _one in chain], closed, self.options.precision)
                path += written([tuple(through(back, z) for z in one) for one in curves], closed)
            shape.path = inkex.Path(path)
            for key in ("inkscape:original-d", "inkscape:path-effect", "sodipodi:nodetypes"):
                shape.attrib.pop(inkex.addNS(key.split(":")[1], key.split(":")[0]), None)

    def shapes(self, elements):
        """Returns the paths among the elements and in their groups. Converts other shapes to paths."""
        result = []
        for one in elements:
            if isinstance(one, inkex.Group):
                result += self.shapes(list(one))
            elif isinstance(one, inkex.PathElement):
                result.append(one)
            elif isinstance(one, (inkex.TextElement, inkex.Use)):
                inkex.errormsg(_("{} stays as it is: convert it to a path first.").format(one.get_id()))
            elif isinstance(one, inkex.ShapeElement) and not isinstance(one, inkex.Image):
                path = one.to_path_element()
                one.replace_with(path)
                result.append(path)
        return result

    def to_pixels(self):
        """Returns the transform from the drawing's coordinates to those of the project."""
        if self.options.place == "units":
            return inkex.Transform()
        width, height = picture_size(self.options.project)
        if self.options.place == "image":
            image = next(iter(self.svg.selection.filter(inkex.Image)), None)
            if image is None:
                raise inkex.AbortExtension(_("Please select the image, too, whose place the project's picture has."))
            place = image.composed_transform() @ inkex.Transform(
                (image.width / width, 0, 0, image.height / height, image.left, image.top))
        else:
            left, top, wide, high = self.svg.get_viewbox()
            place = inkex.Transform(((wide or self.svg.viewport_width) / width, 0, 0,
                                     (high or self.svg.viewport_height) / height, left, top))
        return -place


if __name__ == "__main__":
    BendWithWend().run()
