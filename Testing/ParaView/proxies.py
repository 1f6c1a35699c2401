"""In pvpython: what each proxy says (inputs, defaults, ranges, choices, help) is what its class does."""
import re

import oversketch
from hosts import load_plugin
from paraview import servermanager
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from paraview.modules.vtkRemotingServerManager import vtkSMInputProperty, vtkSMProxyProperty, vtkSMSourceProxy

load_plugin(globals())
HUGE = 2**31 - 1


def values(instance, name):
    value = getattr(instance, "Get" + name)()
    return [float(v) for v in value] if isinstance(value, (tuple, list)) else [float(value)]


def after(instance, name, wanted, components):
    getattr(instance, "Set" + name)(*[wanted] * components)
    return values(instance, name)[0]


def properties(proxy):
    it = proxy.NewPropertyIterator()
    it.UnRegister(None)
    it.Begin()
    while not it.IsAtEnd():
        yield it.GetKey(), it.GetProperty()
        it.Next()


def domain(prop, kind):
    it = prop.NewDomainIterator()
    it.UnRegister(None)
    it.Begin()
    while not it.IsAtEnd():
        if it.GetDomain().IsA(kind):
            return it.GetDomain()
        it.Next()
    return None


def check_parameter(kind, name, prop):
    """Default, range and choices of a parameter against a fresh instance of the class."""
    instance = kind()
    count = prop.GetNumberOfElements()
    what = f"{kind.__name__}.{name}"
    text = getattr(instance, "Get" + name)()
    if isinstance(text, str):
        assert (count, prop.GetElement(0)) == (1, text), f"{what}: default {prop.GetElement(0)!r}, the class has {text!r}"
        assert prop.IsA("vtkSMStringVectorProperty") and prop.GetDocumentation().GetDescription().strip(), what
        return
    said = [float(prop.GetElement(i)) for i in range(count)]
    assert said == values(instance, name), f"{what}: default {said}, the class has {values(instance, name)}"
    assert prop.GetDocumentation() and prop.GetDocumentation().GetDescription().strip(), f"{what}: no help"
    if domain(prop, "vtkSMBooleanDomain"):
        assert isinstance(getattr(instance, "Get" + name)(), bool), what
        return
    choices = domain(prop, "vtkSMEnumerationDomain")
    low, high = after(instance, name, -HUGE, count), after(instance, name, HUGE, count)
    if choices:
        entries = {choices.GetEntryValue(i): choices.GetEntryText(i) for i in range(choices.GetNumberOfEntries())}
        assert sorted(entries) == list(range(int(low), int(high) + 1)), f"{what}: choices {entries}, {low} to {high}"
        for value, text in entries.items():
            getattr(instance, f"Set{name}To{text.replace(' ', '')}")()
            assert values(instance, name) == [value], f"{what}: {text} is not {value}"
        return
    limits = domain(prop, "vtkSMDoubleRangeDomain") or domain(prop, "vtkSMIntRangeDomain")
    bounded = [low > -HUGE, high < HUGE]
    assert bool(limits) == any(bounded), f"{what}: limited to {low} .. {high}, a range in the proxy: {bool(limits)}"
    if limits:
        said = [limits.GetMinimumExists(0), limits.GetMaximumExists(0)]
        assert [bool(s) for s in said] == bounded, f"{what}: range has ends {said}, the class {bounded}"
        if bounded[0]:
            assert limits.GetMinimum(0) == low, f"{what}: at least {limits.GetMinimum(0)}, the class {low}"
        if bounded[1]:
            assert limits.GetMaximum(0) == high, f"{what}: at most {limits.GetMaximum(0)}, the class {high}"


