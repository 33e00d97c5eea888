"""What runs inside a recompute: in a window it has to listen for Esc, and its errors are for the user."""

import functools

import FreeCAD

from ..errors import MeshError


def run_in_recompute(job):
    """job.run(progress); with a GUI Esc ends it: Cancelled."""
    if not FreeCAD.GuiUp:
        return job.run()
    from ..escape import stoppable

    with stoppable() as progress:
        return job.run(progress)


def told_briefly(execute):
    """An object's execute() whose MeshErrors come without the calls that led to them: FreeCAD prints those before the message."""

    @functools.wraps(execute)
    def run(self, obj):
        try:
            return execute(self, obj)
        except MeshError as error:
            raise error.with_traceback(None) from None

    return run
