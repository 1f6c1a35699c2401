"""Writes ParaView's description of the filters (server manager XML) from their headers.

usage: make_proxies.py HEADER... > oversketch.xml

What a proxy says is what the header says: help is the comment, a default the member's initialiser (else what the
comment calls the default), a range that of vtkSetClampMacro, the entries of a choice the named setters
SetXToY(). Only what headers do not tell is here: the inputs' names.
"""
import pathlib
import re
import sys
from xml.sax.saxutils import escape, quoteattr

# Inputs by port: name, and how many: "1", "?" (may be left out), "*" (repeatable). Types are vtkPolyData but for ForEach.
PORTS = {
    "StrokeFilter": [("Strokes", "1")],
    "ViewStroke": [("Polyline", "1")],
    "Silhouette": [("Mesh", "1"), ("Stroke", "1")],
    "Snake": [("Curves", "1"), ("Mesh", "1"), ("Stroke", "1")],
    "Visibility": [("Curves", "1"), ("Mesh", "1"), ("Stroke", "1")],
    "Outline": [("Mesh", "1"), ("Stroke", "1"), ("Curves", "1")],
    "Match": [("Curves", "*"), ("Stroke", "1")],
    "Targets": [("Section", "1"), ("Stroke", "1"), ("Mesh", "1")],
    "Correction": [("Handles", "1"), ("Stroke", "1"), ("Deformed mesh", "1"), ("Mesh before", "1")],
    "ShapeDiameter": [("Mesh", "1")],
    "MixtureRegion": [("Mesh", "1"), ("Handles", "1")],
    "RegionBorder": [("Mesh", "1")],
    "LaplacianDeform": [("Mesh", "1"), ("Handles", "1")],
    "Mirror": [("Mesh before", "1"), ("Deformed mesh", "1")],
    "Remesh": [("Mesh", "1"), ("Handles", "?")],
    "OneStroke": [("Mesh", "1"), ("Stroke", "1")],
    "ForEach": [("Models", "1"), ("Strokes", "1")],
}
COLLECTIONS = ["vtkMultiBlockDataSet", "vtkPartitionedDataSet", "vtkPartitionedDataSetCollection"]
TYPES = {("ForEach", 0): COLLECTIONS, ("ForEach", 1): COLLECTIONS + ["vtkPolyData"]}
OUTPUTS = {"Remesh": ["Mesh", "Handles"]}


# What a widget of the plugin's own sets, as one group: the parameters whose names begin alike.
GROUPS = {"ViewStroke": ("View", "oversketch_camera", ("Camera", "View"))}

# What lies in pixels of a picture, not in the scene: ParaView is not to show it beside the models.
PIXELS = {"StrokeFilter", "ViewStroke"}


def words(name):
    """OneStroke -> One Stroke; OpenCL stays."""
    return re.sub(r"(?<=[a-z])(?=[A-Z][a-z])", " ", name)


def prose(comment):
    """The text of a comment without its stars, paragraphs apart."""
    lines = [re.sub(r"^\s*\*? ?", "", line) for line in comment.strip().splitlines()]
    return "\n".join(lines).strip()


class Header:
    """What a filter's header tells."""

    def __init__(self, path):
        self.text = pathlib.Path(path).read_text()
        self.kind = pathlib.Path(path).stem  # vtkOversketchOneStroke
        self.name = self.kind.replace("vtkOversketch", "")
        top = re.match(r"/\*\*(.*?)\*/", self.text, re.S).group(1)
        body = prose(top)
        self.brief = re.search(r"@brief (.*?)\n\n", body, re.S).group(1).replace("\n", " ")
        self.help = re.sub(r"^@class.*\n@brief (.|\n)*?\n\n", "", body)
        self.help = re.sub(r"\n@sa(.|\n)*$", "", self.help).strip()
        self.values = {}
        for entries in re.findall(r"enum \w+\s*\{(.*?)\}", self.text, re.S):
            self.values.update({key: int(value) for key, value in re.findall(r"(\w+) = (\d+)", entries)})

    def number(self, text):
        text = text.strip()
        if text in self.values:
            return self.values[text]
        return {"true": 1, "on": 1, "false": 0, "off": 0}.get(text, text)

    def parameters(self):
        """(name, type, components, help, range or None) of what has a setter, in the header's order."""
        pattern = re.compile(
            r"/\*\*(?P<help>(?:(?!\*/).)*)\*/\s*"
            r"(?:vtkSet(?:Clamp)?Macro\((?P<name>\w+), (?P<type>int|double|bool)(?P<range>, [^;]*)?\);"
            r"|vtkSetVector(?P<size>\d)Macro\((?P<vector>\w+), (?P<component>int|double)\);"
            r"|void Set(?P<method>\w+)\((?P<argument>int|double|bool) \w+\);)",
            re.S,
        )
        for found in pattern.finditer(self.text):
            name = found["name"] or found["vector"] or found["method"]
            kind = found["type"] or found["component"] or found["argument"]
            limits = [self.number(t) for t in found["range"].strip(", )").split(",")] if found["range"] else None
            yield name, kind, int(found["size"] or 1), prose(found["help"]), limits

    def default(self, name, comment, components):
        member = re.search(rf"^  \w+ {name}(?:\[\d\])? = (.*?);", self.text, re.M)
        if member:
            values = member.group(1).strip("{ }").split(",")
        else:
            values = re.findall(r"[Dd]efault:? (?:is )?([\w.+-]+?)[.,;\]]?(?:\s|$)", comment)[:1]
        if len(values) != components:
            raise SystemExit(f"{self.kind}: no default of {name}")
        return " ".join(str(self.number(value)) for value in values)

    def choices(self, name):
        """(value, text) for each named setter."""
        setters = re.findall(rf"void Set{name}To(\w+)\(\) {{ this->Set{name}\((\w+)\); }}", self.text)
        return [(self.number(value), words(text)) for text, value in setters]


