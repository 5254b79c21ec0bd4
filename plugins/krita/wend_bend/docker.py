# SPDX-License-Identifier: AGPL-3.0-or-later
"""Provides the docker, which chooses a project and a time and bends the active layer."""
import os
import subprocess

from krita import DockWidget, Krita
from PyQt5.QtCore import QSettings, Qt
from PyQt5.QtWidgets import (QApplication, QDoubleSpinBox, QFileDialog, QFormLayout, QLabel, QLineEdit, QMessageBox,
                             QPushButton, QToolButton, QHBoxLayout, QWidget)

from . import bending


class BendDocker(DockWidget):
    def __init__(self):
        super().__init__()
        self.setWindowTitle("Bend with Wend")
        body = QWidget(self)
        form = QFormLayout(body)
        self.project = QLineEdit(QSettings().value("wend_bend/project", ""))
        self.project.setToolTip("A project of Wend whose picture has the size of this document")
        choose = QToolButton(text="…")
        choose.setToolTip("Choose a project")
        choose.clicked.connect(self.choose)
        row = QHBoxLayout()
        row.addWidget(self.project)
        row.addWidget(choose)
        form.addRow("Project", row)
        self.time = QDoubleSpinBox(minimum=-1, maximum=1e4, value=-1, singleStep=0.1, decimals=3)
        self.time.setSpecialValueText("End")
        self.time.setToolTip("The time of the motion to bend to")
        form.addRow("Time", self.time)
        self.bend_button = QPushButton("Bend Layer")
        self.bend_button.setToolTip("Put the bent layer or group above the active one")
        self.bend_button.clicked.connect(self.bend)
        form.addRow(self.bend_button)
        start = QPushButton("Set Pins in Wend…")
        start.setToolTip("Write the active layer or group as a picture and open it in Wend, to make a project of it")
        start.clicked.connect(self.start)
        form.addRow(start)
        form.addRow(QLabel("The layer itself stays as it is."))
        self.setWidget(body)

    def canvasChanged(self, canvas):
        self.bend_button.setEnabled(canvas is not None)

    def active(self):
        document = Krita.instance().activeDocument()
        layer = document.activeNode() if document else None
        if layer is None:
            raise bending.Failure("There is no layer to bend.")
        return document, layer

    def choose(self):
        name, _ = QFileDialog.getOpenFileName(self, "Choose Project", self.project.text(), "Wend projects (*.wend)")
        if name:
            self.project.setText(name)

    def attempt(self, work):
        QApplication.setOverrideCursor(Qt.WaitCursor)
        try:
            work()
        except bending.Failure as failure:
            QApplication.restoreOverrideCursor()
            QMessageBox.warning(self, "Bend with Wend", str(failure))
        else:
            QApplication.restoreOverrideCursor()

    def bend(self):
        def work():
            document, layer = self.active()
            if not self.project.text():
                raise bending.Failure("Choose a project first.")
            bending.bend(document, layer, self.project.text(), self.time.value())
            QSettings().setValue("wend_bend/project", self.project.text())

        self.attempt(work)

    def start(self):
        def work():
            document, layer = self.active()
            beside = os.path.dirname(document.fileName()) or os.path.expanduser("~")
            name, _ = QFileDialog.getSaveFileName(
                self, "Write Layer", os.path.join(beside, layer.name() + ".png"), "PNG (*.png)")
            if not name:
                return
            bending.save_layer(document, layer, name)
            try:
                subprocess.Popen([bending.program(), name])
            except OSError:
                raise bending.Failure("The program wend was not found. Please install Wend.")

        self.attempt(work)
