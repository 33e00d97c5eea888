"""AnisoQuad: anisotropic all-quad surface meshes from triangles.

`quad_mesh` and all that it needs work without FreeCAD; the `make_…` functions make document objects in FreeCAD, without its
GUI. Names are looked up at their first use, so that the workbench loads also where the compiled core can not.
"""

from importlib import import_module

_EXPORTS = {
    "CadShape": "cad",
    "CadSurface": "cad",
    "Cancelled": "errors",
    "MeshError": "errors",
    "Options": "meshing",
    "QuadMesh": "quad_mesh_result",
    "Source": "source",
    "export_quad_mesh": "make",
    "make_quad_mesh": "make",
    "make_source": "make",
    "make_triangles": "make",
    "passes_for_anisotropy": "source",
    "quad_mesh": "meshing",
}
__all__ = [*sorted(_EXPORTS), "__version__"]


def __getattr__(name):
    if name == "_core":
        try:
            return import_module("._core", __name__)
        except ImportError as error:
            raise ImportError(f"AnisoQuad's compiled core is missing, or made for another Python; run `make build` in the add-on's "
                              f"folder ({error})") from error
    if name == "__version__":
        return __getattr__("_core").__version__
    if name not in _EXPORTS:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module("." + _EXPORTS[name], __name__), name)


def __dir__():
    return sorted([*globals(), *__all__])
