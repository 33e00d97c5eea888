"""The user's guide: every option is in its table, every picture and file that it names is there."""

import re
import sys
import unittest
from pathlib import Path

from anisoquad import Options

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs"))

import make_docs  # noqa: E402


class Guide(unittest.TestCase):
    def test_the_table_has_every_option_with_its_default(self):
        text = make_docs.guide()
        for name in Options.fields:
            self.assertIn(f"| `{name}` | `{getattr(Options(), name)}` |", text)

    def test_pictures_exist(self):
        for document in ("docs/guide.md", "README.md"):
            path = ROOT / document
            pictures = re.findall(r"!\[[^\]]*\]\(([^)]*)\)", path.read_text(encoding="utf-8"))
            self.assertTrue(pictures, document)
            for picture in pictures:
                self.assertTrue((path.parent / picture).is_file(), f"{document}: {picture}")
                self.assertLess((path.parent / picture).stat().st_size, 200_000, picture)

    def test_named_files_exist(self):
        text = (ROOT / "docs" / "guide.md").read_text(encoding="utf-8")
        for name in re.findall(r"`((?:tests|resources)/[^`]*\.(?:py|off))`", text):
            self.assertTrue((ROOT / name).is_file() or "NAME" in name, name)


if __name__ == "__main__":
    unittest.main()
