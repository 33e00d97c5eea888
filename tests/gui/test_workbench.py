"""The workbench loads, and its commands know when they can run."""

import FreeCADGui
from PySide import QtGui
from window import WindowTest, wait

from anisoquad.commands import all_commands
from anisoquad.compat import qt_widgets, translate

NEEDS_NOTHING = ("AnisoQuad_Preferences",)


class Workbench(WindowTest):
    def test_it_is_listed_with_menu_and_tool_bar(self):
        self.assertIn("AnisoQuadWorkbench", FreeCADGui.listWorkbenches())
        window = FreeCADGui.getMainWindow()
        bars = [bar for bar in window.findChildren(qt_widgets().QToolBar) if bar.objectName() == "AnisoQuad"]
        self.assertEqual(len(bars), 1)
        commands = [command for command in all_commands() if command is not None]
        self.assertEqual(len([action for action in bars[0].actions() if not action.isSeparator()]), len(commands))
        self.assertIn("AnisoQuad", [action.text().replace("&", "") for action in window.menuBar().actions()])

    def test_every_command_has_icon_text_and_tooltip(self):
        shortcuts = []
        for command in filter(None, all_commands()):
            with self.subTest(command.NAME):
                resources = command.GetResources()
                self.assertFalse(QtGui.QIcon(resources["Pixmap"]).pixmap(64, 64).isNull())
                self.assertTrue(resources["MenuText"] and resources["ToolTip"])
                self.assertGreater(len(resources["WhatsThis"]), 100)
                self.assertIn(command.NAME, FreeCADGui.listCommands())
                shortcuts.append(resources.get("Accel"))
        used = [shortcut for shortcut in shortcuts if shortcut]
        self.assertEqual(len(used), len(set(used)))

    def test_commands_are_grey_when_they_can_not_run(self):
        active = lambda: {c.NAME for c in all_commands() if c is not None and c.IsActive()}  # noqa: E731
        self.select()
        self.assertEqual(active(), set(NEEDS_NOTHING))
        self.select(self.base)
        self.assertEqual(active(), {*NEEDS_NOTHING, "AnisoQuad_QuadMesh", "AnisoQuad_AddSource", "AnisoQuad_SuggestSources"})
        box = self.doc.addObject("Part::Box", "Box")
        self.doc.recompute()
        self.select(box)
        self.assertEqual(active(), {*NEEDS_NOTHING, "AnisoQuad_QuadMesh", "AnisoQuad_AddSource"})

    def test_it_speaks_the_users_language(self):
        self.addCleanup(FreeCADGui.setLocale, "English")
        for language, text in (("German", "Vierecknetz aus Netz"), ("French", "Maillage quadrangulaire à partir d’un maillage"),
                               ("Spanish", "Malla de cuadriláteros a partir de malla")):
            FreeCADGui.setLocale(language)
            wait(seconds=0.1)
            self.assertEqual(translate("AnisoQuad_QuadMesh", "Quad mesh from mesh"), text)

    def test_whats_this_and_options_are_in_the_users_language(self):
        self.addCleanup(FreeCADGui.setLocale, "English")
        FreeCADGui.setLocale("German")
        wait(seconds=0.1)
        bar = next(bar for bar in FreeCADGui.getMainWindow().findChildren(qt_widgets().QToolBar) if bar.objectName() == "AnisoQuad")
        pages = [action.whatsThis() for action in bar.actions() if not action.isSeparator()]
        self.assertIn("Vierecknetz aus dem gewählten Dreiecksnetz", pages[0])
        for command, page in zip(filter(None, all_commands()), pages):
            self.assertEqual(page, translate(command.NAME, command.WHATS_THIS))
            self.assertNotEqual(page, command.WHATS_THIS)
        quads = self.make_quad_mesh()
        FreeCADGui.ActiveDocument.setEdit(quads.Name)
        form = self.panel("QuadMeshPanel")
        growth = form.findChild(object, "RowGrowth")
        self.assertEqual(form.findChild(object, "options").labelForField(growth).text(), "Wachstum der Reihen")
        self.assertIn("Höhe einer Reihe", growth.toolTip())
        quads.touch()
        self.doc.recompute()
        self.assertEqual(form.findChild(object, "figures").text().count("Durchgang"), 1)
        for text in quads.RowsPerPass:
            self.assertRegex(text, "^Quelle 1, (links|rechts), Durchgang 1 .* Reihen zu [0-9]+ Spalten; (.*(Reihe|Rand|Spalte|Dreiecke|Viereck).*)$")
        self.screenshot("german")
        self.button("Abbrechen").click()

    def test_the_window_shows_it(self):
        self.select(self.base)
        wait(seconds=0.3)
        self.screenshot("workbench")
