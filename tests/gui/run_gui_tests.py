"""Runs the tests in a real window: FreeCAD on a virtual screen, with the repository as its only add-on.

python3 tests/gui/run_gui_tests.py [name of a test module, class or method] …
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIMIT = int(os.environ.get("ANISOQUAD_GUI_LIMIT", 600))  # seconds, after which the tests tell where they hang


def main(names):
    with tempfile.TemporaryDirectory() as home:
        (Path(home) / "Mod").mkdir()
        (Path(home) / "Mod" / "AnisoQuad").symlink_to(ROOT)
        result = Path(home) / "result"
        environment = dict(os.environ, HOME=home, FREECAD_USER_HOME=home, LIBGL_ALWAYS_SOFTWARE="1", QTWEBENGINE_DISABLE_SANDBOX="1",
                           PYTHONDONTWRITEBYTECODE="1", ANISOQUAD_GUI_TESTS=" ".join(names), ANISOQUAD_GUI_RESULT=str(result), ANISOQUAD_GUI_LIMIT=str(LIMIT))
        command = ["xvfb-run", "-a", "-s", "-screen 0 1400x1000x24 -dpi 96", "freecad", str(ROOT / "tests" / "gui" / "gui_tests.FCMacro")]
        try:
            subprocess.run(command, env=environment, timeout=LIMIT + 60, check=False, stdin=subprocess.DEVNULL)
        except subprocess.TimeoutExpired:
            print(f"The window was still open after {LIMIT + 60} s.", file=sys.stderr)
        text = result.read_text() if result.exists() else "FreeCAD ended before the tests did.\n" + read(result.with_suffix(".log"))
    print(text)
    return 0 if text.rstrip().endswith("OK") else 1


def read(path):
    return path.read_text() if path.exists() else ""


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
