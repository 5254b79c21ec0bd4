# SPDX-License-Identifier: AGPL-3.0-or-later
from krita import DockWidgetFactory, DockWidgetFactoryBase, Krita

from .docker import BendDocker

Krita.instance().addDockWidgetFactory(
    DockWidgetFactory("wend_bend", DockWidgetFactoryBase.DockRight, BendDocker))
