"""A run inside a recompute, which in a window has to listen for Esc."""

import FreeCAD


def run_in_recompute(job):
    """job.run(progress); with a GUI Esc ends it: Cancelled."""
    if not FreeCAD.GuiUp:
        return job.run()
    from ..escape import stoppable

    with stoppable() as progress:
        return job.run(progress)
