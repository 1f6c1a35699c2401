"""In pvpython: writes the collection of variants.py.

usage: pvpython make_collection.py FOLDER COUNT

FOLDER/models.vtpc and strokes.vtpc: one dataset with a partition per model, COUNT good ones and the three that are not.
FOLDER/few.vtm: the first three models, a block each."""
import pathlib
import sys

from variants import pairs
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPartitionedDataSet, vtkPartitionedDataSetCollection
from vtkmodules.vtkIOParallelXML import vtkXMLPartitionedDataSetCollectionWriter
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter


def write(writer, data, path):
    writer.SetFileName(str(path))
    writer.SetInputDataObject(data)
    assert writer.Write() == 1, path


def blocks(leaves):
    collection = vtkMultiBlockDataSet()
    for index, leaf in enumerate(leaves):
        collection.SetBlock(index, leaf)
    return collection


def partitions(leaves):
    parts, collection = vtkPartitionedDataSet(), vtkPartitionedDataSetCollection()
    for index, leaf in enumerate(leaves):
        parts.SetPartition(index, leaf)
    collection.SetPartitionedDataSet(0, parts)
    return collection


def main():
    folder, count = pathlib.Path(sys.argv[1]), int(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    meshes, strokes = zip(*pairs(count))
    write(vtkXMLPartitionedDataSetCollectionWriter(), partitions(meshes), folder / "models.vtpc")
    write(vtkXMLPartitionedDataSetCollectionWriter(), partitions(strokes), folder / "strokes.vtpc")
    write(vtkXMLMultiBlockDataWriter(), blocks(meshes[:3]), folder / "few.vtm")


main()
