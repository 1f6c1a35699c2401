"""update(filter): a pipeline's errors as an exception, its warnings as Python's."""
from __future__ import annotations

import re
import warnings
from typing import Any, List

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

__all__ = ["FilterError", "update"]


class FilterError(RuntimeError):
    """A filter could not do its work, or something above it in its pipeline could not.

    `messages` holds what was said, as "class: message", the first cause first; `code` is the error code of the filter that
    was updated (0 where only something above it failed).
    """

    def __init__(self, messages: List[str], code: int) -> None:
        super().__init__("\n".join(messages))
        self.messages = messages
        self.code = code


def update(filter: vtkAlgorithm, port: int = 0) -> Any:
    """Updates the filter and what it depends on, and returns its output of that port.

    Raises FilterError with the messages of whatever failed, in this filter or above it, which are then not printed. What they
    warn of, that a result is not as drawn among it, is given to warnings.warn, each text once. What failed or was cancelled in
    an earlier run is tried again (VTK's own Update would return its empty output and say nothing).
    """
    messages: List[str] = []
    doubts: List[str] = []
    complaints: List[str] = []  # the executives': that an algorithm failed, not why

    def listen(to: List[str]) -> Any:
        def heard(caller: Any, event: str, text: str) -> None:
            to.append(_plain(text, caller.GetClassName()))

        heard.CallDataType = "string0"  # type: ignore[attr-defined]
        return heard

    observed = []
    pipeline = _upstream(filter)
    try:
        for algorithm in pipeline:
            executive = algorithm.GetExecutive()
            for what, event, to in ((algorithm, "ErrorEvent", messages), (executive, "ErrorEvent", complaints),
                                    (algorithm, "WarningEvent", doubts)):
                observed.append((what, what.AddObserver(event, listen(to))))
            if algorithm.GetErrorCode():
                algorithm.Modified()
        filter.Update(port)
    finally:
        for what, tag in observed:
            what.RemoveObserver(tag)
    code = filter.GetErrorCode()
    if code and not messages:  # a cancelled run is silent
        messages = [f"{filter.GetClassName()}: cancelled or stopped, error code {code}"]
    if messages or complaints:
        raise FilterError(messages or complaints, code)
    for doubt in dict.fromkeys(doubts):
        warnings.warn(doubt, RuntimeWarning, stacklevel=2)
    return filter.GetOutputDataObject(port)


def _upstream(filter: vtkAlgorithm) -> List[vtkAlgorithm]:
    """The filter and everything that it takes data from, each once."""
    found, waiting = [], [filter]
    while waiting:
        algorithm = waiting.pop()
        if algorithm is None or algorithm in found:
            continue
        found.append(algorithm)
        for port in range(algorithm.GetNumberOfInputPorts()):
            for index in range(algorithm.GetNumberOfInputConnections(port)):
                waiting.append(algorithm.GetInputAlgorithm(port, index))
    return found


def _plain(text: str, name: str) -> str:
    """"ERROR: In FILE, line N\\nCLASS (0x...): message", or "Warning: ...", as "CLASS: message", without the request that an
    executive appends."""
    found = re.match(r"(?:ERROR|Warning): In .*?, line \d+\s+(\w+) \(\w+\): (.*?)(?: for request: vtkInformation.*)?$", text, re.S)
    return f"{found.group(1)}: {found.group(2).strip()}" if found else f"{name}: {text.strip()}"
