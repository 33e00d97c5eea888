"""FreeCAD shows the documentation of properties translated in the context App::Property: all of ours has an entry there."""

import sys
import unittest
from pathlib import Path

from documents import DocumentTest

import anisoquad

sys.path.append(str(Path(__file__).resolve().parents[2] / "resources" / "translations"))

import update  # noqa: E402

_GROUPS = ("QuadMesh", "Source", "Triangles", "Options", "Result", "Internal")


class PropertyTexts(DocumentTest):
    def test_every_property_has_a_text_that_is_translated(self):
        box = self.doc.addObject("Part::Box", "Box")
        quads = anisoquad.make_quad_mesh(self.doc, base=box)
        source = anisoquad.make_source(self.doc, quads.Base)
        for language in update.LANGUAGES:
            known = update.read(update.FOLDER / f"AnisoQuad_{language}.ts")
            for obj in (quads, quads.Base, source):
                ours = [name for name in obj.PropertiesList if obj.getGroupOfProperty(name) in _GROUPS]
                self.assertGreater(len(ours), 7, obj.Name)
                for name in ours:
                    text = obj.getDocumentationOfProperty(name)
                    self.assertTrue(known.get(("App::Property", text)), (language, obj.Name, name, text))


if __name__ == "__main__":
    unittest.main()
