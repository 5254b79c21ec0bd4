# SPDX-License-Identifier: AGPL-3.0-or-later
"""Bends a layer of Krita in the same manner as a project of Wend bends its picture, by running the program `wend`."""
import json
import os
import subprocess
import tempfile

from krita import InfoObject, Krita
from PyQt5.QtCore import QRect


class Failure(Exception):
    """An error whose message is shown to the user."""


def program():
    """Returns the program that the environment variable WEND names, or `wend`."""
    return os.environ.get("WEND", "wend")


def wend(*arguments, folder=None, text=""):
    """Runs the program in a folder with `text` as its input and returns its output."""
    try:
        done = subprocess.run([program(), *arguments], cwd=folder, input=text, capture_output=True, text=True)
    except OSError:
        raise Failure("The program wend was not found. Please install Wend.")
    if done.returncode:
        raise Failure(done.stderr.strip())
    return done.stdout


def save_layer(document, layer, file):
    """Writes a layer or group as a PNG of the document's size, with the layer's colour profile and depth."""
    options = InfoObject()
    for name, value in {"alpha": True, "compression": 1, "forceSRGB": False, "indexed": False, "interlaced": False,
                        "saveSRGBProfile": True, "transparencyFillcolor": [255, 255, 255]}.items():
        options.setProperty(name, value)
    frame = QRect(0, 0, document.width(), document.height())
    # Outside batch mode, Krita asks for the options of the format.
    Krita.instance().setBatchmode(True)
    try:
        layer.save(file, document.xRes(), document.yRes(), options, frame)
    finally:
        Krita.instance().setBatchmode(False)
    if not os.path.exists(file):
        raise Failure(f"The layer could not be written to {file}")


def with_picture(project, document, picture):
    """Returns the text of a project with its picture replaced by another one of the same size."""
    try:
        with open(project, encoding="utf-8") as file:
            content = json.load(file)
        own = content["domain"]["image"]
    except (OSError, ValueError, KeyError, TypeError):
        raise Failure(f"{project} is not a project of a single picture")
    info = json.loads(wend("info", "--json", os.path.join(os.path.dirname(project), own)))
    size, ours = (info["width"], info["height"]), (document.width(), document.height())
    if size != ours:
        raise Failure("The project bends a picture of {} × {} pixels; this document has {} × {}".format(*size, *ours))
    content["domain"]["image"] = picture
    return json.dumps(content)


def add_layer(document, layer, file, name):
    """Adds a picture file as a layer above another one, converted to the document's colours, and returns the new layer."""
    loaded = Krita.instance().openDocument(file)
    if loaded is None:
        raise Failure("The bent picture could not be read")
    try:
        loaded.setBatchmode(True)
        loaded.setColorSpace(document.colorModel(), document.colorDepth(), document.colorProfile())
        loaded.waitForDone()
        pixels = loaded.pixelData(0, 0, document.width(), document.height())
    finally:
        loaded.close()
    bent = document.createNode(name, "paintlayer")
    bent.setColorSpace(document.colorModel(), document.colorDepth(), document.colorProfile())
    bent.setPixelData(pixels, 0, 0, document.width(), document.height())
    layer.parentNode().addChildNode(bent, layer)
    document.refreshProjection()
    return bent


def bend(document, layer, project, time=-1.0):
    """Bends a layer or group and returns the new layer above it. A negative time means the end of the motion."""
    project = os.path.abspath(project)
    with tempfile.TemporaryDirectory() as folder:
        before, after = os.path.join(folder, "before.png"), os.path.join(folder, "after.png")
        save_layer(document, layer, before)
        at = [] if time < 0 else ["--at", repr(time)]
        wend("run", "-", "--quiet", "--image", after, *at, folder=os.path.dirname(project),
             text=with_picture(project, document, before))
        return add_layer(document, layer, after, layer.name() + ", bent")
