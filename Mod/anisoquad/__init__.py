"""AnisoQuad: anisotropic all-quad surface meshes from triangles.

`quad_mesh` and all that it needs work without FreeCAD; `make_quad_mesh` makes a document object in FreeCAD, without its GUI.
"""

try:
    from ._core import __version__
except ImportError as error:
    raise ImportError(f"AnisoQuad's compiled core is missing, or made for another Python; run `make build` ({error})") from error
from .errors import Cancelled, MeshError
from .meshing import Options, quad_mesh
from .quad_mesh_result import QuadMesh
from .source import Source, passes_for_anisotropy

__all__ = [
    "Cancelled",
    "MeshError",
    "Options",
    "QuadMesh",
    "Source",
    "__version__",
    "make_quad_mesh",
    "passes_for_anisotropy",
    "quad_mesh",
]


def make_quad_mesh(*args, **kwargs):
    """In FreeCAD: see anisoquad.make.make_quad_mesh."""
    from .make import make_quad_mesh as make

    return make(*args, **kwargs)