def setters(kind):
    """Parameters by the class itself: it has SetX and GetX and does not inherit them from VTK. Another algorithm or object is no
    parameter; a value that no proxy can hold is an error."""
    instance = kind()
    ours = set(dir(kind)) - set(dir(vtkAlgorithm))
    for method in sorted(ours):
        name = method[3:]
        if not method.startswith("Set") or "Get" + name not in ours:
            continue
        if re.match(r"Set\w+\(self, \w+:\s*vtk\w+\)", getattr(kind, method).__doc__):
            continue
        value = getattr(instance, "Get" + name)()
        assert isinstance(value, (bool, int, float, str, tuple)), f"{kind.__name__}.{method}: no proxy is made for {value!r}"
        yield name


def types_said(proxy, group, name):
    """The data types of each input port; ParaView's domain does not tell them, its definition does."""
    definition = proxy.GetSessionProxyManager().GetProxyDefinitionManager().GetProxyDefinition(group, name)
    elements = [definition.GetNestedElement(i) for i in range(definition.GetNumberOfNestedElements())]
    told = {}
    for element in elements:
        if element.GetName() == "InputProperty":
            types = element.FindNestedElementByName("DataTypeDomain")
            nested = [types.GetNestedElement(i) for i in range(types.GetNumberOfNestedElements())]
            told[int(element.GetAttribute("port_index"))] = [e.GetAttribute("value") for e in nested]
    return told


def check(kind, name, group):
    manager = servermanager.ProxyManager()
    proxy = manager.SMProxyManager.NewProxy(group, name)
    assert proxy, f"no proxy {group}/{name}"
    said = set()
    inputs = {}
    for key, prop in properties(proxy):
        if isinstance(prop, vtkSMInputProperty):
            inputs[prop.GetPortIndex()] = prop
        elif isinstance(prop, vtkSMProxyProperty):
            assert hasattr(kind, "Set" + key)
        else:
            check_parameter(kind, key, prop)
            said.add(key)
    assert said == set(setters(kind)), f"{kind.__name__}: proxy has {said}, the class {set(setters(kind))}"
    assert proxy.GetDocumentation() and len(proxy.GetDocumentation().GetDescription()) > 100
    if isinstance(proxy, vtkSMSourceProxy):
        instance = kind()
        assert sorted(inputs) == list(range(instance.GetNumberOfInputPorts())), f"{kind.__name__}: inputs {sorted(inputs)}"
        for port, prop in inputs.items():
            info = instance.GetInputPortInformation(port)
            accepted = types_said(proxy, group, name)[port]
            key = vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE()
            needed = [info.Get(key, i) for i in range(info.Length(key))]
            collection = {"vtkMultiBlockDataSet", "vtkPartitionedDataSet", "vtkPartitionedDataSetCollection"}
            told = {"vtkDataObjectTree" if a in collection else a for a in accepted}
            assert told == set(needed), f"{kind.__name__}, input {port}: {accepted}, the class takes {needed}"
            assert bool(prop.GetMultipleInput()) == bool(info.Has(vtkAlgorithm.INPUT_IS_REPEATABLE()))
            optional = prop.GetHints() and prop.GetHints().FindNestedElementByName("Optional")
            assert bool(optional) == bool(info.Has(vtkAlgorithm.INPUT_IS_OPTIONAL()))
        proxy.UpdateVTKObjects()
        assert proxy.GetNumberOfOutputPorts() == instance.GetNumberOfOutputPorts()
        menu = proxy.GetHints().FindNestedElementByName("ShowInMenu")
        assert menu.GetAttribute("category") == "Oversketch"
    return len(said)


def complete(kind):
    """Whether there are instances: a base of filters has none."""
    try:
        return kind() is not None
    except (TypeError, NotImplementedError):
        return False


classes = [getattr(oversketch, name) for name in dir(oversketch) if name.startswith("vtkOversketch")]
classes = [kind for kind in classes if complete(kind)]
assert len(classes) >= 16, classes
total = sum(check(kind, kind.__name__[3:], "filters") for kind in classes)
for name in ("OneStroke", "Augment", "Terrain", "Silhouette"):
    total += check(getattr(oversketch, "vtkOversketch" + name), name, "oversketch_driven")
print(f"{len(classes)} filters, {total} parameters")