def documentation(indent, text, brief=None):
    short = f" short_help={quoteattr(brief)}" if brief else ""
    yield f"{indent}<Documentation{short}>\n{escape(text)}\n{indent}</Documentation>"


def parameter(header, name, kind, components, comment, limits):
    """The property of one parameter."""
    element = "DoubleVectorProperty" if kind == "double" else "IntVectorProperty"
    choices = header.choices(name)
    advanced = ' panel_visibility="advanced"' if name == "Backend" else ""
    yield (
        f'      <{element} name="{name}" label="{words(name)}" command="Set{name}" number_of_elements="{components}"\n'
        f'        default_values="{header.default(name, comment, components)}"{advanced}>'
    )
    if kind == "bool":
        yield '        <BooleanDomain name="bool" />'
    elif choices:
        yield '        <EnumerationDomain name="enum">'
        yield from (f'          <Entry value="{value}" text="{text}" />' for value, text in choices)
        yield "        </EnumerationDomain>"
    elif limits:
        low, high = limits
        upper = "" if str(high).startswith("VTK_") else f' max="{high}"'
        domain = "DoubleRangeDomain" if kind == "double" else "IntRangeDomain"
        yield f'        <{domain} name="range" min="{low}"{upper} />'
    yield from documentation("        ", comment)
    yield f"      </{element}>"


def port(header, index, label, count):
    """The property of one input."""
    name = "Input" if index == 0 else label.title().replace(" ", "")
    extra = ' multiple_input="1" clean_command="RemoveAllInputs"' if count == "*" else ""
    command = "AddInputConnection" if count == "*" else "SetInputConnection"
    yield f'      <InputProperty name="{name}" label="{label}" port_index="{index}" command="{command}"{extra}>'
    yield '        <ProxyGroupDomain name="groups"><Group name="sources" /><Group name="filters" /></ProxyGroupDomain>'
    yield '        <DataTypeDomain name="input_type">'
    for kind in TYPES.get((header.name, index), ["vtkPolyData"]):
        yield f'          <DataType value="{kind}" />'
    yield "        </DataTypeDomain>"
    if count == "?":
        yield "        <Hints><Optional /></Hints>"
    yield from documentation("        ", f"{label}: input {index}, see the filter's help.")
    yield "      </InputProperty>"


def group(header):
    """The parameters that one widget sets."""
    if header.name in GROUPS:
        label, widget, beginnings = GROUPS[header.name]
        yield f'      <PropertyGroup label="{label}" panel_widget="{widget}">'
        for name, *_ in header.parameters():
            if name.startswith(beginnings):
                yield f'        <Property name="{name}" function="{name}" />'
        yield "      </PropertyGroup>"


def driven_filter(driven):
    """The filter that ForEach is to drive."""
    yield '      <ProxyProperty name="Filter" label="Filter" command="SetFilter">'
    yield '        <ProxyListDomain name="proxy_list">'
    yield from (f'          <Proxy group="oversketch_driven" name="{name}" />' for name in driven)
    yield "        </ProxyListDomain>"
    yield from documentation("        ", "The filter to drive, with its parameters.")
    yield "      </ProxyProperty>"


def filters(headers):
    driven = [h.name for h in headers if [p[0] for p in PORTS[h.name]] == ["Mesh", "Stroke"]]
    driven.sort(key=lambda name: name != "OneStroke")  # the first is the default
    yield "<!-- Made by make_proxies.py from the filters' headers; not to be edited. -->"
    yield "<ServerManagerConfiguration>"
    yield '  <ProxyGroup name="filters">'
    for header in headers:
        title = f"Oversketch {words(header.name)}"
        yield f'    <SourceProxy name="Oversketch{header.name}" class="{header.kind}" label="{title}">'
        yield from documentation("      ", header.help, header.brief)
        for index, (label, count) in enumerate(PORTS[header.name]):
            yield from port(header, index, label, count)
        if header.name == "ForEach":
            yield from driven_filter(driven)
        for entry in header.parameters():
            yield from parameter(header, *entry)
        yield from group(header)
        for index, label in enumerate(OUTPUTS.get(header.name, [])):
            yield f'      <OutputPort name="{label}" index="{index}" id="port{index}" />'
        hidden = '<View type="None" />' if header.name in PIXELS else ""
        yield f'      <Hints><ShowInMenu category="Oversketch" />{hidden}</Hints>'
        yield "    </SourceProxy>"
    yield "  </ProxyGroup>"
    yield '  <ProxyGroup name="oversketch_driven">'
    for header in sorted((h for h in headers if h.name in driven), key=lambda h: driven.index(h.name)):
        yield f'    <Proxy name="{header.name}" class="{header.kind}" label="{words(header.name)}">'
        yield from documentation("      ", header.help, header.brief)
        for entry in header.parameters():
            yield from parameter(header, *entry)
        yield "    </Proxy>"
    yield "  </ProxyGroup>"
    yield "</ServerManagerConfiguration>"


def main():
    headers = [Header(path) for path in sys.argv[1:]]
    unknown = [h.name for h in headers if h.name not in PORTS]
    if unknown:
        raise SystemExit(f"make_proxies.py: say in PORTS what the inputs of {', '.join(unknown)} are")
    print("\n".join(filters(headers)))


if __name__ == "__main__":
    main()
