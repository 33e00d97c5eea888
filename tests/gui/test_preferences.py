"""The preferences page, and that its values are used."""

import FreeCAD
import FreeCADGui
from PySide import QtCore
from window import WindowTest

from anisoquad import preferences
from anisoquad.compat import qt_widgets

GROUP = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/AnisoQuad")


class Preferences(WindowTest):
    def setUp(self):
        super().setUp()
        self.addCleanup(GROUP.Clear)

    def test_the_page_writes_what_new_objects_use(self):
        found = {}

        def change():
            dialog = qt_widgets().QApplication.activeModalWidget()
            box = dialog.findChild(qt_widgets().QSpinBox, "anisotropy")
            found["shown"] = box.isVisible()
            found["default"] = box.value()
            box.setValue(6)
            dialog.findChild(qt_widgets().QDialogButtonBox).button(qt_widgets().QDialogButtonBox.Ok).click()

        QtCore.QTimer.singleShot(500, change)
        FreeCADGui.runCommand("AnisoQuad_Preferences")
        self.assertEqual(found, {"shown": True, "default": 16})
        self.assertEqual(preferences.anisotropy(), 6)
        self.select(self.base)
        self.run_command("AnisoQuad_AddSource")
        self.assertEqual(self.doc.getObject("Source").Anisotropy, 6)
        self.button("Cancel").click()

    def test_defaults(self):
        self.assertEqual((preferences.anisotropy(), preferences.element_order(), preferences.hide_base(), preferences.line_width()),
                         (16, 1, True, 4))
