"""The window stays alive while a large mesh is made. ANISOQUAD_TEST_TRIANGLES says how large; 1000000 takes minutes."""

import os
import threading
import time
from pathlib import Path
from unittest import mock

import FreeCADGui
import numpy as np
from PySide import QtCore
from window import WindowTest, wait

import anisoquad
from anisoquad.convert import mesh_of
from anisoquad.taskpanels.quad_mesh_panel import QuadMeshPanel

TRIANGLES = int(os.environ.get("ANISOQUAD_TEST_TRIANGLES", 100000))
LONGEST = 0.2  # seconds


class Pulse:
    """Measures how long the event loop was away, without the time in which other programs had the processor."""

    def __init__(self):
        self.longest = 0.0
        self.beats = 0
        self._last = None
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._beat)

    def start(self):
        self._last = time.monotonic(), waited()
        self._timer.start(5)

    def _beat(self):
        now = time.monotonic(), waited()
        away, others = (after - before for after, before in zip(now, self._last))
        self.longest = max(self.longest, away - max(others, 0.0))
        self.beats += 1
        self._last = now

    def stop(self):
        self._timer.stop()


def waited():
    """Seconds in which Python's threads could have run, had the processor been free; 0 where the system does not tell."""
    total = 0
    for thread in threading.enumerate():
        try:
            total += int(Path(f"/proc/self/task/{thread.native_id}/schedstat").read_text().split()[1])
        except OSError:  # the thread has ended, or this is not Linux
            pass
    return total / 1e9


class Responsiveness(WindowTest):
    def test_the_event_loop_is_never_away_while_meshing(self):
        side = int((TRIANGLES / 2) ** 0.5)
        self.base.Mesh = waves(side)
        self.base.ViewObject.Visibility = False  # drawing it without a graphics card takes longer than what is measured
        # A busy machine can still stop the window for so long, but hardly three times; what we did wrong would show each time.
        pauses = []
        while len(pauses) < 3 and (not pauses or pauses[-1] >= LONGEST):
            pauses.append(self.longest_pause(side))
        self.assertLess(pauses[-1], LONGEST, pauses)

    def longest_pause(self, side):
        """Mesh in the panel; returns the event loop's longest pause in seconds."""
        quads = anisoquad.make_quad_mesh(self.doc, base=self.base, sources=[list(range(side + 1))], anisotropy=4)
        quads.purgeTouched()
        pulse, taken = Pulse(), {}
        hand_over = QuadMeshPanel._done

        def done(panel, run):
            pulse.stop()  # what follows is not meshing: FreeCAD takes the mesh over in one go
            taken["meshing"] = time.monotonic() - started
            hand_over(panel, run)
            taken["hand-over"] = time.monotonic() - started - taken["meshing"]

        with mock.patch.object(QuadMeshPanel, "_done", done):
            FreeCADGui.ActiveDocument.setEdit(quads.Name)
            form = self.panel("QuadMeshPanel")
            seen = set()
            form.findChild(object, "progress").valueChanged.connect(seen.add)
            self.assertTrue(wait(lambda: form.findChild(object, "cancel").isEnabled(), 60))
            started = time.monotonic()
            pulse.start()
            self.assertTrue(wait(lambda: not form.findChild(object, "cancel").isEnabled(), 1800))
        print(f"{TRIANGLES} triangles: meshed in {taken['meshing']:.1f} s, {pulse.beats} beats, longest pause {1000 * pulse.longest:.0f} ms; "
              f"hand-over to the document {taken['hand-over']:.1f} s")
        self.assertGreater(quads.Quads, TRIANGLES // 8)
        self.assertGreater(pulse.beats, 10 * taken["meshing"])
        self.assertGreater(len(seen), 5, "the progress bar did not move")
        quads.ViewObject.Visibility = False
        self.button("Cancel").click()
        wait()
        return pulse.longest


def waves(side):
    """A Mesh.Mesh of side × side cells in waves."""
    x, y = np.meshgrid(np.arange(side + 1.0), np.arange(side + 1.0))
    points = np.column_stack([x.ravel(), y.ravel(), 3.0 * np.sin(x / 15).ravel() * np.cos(y / 20).ravel()])
    a = (np.arange(side)[:, None] * (side + 1) + np.arange(side)).ravel()
    triangles = np.concatenate([np.column_stack([a, a + 1, a + side + 2]), np.column_stack([a, a + side + 2, a + side + 1])])
    return mesh_of(points, triangles)
