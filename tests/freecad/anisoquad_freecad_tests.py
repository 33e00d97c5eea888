"""All tests that need FreeCAD, without its GUI: freecadcmd -t anisoquad_freecad_tests -M <repository>."""

from test_convert import *  # noqa: F401,F403
from test_examples import *  # noqa: F401,F403
from test_gmsh import *  # noqa: F401,F403
from test_part_shape import *  # noqa: F401,F403
from test_property_texts import *  # noqa: F401,F403
from test_quad_mesh_object import *  # noqa: F401,F403
from test_rings import *  # noqa: F401,F403
from test_source_object import *  # noqa: F401,F403
from test_wing_shell import *  # noqa: F401,F403
