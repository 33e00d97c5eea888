"""Widgets for the core's options: every field of Options gets one by itself."""

from ..compat import qt_widgets, translate
from ..meshing import Options
from ..objects.option_properties import option_fields, option_label, property_name


class OptionForm:
    """Rows of a form layout, one for each option that is a number or a switch."""

    def __init__(self, layout, obj):
        self._obj = obj
        self._widgets = {}
        defaults = Options()
        for field, doc in option_fields().items():
            widget = _widget(getattr(defaults, field), getattr(obj, property_name(field)))
            if widget is not None:
                if field.endswith("_angle"):
                    widget.setSuffix("°")
                widget.setObjectName(property_name(field))
                widget.setToolTip(translate("Options", doc))
                layout.addRow(translate("Options", option_label(field)), widget)
                self._widgets[field] = widget

    def changes(self):
        """{property of the object: new value} of what differs."""
        values = {property_name(field): _value(widget) for field, widget in self._widgets.items()}
        return {name: value for name, value in values.items() if getattr(self._obj, name) != value}


class NumberBox(qt_widgets().QDoubleSpinBox):
    """Shows no more decimals than the number has."""

    def textFromValue(self, value):
        text = super().textFromValue(value)
        point = self.locale().decimalPoint()
        return text.rstrip("0").rstrip(point) if point in text else text


def _widget(default, value):
    widgets = qt_widgets()
    if isinstance(default, bool):
        box = widgets.QCheckBox()
        box.setChecked(value)
        return box
    if isinstance(default, int):
        box = widgets.QSpinBox()
        box.setRange(0, 10**6)
    elif isinstance(default, float):
        box = NumberBox()
        box.setDecimals(4)
        box.setRange(0.0, 1e9)
    else:
        return None
    box.setValue(value)
    return box


def _value(widget):
    return widget.isChecked() if hasattr(widget, "isChecked") else widget.value()
