"""Writes groups.kra, groups.ora and groups.psd into the current folder.

Run it by `kritarunner -s groups_in_krita` of Krita 5.1.5 with PYTHONPATH at this folder. Krita renders the pictures of
all layers. Colour profiles and previews were removed from the archives afterwards.
"""
import os

from krita import Krita, InfoObject
from PyQt5.QtCore import QByteArray
OUT = os.getcwd()
W, H = 40, 32

def pixels(colour):
    data = bytearray()
    for y in range(H):
        for x in range(W):
            r, g, b, a = colour(x, y)
            data += bytes((b, g, r, a))
    return QByteArray(bytes(data))

def disc(cx, cy, radius, rgb):
    def colour(x, y):
        d = ((x + .5 - cx) ** 2 + (y + .5 - cy) ** 2) ** .5
        a = max(0.0, min(1.0, (radius - d) / 4 + .5))
        return (min(255, rgb[0] + 2 * x), min(255, rgb[1] + y), rgb[2], round(255 * a))
    return colour

def band(y0, y1, rgb, alpha):
    return lambda x, y: (*rgb, alpha if y0 <= y < y1 else 0)

def work(kind):
    ora = kind != "kra"
    app = Krita.instance()
    doc = app.createDocument(W, H, "groups", "RGBA", "U8", "", 72)
    doc.setBatchmode(True)
    root = doc.rootNode()
    for node in root.childNodes(): node.remove()
    def layer(parent, name, colour, blend="normal", opacity=255, inherit=False, visible=True):
        node = doc.createNode(name, "paintlayer")
        node.setPixelData(pixels(colour), 0, 0, W, H)
        node.setBlendingMode(blend)
        node.setOpacity(opacity)
        parent.addChildNode(node, None)
        if inherit: node.setInheritAlpha(True)
        node.setVisible(visible)
        return node
    def group(parent, name, blend="normal", opacity=255, passing=False):
        node = doc.createGroupLayer(name)
        node.setBlendingMode(blend)
        node.setOpacity(opacity)
        parent.addChildNode(node, None)
        node.setPassThroughMode(passing)
        return node
    layer(root, "ground", lambda x, y: (200 - 2 * x, 90 + 4 * y, 120, 255))
    body = group(root, "body", opacity=255, passing=True)
    layer(body, "torso", disc(14, 18, 10, (180, 60, 40)))
    legs = group(root, "legs", opacity=128)
    layer(legs, "left", disc(10, 24, 7, (20, 90, 160)))
    layer(legs, "right", disc(17, 25, 7, (120, 190, 10)))
    arm = group(root, "arm")
    layer(arm, "skin", disc(26, 14, 11, (60, 120, 100)))
    layer(arm, "shade", band(8, 15, (90, 80, 160), 200), blend="multiply", inherit=not ora)
    layer(arm, "light", band(13, 22, (60, 40, 20), 255), blend={"kra": "add", "ora": "normal", "psd": "screen"}[kind], opacity=180, inherit=kind != "psd")
    layer(arm, "off", band(3, 5, (255, 0, 0), 255), inherit=True, visible=False)
    glow = group(root, "glow", blend="screen", opacity=200)
    layer(glow, "near", disc(30, 24, 6, (90, 20, 60)))
    layer(glow, "far", disc(34, 22, 6, (10, 80, 30)))
    doc.refreshProjection(); doc.waitForDone()
    doc.exportImage(f"{OUT}/groups.{kind}", InfoObject())


def __main__(arguments):
    for kind in ("kra", "ora", "psd"):
        work(kind)
