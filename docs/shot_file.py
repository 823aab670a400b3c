"""Writes docs/shot_file.md, the reference of shot files, from the schema that the program has:

    burnish composite --schema | python3 docs/shot_file.py > docs/shot_file.md
"""

import json
import sys

OPENING = """# Shot files

Made by `docs/shot_file.py` from `burnish composite --schema`, which editors can check shot files with.

A shot file is one JSON document that says what a job is: `burnish composite shot.json`, `burnish.run("shot.json")`. Options of the
command line win over it. Paths in it are relative to its folder. Every field may be left out but the frame and the output; unknown
fields are refused with the nearest known name. `burnish demo -o demo` writes one to start from:

```json
{
  "aovs": "shot.####.exr",
  "lights": {"sky": {"type": "environment", "file": "studio.hdr"}},
  "materials": {"varnish": {"model": "kurt", "ks": 0.8, "mx": 0.1, "my": 0.1, "r0": 0.05}},
  "material": "varnish",
  "assign": [{"material": "gold", "cryptomatte": "ball_*"}],
  "quality": {"psnr": 40},
  "output": {"file": "out.####.exr"}
}
```
"""
LIGHTS = """The key is the light's name. At most one is an `environment`; in place of a light its JSON file may stand. Lengths are scene
units, places are world space."""
TITLES = {
    "antialias": "How finer AOVs become pixels.",
    "color": "OpenColorIO names.",
    "composite": "What becomes of the overlay.",
    "output": "What is written, and where.",
    "quality": "How the reflection is integrated.",
    "surface": "What normals, tangents and roughness mean.",
}


def text_of(value):
    """A value as the reader writes it."""
    return f"`{json.dumps(value, ensure_ascii=False)}`"


def range_of(schema):
    """' from 0 to 1', for the bounds that there are."""
    bounds = [f" {word} {schema[key]:g}" for word, key in (("from", "minimum"), ("to", "maximum")) if key in schema]
    return "".join(bounds)


def kind_of(schema):
    """What may stand there, in words."""
    if "const" in schema:
        return text_of(schema["const"])
    if "enum" in schema:
        return ", ".join(map(text_of, schema["enum"]))
    if "anyOf" in schema:
        return " or ".join(map(kind_of, schema["anyOf"]))
    kind = schema.get("type")
    if isinstance(kind, list):
        return " or ".join(kind_of({"type": one}) for one in kind)
    if kind == "array":
        items = kind_of(schema["items"])
        if "maxItems" in schema:
            return f"{schema['maxItems']} {items}s"
        return f"list of {items}"
    if kind == "object" and "properties" in schema:
        fields = ", ".join(f"{name}: {kind_of(value)}" for name, value in schema["properties"].items())
        return "{" + fields + "}"
    return {"string": "text", "boolean": "true or false"}.get(kind, kind) + range_of(schema)


def cell(text):
    """A text inside a table."""
    return text.replace("|", "\\|")


def table(properties):
    """One row a field."""
    rows = ["| field | value | default | meaning |", "|---|---|---|---|"]
    for name, schema in properties.items():
        default = text_of(schema["default"]) if "default" in schema else ""
        rows.append(f"| `{name}` | {cell(kind_of(schema))} | {cell(default)} | {cell(schema['description'])} |")
    return "\n".join(rows)


def kinds_of_light(schema):
    """A section for each type of light."""
    parts = [LIGHTS]
    for form in schema["additionalProperties"]["anyOf"]:
        if "properties" not in form:
            continue
        fields = dict(form["properties"])
        kind = fields.pop("type")["const"]
        needed = [f"`{name}`" for name in form.get("required", []) if name != "type"]
        parts += [f"### `\"type\": \"{kind}\"`" + (f", needs {', '.join(needed)}" if needed else ""), table(fields)]
    return parts


def page(schema):
    """The whole page."""
    properties = {name: value for name, value in schema["properties"].items() if name != "$schema"}
    sections = {name: value for name, value in properties.items() if "properties" in value}
    rule = next(form for form in properties["assign"]["items"]["anyOf"] if "properties" in form)
    fields = {name: value for name, value in properties.items() if name not in sections and name != "lights"}
    fields["assign"] = fields["assign"] | {"type": "array", "items": {"type": "rule"}}
    parts = [OPENING, "## The document", table(fields), "## A rule of `assign`",
             "One of `index`, `material_index` and `cryptomatte` says which pixels; later rules win. The short form is text, "
             "`\"gold=crypto:ball_*@sky\"`.", table(rule["properties"]), "## `lights`", *kinds_of_light(properties["lights"])]
    for name, section in sections.items():
        parts += [f"## `{name}`", TITLES[name], table(section["properties"])]
    return "\n\n".join(part.strip() for part in parts) + "\n"


if __name__ == "__main__":
    sys.stdout.write(page(json.load(sys.stdin)))
