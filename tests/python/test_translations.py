"""The .ts files hold every text of the workbench, translated, with the same places for figures."""

import re
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "resources" / "translations"))

import update  # noqa: E402


class Translations(unittest.TestCase):
    def test_every_text_is_translated(self):
        found = {(context, text) for context, texts in update.texts().items() for text in texts}
        self.assertGreater(len(found), 50)
        for language in update.LANGUAGES:
            known = update.read(update.FOLDER / f"AnisoQuad_{language}.ts")
            with self.subTest(language):
                self.assertEqual(found - set(known), set(), "run resources/translations/update.py")
                self.assertEqual([key for key in found if not known[key]], [], "not translated")

    def test_figures_have_their_places(self):
        for language in update.LANGUAGES:
            for (_, text), translation in update.read(update.FOLDER / f"AnisoQuad_{language}.ts").items():
                self.assertEqual(sorted(re.findall(r"{[^}]*}", text)), sorted(re.findall(r"{[^}]*}", translation or "")), (language, text))


if __name__ == "__main__":
    unittest.main()
