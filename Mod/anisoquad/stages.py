"""The stages of a run, of which progress(stage, fraction) tells, as they are shown."""

from .translation import QT_TRANSLATE_NOOP

TITLES = {
    "triangulate": QT_TRANSLATE_NOOP("Stages", "Triangulating"),
    "repair": QT_TRANSLATE_NOOP("Stages", "Repairing"),
    "check": QT_TRANSLATE_NOOP("Stages", "Checking"),
    "features": QT_TRANSLATE_NOOP("Stages", "Finding features"),
    "prepare": QT_TRANSLATE_NOOP("Stages", "Preparing triangles"),
    "rows": QT_TRANSLATE_NOOP("Stages", "Building rows"),
    "parity": QT_TRANSLATE_NOOP("Stages", "Evening out patches"),
    "fill": QT_TRANSLATE_NOOP("Stages", "Filling with quads"),
    "clean-up": QT_TRANSLATE_NOOP("Stages", "Cleaning up"),
    "smoothing": QT_TRANSLATE_NOOP("Stages", "Smoothing"),
    "report": QT_TRANSLATE_NOOP("Stages", "Measuring"),
}


def stage_title(stage):
    """What is shown of a stage, in English; translated in the context Stages."""
    return TITLES.get(stage, stage)
