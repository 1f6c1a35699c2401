"""Writes ParaView's description of the filters (server manager XML) from their headers.

usage: make_proxies.py HEADER... > oversketch.xml

What a proxy says is what the header says: help is the comment, inputs and outputs are its lines "Input 1 (Handles, optional):",
a default the member's initialiser (else what the comment calls the default), a range that of vtkSetClampMacro, or "[from 0, ...]" in
the comment of a setter written out, the entries of a choice the named setters SetXToY(); a text is empty by default. Parameters that
a class has from another one of ours are its own too. A setter that is not understood is an error.
"""
import pathlib
import re
import sys
from xml.sax.saxutils import escape, quoteattr

# What ParaView calls a vtkDataObjectTree.
COLLECTIONS = ["vtkMultiBlockDataSet", "vtkPartitionedDataSet", "vtkPartitionedDataSetCollection"]

# What a widget of the plugin's own sets, as one group: the parameters whose names begin alike.
GROUPS = {"ViewStroke": ("View", "oversketch_camera", ("Camera", "View"))}

# What lies in pixels of a picture, not in the scene: ParaView is not to show it beside the models.
PIXELS = {"Chaikin", "NurbsFit", "StrokeFilter", "StrokeThinning", "Trace", "ViewStroke"}


def words(name):
    """OneStroke -> One Stroke; OpenCL stays."""
    return re.sub(r"(?<=[a-z])(?=[A-Z][a-z])", " ", name)


def prose(comment):
    """The text of a comment without its stars, paragraphs apart."""
    lines = [re.sub(r"^\s*\*? ?", "", line) for line in comment.strip().splitlines()]
    return "\n".join(lines).strip()


class Port:
    """An input or output as a header's line says it: "Input 1 (Strokes, optional, vtkPolyData or vtkDataObjectTree)"."""

    def __init__(self, label, terms):
        self.label = label
        self.optional, self.repeatable = "optional" in terms, "repeatable" in terms
        types = [term for term in terms if term.startswith("vtk")]
        self.types = types[0].split(" or ") if types else ["vtkPolyData"]
        if len(types) > 1 or set(terms) - {"optional", "repeatable", *types}:
            raise SystemExit(f"make_proxies.py: {', '.join(terms)} of {label} is not understood")


class Header:
    """What a filter's header tells."""

    def __init__(self, path):
        path = pathlib.Path(path)
        self.text = path.read_text()
        self.kind = path.stem  # vtkOversketchOneStroke
        self.name = self.kind.replace("vtkOversketch", "")
        self.filter = f"static {self.kind}* New();" in self.text  # else the base of others
        base = re.search(rf"^class \w+ {self.kind} : public (vtkOversketch\w+)", self.text, re.M)
        found = list(path.parents[1].glob(f"*/{base.group(1)}.h")) if base else []
        if base and not found:
            raise SystemExit(f"make_proxies.py: {self.kind} derives from {base.group(1)}, which no room has")
        self.base = Header(found[0]) if found else None
        top = re.match(r"/\*\*(.*?)\*/", self.text, re.S).group(1)
        body = prose(top)
        self.brief = re.search(r"@brief (.*?)\n\n", body, re.S).group(1).replace("\n", " ")
        self.help = re.sub(r"^@class.*\n@brief (.|\n)*?\n\n", "", body)
        self.help = re.sub(r"\n@sa(.|\n)*$", "", self.help).strip()
        self.inputs, self.outputs = self.ports("Input"), self.ports("Output")
        self.values = {}
        for entries in re.findall(r"enum \w+\s*\{(.*?)\}", self.text, re.S):
            self.values.update({key: int(value) for key, value in re.findall(r"(\w+) = (\d+)", entries)})

    def ports(self, which):
        found = re.findall(rf"^{which} (\d+) \(([\w ]+)((?:, [\w ]+)*)\):", self.help, re.M)
        if [int(index) for index, _, _ in found] != list(range(len(found))):
            raise SystemExit(f"make_proxies.py: {self.kind} does not name each {which} once, in order")
        if self.filter and which == "Input" and not found:
            raise SystemExit(f'make_proxies.py: {self.kind} has no line "Input 0 (Name): ..."')
        return [Port(label, terms.split(", ")[1:]) for _, label, terms in found]

    def number(self, text):
        text = text.strip()
        for header in self.lineage():
            if text in header.values:
                return header.values[text]
        return {"true": 1, "on": 1, "false": 0, "off": 0}.get(text, text)

    def lineage(self):
        """This header, then those of the classes that it derives from."""
        header = self
        while header:
            yield header
            header = header.base

    def parameters(self):
        """(name, type, components, help, range or None) of what has a setter, in the header's order, then those inherited."""
        found = {}
        for header in self.lineage():
            for entry in header.own_parameters():
                found.setdefault(entry[0], entry)
        return list(found.values())

    def own_parameters(self):
        pattern = re.compile(
            r"/\*\*(?P<help>(?:(?!\*/).)*)\*/\s*"
            r"(?:vtkSet(?:Clamp)?Macro\((?P<name>\w+), (?P<type>int|double|bool)(?P<range>, [^;]*)?\);"
            r"|vtkSetVector(?P<size>\d)Macro\((?P<vector>\w+), (?P<component>int|double)\);"
            r"|(?:virtual )?void Set(?P<method>\w+)\((?P<argument>int|double|bool|const char\*) \w+\)(?: override)?;)",
            re.S,
        )
        read = set()
        for found in pattern.finditer(self.text):
            name = found["name"] or found["vector"] or found["method"]
            kind = found["type"] or found["component"] or found["argument"]
            limits = [self.number(t) for t in found["range"].strip(", )").split(",")] if found["range"] else None
            least = re.search(r"\[[^\]]*\bfrom (\d+)\b", found["help"]) if found["method"] else None
            limits = [least[1], "VTK_DOUBLE_MAX"] if least else limits
            read.add(name)
            yield name, kind, int(found["size"] or 1), prose(found["help"]), limits
        # Data and other algorithms are no parameters; the rest must have been read.
        public = self.text.split("protected:")[0]
        known = read.union(*(header.settable() for header in self.lineage() if header is not self))
        for name in re.findall(r"\bvtkSet\w*Macro\((\w+)", public) + re.findall(r"\bvoid Set(\w+)\((?!\)|vtk\w+\*|std::shared_ptr)", public):
            if name not in known:
                raise SystemExit(f"make_proxies.py: {self.kind}::Set{name} has no comment of its own, or a type that no proxy is made for")

    def settable(self):
        return {entry[0] for entry in self.own_parameters()}

    def default(self, name, comment, components):
        members = [re.search(rf"^  \w+ (?:[^;\n]*, )?{name}(?:\[\d\])? = (\{{.*?\}}|[^,;]*)", header.text, re.M) for header in self.lineage()]
        member = next((m for m in members if m), None)
        if member:
            values = member.group(1).strip("{ }").split(",")
        else:
            values = re.findall(r"[Dd]efault:? (?:is )?([\w.+-]+?)[.,;\]]?(?:\s|$)", comment)[:1]
        if len(values) != components:
            raise SystemExit(f"{self.kind}: no default of {name}")
        return " ".join(str(self.number(value)) for value in values)

    def choices(self, name):
        """(value, text) for each named setter."""
        text = "".join(header.text for header in self.lineage())
        setters = re.findall(rf"void Set{name}To(\w+)\(\) {{ this->Set{name}\((\w+)\); }}", text)
        return [(self.number(value), words(text)) for text, value in setters]


