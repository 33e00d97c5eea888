# Finds the Python that FreeCAD embeds: the module must be built for that one, and not for another that is first on PATH.
if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that FreeCAD embeds")
endif()
set(PYBIND11_FINDPYTHON ON)
find_package(Python 3.9 REQUIRED COMPONENTS Interpreter Development.Module)

find_program(FREECADCMD NAMES freecadcmd FreeCADCmd)
if(FREECADCMD AND NOT DEFINED ANISOQUAD_FREECAD_PYTHON)
    set(probe ${CMAKE_BINARY_DIR}/freecad_python.py)
    file(WRITE ${probe} "import sys\nprint('embedded-python=%d.%d' % sys.version_info[:2])\nsys.exit(0)\n")
    execute_process(COMMAND ${FREECADCMD} ${probe} INPUT_FILE /dev/null
        OUTPUT_VARIABLE output ERROR_VARIABLE errors TIMEOUT 120)
    if(output MATCHES "embedded-python=([0-9]+\\.[0-9]+)")
        set(ANISOQUAD_FREECAD_PYTHON ${CMAKE_MATCH_1} CACHE INTERNAL "Version of the Python that FreeCAD embeds")
    else()
        message(WARNING "${FREECADCMD} did not tell its Python version; not checked.\n${output}${errors}")
    endif()
endif()
if(DEFINED ANISOQUAD_FREECAD_PYTHON
        AND NOT ANISOQUAD_FREECAD_PYTHON STREQUAL "${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}")
    message(FATAL_ERROR
        "FreeCAD (${FREECADCMD}) embeds Python ${ANISOQUAD_FREECAD_PYTHON}, but ${Python_EXECUTABLE} is Python "
        "${Python_VERSION}. A module built for it could not be loaded in FreeCAD. Give the right one with "
        "-DPython_EXECUTABLE=…")
endif()
