# FreeCAD runs this at start, with the add-on's folder on sys.path and without __file__.
import os
import sys

for _root in list(sys.path):
    _mod = os.path.join(_root, "Mod")
    if os.path.isfile(os.path.join(_mod, "anisoquad", "__init__.py")) and _mod not in sys.path:
        sys.path.append(_mod)