def documentation(indent, text, brief=None):
    short = f" short_help={quoteattr(brief)}" if brief else ""
    yield f"{indent}<Documentation{short}>\n{escape(text)}\n{indent}</Documentation>"


def parameter(header, name, kind, components, comment, limits):
    """The property of one parameter."""
    text = kind == "const char*"
    element = "StringVectorProperty" if text else "DoubleVectorProperty" if kind == "double" else "IntVectorProperty"
    choices = header.choices(name)
    advanced = ' panel_visibility="advanced"' if name == "Backend" else ""
    yield (
        f'      <{element} name="{name}" label="{words(name)}" command="Set{name}" number_of_elements="{components}"\n'
        f'        default_values="{"" if text else header.default(name, comment, components)}"{advanced}>'
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


def input_property(index, port):
    name = "Input" if index == 0 else port.label.title().replace(" ", "")
    extra = ' multiple_input="1" clean_command="RemoveAllInputs"' if port.repeatable else ""
    command = "AddInputConnection" if port.repeatable else "SetInputConnection"
    yield f'      <InputProperty name="{name}" label="{port.label}" port_index="{index}" command="{command}"{extra}>'
    yield '        <ProxyGroupDomain name="groups"><Group name="sources" /><Group name="filters" /></ProxyGroupDomain>'
    yield '        <DataTypeDomain name="input_type">'
    for kind in port.types:
        yield from (f'          <DataType value="{each}" />' for each in (COLLECTIONS if kind == "vtkDataObjectTree" else [kind]))
    yield "        </DataTypeDomain>"
    if port.optional:
        yield "        <Hints><Optional /></Hints>"
    yield from documentation("        ", f"{port.label}: input {index}, see the filter's help.")
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


def is_driven(header):
    """Whether ForEach has all that a filter needs, which hands it a model and what was drawn on it: any system, and what takes a mesh
    and a stroke."""
    needed = [port.label for port in header.inputs if not port.optional]
    system = any(each.name == "System" for each in header.lineage())
    return len(needed) <= 2 and (system or needed == ["Mesh", "Stroke"])


def filters(headers):
    driven = [h.name for h in headers if is_driven(h)]
    driven.sort(key=lambda name: name != "OneStroke")  # the first is the default
    yield "<!-- Made by make_proxies.py from the filters' headers; not to be edited. -->"
    yield "<ServerManagerConfiguration>"
    yield '  <ProxyGroup name="filters">'
    for header in headers:
        title = f"Oversketch {words(header.name)}"
        yield f'    <SourceProxy name="Oversketch{header.name}" class="{header.kind}" label="{title}">'
        yield from documentation("      ", header.help, header.brief)
        for index, port in enumerate(header.inputs):
            yield from input_property(index, port)
        if header.name == "ForEach":
            yield from driven_filter(driven)
        for entry in header.parameters():
            yield from parameter(header, *entry)
        yield from group(header)
        for index, port in enumerate(header.outputs):
            yield f'      <OutputPort name="{port.label}" index="{index}" id="port{index}" />'
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
    print("\n".join(filters([header for header in map(Header, sys.argv[1:]) if header.filter])))


if __name__ == "__main__":
    main()
