"""What make_proxies.py reads in a header, and where it stops; ParaView is not needed for this."""
import pathlib
import re
import sys
import xml.etree.ElementTree as tree

import pytest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "Applications" / "ParaView" / "Plugin"))
import make_proxies  # noqa: E402

HEADER = """/**
 * @class vtkOversketch{name}
 * @brief makes nothing of something
 *
 * For nobody.
 *
 * {ports}
 *
 * @sa nothing
 */
class X_EXPORT vtkOversketch{name} : public {base}
{{
public:
{new}  vtkTypeMacro(vtkOversketch{name}, {base});
  void SetStrokeData(vtkPolyData* stroke);
{setters}
protected:
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int Count = 3;
}};
"""
COUNT = """  /**
   * How many. Default 3.
   */
  vtkSetClampMacro(Count, int, 1, VTK_INT_MAX);
"""


def header(folder, name="Toy", ports="Input 0 (Mesh): a mesh.", setters=COUNT, base="vtkPolyDataAlgorithm", abstract=False):
    path = folder / "Room" / f"vtkOversketch{name}.h"
    path.parent.mkdir(exist_ok=True)
    new = "" if abstract else f"  static vtkOversketch{name}* New();\n"
    path.write_text(HEADER.format(name=name, ports=ports, setters=setters, base=base, new=new))
    return path


def described(*paths):
    return tree.fromstring("\n".join(make_proxies.filters([h for h in map(make_proxies.Header, paths) if h.filter])))


def proxies(*paths):
    return {proxy.get("name"): proxy for proxy in described(*paths).iter("SourceProxy")}


def filter_headers():
    return [path for path in sorted(SOURCE.glob("Filters/*/vtkOversketch*.h")) if "_EXPORT vtkOversketch" in path.read_text()]


def refusal(*paths):
    with pytest.raises(SystemExit) as raised:
        proxies(*paths)
    return str(raised.value)


def test_inputs_and_outputs_have_the_names_of_the_header(tmp_path):
    ports = ("Input 0 (Mesh): a mesh, which input 1 (or so) lies on.\n * Input 1 (First stroke, repeatable): strokes.\n"
             " * Input 2 (Picture, optional, vtkImageData): a picture.\n * Input 3 (Models, vtkPolyData or vtkDataObjectTree): models.\n"
             " *\n * Output 0 (Mesh): the mesh.\n * Output 1 (Handles): handles.")
    toy = proxies(header(tmp_path, ports=ports))["OversketchToy"]
    inputs = {each.get("label"): each for each in toy.findall("InputProperty")}
    assert list(inputs) == ["Mesh", "First stroke", "Picture", "Models"]
    assert [each.get("name") for each in inputs.values()] == ["Input", "FirstStroke", "Picture", "Models"]
    assert [each.get("port_index") for each in inputs.values()] == ["0", "1", "2", "3"]
    assert [each.get("multiple_input") for each in inputs.values()] == [None, "1", None, None]
    assert [each.find("Hints/Optional") is not None for each in inputs.values()] == [False, False, True, False]
    types = [[kind.get("value") for kind in each.iter("DataType")] for each in inputs.values()]
    assert types == [["vtkPolyData"], ["vtkPolyData"], ["vtkImageData"], ["vtkPolyData", *make_proxies.COLLECTIONS]]
    assert [each.get("name") for each in toy.findall("OutputPort")] == ["Mesh", "Handles"]


def test_a_text_is_a_property_too(tmp_path):
    setters = '  /**\n   * A "x y" list; empty (default): none.\n   */\n  void SetProfile(const char* text);\n'
    profile, = proxies(header(tmp_path, setters=setters))["OversketchToy"].findall("StringVectorProperty")
    assert (profile.get("name"), profile.get("command"), profile.get("default_values")) == ("Profile", "SetProfile", "")
    assert '"x y" list' in profile.find("Documentation").text


@pytest.mark.parametrize("ports, words", [
    ("Input 0: a mesh.", 'no line "Input 0 (Name): ..."'),
    ("Input 1 (Mesh): a mesh.", "does not name each Input once"),
    ("Input 0 (Mesh): a mesh.\n * Input 0 (Stroke): a stroke.", "does not name each Input once"),
    ("Input 0 (Mesh, perhaps): a mesh.", "perhaps of Mesh is not understood"),
])
def test_stops_at_inputs_that_it_cannot_read(tmp_path, ports, words):
    assert words in refusal(header(tmp_path, ports=ports))


@pytest.mark.parametrize("setter", [
    "vtkSetStringMacro(Name);", "vtkSetMacro(Point, vtkIdType);", "void SetName(char* name);", "void SetPoint(vtkIdType point);",
    "void SetName(const std::string& name);", "void SetBox(double low, double high);", "virtual void SetBounds(const double bounds[6]);"])
