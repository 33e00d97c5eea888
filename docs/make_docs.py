"""Writes the user's guide with the table of options, which is made of the options themselves, to build/docs."""

import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
OUT = ROOT / "build" / "docs"
MARK = "<!-- options -->"


def options_table():
    """The options as a Markdown table."""
    from anisoquad import Options

    defaults = Options()
    rows = [f"| `{name}` | `{getattr(defaults, name)}` | {doc} |" for name, doc in Options.fields.items()]
    return "\n".join(["| Option | Default | Meaning |", "|---|---|---|", *rows])


def guide():
    """The guide's text with the table."""
    text = (ROOT / "docs" / "guide.md").read_text(encoding="utf-8")
    if text.count(MARK) != 1:
        raise ValueError(f"docs/guide.md must hold {MARK} once")
    return text.replace(MARK, options_table()).replace("../resources/screenshots/", "screenshots/")


def main():
    shutil.rmtree(OUT, ignore_errors=True)
    shutil.copytree(ROOT / "resources" / "screenshots", OUT / "screenshots")
    (OUT / "guide.md").write_text(guide(), encoding="utf-8")
    print(OUT / "guide.md")


if __name__ == "__main__":
    sys.path.insert(0, str(ROOT / "Mod"))
    main()
