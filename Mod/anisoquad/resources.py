"""Where the add-on's resources are."""

from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "resources"


def icon(name):
    return str(FOLDER / "icons" / f"{name}.svg")


def icons():
    return str(FOLDER / "icons")


def ui_file(name):
    return str(FOLDER / "ui" / f"{name}.ui")


def translations():
    return str(FOLDER / "translations")