def test_stops_at_a_setter_that_it_cannot_read(tmp_path, setter):
    assert "vtkOversketchToy::Set" in refusal(header(tmp_path, setters=f"  /**\n   * What. Default none.\n   */\n  {setter}\n"))


def test_stops_at_a_setter_without_a_comment(tmp_path):
    assert "vtkOversketchToy::SetSize" in refusal(header(tmp_path, setters=COUNT + "  int GetSize();\n  void SetSize(int size);\n"))


def test_parameters_of_the_base_are_the_class_s_own(tmp_path):
    header(tmp_path, "System", "What all systems share.", abstract=True)
    size = "  /**\n   * How large. Default 1.5.\n   */\n  void SetSize(double size);\n"
    toy = header(tmp_path, "Toy", setters=size, base="vtkOversketchSystem")
    found = proxies(toy, tmp_path / "Room" / "vtkOversketchSystem.h")
    assert list(found) == ["OversketchToy"]
    assert [(name, default) for name, default, _ in said(found["OversketchToy"])] == [("Size", "1.5"), ("Count", "3")]


def said(proxy):
    """Name, default and domain of each parameter of a proxy."""
    kinds = ("IntVectorProperty", "DoubleVectorProperty", "StringVectorProperty")
    return [(each.get("name"), each.get("default_values"), [tree.tostring(part) for part in each]) for each in proxy if each.tag in kinds]


def offered(*paths):
    """The filters that ForEach has a choice of, each with its proxy."""
    root = described(*paths)
    choice, = root.findall(".//ProxyListDomain")
    group, = [group for group in root.findall("ProxyGroup") if group.get("name") == "oversketch_driven"]
    found = {each.get("name"): each for each in group}
    assert list(found) == [each.get("name") for each in choice] and all(each.get("group") == "oversketch_driven" for each in choice)
    return found


def test_for_each_offers_what_a_model_and_one_thing_drawn_on_it_are_enough_for(tmp_path):
    header(tmp_path, "System", "What all systems share.", abstract=True)
    mesh, picture = "Input 0 (Mesh): a mesh.", "Input 2 (Picture{}, vtkImageData): a picture."
    ports = {"Lines": [mesh, "Input 1 (Strokes): lines."], "Alone": ["Input 0 (Heights, vtkImageData): heights."],
             "More": [mesh, "Input 1 (Lines): lines.", picture.format(", optional")],
             "TooMany": [mesh, "Input 1 (Strokes): lines.", picture.format("")]}
    paths = [header(tmp_path, name, "\n * ".join(lines), base="vtkOversketchSystem") for name, lines in ports.items()]
    paths.append(header(tmp_path, "OneStroke", mesh + "\n * Input 1 (Stroke): a line."))
    paths.append(header(tmp_path, "Step", mesh + "\n * Input 1 (Handles): handles."))
    paths.append(header(tmp_path, "ForEach", "Input 0 (Models): models.\n * Input 1 (Strokes, optional): strokes."))
    assert list(offered(*paths)) == ["OneStroke", "Lines", "Alone", "More"]


def test_for_each_offers_every_system_with_the_parameters_of_its_own_proxy():
    paths = filter_headers()
    systems = {h.name for h in map(make_proxies.Header, paths)
               if h.filter and h.base and h.base.name == "System" and sum(not port.optional for port in h.inputs) <= 2}
    found, alone = offered(*paths), proxies(*paths)
    assert {"OneStroke", "Augment", "Terrain"} <= systems and set(found) == systems | {"Silhouette"}
    for name, proxy in found.items():
        assert proxy.get("class") == "vtkOversketch" + name and proxy.find("InputProperty") is None
        assert said(proxy) == said(alone["Oversketch" + name]) and (said(proxy) or name == "Silhouette"), name


def test_stops_at_a_base_that_is_not_there(tmp_path):
    assert "vtkOversketchSystem, which no room has" in refusal(header(tmp_path, base="vtkOversketchSystem"))


def test_all_headers_are_understood():
    assert len(proxies(*filter_headers())) > 15


def test_every_input_is_told_on_a_line_of_its_own():
    told = 0
    for header in sorted((SOURCE / "Filters").glob("*/vtkOversketch*.h")):
        code = header.with_suffix(".cxx")
        count = re.search(r"SetNumberOfInputPorts\((\d+)\)", code.read_text()) if code.exists() else None
        if count:
            ports = {int(port) for port in re.findall(r"^ \* Input (\d+) \(", header.read_text(), re.M)}
            assert ports == set(range(int(count[1]))), header.name
            told += 1
    assert told > 20
