"""Brings the .ts files up to date with the sources: new texts are added, lost ones go, translations stay.

After `make build`, whose core tells the options: python3 resources/translations/update.py; then translate what is marked unfinished, e.g.
in Qt Linguist. `make translations` compiles.
"""

import ast
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
ROOT = FOLDER.parents[1]
LANGUAGES = ("de", "es-ES", "fr")  # as FreeCAD names them, or it does not find them
_CALLS = ("QT_TRANSLATE_NOOP", "translate")


def texts():
    """{context: {text, …}} of the package and the .ui files."""
    found = {}
    for path in sorted((ROOT / "Mod" / "anisoquad").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") in _CALLS and len(node.args) == 2:
                context, text = node.args
                if isinstance(context, ast.Constant) and isinstance(text, ast.Constant):
                    found.setdefault(context.value, set()).add(text.value)
    for path in sorted((ROOT / "resources" / "ui").glob("*.ui")):
        tree = ElementTree.parse(path)
        context = tree.findtext("class")
        found.setdefault(context, set()).update(node.text for node in tree.iter("string") if node.text)
    sys.path.insert(0, str(ROOT / "Mod"))
    from anisoquad.objects.option_properties import option_fields, option_label
    from anisoquad.quality_measures import MEASURES

    found.setdefault("QualityPanel", set()).update(measure.title for measure in MEASURES.values())
    found["App::Property"].update(option_fields().values())  # tooltips of the property editor
    found["Options"] = {text for field, doc in option_fields().items() for text in (option_label(field), doc)}
    return found


def read(path):
    """{(context, text): translation} of a .ts file; empty where there is none yet."""
    if not path.exists():
        return {}
    return {(context.findtext("name"), message.findtext("source")): message.findtext("translation")
            for context in ElementTree.parse(path).iter("context") for message in context.iter("message")}


def write(path, language, found, known):
    """Write a .ts file; returns how many texts have no translation."""
    root = ElementTree.Element("TS", version="2.1", language=language, sourcelanguage="en")
    missing = 0
    for name in sorted(found):
        context = ElementTree.SubElement(root, "context")
        ElementTree.SubElement(context, "name").text = name
        for text in sorted(found[name]):
            message = ElementTree.SubElement(context, "message")
            ElementTree.SubElement(message, "source").text = text
            translation = ElementTree.SubElement(message, "translation")
            translation.text = known.get((name, text))
            if not translation.text:
                translation.set("type", "unfinished")
                missing += 1
    ElementTree.indent(root, " ")
    content = ElementTree.tostring(root, encoding="unicode")
    path.write_text(f'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n{content}\n', encoding="utf-8")
    return missing


if __name__ == "__main__":
    all_texts = texts()
    for language in LANGUAGES:
        path = FOLDER / f"AnisoQuad_{language}.ts"
        print(f"{path.name}: {write(path, language, all_texts, read(path))} texts to translate")
