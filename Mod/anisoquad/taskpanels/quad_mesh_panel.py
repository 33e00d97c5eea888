"""The panel of a quad mesh: sources and options, and meshing while the window stays alive."""

import FreeCAD
import FreeCADGui
from PySide import QtCore

from .. import preferences
from ..commands.add_source_command import add_source
from ..commands.command import open_transaction, record, reference
from ..commands.selection import is_mesh
from ..compat import button_box, button_name, load_ui, translate
from ..errors import Cancelled, MeshError
from ..objects.mesh_job import MeshJob, row_edges
from ..objects.source_object import is_source
from ..objects.triangles_object import is_triangles
from ..resources import ui_file
from ..stages import stage_title
from .cad_form import CadForm
from .figures import figures_text
from .highlight import Highlight
from .mesh_worker import MeshWorker
from .option_form import OptionForm
from .row_preview import RowPreview
from .source_table import SourceTable


class QuadMeshPanel:
    """Task panel of a quad mesh object. An object without quads is meshed at once."""

    def __init__(self, obj):
        self.obj = obj
        open_transaction(obj.Document, f"Edit {obj.Label}")
        self.form = form = load_ui(ui_file("quad_mesh"))
        obj.Proxy.remember(obj)
        self.worker = None
        self._close_when_done = False
        self._previewed = None, None  # key of the job of the last preview, and its rows
        self.highlight = Highlight(FreeCADGui.ActiveDocument.ActiveView)
        self.preview = RowPreview(FreeCADGui.ActiveDocument.ActiveView)
        self.bases = [other for other in obj.Document.Objects if is_mesh(other)]
        form.base.addItems([base.Label for base in self.bases])
        form.base.setCurrentIndex(self.bases.index(obj.Base) if obj.Base in self.bases else -1)
        form.order.setCurrentIndex(1 if obj.ElementOrder == "2nd" else 0)
        self.options = OptionForm(form.options, obj)
        self.cad = CadForm(form, obj)
        self.sources = SourceTable(form.sources)
        self.sources.fill(obj.Sources)
        form.figures.setText(figures_text(obj))
        self._show_base()
        form.base.currentIndexChanged.connect(self._show_base)
        form.add.clicked.connect(self._add_source)
        form.edit.clicked.connect(self._edit_source)
        form.remove.clicked.connect(self._remove_source)
        form.preview.toggled.connect(self._preview_rows)
        form.cancel.clicked.connect(self._stop)
        form.sources.itemSelectionChanged.connect(self._show_selected)
        if obj.Quads == 0 and obj.Base is not None:
            QtCore.QTimer.singleShot(0, self.apply)

    def getStandardButtons(self):
        return button_box("Ok", "Apply", "Cancel")

    def clicked(self, button):
        if button_name(button) == "Apply":
            self.apply()

    def accept(self):
        """OK: mesh when something has changed, then close."""
        if self.worker is not None:
            self._close_when_done = True
            return False
        if not self._write():
            return False
        if self._is_current():
            self._close()
            return True
        self._close_when_done = True
        self._start()
        return False

    def reject(self):
        """Cancel: stop meshing, and take back everything since the panel was opened."""
        if self.worker is not None:
            self.worker.abandon()
        self._leave()
        FreeCAD.ActiveDocument.abortTransaction()
        FreeCADGui.ActiveDocument.resetEdit()
        FreeCAD.ActiveDocument.recompute()  # a FemMesh does not come back by itself; the run is still known
        return True

    def apply(self):
        """Keep what is set, and mesh."""
        if self.worker is None and self._write():
            self._start()

    def _write(self):
        """Set the properties; recorded. False, with a message, when something can not be read."""
        name = reference(self.obj)
        try:
            lines = self.sources.lines()
        except MeshError as error:
            self._fail(error)
            return False
        base = self._base()
        if base is not self.obj.Base:
            lines.append(f"{name}.Base = {reference(base)}")
        values = {"ElementOrder": "2nd" if self.form.order.currentIndex() else "1st"}
        changes = self.options.changes()
        changes.update({key: value for key, value in values.items() if getattr(self.obj, key) != value})
        changes.update(self.cad.changes())
        lines += self.cad.triangle_lines(base, changes)
        record(*lines, *(f"{name}.{key} = {value!r}" for key, value in changes.items()))
        return True

    def _is_current(self):
        return self.obj.Quads > 0 and not any("Touched" in other.State for other in (self.obj, self.obj.Base, *self.obj.Sources) if other)

    def _base(self):
        """The mesh object that is chosen, or None."""
        return self.bases[self.form.base.currentIndex()] if self.form.base.currentIndex() >= 0 else None

    def _show_base(self, *_):
        self.cad.show(self._base())

    def _start(self):
        self.form.preview.setChecked(False)
        self._triangulate(self._mesh)

    def _triangulate(self, go_on):
        """Have the base's triangles made where that takes a run of Gmsh; go_on() follows."""
        try:
            job = self.obj.Base.Proxy.missing_run(self.obj.Base) if is_triangles(self.obj.Base) else None
        except MeshError as error:
            self._fail(error)
            return
        if job is None:
            go_on()
        else:
            self._run(job.run, lambda mesh: self._keep_triangles(job, mesh, go_on))

    def _keep_triangles(self, job, mesh, go_on):
        self._stopped()
        self.obj.Base.Proxy.keep(job, mesh)
        go_on()

    def _mesh(self):
        job = self._job()
        if job is not None:
            self._run(job.run_for_document, self._done)

    def _job(self):
        """The object's MeshJob; None, with what is wrong shown, when its properties can not be read."""
        self.highlight.clear()
        try:
            for other in (self.obj.Base, *self.obj.Sources):
                if is_triangles(other) and "Touched" in other.State or is_source(other):
                    other.recompute()
            return MeshJob.of(self.obj)
        except MeshError as error:
            self._fail(error)
            return None

    def _run(self, task, done):
        """Begin a task(progress); done(result) follows."""
        self.form.figures.setText(translate("QuadMeshPanel", "Meshing…"))
        self.form.cancel.setEnabled(True)
        self.worker = MeshWorker(task, self._show_progress, done, self._fail)
        self.worker.start()

    def _stop(self):
        if self.worker is not None:
            self.worker.cancel()

    def _show_progress(self, stage, fraction):
        if self.form is None:  # FreeCAD has closed the panel, as it does with the document
            self.worker.abandon()
            return
        self.form.progress.setValue(int(1000 * fraction))
        title = translate("Stages", stage_title(stage)) if stage else ""
        self.form.progress.setFormat(f"{title} %p %".lstrip())

    def _stopped(self):
        self.worker = None
        self.form.cancel.setEnabled(False)

    def _done(self, run):
        self._stopped()
        self.obj.Proxy.keep(run)
        self.obj.touch()
        record("FreeCAD.ActiveDocument.recompute()")
        self.form.progress.setValue(1000)
        self.form.progress.setFormat("%p %")
        self.form.figures.setText(figures_text(self.obj))
        self.sources.fill(self.obj.Sources)
        if preferences.hide_base() and self.obj.Base.ViewObject is not None:
            self.obj.Base.ViewObject.Visibility = False
        if self._close_when_done:
            self._close()

    def _fail(self, error):
        """Say what is wrong, and show where; the old mesh stays."""
        self._stopped()
        self._close_when_done = False
        self.form.preview.setChecked(False)
        self.form.progress.setValue(0)
        self.form.progress.setFormat("%p %")
        if isinstance(error, Cancelled):
            self.form.figures.setText(translate("QuadMeshPanel", "Stopped. The old mesh was kept."))
            return
        self.form.figures.setText(str(error))
        FreeCAD.Console.PrintError(f"{self.obj.Label}: {error}\n")
        if isinstance(error, MeshError):
            self.highlight.show(error, self.obj.Base)

    def _add_source(self):
        if self.obj.Base is None or not self._write():
            return
        source = add_source(self.obj.Base, [self.obj], preferences.anisotropy())
        self._edit(source)

    def _edit_source(self):
        source = self.sources.selected()
        if source is not None and self._write():
            self._edit(source)

    def _edit(self, source):
        """Leave this panel for that of a source."""
        self._leave()
        name, gui_doc = source.Name, FreeCADGui.ActiveDocument
        gui_doc.resetEdit()
        QtCore.QTimer.singleShot(0, lambda: gui_doc.setEdit(name))

    def _remove_source(self):
        source = self.sources.selected()
        if source is not None and self._write():
            kept = [other for other in self.obj.Sources if other is not source]
            record(f"{reference(self.obj)}.Sources = [{', '.join(map(reference, kept))}]")
            self.sources.fill(kept)

    def _preview_rows(self, on):
        self.preview.clear()
        if on and self.worker is None and self._write():
            self._triangulate(self._preview_job)

    def _preview_job(self):
        job = self._job()
        if job is None:
            return
        run = self.obj.Proxy.find(job.key)
        if run is not None:  # they are there already
            self.preview.show(*row_edges(run.mesh))
        elif job.key == self._previewed[0]:
            self.preview.show(*self._previewed[1])
        else:
            self._run(job.preview, lambda rows: self._show_rows(job.key, rows))

    def _show_rows(self, key, rows):
        self._stopped()
        self._previewed = key, rows
        self.form.figures.setText(figures_text(self.obj))
        self.preview.show(*rows)
        if self._close_when_done:  # OK was pressed meanwhile
            self._close_when_done = False
            self.accept()

    def _show_selected(self):
        source = self.sources.selected()
        self.highlight.show_line(source.Points if source is not None else [])

    def _close(self):
        self._leave()
        FreeCAD.ActiveDocument.commitTransaction()
        FreeCADGui.ActiveDocument.resetEdit()

    def _leave(self):
        self.highlight.remove()
        self.preview.remove()
