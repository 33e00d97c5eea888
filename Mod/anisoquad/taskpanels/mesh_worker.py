"""Meshing off the GUI's thread."""

import threading

from PySide import QtCore

_POLL = 40  # milliseconds


class MeshWorker:
    """Runs one task on a thread of its own, and tells the GUI's thread how it goes.

    task(progress) -- MeshJob.run or the like
    on_progress(stage, fraction), on_done(result), on_error(exception) -- called on the GUI's thread
    """

    def __init__(self, task, on_progress, on_done, on_error):
        self._task = task
        self._on_progress = on_progress
        self._on_done = on_done
        self._on_error = on_error
        self._cancelled = False
        self._state = ("", 0.0)
        self._outcome = None
        self._thread = threading.Thread(target=self._run, name="AnisoQuad", daemon=True)
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._poll)

    def start(self):
        self._thread.start()
        self._timer.start(_POLL)

    def cancel(self):
        """End the run at the mesher's next report; on_error gets Cancelled."""
        self._cancelled = True

    def abandon(self):
        """The same, and nothing is called any more."""
        self.cancel()
        self._timer.stop()

    def _run(self):
        try:
            self._outcome = (self._on_done, self._task(self._progress))
        except Exception as error:  # whatever it is, the GUI's thread has to know
            self._outcome = (self._on_error, error)

    def _progress(self, stage, fraction):
        self._state = (stage, fraction)
        return not self._cancelled

    def _poll(self):
        self._on_progress(*self._state)
        if self._outcome is not None and self._timer.isActive():  # not abandoned
            self._timer.stop()
            call, argument = self._outcome
            call(argument)
