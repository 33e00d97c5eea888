"""The core's options as properties of a document object: every field of Options becomes one by itself."""

from itertools import chain

from ..errors import MeshError
from ..meshing import Options
from . import properties

# Options of the machine, for tests and for pictures, not for documents.
_NOT_PROPERTIES = ("threads", "validate", "record_stages")

_TYPE_OF = {bool: "App::PropertyBool", int: "App::PropertyInteger", float: "App::PropertyFloat"}
_TYPE_OF_LIST = {"feature_edges": "App::PropertyIntegerList", "vertex_size": "App::PropertyFloatList"}
_PAIRS = ("feature_edges",)


def option_fields():
    """{field: documentation} of the options that documents keep."""
    return {name: doc for name, doc in Options.fields.items() if name not in _NOT_PROPERTIES}


def property_name(field):
    """feature_angle → FeatureAngle"""
    return "".join(part.capitalize() for part in field.split("_"))


def option_label(field):
    """feature_angle → Feature angle; in English, translated in the context Options as the documentation is."""
    return field.replace("_", " ").capitalize()


def add_options(obj):
    """Add the properties that are missing, with the core's defaults."""
    defaults = Options()
    for field, doc in option_fields().items():
        default = getattr(defaults, field)
        type_ = _TYPE_OF_LIST.get(field) or _TYPE_OF[type(default)]
        if properties.add(obj, type_, property_name(field), "Options", doc) and default:
            setattr(obj, property_name(field), default)


def set_options(obj, options):
    """Keep an anisoquad.Options in the properties."""
    for field in option_fields():
        value = getattr(options, field)
        setattr(obj, property_name(field), list(chain.from_iterable(value)) if field in _PAIRS else value)


def options_of(obj):
    """The anisoquad.Options that the properties hold. Raises MeshError for feature edges that are not pairs."""
    values = {}
    for field in option_fields():
        value = getattr(obj, property_name(field))
        if field in _PAIRS:
            if len(value) % 2:
                raise MeshError(f"{property_name(field)}: point ids come in pairs.", code="invalid_feature_edge")
            value = list(zip(value[::2], value[1::2]))
        values[field] = value
    return Options(**values)
