"""Texts that are shown later, in the user's language. No Qt: the objects need them without a GUI."""


def QT_TRANSLATE_NOOP(context, text):  # noqa: N802 -- Qt's name, for which resources/translations/update.py looks
    """The text, marked for translation in this context."""
    return text
