"""In pvbatch --sym, on any number of ranks: a stroke for each model of a collection. Each rank writes what it made and how long it
took.

usage: pvbatch --sym collection.py MODELS STROKES FOLDER   (.vtpc or .vtm; STROKES may be one .vtp for all)"""
import json
import pathlib
import sys
import time

import oversketch  # noqa: F401  for the filter's own methods
from digest import digest
from hosts import load_plugin
from paraview import servermanager, simple

load_plugin(globals())
models_path, strokes_path, folder = sys.argv[1:]
models, strokes = simple.OpenDataFile(models_path), simple.OpenDataFile(strokes_path)
models.UpdatePipeline()
strokes.UpdatePipeline()
each = OversketchForEach(Models=models, Strokes=strokes)  # noqa: F821

start, used = time.perf_counter(), time.process_time()
each.UpdatePipeline()
seconds, used = time.perf_counter() - start, time.process_time() - used


def leaves(data):
    it = data.NewIterator()
    it.UnRegister(None)
    it.InitTraversal()
    while not it.IsDoneWithTraversal():
        yield it.GetCurrentDataObject()
        it.GoToNextItem()


def own(proxy):
    """The part of a pipeline's result that this rank holds."""
    return proxy.SMProxy.GetClientSideObject().GetOutputDataObject(0)


def ident(leaf):
    array = leaf.GetFieldData().GetArray("ModelId")
    return array.GetValue(0) if array else None  # a reader may drop it from a model without points


before, after = list(leaves(own(models))), list(leaves(own(each)))
assert len(before) == len(after)
made = {ident(model): digest(leaf) if leaf.GetNumberOfPoints() else "" for model, leaf in zip(before, after)}
rank = servermanager.vtkProcessModule.GetProcessModule().GetPartitionId()
failures = each.SMProxy.GetClientSideObject().GetNumberOfFailures()
report = {"rank": rank, "held": len(before), "seconds": seconds, "processor_seconds": used, "failures": failures, "made": made}
(pathlib.Path(folder) / f"rank{rank}.json").write_text(json.dumps(report))
